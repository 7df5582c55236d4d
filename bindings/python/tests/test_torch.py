"""Derivatives in PyTorch against finite differences."""

import numpy as np
import pytest
import tribos

torch = pytest.importorskip("torch")

import tribos.torch as tt  # noqa: E402
from tribos import _gradients, _torch_forms, _torch_kernel  # noqa: E402

FRICTIONS = [
    tribos.Friction(tribos.disk(0.1), mu=0.5),
    tribos.Friction(tribos.box(0.2, 0.1), mu=0.5),
]
TWISTS = [[1.0, 0.3, 12.0], [0.1, -0.4, -3.0]]
PUSHES = [[3.0, 4.0, 0.1], [-9.0, 1.0, 0.2]]
BODY = {"mass": 2.0, "inertia": 0.006, "dt": 0.01}


def doubles(*given):
    return tuple(torch.tensor(x, dtype=torch.float64, requires_grad=True) for x in given)


def check(of, *given, eps: float = 1e-6, tol: float = 1e-6) -> None:
    assert torch.autograd.gradcheck(of, doubles(*given), eps=eps, atol=tol, rtol=tol)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_everything_has_the_slopes_of_differences(friction: tribos.Friction) -> None:
    loads = [10.0, 7.0]
    check(lambda twists, load: tt.wrench(friction, twists, load), TWISTS, loads)
    check(lambda twists, load: tt.wrench(friction, twists, load), TWISTS, 3.0)
    check(lambda twists, load: tt.support(friction, twists, load), TWISTS, loads)
    check(lambda wrenches, load: tt.gauge(friction, wrenches, load), PUSHES, loads)
    check(lambda wrenches: tt.normal(friction, wrenches), PUSHES, tol=1e-5)
    double = (2 * np.array(PUSHES)).tolist()
    check(lambda wrenches, load: tt.project(friction, wrenches, load, length=0.03), double, loads)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_a_planar_step_has_the_slopes_of_differences(friction: tribos.Friction) -> None:
    def step(twists, push, load, mass, inertia, dt):
        return tt.planar_step(friction, twists, push, load, mass=mass, inertia=inertia, dt=dt)[:2]

    check(step, TWISTS, PUSHES, [10.0, 7.0], 2.0, 0.006, 0.01, eps=1e-7, tol=1e-5)
    at_rest = tt.planar_step(friction, *doubles([1e-3, 0.0, 0.0], [1.0, 0.0, 0.01]), 10.0, **BODY)
    assert at_rest.at_rest
    assert np.array_equal(at_rest.twists.detach(), np.zeros(3))


def test_a_step_into_rest_passes_no_gradient_on() -> None:
    twist, push = doubles([1e-3, 0.0, 0.0], [1.0, 0.0, 0.01])
    tt.planar_step(FRICTIONS[0], twist, push, 10.0, **BODY).twists.sum().backward()
    assert not twist.grad.any() and not push.grad.any()


def test_a_turned_box_has_the_slopes_of_differences() -> None:
    def step(twists, pushes, angle):
        return tt.planar_step(FRICTIONS[1], twists, pushes, 10.0, angle=angle, **BODY)[:2]

    check(step, TWISTS, PUSHES, [0.3, -1.0], eps=1e-7, tol=1e-5)


def test_a_slide_has_the_slopes_of_differences() -> None:
    disk = tribos.Friction(tribos.disk(0.08), mu=0.3)

    def way(speed, spin, gravity, radius):
        return tuple(tt.slide(disk, speed, spin, gravity=gravity, radius=radius))

    check(way, [1.0, 2.0], [11.0, -5.0], 10.0, 0.08, eps=1e-5)


def test_a_gradient_through_a_hundred_steps_is_that_of_differences() -> None:
    def travelled(start):
        twist, way = start, 0.0
        for _ in range(100):
            after = tt.planar_step(
                FRICTIONS[0], twist, torch.zeros(3, dtype=torch.float64), 5.0, **BODY
            ).twists
            way = way + 0.005 * (twist + after)
            twist = after
        return way

    check(travelled, [4.0, 1.0, 60.0], eps=1e-5, tol=1e-5)


