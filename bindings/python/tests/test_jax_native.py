"""Friction in XLA's operations against high precision, the compiled kernel and finite differences.

TRIBOS_LONG=1: softened polygons' second derivatives, too.
"""

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest
import tribos
from conftest import LONG

jax = pytest.importorskip("jax")
import jax.numpy as jnp  # noqa: E402
import tribos.jax as tj  # noqa: E402
from tribos import _gradients, _jax_native  # noqa: E402

RADIUS, MU = 0.04, 0.3
ROUND = [
    tribos.Friction(getattr(tribos, kind)(RADIUS), mu=MU)
    for kind in ("disk", "ring", "punch", "hertz", "paraboloid")
]
DISK, RING = ROUND[:2]
CORNERS = [[0.0, 0.0], [0.25, 0.02], [0.2, 0.1], [0.0, 0.08]]
FOOT = tribos.Friction(tribos.polygon(CORNERS), mu=MU)
BODY = {"mass": 0.17, "inertia": 1.36e-4, "dt": 0.01}
EPSILON = {"float32": 1.2e-7, "float64": 2.3e-16}


@pytest.fixture(autouse=True)
def double() -> Iterator[None]:
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", False)


def motions(count: int, arm: float = RADIUS) -> np.ndarray:
    """Of all sizes and ratios; pure sliding and spinning, motion along an axis and rest among them."""
    rng = np.random.default_rng(count)
    sizes = np.exp(rng.uniform(-7.0, 7.0, size=(count, 3)))
    rows = rng.normal(size=(count, 3)) * sizes / [1.0, 1.0, arm]
    rows[0:4, 2], rows[4:8, :2], rows[8:12], rows[12:16, 1] = 0.0, 0.0, 0.0, 0.0
    # Equal speeds of sliding and of the rim, and next to them.
    rows[16:20] = [0.75, 0.0, 0.75 / arm]
    rows[18:20, 2] *= 1.0 + 1e-9
    return rows


def wrenches(count: int, arm: float, reach: float = 20.0) -> np.ndarray:
    """Inside and outside of the limit surface of 1 N."""
    rng = np.random.default_rng(count)
    sizes = np.exp(rng.uniform(-1.0, np.log(reach), size=(count, 1)))
    return MU * rng.normal(size=(count, 3)) * sizes * [1.0, 1.0, 0.6 * arm]


def worst(got, wanted, size) -> float:
    return float(np.max(np.abs(np.asarray(got, float) - wanted) / size))


def test_a_disk_has_the_digits_of_forty() -> None:
    # F(h) = 2F1(-1/2, 1/2; 2; h²) and T(h) = h/4 2F1(1/2, 1/2; 3; h²) by mpmath, for the ratio h of rim to sliding speed.
    ratios = np.array([0.001, 0.25, 0.9, 0.999999])
    forces = np.array(
        [0.999999874999984375, 0.99212523904396478, 0.884177009888832222, 0.84882678756569295]
    )
    torques = np.array(
        [0.000250000020833339193, 0.0628313968234312882, 0.245795484608120284, 0.282941696643128345]
    )
    twists = np.stack([0.0 * ratios, np.ones(4), ratios / RADIUS], -1)
    for dtype in (np.float64, np.float32):
        made = np.asarray(tj.wrench(DISK, twists.astype(dtype), 1.0 / MU), float)
        ulps = 3.0 * EPSILON[dtype.__name__]
        assert worst(made[:, 1], -forces, forces) < ulps
        # The ratio itself is rounded.
        assert worst(made[:, 2], -RADIUS * torques, RADIUS * torques) < 2 * ulps


