"""Derivatives of the kernel in JAX, by callback, against finite differences, in both modes and under its transformations."""

import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest
import tribos

jax = pytest.importorskip("jax")
import jax.numpy as jnp  # noqa: E402
import tribos.jax as tj  # noqa: E402
from jax.test_util import check_grads  # noqa: E402
from tribos._jax_callback import compiled  # noqa: E402

# Patches without a form in XLA.
DISK = tribos.Friction(tribos.annulus(0.001, 0.1), mu=0.5)
FRICTIONS = [DISK, tribos.Friction(tribos.box(0.2, 0.1, centre=(0.0, 0.0)), mu=0.5)]
TWISTS = np.array([[1.0, 0.3, 12.0], [0.1, -0.4, -3.0]])
PUSHES = np.array([[3.0, 4.0, 0.1], [-9.0, 1.0, 0.2]])
LOADS = np.array([10.0, 7.0])
BODY = {"mass": 2.0, "inertia": 0.006, "dt": 0.01}


@pytest.fixture(autouse=True)
def double() -> Iterator[None]:
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", False)


def check(of, *given, eps: float = 1e-5, tol: float = 1e-6) -> None:
    check_grads(of, given, order=1, modes=["fwd", "rev"], eps=eps, atol=tol, rtol=tol)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_wrench_and_support_have_the_slopes_of_differences(friction: tribos.Friction) -> None:
    check(lambda twists, load: tj.wrench(friction, twists, load), TWISTS, LOADS)
    check(lambda twists, load: tj.support(friction, twists, load), TWISTS, LOADS)
    # One load for all: its derivative is a sum.
    check(lambda twists, load: tj.wrench(friction, twists, load), TWISTS, 3.0)


def test_powers_and_softened_laws_have_slopes() -> None:
    for friction in (
        tribos.Friction(tribos.disk(0.1), mu=0.5, alpha=0.5),
        tribos.Friction(tribos.box(0.2, 0.1), mu=0.5, alpha=1.0),
        tribos.Friction(
            tribos.points([[0.1, 0], [-0.1, 0], [0, 0.2]]), law=tribos.softened(0.5, 0.1)
        ),
    ):
        check(lambda twists, load, made=friction: tj.wrench(made, twists, load), TWISTS, LOADS)
    soft = tribos.Friction(tribos.disk(0.1), law=tribos.softened(0.5, 0.1))
    at_rest = jax.jacrev(lambda twist: tj.wrench(soft, twist, 10.0))(jnp.zeros(3))
    assert np.allclose(np.diag(at_rest), [-50.0, -50.0, -50.0 * 0.1**2 / 2], rtol=1e-6)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_limit_surfaces_have_the_slopes_of_differences(friction: tribos.Friction) -> None:
    check(lambda wrenches, load: tj.gauge(friction, wrenches, load), PUSHES, LOADS)
    check(lambda wrenches: tj.normal(friction, wrenches), PUSHES, tol=1e-5)
    check(lambda wrenches, load: tj.project(friction, wrenches, load), 2 * PUSHES, LOADS)
    check(
        lambda wrenches, load: tj.project(friction, wrenches, load, length=0.03), 2 * PUSHES, LOADS
    )
    inside = jax.jacfwd(lambda wrench: tj.project(friction, wrench, 10.0))(0.1 * PUSHES[0])
    assert np.array_equal(inside, np.eye(3))
    # Without load the first friction grows along the projection.
    by_load = jax.jacfwd(lambda load: tj.project(friction, PUSHES[0], load))
    assert np.allclose(by_load(0.0), by_load(1e-7), rtol=1e-6)


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_a_planar_step_has_the_slopes_of_differences(friction: tribos.Friction) -> None:
    def step(twists, push, load, mass, inertia, dt):
        return tj.planar_step(friction, twists, push, load, mass=mass, inertia=inertia, dt=dt)[:2]

    # Sliding, and next to the end of the motion, in which friction turns it about.
    check(step, TWISTS, PUSHES, LOADS, 2.0, 0.006, 0.01, eps=1e-6)
    slow = np.array([[0.01, 0.0, 0.3], [0.012, -0.01, -0.3]])
    check(step, slow, 3 * PUSHES, LOADS, 2.0, 0.006, 0.01, eps=1e-6, tol=3e-6)