def test_types_are_those_of_the_tensors() -> None:
    twist = torch.tensor(TWISTS, requires_grad=True)
    made = tt.wrench(FRICTIONS[0], twist, 10.0)
    assert made.dtype == torch.float32
    exact = FRICTIONS[0].wrench(np.array(TWISTS, dtype=np.float32), 10.0)
    assert np.array_equal(made.detach().numpy(), exact.astype(np.float32))
    made.sum().backward()
    assert twist.grad.dtype == torch.float32
    assert tt.wrench(FRICTIONS[0], TWISTS, 10.0).dtype == torch.get_default_dtype()


def operations(friction: tribos.Friction):
    """Each operation that has a form, with arguments."""
    loads, body = [10.0, 7.0], (2.0, 0.006, 0.01)
    return [
        (_gradients.Wrench(friction), (TWISTS, loads)),
        (_gradients.Support(friction), (TWISTS, 3.0)),
        (_gradients.Gauge(friction), (PUSHES, loads)),
        (_gradients.Normal(friction), (PUSHES,)),
        (_gradients.Project(friction, 0.03), ([[6.0, 8.0, 0.2], [-18.0, 2.0, 0.4]], loads)),
        (_gradients.PlanarStep(friction), (TWISTS, PUSHES, loads, *body)),
    ]


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_forms_on_tensors_give_what_the_kernel_gives(friction: tribos.Friction) -> None:
    for operation, given in operations(friction):
        assert _torch_forms.has_form(operation)
        for dtype, tolerance in ((torch.float64, 1e-12), (torch.float32, 1e-5)):
            tensors = [torch.tensor(x, dtype=dtype) for x in given]
            made = _torch_forms.applied(operation, *tensors)
            wanted = operation.value(*(x.numpy().astype(float) for x in tensors))
            for one, other in zip(made, wanted, strict=True):
                assert one.dtype == dtype
                scale = float(np.abs(other).max()) or 1.0
                assert np.allclose(one / scale, other / scale, rtol=0.0, atol=tolerance), operation


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_second_derivatives_are_those_of_differences(friction: tribos.Friction) -> None:
    for operation, given in operations(friction):
        smooth = [_torch_kernel.applied(operation, *doubles(*given))[k] for k in operation.smooth]
        assert all(one.requires_grad for one in smooth)

        def of(*tensors, operation=operation):
            made = _torch_kernel.applied(operation, *tensors)
            return tuple(made[k] for k in operation.smooth)

        assert torch.autograd.gradgradcheck(
            of, doubles(*given), eps=1e-7, atol=1e-4, rtol=1e-4, fast_mode=True
        )


def test_what_has_no_form_has_first_derivatives() -> None:
    friction = tribos.Friction(tribos.points([[0.1, 0.0], [-0.1, 0.0], [0.0, 0.2]]), mu=0.5)
    (twist,) = doubles(TWISTS[0])
    (slope,) = torch.autograd.grad(tt.support(friction, twist, 7.0), twist, create_graph=True)
    with pytest.raises(RuntimeError, match="grad"):
        slope.sum().backward()


CORNERS = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]


def sized(friction: tribos.Friction) -> tuple[str, list]:
    """The keyword of a size, and two sizes that are not the patch's own."""
    if friction.patch.kind == "disk":
        return "radius", [0.08, 0.12]
    # The other way round, with a corner twice.
    large = (1.2 * np.array([*CORNERS[::-1], CORNERS[0]])).tolist()
    return "corners", [[*CORNERS, CORNERS[-1]], large]


