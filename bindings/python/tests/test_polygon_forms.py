"""Polygons and manifolds in operations of JAX.

TRIBOS_LONG=1: second derivatives in single precision, too.
"""

from functools import partial

import numpy as np
import pytest
import tribos
from conftest import LONG

jax = pytest.importorskip("jax")
jnp = jax.numpy

from tribos._forms import manifold, xla  # noqa: E402
from tribos._forms.polygon import Flat  # noqa: E402

# Padded to as many corners, so that both share what is compiled.
PLANK = np.array([[-2, -0.5], [2, -0.5], [2, 0.5], [-2, 0.5], [-2, 0.5], [-2, 0.5]])
CORNER = np.array([[0.0, 0.0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]])

# Line integrals about the centre of rotation in 70 digits by mpmath: corners, twist, friction per mu N.
FRICTION = [
    (PLANK, [0.3, -0.2, 0.5], [-0.53700364263324051, 0.18989435916304348, -0.87748748984395584]),
    (PLANK, [1.0, 0.5, 0.0], [-0.89442719099991588, -0.44721359549995794, 0.0]),
    (PLANK, [0.0, 0.0, 1.0], [0.0, 0.0, -1.060779397733901]),
    (PLANK, [1e-8, 2e-8, 1.0], [-1.0473562736305506e-8, -9.8986584618905382e-9, -1.0607793977339]),
    (PLANK, [-0.5, 2.0, 1.0], [0.32339188121646794, -0.88532112629673447, -0.18922060226609903]),
    (PLANK, [0.0, -0.5, -1.0], [0.0, 0.24730895375125717, 0.9989722288275391]),
    (PLANK, [1e-6, -1.0, 1e-9], [-9.9999999999949996e-7, 0.9999999999995, -8.3333333334541672e-11]),
    (CORNER, [0.3, -0.2, 0.5], [0.22550358531222691, -0.41158472223590513, -1.1324023670926145]),
    (CORNER, [1.0, 0.5, 0.0], [-0.89442719099991588, -0.44721359549995794, 0.37267799624996495]),
    (CORNER, [0.0, 0.0, 1.0], [0.63018325975399252, -0.63018325975399252, -1.3268905373624621]),
    (CORNER, [0.5, -1.25, 1.0], [0.25987072536558572, 0.35452748126926897, -0.53000930586723228]),
    (CORNER, [0.0, -0.5, -1.0], [-0.49695115850840613, 0.79100748127651687, 1.292263351959106]),
]


@pytest.fixture(autouse=True)
def double():
    with jax.enable_x64(True):
        yield


@jax.jit
def wrench(twists, corners):
    return Flat(corners).wrench(xla, twists)


@jax.jit
def matrix(twists, corners):
    parts = Flat(corners).hessian(xla, twists)
    rows = jnp.stack([parts[at] for at in (0, 1, 3, 1, 2, 4, 3, 4, 5)], -1)
    return rows.reshape((*twists.shape, 3))


@jax.jit
@partial(jax.vmap, in_axes=(0, None))
def rates(twist, corners):
    return jax.jacfwd(wrench, argnums=(0, 1))(twist, corners)


@jax.jit
@partial(jax.vmap, in_axes=(0, None))
def bends(twist, corners):
    def power(twist, corners):
        return wrench(twist, corners) @ jnp.array([1.0, 2.0, 3.0], twist.dtype)

    return jax.jacfwd(jax.grad(power, argnums=(0, 1)), argnums=(0, 1))(twist, corners)


@jax.jit
def nearest(wrenches, corners, length):
    form = Flat(corners).per(xla, length)
    found = form.nearest(xla, wrenches / jnp.array([1.0, 1.0, length]))
    return found.points * jnp.array([1.0, 1.0, length]), found.beyond


@jax.jit
def ray(wrenches, corners):
    return Flat(corners).ray(xla, wrenches)


def surface(corners):
    return tribos.Friction(tribos.polygon(corners), mu=1.0).limit_surface(load=1.0)


def outline(corners):
    """Without the corners that repeat."""
    return corners[:4] if corners is PLANK else corners