def test_a_step_into_rest_depends_on_nothing() -> None:
    def step(twist, push):
        return tj.planar_step(DISK, twist, push, 10.0, **BODY).twists

    by_twist, by_push = jax.jacrev(step, argnums=(0, 1))(
        jnp.array([1e-3, 0, 0]), jnp.array([1.0, 0, 0.01])
    )
    assert not by_twist.any() and not by_push.any()
    assert tj.planar_step(DISK, jnp.zeros(3), jnp.zeros(3), 10.0, **BODY).at_rest.dtype == bool


def test_a_row_at_rest_passes_zero_on_and_disturbs_no_other() -> None:
    at_rest = np.array([TWISTS[0], np.zeros(3), TWISTS[1]])
    for friction in FRICTIONS:
        of = lambda twist, made=friction: tj.wrench(made, twist, 7.0)  # noqa: E731
        slopes = jax.vmap(jax.jacrev(of))(at_rest)
        assert not slopes[1].any()
        assert np.array_equal(slopes[::2], jax.vmap(jax.jacfwd(of))(TWISTS))
        # The gradient of a mean is that without the row.
        mean = jax.grad(lambda size, of=of: jnp.mean(of(at_rest * size)))(1.0)
        moving = jax.grad(lambda size, of=of: jnp.sum(of(TWISTS * size)) / 9.0)(1.0)
        assert np.isclose(mean, moving, rtol=1e-12, atol=1e-12)
    assert not jax.grad(lambda wrench: tj.gauge(DISK, wrench, 7.0))(jnp.zeros(3)).any()
    # What is no number stays none, in its row.
    at_rest[1, 0] = np.nan
    slopes = jax.vmap(jax.jacrev(lambda twist: tj.wrench(DISK, twist, 7.0)))(at_rest)
    assert np.isnan(slopes[1]).any() and np.isfinite(slopes[::2]).all()


def test_second_derivatives_are_refused_in_words() -> None:
    with pytest.raises(NotImplementedError, match="first derivatives only"):
        jax.hessian(lambda twist: tj.support(DISK, twist, 7.0))(TWISTS[0])
    with pytest.raises(NotImplementedError, match="first derivatives only"):
        jax.jit(jax.grad(jax.grad(lambda load: tj.wrench(DISK, TWISTS[0], load)[0])))(7.0)


def test_calls_outside_of_jit_compile_once() -> None:
    friction = tribos.Friction(tribos.annulus(0.05, 0.1), mu=0.31)
    tj.wrench(friction, TWISTS, LOADS)
    before = compiled._cache_size()
    for _ in range(3):
        tj.wrench(tribos.Friction(tribos.annulus(0.05, 0.1), mu=0.31), TWISTS + 1.0, LOADS)
    assert compiled._cache_size() == before


def test_a_turned_box_has_the_slopes_of_differences() -> None:
    box = FRICTIONS[1]

    def step(twists, pushes, angle):
        return tj.planar_step(box, twists, pushes, 10.0, angle=angle, **BODY)[:2]

    angles = np.array([0.3, -1.0])
    check(step, TWISTS, PUSHES, angles, eps=1e-6)
    body = tribos.PlanarBody(box, BODY["mass"], BODY["inertia"], load=10.0)
    expected = body.step(TWISTS, PUSHES, BODY["dt"], angle=angles)
    for got, wanted in zip(step(TWISTS, PUSHES, angles), expected, strict=False):
        assert np.allclose(got, wanted, rtol=1e-12, atol=1e-14)


def test_a_slide_has_the_slopes_of_differences() -> None:
    disk = tribos.Friction(tribos.disk(0.08), mu=0.3)

    def way(speed, spin, gravity, radius):
        return tuple(tj.slide(disk, speed, spin, gravity=gravity, radius=radius))

    check(way, np.array([1.0, 2.0]), np.array([11.0, -5.0]), 10.0, 0.08, eps=1e-5)
    viscous = tribos.Friction(tribos.disk(0.08), mu=0.3, alpha=0.5)
    check(lambda speed: tj.slide(viscous, speed, 11.0).time, 1.0)


def swung(friction: tribos.Friction, steps: int):
    def cost(start, push, load):
        def one(twist, _):
            after = tj.planar_step(friction, twist, push, load, **BODY).twists
            return after, 0.01 * (twist + after) / 2

        _, ways = jax.lax.scan(one, start, length=steps)
        return jnp.sum(jnp.sum(ways, axis=0) * jnp.array([1.0, -0.5, 0.02]))

    return cost