def made_of(friction: tribos.Friction, size, mu: float) -> tribos.Friction:
    """The friction that a size and a coefficient stand for."""
    if friction.patch.kind == "disk":
        return tribos.Friction(tribos.disk(size), mu=mu)
    once = list(dict.fromkeys(map(tuple, size)))
    return tribos.Friction(tribos.polygon(once), mu=mu)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_coefficients_and_sizes_for_each_row_are_those_of_frictions(friction) -> None:
    key, sizes = sized(friction)
    mus, loads = [0.2, 0.7], [10.0, 7.0]
    twists, pushes, load, mu, size = doubles(TWISTS, PUSHES, loads, mus, sizes)
    given = {"mu": mu, key: size}
    made = [
        tt.wrench(friction, twists, load, **given),
        tt.support(friction, twists, load, **given),
        tt.jacobian(friction, twists, load, **given),
        tt.gauge(friction, pushes, load, **given),
        tt.project(friction, 5 * pushes, load, length=0.03, **given),
        tt.planar_step(friction, twists, pushes, load, **given, **BODY).twists,
    ]
    for row in range(2):
        own = made_of(friction, sizes[row], mus[row])
        body = tribos.PlanarBody(own, BODY["mass"], BODY["inertia"], load=loads[row])
        surface = tribos.LimitSurface(own.patch, mu=mus[row], load=loads[row])
        wanted = [
            own.wrench(TWISTS[row], loads[row]),
            surface.support(TWISTS[row]),
            own.jacobian(TWISTS[row], loads[row]),
            surface.gauge(PUSHES[row]),
            surface.project(5 * np.array(PUSHES[row]), length=0.03),
            body.step(TWISTS[row], PUSHES[row], BODY["dt"])[0],
        ]
        for one, other in zip(made, wanted, strict=True):
            scale = float(np.abs(other).max())
            assert np.abs(one[row].detach().numpy() - other).max() < 3e-13 * scale


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_coefficients_and_sizes_have_the_slopes_of_differences(friction) -> None:
    key, sizes = sized(friction)

    def each(twists, pushes, mu, size):
        given = {"mu": mu, key: size}
        step = tt.planar_step(friction, twists, pushes, 10.0, **given, **BODY)
        return (
            tt.wrench(friction, twists, 10.0, **given),
            tt.gauge(friction, pushes, 10.0, **given),
            tt.project(friction, 9 * pushes, 10.0, length=0.03, **given),
            step.twists,
        )

    given = doubles(TWISTS, PUSHES, [0.2, 0.7], sizes)
    # Along chosen directions: an entry at a time would take long.
    assert torch.autograd.gradcheck(each, given, eps=1e-7, atol=1e-5, rtol=1e-5, fast_mode=True)
    kernel = {"backend": "kernel"}
    check(lambda mu: tt.wrench(friction, torch.tensor(TWISTS).double(), 7.0, mu=mu, **kernel), 0.3)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_softened_friction_is_minus_the_gradient_of_its_potential(friction) -> None:
    key, sizes = sized(friction)

    def both(twists, mu, size, soft):
        given = {"mu": mu, key: size, "soft": soft}
        return tt.support(friction, twists, 7.0, **given), tt.wrench(friction, twists, 7.0, **given)

    given = doubles(TWISTS, [0.2, 0.7], sizes, [0.3, 1.0])
    assert torch.autograd.gradcheck(both, given, atol=1e-6, rtol=1e-6)
    potential, made = both(*given)
    (slope,) = torch.autograd.grad(potential.sum(), given[0], create_graph=True)
    assert torch.allclose(-slope, made, rtol=1e-12, atol=1e-12)
    (bend,) = torch.autograd.grad(slope[0, 2], given[0])
    keywords = {"mu": given[1], key: given[2], "soft": given[3]}
    matrix = tt.jacobian(friction, given[0], 7.0, **keywords)
    assert torch.allclose(-bend[0], matrix[0, 2], rtol=1e-10, atol=1e-12)


def test_softened_friction_at_rest_is_that_of_a_damper() -> None:
    rest = torch.zeros(3, dtype=torch.float64, requires_grad=True)
    matrix = tt.jacobian(FRICTIONS[0], rest, 10.0, soft=0.01)
    wanted = [-500.0, -500.0, -500.0 * (2 / 3 * 0.1) ** 2]
    assert np.allclose(matrix.detach(), np.diag(wanted), rtol=1e-12, atol=1e-12)
    made = tt.wrench(FRICTIONS[0], rest, 10.0, soft=0.01)
    (slope,) = torch.autograd.grad(made[2], rest)
    assert not made.any() and np.allclose(slope, [0.0, 0.0, wanted[2]], rtol=1e-12)


@pytest.mark.parametrize("backend", ["kernel", "tensors"])
@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_rows_at_rest_pass_zero_on_and_what_is_no_number_stays_in_its_row(
    friction, backend
) -> None:
    (twists,) = doubles([TWISTS[0], [0.0] * 3, [np.nan, 0.0, 0.0], TWISTS[1]])
    (alone,) = doubles(TWISTS)
    for of in (tt.wrench, tt.support, tt.jacobian, tt.gauge):
        made = of(friction, twists, 7.0, backend=backend)
        assert made[2].isnan().any() and torch.isfinite(made[[0, 1, 3]]).all()
        assert not made[1].any()
        assert torch.equal(made[::3], of(friction, alone, 7.0, backend=backend))
        if of is not tt.jacobian:
            (slopes,) = torch.autograd.grad(made.sum(), twists)
            assert torch.isfinite(slopes[[0, 1, 3]]).all() and not slopes[1].any()