def hard_twists():
    """Twists about centres at 1e-8 to 1e8, on corners, on edges, at rest, sliding."""
    random = np.random.default_rng(5)
    angles, spins = random.uniform(0.0, 6.3, 90), random.choice([-1.0, 1.0, 1e-3], 90)
    away = 10.0 ** np.linspace(-8.0, 8.0, 90)
    shares = np.linspace(0.0, 1.0, 9)[:, None]
    edges = [a * shares + b * (1.0 - shares) for a, b in zip(CORNER, np.roll(CORNER, 1, 0))]
    centres = np.concatenate(
        [away[:, None] * np.stack([np.cos(angles), np.sin(angles)], 1), *edges]
    )
    spins = np.concatenate([spins, np.ones(len(centres) - 90)])
    about = np.stack([spins * centres[:, 1], -spins * centres[:, 0], spins], 1)
    rest = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, -1e-12, 0.0], [0.0, 0.0, 1e12]]
    return np.concatenate([about, rest])


def first_of_many(twist):
    """A twist before others, of the shape that is compiled already."""
    return jnp.array(np.concatenate([[twist], hard_twists()[1:]]))


def test_friction_is_that_of_line_integrals():
    for corners, twist, expected in FRICTION:
        limits = np.array([1.0, 1.0, np.hypot(*CORNER.T).max()])
        found = wrench(jnp.array(twist), jnp.array(corners))
        assert np.all(np.abs(found - np.array(expected)) < 1e-15 * limits), twist
        single = wrench(jnp.array(twist, jnp.float32), jnp.array(corners, jnp.float32))
        assert single.dtype == jnp.float32
        assert np.all(np.abs(single - np.array(expected)) < 3e-7 * limits), twist


def test_friction_and_its_rates_are_the_kernels():
    twists = hard_twists()
    for corners in (PLANK, CORNER):
        exact = tribos.Friction(tribos.polygon(outline(corners)), mu=1.0)
        found = wrench(jnp.array(twists), jnp.array(corners))
        assert np.abs(found - exact.wrench(twists, 1.0)).max() < 5e-15
        jacobian = exact.jacobian(twists, 1.0)[:-4]
        scale = np.abs(jacobian).max((1, 2), keepdims=True)
        for made in (-matrix(twists, corners), rates(twists, corners)[0]):
            assert np.abs((made[:-4] - jacobian) / scale).max() < 3e-14


def test_rates_by_corners_are_differences_of_the_kernel():
    twist, step = np.array([0.3, -0.2, 0.5]), 1e-5
    made = rates(first_of_many(twist), jnp.array(CORNER))[1][0]
    for corner, axis in np.ndindex(CORNER.shape):

        def moved(by, corner=corner, axis=axis):
            corners = CORNER.copy()
            corners[corner, axis] += by
            return tribos.Friction(tribos.polygon(corners), mu=1.0).wrench(twist, 1.0)

        differences = (moved(step) - moved(-step)) / (2.0 * step)
        assert np.abs(made[:, corner, axis] - differences).max() < 1e-9


def test_sense_of_rotation_and_repeated_corners_make_no_difference():
    twists = hard_twists()
    found = wrench(jnp.array(twists), jnp.array(CORNER))
    turned = wrench(jnp.array(twists), jnp.array(CORNER[::-1].copy()))
    assert np.abs(found - turned).max() < 2e-15


def test_derivatives_are_finite_everywhere():
    for number in (np.float32, np.float64):
        for corners in (PLANK, CORNER):
            twists = jnp.array(hard_twists(), number)
            given = jnp.array(corners, number)
            made = [wrench(twists, given), rates(twists, given)]
            if number is np.float64 or LONG:
                made.append(bends(twists, given))
            for leaf in jax.tree.leaves(made):
                assert leaf.dtype == number and bool(jnp.isfinite(leaf).all())
            # At rest there is no friction, and no derivative of it.
            rest = jax.tree.leaves(jax.tree.map(lambda leaf: leaf[-4], made))
            assert all(not bool(leaf.any()) for leaf in rest)