@pytest.mark.parametrize("friction", [*ROUND, FOOT], ids=lambda one: one.patch.kind)
def test_friction_is_that_of_the_kernel(friction: tribos.Friction, as_users: Any) -> None:
    arm = friction.patch.radius + np.hypot(*friction.patch.centre)
    twists, loads = motions(400, arm), np.linspace(0.0, 3.0, 400)
    size = MU * np.array([1.0, 1.0, arm])
    for dtype, most in ((np.float64, 2e-15), (np.float32, 6e-7)):
        rows = twists.astype(dtype)
        made = as_users(partial(tj.wrench, friction), rows, loads)
        assert made.dtype == dtype
        wanted = friction.wrench(rows.astype(float), loads)
        assert worst(made, wanted, 3.0 * size) < most
    # Slopes in units of the largest, away from rest and equal speeds.
    rows = twists[20:]
    scale = np.array([1.0, 1.0, arm])
    wanted = friction.jacobian(rows, 2.0) / (scale[:, None] * scale)
    made = np.asarray(tj.jacobian(friction, rows, 2.0)) / (scale[:, None] * scale)
    assert worst(made, wanted, np.abs(wanted).max((1, 2), keepdims=True)) < 1e-13


@pytest.fixture(scope="module")
def derivatives_of_power():
    """Value, gradient and Hessian of the support, and slopes of friction forwards and backwards, of a row."""

    def every(twist, mu, radius):
        def friction(twist):
            return tj.wrench(DISK, twist, 2.0, mu=mu, radius=radius)

        def power(twist):
            return tj.support(DISK, twist, 2.0, mu=mu, radius=radius)

        second = jax.jacfwd(jax.jacfwd(friction))(twist)
        slopes = jax.jacfwd(friction)(twist), jax.jacrev(friction)(twist)
        by_sizes = jax.jacfwd(
            lambda mu, radius: tj.wrench(DISK, twist, 2.0, mu=mu, radius=radius), argnums=(0, 1)
        )(mu, radius)
        return (
            power(twist),
            jax.grad(power)(twist),
            jax.hessian(power)(twist),
            friction(twist),
            *slopes,
            second,
            *by_sizes,
        )

    jax.config.update("jax_enable_x64", True)
    return jax.jit(jax.vmap(every))


def test_derivatives_are_those_of_differences_and_finite_everywhere(derivatives_of_power) -> None:
    rows = motions(200)
    mu, radius = np.linspace(0.1, 0.5, 200), np.linspace(0.03, 0.06, 200)
    found = derivatives_of_power(rows, mu, radius)
    assert all(np.isfinite(part).all() for part in found)
    power, gradient, hessian, friction, forwards, backwards, second, by_mu, by_radius = found
    scale = np.stack([np.ones(200), np.ones(200), radius], -1)
    matrix = scale[:, :, None] * scale[:, None, :]
    largest = np.maximum(np.abs(np.asarray(forwards) / matrix).max((1, 2), keepdims=True), 1e-300)
    assert np.allclose(gradient, -friction, rtol=1e-14, atol=1e-15)
    assert np.allclose(hessian / matrix / largest, -forwards / matrix / largest, atol=1e-12)
    assert np.allclose(backwards / matrix / largest, forwards / matrix / largest, atol=1e-13)
    at_rest = slice(8, 12)
    assert all(not np.asarray(part)[at_rest].any() for part in found)
    assert np.allclose(by_mu * mu[:, None], friction, rtol=1e-13, atol=1e-18)
    # Differences, away from equal speeds.
    moving = slice(20, 200)
    step = 1e-6 * np.abs(rows).max(1)
    for axis in range(3):
        move = step[:, None] * np.eye(3)[axis] / scale
        ends = [derivatives_of_power(rows + s * move, mu, radius) for s in (1.0, -1.0)]
        for value, slope, tol in ((3, 4, 1e-7), (4, 6, 1e-5)):
            one, other = (np.asarray(end[value])[moving] for end in ends)
            change = (one - other) / (2.0 * move[moving, axis]).reshape(
                (-1,) + (1,) * (one.ndim - 1)
            )
            wanted = np.asarray(found[slope])[moving][..., axis]
            span = np.abs(np.asarray(found[slope])[moving]).reshape(180, -1).max(1)
            assert worst(change, wanted, span.reshape((-1,) + (1,) * (wanted.ndim - 1))) < tol