@pytest.mark.parametrize("friction", FRICTIONS[:2], ids=repr)
def test_a_gradient_through_a_hundred_steps_is_that_of_differences(
    friction: tribos.Friction,
) -> None:
    cost = swung(friction, 100)
    starts = jnp.array([[4.0, 1.0, 60.0], [5.0, 0.5, -40.0], [3.0, -4.0, 100.0]])
    push, load = jnp.array([0.3, 0.1, 0.01]), 5.0
    slopes = jax.jit(jax.vmap(jax.grad(cost, argnums=(0, 1, 2)), in_axes=(0, None, None)))
    by_start, by_push, by_load = slopes(starts, push, load)
    value = jax.jit(jax.vmap(cost, in_axes=(0, None, None)))
    for axis in range(3):
        move = np.zeros(3)
        move[axis] = 1e-4
        change = (value(starts + move, push, load) - value(starts - move, push, load)) / 2e-4
        assert np.allclose(by_start[:, axis], change, rtol=1e-6, atol=1e-8)
        change = (value(starts, push + move, load) - value(starts, push - move, load)) / 2e-4
        assert np.allclose(by_push[:, axis], change, rtol=1e-6, atol=1e-8)
    change = (value(starts, push, load + 1e-4) - value(starts, push, load - 1e-4)) / 2e-4
    assert np.allclose(by_load, change, rtol=1e-6, atol=1e-8)


def test_a_map_gives_what_an_array_gives() -> None:
    rng = np.random.default_rng(2)
    twists, loads = rng.normal(size=(4, 5, 3)), rng.uniform(1, 2, size=(4, 5))
    whole = DISK.wrench(twists, loads)
    of = lambda twist, load: tj.wrench(DISK, twist, load)  # noqa: E731
    assert np.array_equal(jax.vmap(jax.vmap(of))(twists, loads), whole)
    assert np.array_equal(jax.jit(of)(twists, loads), whole)
    # An axis of one argument alone.
    outer = jax.vmap(of, in_axes=(None, 0))(twists[0], loads[:, 0])
    assert np.array_equal(outer, DISK.wrench(twists[0], loads[:, :1]))
    outer = jax.vmap(of, in_axes=(0, None))(twists, loads[0])
    assert np.array_equal(outer, DISK.wrench(twists, loads[0]))
    slopes = jax.vmap(jax.jacfwd(of), in_axes=(0, None))(twists[0], 1.0)
    assert np.allclose(slopes, DISK.jacobian(twists[0], 1.0), rtol=1e-14)
    assert np.array_equal(jax.vmap(of, in_axes=(1, 1), out_axes=1)(twists, loads), whole)


def test_single_precision_is_rounded_once() -> None:
    jax.config.update("jax_enable_x64", False)
    made = tj.wrench(DISK, jnp.array(TWISTS), jnp.array(LOADS))
    assert made.dtype == jnp.float32
    exact = DISK.wrench(TWISTS.astype(np.float32), LOADS)
    assert np.array_equal(made, exact.astype(np.float32))
    slope = jax.grad(lambda x: tj.support(DISK, x, 10.0))(jnp.array(TWISTS[0]))
    assert slope.dtype == jnp.float32 and np.allclose(slope, -exact[0], rtol=1e-6)
    step = jax.jit(lambda x: tj.planar_step(DISK, x, jnp.zeros(3), 10.0, **BODY))(
        jnp.array(TWISTS[0])
    )
    assert step.twists.dtype == jnp.float32


def test_frictions_may_be_static_arguments() -> None:
    of = jax.jit(tj.wrench, static_argnums=0)
    assert np.array_equal(of(DISK, TWISTS, 1.0), DISK.wrench(TWISTS, 1.0))


def test_wrong_shapes_and_laws_are_refused() -> None:
    with pytest.raises(ValueError, match="shape"):
        tj.wrench(DISK, jnp.zeros(2), 1.0)
    with pytest.raises(ValueError, match="no limit surface"):
        tj.gauge(tribos.Friction(tribos.disk(0.1), mu=0.5, alpha=0.5), jnp.ones(3), 1.0)


def test_a_step_on_four_feet_has_no_more_friction_than_they_carry() -> None:
    places = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]
    feet = tribos.Friction(tribos.points(places), mu=0.3)
    twists = np.random.default_rng(0).normal(size=(500, 3)) * [3.0, 3.0, 30.0]
    for dt in (1e-3, 1e-5, 1e-7):
        step = tj.planar_step(feet, twists, jnp.zeros(3), 50.0, mass=5.0, inertia=0.3, dt=dt)
        assert tj.gauge(feet, step.friction, 50.0).max() < 1.0 + 1e-9


def test_the_package_does_not_import_jax_by_itself() -> None:
    code = "import sys, tribos; assert 'jax' not in sys.modules and 'torch' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