def test_second_derivatives_are_differences_of_first_ones():
    twist, step = np.array([0.3, -0.2, 0.5]), 1e-5
    weights = np.array([1.0, 2.0, 3.0])

    def first(twist, corners):
        return [one[0] for one in rates(first_of_many(twist), jnp.array(corners))]

    (second, mixed), (_, by_corners) = bends(first_of_many(twist), jnp.array(CORNER))
    # Differences of this step are right to 3e-8.
    for axis in range(3):
        nudge = step * np.eye(3)[axis]
        ahead, behind = first(twist + nudge, CORNER), first(twist - nudge, CORNER)
        differences = [(a - b) / (2.0 * step) for a, b in zip(ahead, behind)]
        assert np.abs(weights @ differences[0] - second[0, axis]).max() < 2e-7
        assert np.abs(np.tensordot(weights, differences[1], 1) - mixed[0, axis]).max() < 2e-7
    nudge = np.zeros(CORNER.shape)
    nudge[3, 1] = step
    ahead, behind = first(twist, CORNER + nudge), first(twist, CORNER - nudge)
    differences = np.tensordot(weights, (ahead[1] - behind[1]) / (2.0 * step), 1)
    assert np.abs(differences - by_corners[0, :, :, 3, 1]).max() < 2e-7


def pushes(limits, count=300):
    """Wrenches inside, next to the surface and far outside."""
    random = np.random.default_rng(2)
    made = random.normal(size=(count, 3)) * [1.0, 1.0, limits.torque_limit]
    made = limits.scale_to_surface(made)
    third = count // 3
    made[:third] *= 1.0 + random.choice([-1, 1], (third, 1)) * 10.0 ** random.uniform(
        -11, -1, (third, 1)
    )
    made[third:] *= 10.0 ** random.uniform(-1.0, 2.0, (count - third, 1))
    return made


def test_rays_and_nearest_points_are_the_kernels():
    for corners in (PLANK, CORNER):
        limits = surface(outline(corners))
        given = pushes(limits)
        normals, gauges = ray(jnp.array(given), jnp.array(corners))
        exact = limits.gauge(given)
        assert np.abs(gauges / exact - 1.0).max() < 1e-14
        expected = limits.normal(given)
        expected /= np.linalg.norm(expected, axis=1, keepdims=True)
        assert np.abs(normals - expected).max() < 3e-13
        scale = np.array([1.0, 1.0, limits.torque_limit])
        for length in (0.2, 2.0, 20.0):
            points, beyond = nearest(jnp.array(given), jnp.array(corners), length)
            assert np.array_equal(beyond > 0.0, exact > 1.0)
            outside = exact > 1.0
            off = (points - limits.project(given, length=length)) / scale
            assert np.abs(off[outside]).max() < 1e-12


def test_searches_in_single_precision():
    limits = surface(CORNER)
    given = pushes(limits).astype(np.float32)
    single = jnp.array(CORNER, jnp.float32)
    exact = limits.gauge(given.astype(float))
    points, _ = nearest(jnp.array(given), single, jnp.float32(2.0))
    assert points.dtype == jnp.float32
    off = (points - limits.project(given.astype(float), length=2.0))[exact > 1.0 + 1e-5]
    assert np.abs(off).max() < 1e-5