@pytest.fixture(scope="module")
def nearest():
    """The nearest friction of a disk, and its first and second derivatives: of rows of a wrench, load, mu, radius and length."""

    def of(given):
        size = {"mu": given[4], "radius": given[5], "length": given[6]}
        return tj.project(DISK, given[:3], given[3], **size)

    def every(given):
        return of(given), jax.jacrev(of)(given), jax.jacfwd(jax.jacrev(of))(given)

    jax.config.update("jax_enable_x64", True)
    return jax.jit(jax.vmap(every))


def given_of(rows: np.ndarray, loads: Any) -> np.ndarray:
    """Rows for `nearest`."""
    sizes = [np.full(100, x) for x in (loads, MU, RADIUS, RADIUS)]
    return np.stack([*rows.T, *sizes], -1)


def test_not_a_number_stays_in_its_row(derivatives_of_power, nearest) -> None:
    rows = motions(200)
    rows[3, 2] = np.nan
    rows[5] = [np.inf, 0.0, 1.0]
    found = derivatives_of_power(rows, np.full(200, MU), np.full(200, RADIUS))
    made, slopes = np.asarray(found[3]), found[5]
    wrong = np.isnan(made).any(1)
    assert np.array_equal(wrong, [n in (3, 5) for n in range(200)])
    assert np.isnan(slopes[3]).any() and np.isfinite(np.delete(slopes, (3, 5), 0)).all()
    held, slopes, _ = nearest(given_of(rows[:100], 2.0))
    assert np.isnan(held[3]).all() and np.isfinite(np.delete(held, (3, 5), 0)).all()
    assert np.isfinite(np.delete(slopes, (3, 5), 0)).all()


@pytest.mark.parametrize("friction", [RING, FOOT], ids=lambda one: one.patch.kind)
def test_limit_surfaces_are_those_of_the_kernel(friction: tribos.Friction) -> None:
    arm = friction.patch.radius + np.hypot(*friction.patch.centre)
    rows, loads = wrenches(300, arm), np.linspace(0.5, 2.0, 300)
    surface, size = friction.limit_surface(loads), np.array([1.0, 1.0, arm])
    most = {"polygon": 1e-12}.get(friction.patch.kind, 2e-15)
    levers = arm * np.exp(np.linspace(-2.3, 2.3, 300))
    project = lambda rows, loads, levers: tj.project(friction, rows, loads, length=levers)  # noqa: E731
    made = jax.jit(project)(rows, loads, levers)
    wanted = np.stack(
        [
            friction.limit_surface(load).project(row, length=lever)
            for row, load, lever in zip(rows, loads, levers)
        ]
    )
    assert worst(made, wanted, MU * loads[:, None] * size) < most
    inside = surface.gauge(rows) < 1.0
    assert inside.any() and not inside.all()
    assert np.array_equal(made[inside], rows[inside])
    if friction is FOOT:
        return
    of = lambda rows, loads: (tj.gauge(friction, rows, loads), tj.normal(friction, rows))  # noqa: E731
    gauges, normals = jax.jit(of)(rows, loads)
    assert worst(gauges / surface.gauge(rows), 1.0, 1.0) < most
    assert worst(normals * size, surface.normal(rows) * size, 1.0) < most


def test_projections_have_the_derivatives_of_the_kernel_and_of_differences(nearest) -> None:
    kernel = _gradients.derivatives_of(DISK.patch)
    rows, loads = wrenches(100, RADIUS), np.linspace(0.5, 2.0, 100)
    given = given_of(rows, loads)
    _, slope, second = map(np.asarray, nearest(given))
    unit = np.array([1.0, 1.0, RADIUS])
    wanted = kernel.project_jacobian(MU * loads, rows, RADIUS)
    assert worst(slope[..., :3] * unit / unit[:, None], wanted * unit / unit[:, None], 1.0) < 1e-14
    assert np.isfinite(second).all()
    outside = DISK.limit_surface(loads).gauge(rows) > 1.05
    for axis in range(7):
        move = np.zeros(7)
        move[axis] = 1e-6 * max(given[:, axis].max(), 1e-3)
        change = (nearest(given + move)[1] - nearest(given - move)[1]) / (2.0 * move[axis])
        exact = second[..., axis]
        span = np.abs(exact).max((1, 2), keepdims=True) + 1.0
        assert worst(change[outside], exact[outside], span[outside]) < 1e-5


