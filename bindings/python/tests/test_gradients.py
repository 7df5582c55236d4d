"""Derivatives against central differences, null vectors and closed forms."""

from collections.abc import Callable

import numpy as np
import pytest
import tribos

PATCHES = [
    tribos.disk(0.1),
    tribos.annulus(0.05, 0.1),
    tribos.hertz(0.1),
    tribos.paraboloid(0.1),
    tribos.polynomial(0.1, [1.0, 0.5]),
    tribos.box(0.2, 0.1),
    tribos.polygon([[0, 0], [0.3, 0], [0.1, 0.2]], centre=[0.12, 0.08]),
    tribos.bar(0.3),
]
MU, LOAD = 0.5, 10.0
UNITS = np.array([1.0, 1.0, 0.05])


def surface(patch: tribos.Patch) -> tribos.LimitSurface:
    return tribos.Friction(patch, mu=MU).limit_surface(LOAD)


def differences(of: Callable, at: np.ndarray, widths: np.ndarray) -> np.ndarray:
    """Central differences of two widths, extrapolated: columns of the Jacobian."""

    def central(width: np.ndarray) -> np.ndarray:
        columns = []
        for axis in range(at.shape[-1]):
            move = np.zeros(at.shape[-1])
            move[axis] = width[axis]
            columns.append(
                (np.asarray(of(at + move)) - np.asarray(of(at - move))) / (2 * width[axis])
            )
        return np.stack(columns, axis=-1)

    return (4.0 * central(0.5 * widths) - central(widths)) / 3.0


def pushes(count: int, gauge: float, patch: tribos.Patch, seed: int = 1) -> np.ndarray:
    """Wrenches of a gauge in all directions."""
    rng = np.random.default_rng(seed)
    wrench = surface(patch).wrench(rng.normal(size=(count, 3)) / UNITS)
    return gauge * wrench