# Impulses of tribos_manifold_friction.h, compiled without contraction: curve, p, t, F, lever, k, kt, slip, what is carried.
MANIFOLDS = [
    ("area", (0.4, 0.0), 0.01, 0.05, 0.09, 2.0, 500.0, 1.0, (0.04524843, 0.0, 0.0015126163)),
    ("area", (3.0, -4.0), -0.2, 1.5, 0.1, 0.5, 80.0, 1.0, (0.7847137, -1.0462849, -0.059045874)),
    ("area", (0.0, 0.0), 0.5, 1.0, 0.2, 1.0, 25.0, 1.0, (0.0, 0.0, 0.19999999)),
    ("area", (2.0, 1.0), 0.0, 0.7, 0.05, 1.0, 1.0, 1.0, (0.626099, 0.3130495, 0.0)),
    ("area", (0.6, 0.3), 0.03, 0.7, 0.05, 1.0, 300.0, 0.5, (0.6, 0.3, 0.03)),
    ("points", (0.4, 0.0), 0.01, 0.05, 0.09, 2.0, 500.0, 1.0, (0.0460735, 0.0, 0.0012784017)),
    ("points", (3.0, -4.0), -0.2, 1.5, 0.1, 0.5, 80.0, 1.0, (0.79976475, -1.066353, -0.05077431)),
    ("ellipsoid", (0.4, 0.0), 0.01, 0.05, 0.09, 2.0, 500.0, 1.0, (0.04463596, 0.0, 0.0020277608)),
    (
        "ellipsoid",
        (3.0, -4.0),
        -0.2,
        1.5,
        0.1,
        0.5,
        80.0,
        1.0,
        (0.7876266, -1.0501689, -0.072580285),
    ),
]


@jax.jit
def carried(p, t, force, lever, k, kt, slip, curve):
    made = manifold.manifold_friction(
        xla, p, t, force, lever, k=k, kt=kt, slip=slip, curve=(curve[0], curve[1], curve[2])
    )
    return jnp.concatenate([made[0], made[1][..., None]], -1)


def columns(number):
    parts = list(zip(*MANIFOLDS))
    curves = np.array([manifold.CURVES[name] for name in parts[0]]).T
    return [jnp.array(np.array(part), number) for part in (*parts[1:8], curves)]


def test_manifolds_carry_what_the_header_says():
    given = columns(jnp.float32)
    expected = np.array([row[8] for row in MANIFOLDS])
    limits = np.array([[row[3], row[3], row[3] * row[4]] for row in MANIFOLDS])
    assert np.all(np.abs(carried(*given) - expected) < 5e-7 * limits)


@jax.jit
@partial(jax.grad, argnums=(0, 1, 2, 3, 4, 5, 6))
def slopes_of_manifolds(p, t, force, lever, k, kt, slip, curve, weights):
    return (weights * carried(p, t, force, lever, k, kt, slip, curve)).sum()


def test_derivatives_of_manifolds_are_finite_and_those_of_the_nearest_point():
    *given, curves = map(np.array, columns(jnp.float32))
    # After all of them the last two, on ellipsoids, once for each component.
    again = [*range(9), *(7, 8) * 3]
    weights = np.concatenate([np.ones((9, 3)), np.repeat(np.eye(3), 2, 0)])
    given, curves = [column[again] for column in given], curves[:, again]
    # Without any impulse, without lever, without load.
    given[0][4], given[1][4], given[3][6], given[2][8] = 0.0, 0.0, 0.0, 0.0
    slopes = slopes_of_manifolds(*given, curves, np.float32(weights))
    assert all(bool(jnp.isfinite(leaf).all()) for leaf in slopes)
    # On the ellipsoid the nearest point solves λ: p = x + λ x/(k F²), found here by bisection.

    def solved(p, t, force, lever, k, kt):
        a, b = k * force**2, kt * (force * lever) ** 2
        x, y = np.hypot(*p) / force, abs(t) / (force * lever)
        low, high = 0.0, 1e6
        for _ in range(200):
            mid = 0.5 * (low + high)
            outside = (a * x / (a + mid)) ** 2 + (b * y / (b + mid)) ** 2 > 1.0
            low, high = (mid, high) if outside else (low, mid)
        return np.array([*(p * a / (a + low)), t * b / (b + low)])

    for row in range(2):
        at = [column[9 + row].astype(float) for column in given[:6]]
        by = [0.1 * one for one in at]
        ahead, behind = (solved(*(a + s * b for a, b in zip(at, by))) for s in (1e-6, -1e-6))
        made = [
            sum(np.sum(slope[part] * one) for slope, one in zip(slopes, by))
            for part in range(9 + row, 15, 2)
        ]
        limits = np.array([at[2], at[2], at[2] * at[3]])
        assert np.abs(((ahead - behind) / 2e-6 - made) / limits).max() < 2e-3