@pytest.mark.parametrize("backend", ["kernel", "tensors"])
@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_types_stay_what_they_are(friction, backend) -> None:
    for dtype in (torch.float64, torch.float32, torch.float16, torch.bfloat16):
        rows = torch.tensor(TWISTS, dtype=dtype)
        given = {"mu": torch.tensor(0.4, dtype=torch.float64), "backend": backend}
        for of in (tt.wrench, tt.support, tt.jacobian, tt.gauge, tt.project):
            assert of(friction, rows, 10.0, **given).dtype == dtype
        step = tt.planar_step(friction, rows, PUSHES, 10, angle=0.1, **given, **BODY)
        assert (step.twists.dtype, step.at_rest.dtype) == (dtype, torch.bool)
    whole = tt.wrench(friction, torch.tensor([1, 2, 3]), 1, backend=backend)
    assert whole.dtype == torch.get_default_dtype()
    assert tt.wrench(friction, torch.zeros(0, 3), torch.ones(4, 1), backend=backend).shape == (
        4,
        0,
        3,
    )


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_tensors_of_a_device_never_come_to_the_processor(friction) -> None:
    # Tensors without values: a copy of them is refused.
    rows = torch.tensor(TWISTS, device="meta", requires_grad=True)
    for of in (tt.wrench, tt.support, tt.gauge, tt.project):
        made = of(friction, rows, 10.0, mu=0.3)
        (slope,) = torch.autograd.grad(made.sum(), rows, create_graph=True)
        (bend,) = torch.autograd.grad(slope.sum(), rows)
        assert made.is_meta and bend.is_meta and bend.shape == rows.shape
    step = tt.planar_step(friction, rows, rows, 10.0, angle=0.1, **BODY)
    assert step.twists.is_meta and step.at_rest.is_meta
    others = [
        tt.jacobian(friction, rows, 1.0, soft=0.1),
        tt.normal(friction, rows),
        *tt.manifold_friction(rows[:, :2], 0.1, 0.5, 0.1, k=1.0, kt=100.0),
    ]
    assert all(one.is_meta for one in others)
    with pytest.raises(ValueError, match="on the processor, not on meta"):
        tt.wrench(friction, rows, 10.0, backend="kernel")
    with pytest.raises(ValueError, match="on one device"):
        tt.wrench(friction, rows, torch.ones(2))


def test_manifolds_have_the_slopes_of_differences() -> None:
    def carried(p, twist, force, lever, k, kt, slip):
        return tt.manifold_friction(p, twist, force, lever, k=k, kt=kt, slip=slip, steps=4)

    given = doubles([[1.0, 0.2], [0.1, 0.0]], [0.05, 0.01], 0.5, 0.1, 1.0, [100.0, 80.0], 0.9)
    # Where all is carried the forces and masses have no effect.
    assert torch.autograd.gradcheck(carried, given, eps=1e-6, atol=2e-5, rtol=2e-5)
    assert torch.autograd.gradgradcheck(carried, given, eps=1e-6, atol=1e-3, rtol=1e-3)
    # Of a force alone the nearest is the force at the limit.
    p, twist = tt.manifold_friction(
        torch.tensor([3.0, 4.0]).double(), 0.0, 2.0, 0.1, k=1.0, kt=100.0, slip=0.5
    )
    assert np.allclose(p, [1.2, 1.6], rtol=1e-9) and twist == 0.0