def test_a_set_without_load_is_a_point(nearest) -> None:
    rows = wrenches(100, RADIUS)
    none, slopes, _ = nearest(given_of(rows, 0.0))
    assert not none.any()
    assert np.isinf(tj.gauge(DISK, rows, 0.0)).all()
    least, slopes_of_least, _ = nearest(given_of(rows, 1e-7))
    assert np.allclose(slopes[:, :, 3], slopes_of_least[:, :, 3], rtol=1e-5, atol=1e-9)
    assert np.allclose(slopes[:, :, 3], least / 1e-7, rtol=1e-5, atol=1e-9)


@pytest.mark.parametrize("friction", [DISK, FOOT], ids=lambda one: one.patch.kind)
def test_planar_steps_are_those_of_the_kernel(friction: tribos.Friction, as_users: Any) -> None:
    rng = np.random.default_rng(5)
    arm = friction.patch.radius
    twists = rng.normal(size=(1000, 3)) * [1.0, 1.0, 1.0 / arm]
    twists *= np.exp(rng.uniform(-10.0, 1.0, size=(1000, 1)))
    pushes, loads = wrenches(1000, arm, 4.0), np.linspace(0.5, 2.0, 1000)
    body = {**BODY, "inertia": 0.17 * (0.7 * arm) ** 2}
    step = partial(tj.planar_step, friction, **body)
    made = (partial(as_users, step) if friction is DISK else step)(twists, pushes, loads)
    kernel = tribos.PlanarBody(friction, body["mass"], body["inertia"], load=loads)
    wanted = kernel.step(twists, pushes, body["dt"])
    assert np.array_equal(made.at_rest, wanted.at_rest) and 100 < np.sum(wanted.at_rest) < 900
    most = 2e-15 if friction is DISK else 1e-12
    assert worst(made.friction, wanted.friction, loads[:, None] * MU * [1.0, 1.0, arm]) < most
    assert not made.twists[made.at_rest].any()
    if friction is not DISK:
        return
    single = jax.jit(step)(*(x.astype(np.float32) for x in (twists, pushes, loads)))
    assert single.twists.dtype == np.float32
    same = np.asarray(single.at_rest) == wanted.at_rest
    assert same.mean() > 0.995
    near = np.abs(np.asarray(single.friction) - wanted.friction) / (
        loads[:, None] * MU * [1, 1, arm]
    )
    assert np.quantile(near.max(1), 0.99) < 2e-6


def test_a_planar_step_has_the_derivatives_of_the_kernel() -> None:
    rng = np.random.default_rng(6)
    twists = rng.normal(size=(200, 3)) * [1.0, 1.0, 25.0] * np.exp(rng.uniform(-8, 1, (200, 1)))
    pushes, loads = wrenches(200, RADIUS, 4.0), np.linspace(0.5, 2.0, 200)

    def after(twist, push, load, mass, inertia, dt):
        return tj.planar_step(DISK, twist, push, load, mass=mass, inertia=inertia, dt=dt).twists

    by = jax.jit(jax.vmap(jax.jacrev(after, argnums=range(6)), in_axes=(0, 0, 0, None, None, None)))
    made = by(twists, pushes, loads, *BODY.values())
    wanted = tribos.planar_step_jacobian(DISK, twists, pushes, loads, **BODY).twists_by
    for got, exact in zip(made, wanted, strict=True):
        assert np.isfinite(got).all()
        assert worst(got, exact, np.abs(exact).max()) < 1e-11