def scaled(matrices: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Entries in the same unit."""
    return matrices * rows[:, None] / columns


@pytest.mark.parametrize("patch", PATCHES, ids=repr)
def test_derivatives_of_the_gauge_are_those_of_differences(patch: tribos.Patch) -> None:
    limits = surface(patch)
    at = pushes(40, 0.7, patch)
    expected = differences(limits.gauge, at, 1e-5 * UNITS * LOAD)
    assert np.allclose(limits.gauge_gradient(at) * UNITS, expected * UNITS, rtol=0, atol=1e-8)
    hessian = limits.gauge_hessian(at)
    expected = differences(limits.gauge_gradient, at, 1e-5 * UNITS * LOAD)
    size = np.abs(scaled(hessian, UNITS, 1 / UNITS)).max(axis=(-2, -1), keepdims=True)
    off = scaled(hessian - expected, UNITS, 1 / UNITS) / size
    assert np.abs(off).max() < 1e-5


@pytest.mark.parametrize("patch", PATCHES, ids=repr)
def test_the_gauge_grows_in_proportion_to_the_wrench(patch: tribos.Patch) -> None:
    limits = surface(patch)
    at = pushes(40, 2.5, patch)
    assert np.allclose(np.sum(limits.gauge_gradient(at) * at, axis=-1), 2.5, rtol=1e-12)
    null = np.einsum("nij,nj->ni", limits.gauge_hessian(at), at)
    assert np.abs(null * UNITS).max() < 1e-11


@pytest.mark.parametrize("patch", PATCHES, ids=repr)
def test_the_normal_turns_as_differences_do(patch: tribos.Patch) -> None:
    limits = surface(patch)
    at = pushes(40, 1.3, patch)
    jacobian = limits.normal_jacobian(at)
    expected = differences(limits.normal, at, 1e-5 * UNITS * LOAD)
    size = np.abs(scaled(jacobian, UNITS, 1 / UNITS)).max(axis=(-2, -1), keepdims=True)
    off = np.abs(scaled(jacobian - expected, UNITS, 1 / UNITS) / size).max(axis=(-2, -1))
    assert off.max() < 1e-5


@pytest.mark.parametrize("length", [None, 0.02])
@pytest.mark.parametrize("patch", PATCHES, ids=repr)
def test_the_nearest_wrench_moves_as_differences_do(
    patch: tribos.Patch, length: float | None
) -> None:
    limits = surface(patch)
    at = pushes(40, 1.8, patch)
    jacobian = limits.project_jacobian(at, length=length)
    expected = differences(lambda x: limits.project(x, length=length), at, 1e-5 * UNITS * LOAD)
    off = np.abs(scaled(jacobian - expected, 1 / UNITS, 1 / UNITS)).max(axis=(-2, -1))
    assert off.max() < 1e-6
    normal = limits.normal(limits.project(at, length=length))
    assert np.abs(np.einsum("nij,ni->nj", jacobian, normal)).max() < 1e-8


@pytest.mark.parametrize("patch", [tribos.disk(0.1), tribos.box(0.2, 0.1)], ids=repr)
def test_second_derivatives_are_right_to_ten_digits(patch: tribos.Patch) -> None:
    limits = surface(patch)
    at = pushes(100, 1.3, patch)
    width = 2e-4 * UNITS * LOAD

    def sixth_order(of: Callable) -> np.ndarray:
        columns = []
        for axis, size in enumerate(width):
            move = size * np.eye(3)[axis]
            central = [(of(at + k * move) - of(at - k * move)) / (2 * k * size) for k in (1, 2, 3)]
            columns.append(1.5 * central[0] - 0.6 * central[1] + 0.1 * central[2])
        return np.stack(columns, axis=-1)

    normal = scaled(limits.normal_jacobian(at), UNITS, 1 / UNITS)
    off = normal - scaled(sixth_order(limits.normal), UNITS, 1 / UNITS)
    assert (np.abs(off).max(axis=(-2, -1)) < 1e-10 * np.abs(normal).max(axis=(-2, -1))).all()
    off = scaled(limits.project_jacobian(at) - sixth_order(limits.project), 1 / UNITS, 1 / UNITS)
    # The width of the differences shows where the surface bends most.
    assert np.quantile(np.abs(off).max(axis=(-2, -1)), 0.95) < 1e-10
    assert np.abs(off).max() < 1e-8


def test_wrenches_of_the_set_stay() -> None:
    for patch in PATCHES:
        inside = surface(patch).project_jacobian(pushes(5, 0.5, patch))
        assert np.array_equal(inside, np.broadcast_to(np.eye(3), (5, 3, 3)))


def test_without_load_nothing_is_carried() -> None:
    for patch in (tribos.disk(0.1), tribos.box(0.2, 0.1)):
        limits = tribos.Friction(patch, mu=MU).limit_surface(0.0)
        assert np.array_equal(limits.project_jacobian([1.0, 2.0, 0.1]), np.zeros((3, 3)))
        assert np.isnan(limits.gauge_gradient([1.0, 2.0, 0.1])).all()


@pytest.mark.parametrize("patch", PATCHES, ids=repr)
def test_the_support_function_has_friction_as_its_slope(patch: tribos.Patch) -> None:
    limits = surface(patch)
    twists = np.random.default_rng(3).normal(size=(40, 3)) / UNITS
    expected = differences(limits.support, twists, 1e-3 / UNITS)
    assert np.allclose(limits.support_gradient(twists) / UNITS, expected / UNITS, rtol=0, atol=1e-6)
    friction = tribos.Friction(patch, mu=MU)
    assert np.allclose(
        limits.support_hessian(twists), -friction.jacobian(twists, LOAD), rtol=1e-9, atol=1e-12
    )
    null = np.einsum("nij,nj->ni", limits.support_hessian(twists), twists)
    assert np.abs(null / UNITS).max() < 1e-9


def test_a_round_patch_is_the_limit_of_polygons() -> None:
    angle = 2 * np.pi * np.arange(512) / 512
    fine = surface(tribos.polygon(0.1 * np.stack((np.cos(angle), np.sin(angle)), axis=-1)))
    disk = surface(tribos.disk(0.1))
    at = pushes(20, 1.5, tribos.disk(0.1))
    for one, other in (
        (disk.gauge_hessian(at), fine.gauge_hessian(at)),
        (disk.normal_jacobian(at), fine.normal_jacobian(at)),
        (disk.project_jacobian(at), fine.project_jacobian(at)),
    ):
        assert np.abs(one - other).max() < 1e-3 * np.abs(one).max()


def test_an_ellipsoid_has_its_closed_form() -> None:
    limits = surface(tribos.disk(0.1)).ellipsoid()
    axes = np.array([limits.force_limit, limits.force_limit, limits.torque_limit])
    at = pushes(20, 1.5, tribos.disk(0.1))
    gauge = np.linalg.norm(at / axes, axis=-1)[:, None]
    gradient = at / axes**2 / gauge
    assert np.allclose(limits.gauge_gradient(at), gradient, rtol=1e-12, atol=1e-14)
    outer = gradient[:, :, None] * gradient[:, None, :]
    assert np.allclose(
        limits.gauge_hessian(at),
        (np.diag(axes**-2.0) - outer) / gauge[:, None],
        rtol=1e-9,
        atol=1e-9,
    )
    expected = differences(limits.project, at, 1e-5 * UNITS * LOAD)
    assert np.allclose(limits.project_jacobian(at), expected, rtol=1e-6, atol=1e-8)


def test_facets_of_points_are_flat() -> None:
    corners = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]
    table = surface(tribos.points(corners))
    # About a leg the table turns under all forces that this leg carries.
    turn = np.array([-0.2, -0.2, 1.0])
    some = -0.5 * (table.wrench(turn + [1e-6, 0, 0]) + table.wrench(turn - [1e-6, 0, 0]))
    push = some + [0.3, 0.4, 0.2 * 0.4 + 0.2 * 0.3]
    unit = turn / np.hypot(np.hypot(*turn[:2]), turn[2] * np.hypot(0.2, 0.2))
    assert np.allclose(table.normal(push), unit, rtol=1e-9)
    assert np.array_equal(table.gauge_hessian(push), np.zeros((3, 3)))
    jacobian = table.project_jacobian(1.05 * push)
    assert np.linalg.matrix_rank(jacobian, tol=1e-9) == 2
    assert np.allclose(jacobian @ jacobian, jacobian, atol=1e-12)


BODIES = {"mass": 2.0, "inertia": 0.006, "dt": 0.01}


def stepped(patch: tribos.Patch, at: np.ndarray) -> np.ndarray:
    """Twist and friction after a step from twist, push, load, mass, inertia and dt in a row."""
    step = tribos.planar_step_jacobian(
        tribos.Friction(patch, mu=MU),
        at[..., :3],
        at[..., 3:6],
        at[..., 6],
        mass=at[..., 7],
        inertia=at[..., 8],
        dt=at[..., 9],
    )
    return np.concatenate((step.twists, step.friction), axis=-1)


def cases(count: int, speed: float, push: float) -> np.ndarray:
    rng = np.random.default_rng(11)
    at = np.empty((count, 10))
    at[:, :3] = speed * rng.normal(size=(count, 3)) / UNITS
    at[:, 3:6] = push * rng.normal(size=(count, 3)) * UNITS
    at[:, 6:] = [LOAD, BODIES["mass"], BODIES["inertia"], BODIES["dt"]]
    return at


@pytest.mark.parametrize("patch", PATCHES, ids=repr)
@pytest.mark.parametrize(("speed", "push"), [(1.0, 3.0), (0.02, 0.1), (0.02, 20.0)])
def test_a_step_follows_its_state(patch: tribos.Patch, speed: float, push: float) -> None:
    at = cases(60, speed, push)
    step = tribos.planar_step_jacobian(
        tribos.Friction(patch, mu=MU), at[:, :3], at[:, 3:6], LOAD, **BODIES
    )
    got = np.concatenate(
        [
            np.concatenate([by.twists, by.pushes, *(x[..., None] for x in by[2:])], axis=-1)
            for by in (step.twists_by, step.friction_by)
        ],
        axis=-2,
    )
    widths = np.array([*(1e-4 * speed / UNITS), *(1e-3 * UNITS), 1e-3, 2e-4, 6e-7, 1e-6])
    expected = differences(lambda x: stepped(patch, x), at, widths)
    rows = np.array([1.0, 1.0, 0.05, 0.1, 0.1, 2.0]) / max(speed, 0.1)
    # In units of each column's typical change.
    off = np.abs((got - expected) * rows[:, None] * (widths / widths[0]) * 1e-4)
    worst = off.max(axis=(-2, -1))
    # A difference across two branches of the step is none.
    assert np.quantile(worst, 0.8) < 2e-6, worst
    if speed < 0.1 and push < 1.0:
        assert step.at_rest.any()


def test_a_body_at_rest_stays_whatever_happens() -> None:
    for patch in PATCHES:
        friction = tribos.Friction(patch, mu=MU)
        step = tribos.planar_step_jacobian(friction, [0, 0, 0], [1.0, 0.5, 0.01], LOAD, **BODIES)
        assert step.at_rest
        for by in step.twists_by:
            assert np.array_equal(by, np.zeros_like(by))
        assert np.array_equal(step.friction_by.pushes, -np.eye(3))
        assert np.array_equal(step.friction_by.load, np.zeros(3))


def test_a_puck_without_spin_loses_mu_g_dt() -> None:
    puck = tribos.Friction(tribos.disk(0.1), mu=MU)
    step = tribos.planar_step_jacobian(puck, [3.0, 0.0, 0.0], [0.0, 0.0, 0.0], LOAD, **BODIES)
    lost = MU * LOAD * BODIES["dt"] / BODIES["mass"]
    assert np.allclose(step.twists_by.load, [-lost / LOAD, 0, 0], rtol=1e-12)
    assert np.allclose(step.twists_by.mass, [lost / BODIES["mass"], 0, 0], rtol=1e-12)
    # Across the motion friction opposes the mean velocity: (1 - h)/(1 + h) with h = lost/2 over the mean speed.
    h = 0.5 * lost / (3.0 - 0.5 * lost)
    assert np.allclose(np.diag(step.twists_by.twists)[:2], [1.0, (1 - h) / (1 + h)], rtol=1e-12)


def test_a_first_load_slows_as_its_friction_does() -> None:
    for patch in (tribos.disk(0.1), tribos.box(0.2, 0.1)):
        friction = tribos.Friction(patch, mu=MU)
        state = ([1.0, 0.3, 20.0], [0.0, 0.0, 0.0])
        none, little = (
            tribos.planar_step_jacobian(friction, *state, load, **BODIES) for load in (0.0, 1e-6)
        )
        assert np.allclose(none.friction_by.load, little.friction / 1e-6, rtol=1e-6)
        assert np.allclose(none.friction_by.load, friction.wrench(state[0], 1.0), rtol=1e-12)
        assert np.array_equal(none.twists_by.twists, np.eye(3))


@pytest.mark.parametrize("alpha", [0.0, 0.5, -0.5])
@pytest.mark.parametrize(
    "patch", [tribos.disk(0.08), tribos.hertz(0.08), tribos.annulus(0.04, 0.08)], ids=repr
)
def test_the_way_to_rest_follows_the_launch(patch: tribos.Patch, alpha: float) -> None:
    friction = tribos.Friction(patch, mu=0.3, alpha=alpha)
    at = np.array(
        [
            [1.0, 12.5, 9.81, 0.08],
            [2.0, 3.0, 9.81, 0.05],
            [0.5, -40.0, 6.0, 0.08],
            [-1.0, 20.0, 9.81, 0.08],
        ]
    )

    def thrown(x: np.ndarray) -> tribos.SlideJacobian:
        return tribos.slide_jacobian(
            friction, x[..., 0], x[..., 1], gravity=x[..., 2], radius=x[..., 3]
        )

    throw = thrown(at)
    got = np.stack(
        [np.stack(by, axis=-1) for by in (throw.time_by, throw.distance_by, throw.angle_by)],
        axis=-2,
    )
    expected = differences(
        lambda x: np.stack(thrown(x)[:3], axis=-1), at, np.array([1e-4, 1e-3, 1e-4, 1e-6])
    )
    assert np.allclose(got, expected, rtol=1e-6, atol=1e-7)


def test_a_launch_without_spin_goes_as_far_as_a_point() -> None:
    disk = tribos.Friction(tribos.disk(0.08), mu=0.25)
    throw = tribos.slide_jacobian(disk, 2.0, 0.0, gravity=10.0)
    assert np.allclose(
        [throw.time, throw.distance, throw.angle], [2.0 / 2.5, 4.0 / 5.0, 0.0], rtol=1e-13
    )
    assert np.allclose(throw.time_by, [1 / 2.5, 0.0, -0.8 / 10.0, 0.0], rtol=1e-13)
    assert np.allclose(throw.distance_by, [2.0 / 2.5, 0.0, -0.8 / 10.0, 0.0], rtol=1e-13)
    rest = tribos.slide_jacobian(disk, 0.0, 0.0)
    assert not np.array(rest.time_by).any() and rest.time == 0.0


def test_derivatives_are_those_of_the_same_slide_and_step() -> None:
    friction = tribos.Friction(tribos.hertz(0.08), mu=0.25, alpha=0.3)
    speed, spin = np.array([1.0, -2.0]), np.array([[3.0], [20.0], [-4.0]])
    rest = tribos.slide(friction, speed, spin, inertia_ratio=0.7)
    throw = tribos.slide_jacobian(friction, speed, spin, inertia_ratio=0.7)
    assert np.allclose(throw[:3], rest[:3], rtol=1e-12)
    box = tribos.Friction(tribos.box(0.2, 0.1), mu=0.4)
    at = cases(30, 0.1, 3.0)
    body = tribos.PlanarBody(box, BODIES["mass"], BODIES["inertia"], load=LOAD)
    expected = body.step(at[:, :3], at[:, 3:6], BODIES["dt"])
    step = tribos.planar_step_jacobian(box, at[:, :3], at[:, 3:6], LOAD, **BODIES)
    for got, wanted in zip(step, expected, strict=False):
        assert np.array_equal(got, wanted)


def test_launches_that_cannot_be_are_refused() -> None:
    disk = tribos.Friction(tribos.disk(0.1), mu=0.3)
    with pytest.raises(ValueError, match="mu \\* gravity must be > 0"):
        tribos.slide_jacobian(disk, 1.0, 1.0, gravity=0.0)
    with pytest.raises(ValueError, match="round"):
        tribos.slide_jacobian(tribos.Friction(tribos.box(0.1, 0.1), mu=0.3), 1.0, 1.0)
    with pytest.raises(ValueError, match="power of the speed"):
        tribos.slide_jacobian(
            tribos.Friction(tribos.disk(0.1), law=tribos.softened(0.3, 0.1)), 1.0, 1.0
        )
    with pytest.raises(ValueError, match="rest"):
        tribos.slide_jacobian(tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.5), 1.0, 1.0)
    with pytest.raises(ValueError, match="mass"):
        tribos.planar_step_jacobian(disk, [0, 0, 0], [0, 0, 0], 1.0, mass=0.0, inertia=1.0, dt=0.1)


def test_a_softened_law_has_a_slope_at_rest() -> None:
    law = tribos.softened(mu=0.4, speed=1e-3)
    speed = np.array([0.0, 1e-4, 1e-3, 1.0])
    assert np.allclose(law.friction(speed), 0.4 * speed / (speed + 1e-3), rtol=1e-14, atol=0.0)
    assert np.allclose(law.slope(speed), 0.4 * 1e-3 / (speed + 1e-3) ** 2, rtol=1e-13)
    for patch, arm_sq in (
        (tribos.disk(0.1), 0.1**2 / 2),
        (tribos.points([[0.1, 0.0], [-0.1, 0.0], [0.0, 0.1]]), None),
    ):
        jacobian = tribos.Friction(patch, law=law).jacobian([0.0, 0.0, 0.0], LOAD)
        assert np.isfinite(jacobian).all()
        assert np.allclose(jacobian[:2, :2], -400.0 * LOAD * np.eye(2), rtol=1e-6)
        if arm_sq is not None:
            assert np.isclose(jacobian[2, 2], -400.0 * LOAD * arm_sq, rtol=1e-6)
    sharp = tribos.Friction(tribos.disk(0.1), mu=0.4)
    assert not np.isfinite(sharp.jacobian([0.0, 0.0, 0.0], LOAD)).all()
