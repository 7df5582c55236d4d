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

        assert torch.autograd.gradgradcheck(of, doubles(*given), eps=1e-7, atol=1e-4, rtol=1e-4)


def test_what_has_no_form_has_first_derivatives() -> None:
    friction = tribos.Friction(tribos.points([[0.1, 0.0], [-0.1, 0.0], [0.0, 0.2]]), mu=0.5)
    (twist,) = doubles(TWISTS[0])
    (slope,) = torch.autograd.grad(tt.support(friction, twist, 7.0), twist, create_graph=True)
    with pytest.raises(RuntimeError, match="grad"):
        slope.sum().backward()