def test_a_scan_is_a_loop_of_the_kernel_and_has_its_derivative() -> None:
    body = {**BODY, "dt": 0.002}

    @jax.jit
    @jax.vmap
    @jax.value_and_grad
    def travel(spin, mu):
        def one(twist, _):
            after = tj.planar_step(DISK, twist, jnp.zeros(3), 1.7, mu=mu, **body).twists
            return after, 0.001 * (twist[0] + after[0])

        start = jnp.array([1.0, 0.0, 0.0]).at[2].set(spin)
        return jnp.sum(jax.lax.scan(one, start, length=300)[1])

    # Differences of spins, and a coefficient for each world.
    spins, mu = jnp.array([20.0, 20.001, 19.999, 20.0]), jnp.array([MU, MU, MU, 0.4])
    ways, slopes = travel(spins, mu)
    kernel = tribos.PlanarBody(DISK, body["mass"], body["inertia"], load=1.7)
    course = kernel.rollout([1.0, 0.0, 20.0], np.zeros((300, 3)), body["dt"])
    assert np.isclose(ways[0], course.poses[-1, 0], rtol=1e-12) and ways[3] < ways[0]
    assert np.isclose(slopes[0], (ways[1] - ways[2]) / 0.002, rtol=1e-5)


@pytest.mark.parametrize("friction", [DISK, FOOT], ids=lambda one: one.patch.kind)
def test_softened_friction_is_the_gradient_of_a_convex_potential(friction: tribos.Friction) -> None:
    soft, load, (x, y) = 1e-2, 2.0, friction.patch.centre

    def power(twist):
        return tj.support(friction, twist, load, soft=soft)

    @jax.jit
    @jax.vmap
    def every(twist):
        force = tj.wrench(friction, twist, load, soft=soft)
        slopes = tj.jacobian(friction, twist, load, soft=soft)
        gradient = jax.grad(power)
        # A polygon's slopes are compiled for long: of its friction.
        second = jax.jacfwd(gradient)(twist) if friction is DISK or LONG else -slopes
        return force, slopes, gradient(twist), second

    arm = friction.patch.radius
    rows = np.concatenate([motions(40, arm), 1e-4 * motions(40, arm), np.zeros((1, 3))])
    force, slopes, gradient, hessian = (np.asarray(part) for part in every(rows))
    size = MU * load * np.array([1.0, 1.0, arm + np.hypot(x, y)])
    unit = size[:, None] * size / (MU * load)
    assert worst(force, -gradient, size) < 1e-14
    largest = np.abs(slopes / unit).max((1, 2), keepdims=True)
    assert worst(slopes / unit, -hessian / unit, largest) < 1e-13
    # Convex up to rounding, and dry friction D/sqrt(D² + soft²) times.
    least = np.linalg.eigvalsh(-slopes / unit).min(1)
    assert np.all(least > -1e-12 / soft)
    dry = friction.wrench(rows, load)
    power_per = -np.sum(dry * rows, -1) / (MU * load)
    share = power_per / np.hypot(power_per, soft)
    assert worst(force, share[:, None] * dry, size) < 1e-14
    # At rest: -mu N/soft (1, 1, T²) about the centre of pressure.
    assert not force[-1].any()
    spinning = np.array([y, -x, 1.0])
    arm_of_spin = -friction.wrench(spinning, 1.0) @ spinning / MU
    wanted = -MU * load / soft * np.array([1.0, 1.0, arm_of_spin**2])
    about = np.array([[1.0, 0.0, y], [0.0, 1.0, -x], [0.0, 0.0, 1.0]])
    assert np.allclose(about.T @ slopes[-1] @ about, np.diag(wanted), rtol=1e-12, atol=1e-12)


def test_results_have_the_type_of_the_motions() -> None:
    twist = np.array([1.0, 0.2, 20.0])
    load, mu = np.float64(1.7), np.float64(0.3)
    exact = DISK.wrench(twist, 1.7)
    for dtype, digits in ((jnp.float32, 1e-6), (jnp.bfloat16, 1e-2), (jnp.float16, 1e-3)):
        made = tj.wrench(DISK, jnp.asarray(twist, dtype), load, mu=mu, radius=np.float64(RADIUS))
        assert made.dtype == dtype and np.allclose(np.asarray(made, float), exact, rtol=digits)
    assert tj.wrench(DISK, jnp.array([1, 0, 20]), 1.7).dtype == jnp.float64
    jax.config.update("jax_enable_x64", False)
    assert tj.wrench(DISK, twist, load).dtype == jnp.float32