PTS = tribos.Friction(tribos.points([[0.1, 0.0], [-0.1, 0.0], [0.0, 0.2]]), mu=0.5)
REFUSED = [
    ("must be a tribos.Friction", lambda: tt.wrench(tribos.disk(0.1), TWISTS, 1.0)),
    ("must be a tribos.Friction", lambda: tt.slide(tribos.disk(0.1), 1.0, 1.0)),
    ("twists must have shape", lambda: tt.wrench(FRICTIONS[0], torch.zeros(4), 1.0)),
    ("do not fit", lambda: tt.wrench(FRICTIONS[0], TWISTS, torch.ones(3))),
    ("load must be >= 0", lambda: tt.wrench(FRICTIONS[0], TWISTS, -1.0)),
    ("mu must be >= 0", lambda: tt.gauge(FRICTIONS[0], TWISTS, 1.0, mu=np.array([-1.0, 1.0]))),
    ("give radius=", lambda: tt.wrench(FRICTIONS[0], TWISTS, 1.0, corners=CORNERS)),
    ("give corners=", lambda: tt.wrench(FRICTIONS[1], TWISTS, 1.0, radius=0.1)),
    ("corners must have shape", lambda: tt.normal(FRICTIONS[1], PUSHES, corners=[[0.0, 0.0]])),
    ("soft goes with Coulomb friction of disk", lambda: tt.wrench(PTS, TWISTS, 1.0, soft=0.1)),
    ("has no form in tensors", lambda: tt.wrench(PTS, TWISTS, 1.0, backend="tensors")),
    ("backend must be one of", lambda: tt.wrench(PTS, TWISTS, 1.0, backend="xla")),
    ("length must be a number", lambda: tt.project(PTS, PUSHES, 1.0, length=torch.ones(2))),
    ("real numbers", lambda: tt.wrench(PTS, torch.ones(3, dtype=torch.complex64), 1.0)),
    ("curve must be", lambda: tt.manifold_friction([1.0, 0.0], 0, 1, 1, k=1, kt=1, curve="x")),
    ("force must be >= 0", lambda: tt.manifold_friction([1.0, 0.0], 0, -1, 1, k=1, kt=1)),
    (
        "shapes do not fit",
        lambda: tt.manifold_friction(np.ones((2, 2)), np.ones(3), 1, 1, k=1, kt=1),
    ),
    ("shapes do not fit", lambda: tt.slide(FRICTIONS[0], torch.ones(2), torch.ones(3))),
]


@pytest.mark.parametrize(("words", "call"), REFUSED, ids=[words for words, _ in REFUSED])
def test_what_makes_no_sense_is_refused_in_words(words: str, call) -> None:
    with pytest.raises(ValueError, match=words):
        call()


def test_jacobians_of_the_kernel_refuse_derivatives() -> None:
    (twist,) = doubles(TWISTS[0])
    made = tt.jacobian(PTS, twist, 7.0, mu=0.3)
    own = tribos.Friction(PTS.patch, mu=0.3)
    assert np.allclose(made.detach(), own.jacobian(TWISTS[0], 7.0), rtol=1e-13)
    with pytest.raises(NotImplementedError, match="first derivatives"):
        made.sum().backward()
    # Those of a form are differentiated.
    check(lambda twists: tt.jacobian(FRICTIONS[0], twists, 7.0), TWISTS)


def test_a_softening_of_zero_leaves_nothing_at_rest_and_a_negative_load_no_number() -> None:
    loads, soft = torch.tensor([2.0, 2.0, -2.0]), torch.tensor([0.0, 0.1, 0.0])
    rows = torch.tensor([[0.0] * 3, [0.0] * 3, [1.0, 0.0, 0.0]], requires_grad=True)
    matrix = tt.jacobian(FRICTIONS[0], rows, loads, soft=soft)
    assert not matrix[0].any() and torch.isclose(matrix[1, 0, 0], torch.tensor(-10.0))
    assert matrix[2].isnan().all()
    made = tt.wrench(FRICTIONS[0], rows, loads, soft=soft)
    (slopes,) = torch.autograd.grad(made[:2, 0].sum(), rows)
    assert not slopes[0].any() and torch.isclose(slopes[1, 0], torch.tensor(-10.0))
    with pytest.raises(ValueError, match="load must be >= 0"):
        tt.wrench(FRICTIONS[0], rows, loads)


@pytest.mark.parametrize("backend", ["kernel", "tensors"])
def test_a_gauge_without_load_passes_zero_on(backend: str) -> None:
    rows, loads = doubles([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]], [0.0, 4.0])
    made = tt.gauge(FRICTIONS[0], rows, loads, backend=backend)
    assert made[0].isinf()
    by_rows, by_loads = torch.autograd.grad(made.nan_to_num(posinf=0.0).sum(), (rows, loads))
    assert not by_rows[0].any() and by_loads[0] == 0.0
    assert np.allclose(by_rows[1], [0.0, 1.0 / (4.0 * 0.5), 0.0], rtol=1e-9)