def test_a_softening_of_zero_leaves_nothing_at_rest_and_a_negative_load_no_number() -> None:
    loads, soft = jnp.array([2.0, 2.0, -2.0]), jnp.array([0.0, 0.1, 0.0])
    rows = np.array([[0.0] * 3, [0.0] * 3, [1.0, 0.0, 0.0]])
    made = np.asarray(tj.jacobian(DISK, rows, loads, soft=soft))
    assert not made[0].any() and np.isclose(made[1, 0, 0], -MU * 2.0 / 0.1, rtol=1e-12)
    assert np.isnan(made[2]).all()


def test_a_gauge_without_load_passes_zero_on_from_the_kernel() -> None:
    def grown(wrenches, loads):
        made = tj.gauge(DISK, wrenches, loads, backend="callback")
        return jnp.sum(jnp.where(jnp.isinf(made), 0.0, made))

    rows = jnp.array([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]])
    by_rows, by_loads = jax.grad(grown, argnums=(0, 1))(rows, jnp.array([0.0, 4.0]))
    assert not by_rows[0].any() and by_loads[0] == 0.0
    assert np.allclose(by_rows[1], [0.0, 1.0 / (4.0 * MU), 0.0], rtol=1e-9)


def test_frictions_of_one_kind_share_a_program() -> None:
    tj.wrench(DISK, np.ones((5, 3)), 1.0)
    before = _jax_native.wrench._cache_size()
    for mu, radius in ((0.2, 0.1), (0.5, 0.3)):
        friction = tribos.Friction(tribos.disk(radius), mu=mu)
        made = tj.wrench(friction, np.ones((5, 3)), 1.0)
        assert np.allclose(made, friction.wrench(np.ones(3), 1.0), rtol=1e-14)
    assert _jax_native.wrench._cache_size() == before


def test_sizes_and_coefficients_of_each_row() -> None:
    twists, mu, radius = motions(6), np.linspace(0.1, 0.6, 6), np.linspace(0.01, 0.06, 6)
    together = tj.wrench(DISK, twists, 2.0, mu=mu, radius=radius)
    for n in range(6):
        own = tribos.Friction(tribos.disk(radius[n]), mu=mu[n])
        assert np.allclose(together[n], own.wrench(twists[n], 2.0), rtol=1e-13, atol=1e-18)
    # A triangle as a polygon of four corners, of which one repeats.
    corners = np.array([CORNERS, [CORNERS[0], CORNERS[1], CORNERS[2], CORNERS[2]]])
    made = tj.wrench(FOOT, np.ones((2, 3)), 2.0, corners=corners)
    triangle = tribos.Friction(tribos.polygon(CORNERS[:3]), mu=MU)
    assert np.allclose(made[0], FOOT.wrench(np.ones(3), 2.0), rtol=1e-13)
    assert np.allclose(made[1], triangle.wrench(np.ones(3), 2.0), rtol=1e-13)
    # Without a form mu may be an array too.
    pipe = tribos.Friction(tribos.annulus(0.02, 0.04), mu=0.1)
    wanted = pipe.wrench(twists, 2.0) * (mu / 0.1)[:, None]
    assert np.allclose(tj.wrench(pipe, twists, 2.0, mu=mu), wanted, rtol=1e-13, atol=1e-18)


def test_the_kernel_serves_on_demand_and_where_there_is_no_form() -> None:
    twists = motions(20)
    assert np.array_equal(
        tj.wrench(DISK, twists, 2.0, backend="callback"), DISK.wrench(twists, 2.0)
    )
    slopes = tj.jacobian(tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.0), twists, 2.0)
    wanted = tribos.Friction(tribos.disk(0.1), mu=0.3, alpha=1.0).jacobian(twists, 2.0)
    assert np.allclose(slopes, wanted, rtol=1e-14)


def test_what_is_wrong_is_refused_in_words() -> None:
    viscous = tribos.Friction(tribos.disk(0.1), mu=0.5, alpha=0.5)
    twist = jnp.ones(3)
    for words, call in {
        "no form in XLA": lambda: tj.wrench(viscous, twist, 1.0, backend="xla"),
        "backend must be one of": lambda: tj.wrench(DISK, twist, 1.0, backend="gpu"),
        "mu= takes the place": lambda: tj.wrench(viscous, twist, 1.0, mu=0.3),
        "soft goes with": lambda: tj.wrench(viscous, twist, 1.0, soft=1e-3),
        "radius goes with": lambda: tj.wrench(DISK, twist, 1.0, radius=0.1, backend="callback"),
        "radius= is not for": lambda: tj.wrench(FOOT, twist, 1.0, radius=0.1),
        "corners= is not for": lambda: tj.wrench(DISK, twist, 1.0, corners=CORNERS),
        r"shape \(..., n, 2\)": lambda: tj.wrench(FOOT, twist, 1.0, corners=np.ones((4, 3))),
        r"shape \(..., 3\)": lambda: tj.wrench(DISK, jnp.ones(2), 1.0),
        "do not fit": lambda: tj.wrench(DISK, jnp.ones((4, 3)), jnp.ones(3)),
        "load must be >= 0": lambda: tj.gauge(DISK, twist, -1.0),
        "radius must be > 0": lambda: tj.normal(DISK, twist, radius=0.0),
        "mass must be > 0": lambda: tj.planar_step(DISK, twist, twist, 1.0, **{**BODY, "mass": 0}),
        "must be a tribos.Friction": lambda: tj.support(tribos.disk(0.1), twist, 1.0),
        "slide: friction must be": lambda: tj.slide(tribos.disk(0.1), 1.0, 1.0),
        "must be real numbers": lambda: tj.wrench(DISK, twist + 0j, 1.0),
        "shapes do not fit": lambda: tj.slide(DISK, jnp.ones(2), jnp.ones(3)),
        "k must be > 0": lambda: tj.manifold_friction(twist[:2], 0, 1, 1, k=0, kt=1),
        "steps must be": lambda: tj.manifold_friction(twist[:2], 0, 1, 1, k=1, kt=1, steps=0),
    }.items():
        with pytest.raises(ValueError, match=words):
            call()
    with pytest.raises(NotImplementedError, match="tribos.jax.support of .*first derivatives only"):
        power = lambda t: tj.support(DISK, t, 1.0, backend="callback")  # noqa: E731
        jax.hessian(power)(twist)


def test_what_is_out_of_its_domain_is_refused_or_gives_nan() -> None:
    puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    box = tribos.Friction(tribos.box(0.3, 0.2), mu=0.3)
    twist, none = jnp.array([1.0, 0.0, 20.0]), jnp.zeros(3)
    body = {"mass": 0.17, "inertia": 1.36e-4, "dt": 1e-3}

    @jax.jit
    def traced(x: jax.Array) -> list[jax.Array]:
        made = [tj.wrench(puck, twist, 1.7, radius=x), tj.project(puck, twist, 1.7, length=x)]
        for key in body:
            step = tj.planar_step(puck, twist, none, 1.7, **{**body, key: x})
            made += [step.twists, step.friction]
        return made

    assert np.isfinite(traced(1e-3)).all()
    for x in (0.0, -1e-3):
        assert np.isnan(traced(x)).any(axis=-1).all()
    for x in (0.0, -1e-3):
        with pytest.raises(ValueError, match="dt must be > 0"):
            tj.planar_step(puck, twist, none, 1.7, **{**body, "dt": x})
    line = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]])
    with pytest.raises(ValueError, match="corners must bound an area"):
        tj.wrench(box, twist, 1.7, corners=line)
    # A pusher without direction and one without a velocity have no motion.
    for normal, velocity in (([0.0, 0.0], [0.0, 1.0]), ([0.0, 1.0], [jnp.nan, 1.0])):
        finger = tj.PointContact(jnp.array([0.0, -0.1]), jnp.array(normal), 0.3)
        assert np.isnan(tj.push(box, finger, jnp.array(velocity), 1.7).twist).all()
