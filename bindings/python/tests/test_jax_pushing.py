"""Pushes in JAX programs against those of the compiled half, and their derivatives against its differences."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import tribos
from tribos import _native

jax = pytest.importorskip("jax")
import jax.numpy as jnp  # noqa: E402
import tribos.jax as tj  # noqa: E402
from tribos._jax_sides import reach_on  # noqa: E402

MODES = np.array(["sticking", "sliding left", "sliding right", "separating"])
BOX, DISK = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4), tribos.Friction(tribos.disk(0.05), 0.3)
FINGER = tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
COUNT = 300


@pytest.fixture(autouse=True)
def double() -> Iterator[None]:
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", False)


def random_pushes(friction: tribos.Friction, count: int) -> np.ndarray:
    """Rows of place, normal, coefficient and velocity: on the lower side of a box, or around a circle."""
    rng = np.random.default_rng(1)
    if friction is BOX:
        place = np.stack([rng.uniform(-0.15, 0.15, count), np.full(count, -0.1)], axis=1)
        normal = np.broadcast_to([0.0, 2.0], (count, 2))
    else:
        angle = rng.uniform(-np.pi, np.pi, count)
        place = 0.05 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        normal = -place
    velocity = rng.normal(size=(count, 2)) + 0.7 * normal / np.linalg.norm(normal, axis=1)[:, None]
    mu = rng.uniform(0.0, 1.0, count)
    # A third is a tenth of a milliradian from an edge of the motion cone.
    cone = tribos.motion_cone(friction.limit_surface(20.0), tribos.PointContact(place, normal, mu))
    is_left, off = rng.random((count, 1)) < 0.5, 1e-4 * rng.choice([-1.0, 1.0], (count, 1))
    edge = np.where(is_left, cone.left.velocity, cone.right.velocity)
    beside = edge + off * edge[:, ::-1] * [-1.0, 1.0]
    velocity = np.where(np.arange(count)[:, None] % 3 == 0, beside, velocity)
    return np.concatenate([place, normal, mu[:, None], velocity], axis=1)


def split(rows: Any) -> tuple[Any, ...]:
    return rows[..., :2], rows[..., 2:4], rows[..., 4], rows[..., 5:7]


def compiled(friction: tribos.Friction, rows: Any) -> tribos.Push:
    *contact, velocity = split(rows)
    surface = friction.limit_surface(load=20.0)
    return tribos.push(surface, tribos.PointContact(*contact), velocity)


def traced(friction: tribos.Friction, rows: Any, load: Any = 20.0, **keys: Any) -> tj.Push:
    *contact, velocity = split(rows)
    return tj.push(friction, tj.PointContact(*contact), velocity, load, **keys)


def is_same(made: tj.Push, wanted: tribos.Push) -> None:
    assert set(wanted.mode) == set(MODES)
    np.testing.assert_array_equal(MODES[made.mode], wanted.mode)
    for name in ("twist", "contact_velocity", "slip", "wrench"):
        a, b = getattr(made, name), getattr(wanted, name)
        np.testing.assert_allclose(a, b, rtol=1e-9, atol=1e-12 * np.abs(b).max(), err_msg=name)


def differences(friction: tribos.Friction, rows: Any, step: float) -> tuple[Any, Any]:
    """Where the mode does not change within steps of the numbers, and the differences of twist and push over these."""
    ends = [
        compiled(friction, rows + sign * step * one) for one in np.eye(7) for sign in (1.0, -1.0)
    ]
    modes = np.stack([end.mode for end in ends])
    slopes = [
        np.concatenate([up.twist - down.twist, up.wrench - down.wrench], axis=-1) / (2.0 * step)
        for up, down in zip(ends[::2], ends[1::2], strict=True)
    ]
    return (modes == modes[0]).all(axis=0), np.stack(slopes, axis=-1)


def is_close(slopes: Any, wanted: Any, tolerance: float) -> None:
    """Equal to a share of each row's largest slope."""
    scale = np.abs(wanted).max(axis=tuple(range(1, wanted.ndim)), keepdims=True) + 1e-9
    np.testing.assert_allclose(slopes / scale, wanted / scale, atol=tolerance)


def test_pushes_of_a_box_and_their_slopes_are_those_of_the_compiled_half() -> None:
    def both(row: Any) -> Any:
        made = traced(BOX, row)
        return jnp.concatenate([made.twist, made.wrench]), made

    cone = tribos.motion_cone(BOX.limit_surface(20.0), FINGER)
    edges = [[0.05, -0.1, 0.0, 1.0, 0.3, *edge.velocity] for edge in (cone.right, cone.left)]
    # Through the centre without friction; along the side; no push.
    edges += [[0.0, -0.1, 0.0, 1.0, 0.0, 0.0, 1.0], [0.05, -0.1, 0.0, 1.0, 0.3, 1.0, 0.0]]
    edges += [[0.05, -0.1, 0.0, 1.0, 0.3, 0.0, 0.0]]
    rows = random_pushes(BOX, COUNT)
    every = np.concatenate([rows, edges])
    slopes, made = jax.jit(jax.vmap(jax.jacfwd(both, has_aux=True)))(every)
    is_same(jax.tree.map(lambda part: part[:COUNT], made), compiled(BOX, rows))
    is_settled, wanted = differences(BOX, rows, 1e-6)
    assert is_settled.sum() > 0.9 * COUNT
    is_close(slopes[:COUNT][is_settled], wanted[is_settled], 1e-6)
    # Where modes change slopes are finite, and without a push zero.
    assert np.isfinite(slopes).all() and not slopes[made.mode == 3].any()
    np.testing.assert_allclose(made.twist[COUNT + 2], [0.0, 1.0, 0.0], atol=1e-12)
    assert list(made.mode[COUNT + 3 :]) == [3, 3]
    np.testing.assert_array_equal(made.slip[COUNT + 3 :], [[1.0, 0.0], [0.0, 0.0]])


def test_slopes_by_size_coefficient_and_load_in_reverse_mode() -> None:
    rows = random_pushes(DISK, COUNT)
    weights = np.random.default_rng(2).normal(size=(COUNT, 6))

    def loss(rows: Any, radius: Any, mu: Any, load: Any) -> Any:
        made = traced(DISK, rows, load, radius=radius, mu=mu)
        return jnp.sum(jnp.concatenate([made.twist, made.wrench], axis=-1) * weights), made

    radius, mu = np.full(COUNT, 0.05), np.full(COUNT, 0.3)
    slopes = jax.jit(jax.grad(loss, argnums=(0, 1, 2, 3), has_aux=True))
    (by_rows, by_radius, by_mu, by_load), made = slopes(rows, radius, mu, 20.0)
    wanted = compiled(DISK, rows)
    is_same(made, wanted)
    is_settled, change = differences(DISK, rows, 1e-7)
    change = np.einsum("nij,ni->nj", change, weights)
    is_close(by_rows[is_settled], change[is_settled], 1e-5)
    # The push is in proportion to mu and load, on which the motion does not depend.
    pushed = np.sum(wanted.wrench * weights[:, 3:], axis=1)
    np.testing.assert_allclose(by_mu, pushed / 0.3, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(by_load, np.sum(pushed) / 20.0, rtol=1e-9)
    larger, smaller = (
        compiled(tribos.Friction(tribos.disk(0.05 + step), mu=0.3), rows) for step in (1e-7, -1e-7)
    )
    by = [getattr(larger, name) - getattr(smaller, name) for name in ("twist", "wrench")]
    by = np.sum(np.concatenate(by, axis=1) * weights, axis=1) / 2e-7
    settled = is_settled & (larger.mode == smaller.mode)
    is_close(by_radius[settled], by[settled], 1e-5)


def test_single_precision_is_kept() -> None:
    jax.config.update("jax_enable_x64", False)
    rows = random_pushes(DISK, COUNT)
    made, wanted = jax.jit(lambda rows: traced(DISK, rows))(jnp.asarray(rows)), compiled(DISK, rows)
    assert made.twist.dtype == made.wrench.dtype == jnp.float32
    speed = np.linalg.norm(rows[:, 5:], axis=1, keepdims=True)
    np.testing.assert_allclose(made.twist[:, :2] / speed, wanted.twist[:, :2] / speed, atol=1e-4)


# Paths.

INTERVALS = 16
SURFACE = DISK.limit_surface(2.0)


@pytest.fixture(scope="module")
def followed() -> Any:
    """Paths on a round patch from rows of place and coefficient, velocities, interval, start and reaches, with slopes of the
    end by place, coefficient and the first velocity: one program."""

    def of(numbers: Any, velocities: Any, dt: Any, start: Any, side: Any) -> Any:
        contact = tj.PointContact(numbers[:2], jnp.array([0.0, 3.0]), numbers[2])
        made = tj.push_along(
            DISK, contact, velocities + numbers[3:], 2.0, dt=dt, start=start, side=side
        )
        return jnp.append(made.position[-1], made.angle[-1]), made

    return jax.jit(jax.vmap(jax.jacrev(of, has_aux=True)))


CASES = [
    # Place and coefficient, velocity, duration, start, reach to both sides.
    ((0.005, -0.05, 0.3), (-0.001, 0.01), 2.0, (0.2, -0.1, 0.3), 9.0),
    ((0.005, -0.05, 0.3), (-0.001, 0.01), 4.0, (0.2, -0.1, 0.3), 9.0),
    ((0.01, -0.05, 0.0), (0.01, 0.01), 8.0, (0.0, 0.0, 0.0), 0.01),
    ((0.005, -0.05, 0.3), (-0.001, 0.01), 4.0, (0.0, 0.0, 0.0), 9.0),
]


def compiled_path(numbers: Any, velocity: Any, duration: float, start: Any, reach: float) -> Any:
    contact = tribos.PointContact(numbers[:2], [0.0, 3.0], numbers[2])
    keys = {"side": (reach, reach), "start": start, "samples": INTERVALS, "tolerance": 1e-11}
    return tribos.push_along(SURFACE, contact, velocity, duration, **keys)


def test_paths_are_those_of_the_compiled_half(followed: Any) -> None:
    numbers = np.array([[*case[0], 0.0, 0.0] for case in CASES])
    velocities = np.repeat([[case[1]] for case in CASES], INTERVALS, axis=1)
    # The last pusher changes its velocity at half time.
    velocities[3, INTERVALS // 2 :] = [0.004, 0.006]
    durations, starts, reaches = (np.array([case[k] for case in CASES]) for k in (2, 3, 4))
    dt = durations / INTERVALS
    slopes, made = followed(numbers, velocities, dt, starts, (reaches, reaches))
    wanted = compiled_path(*CASES[0])
    assert made.position.shape == (4, INTERVALS + 1, 2)
    assert len(set(wanted.push.mode)) == 1 and wanted.end == "done"
    for name in ("time", "position", "angle", "contact"):
        np.testing.assert_allclose(getattr(made, name)[0], getattr(wanted, name), atol=1e-8)
    np.testing.assert_allclose(made.push.wrench[0], wanted.push.wrench, atol=1e-6)
    np.testing.assert_array_equal(MODES[made.push.mode[0]], wanted.push.mode)
    # Errors fall with the fourth power of the number of steps.
    errors = [
        abs(made.angle[1, INTERVALS // 2] - wanted.angle[-1]),
        abs(made.angle[0, -1] - wanted.angle[-1]),
    ]
    assert 8.0 < errors[0] / errors[1] < 32.0
    # Slopes by the numbers.
    by = []
    for step in np.diag([1e-5, 1e-5, 1e-3, 1e-5, 1e-5]):
        ends = []
        for sign in (1.0, -1.0):
            at = numbers[0] + sign * step
            end = compiled_path(at[:3], velocities[0, 0] + at[3:], *CASES[0][2:])
            ends.append(np.append(end.position[-1], end.angle[-1]))
        by.append((ends[0] - ends[1]) / (2.0 * step.sum()))
    is_close(slopes[:1], np.transpose(by)[None], 1e-4)
    # The third slips off its side, and rests from then on.
    wanted = compiled_path(*CASES[2])
    assert wanted.end == "slipped" and made.end[2, 0] == 0 and made.end[2, -1] == 1
    np.testing.assert_allclose(made.time[2, -1], wanted.time[-1], rtol=1e-3)
    np.testing.assert_allclose(made.position[2, -1], wanted.position[-1], atol=1e-4)
    assert not made.push.twist[2, -1].any() and np.isfinite(slopes).all()
    # The fourth goes on from where another path ends.
    half = compiled_path(*CASES[3][:2], 2.0, *CASES[3][3:])
    there = (*half.contact[-1], 0.3)
    rest = compiled_path(there, [0.004, 0.006], 2.0, (*half.position[-1], half.angle[-1]), 9.0)
    np.testing.assert_allclose(made.position[3, -1], rest.position[-1], atol=1e-5)
    np.testing.assert_allclose(made.angle[3, -1], rest.angle[-1], atol=1e-4)


def test_a_pusher_leaves_a_round_body() -> None:
    left = tribos.PointContact([-0.05, 0.0], [1.0, 0.0], mu=0.1)
    velocities = jnp.broadcast_to(jnp.array([0.01, 0.004]), (100, 2))
    made = tj.push_along(DISK, left, velocities, 2.0, dt=0.4)
    wanted = tribos.push_along(SURFACE, left, [0.01, 0.004], 40.0, tolerance=1e-9)
    assert made.end[-1] == 2 and wanted.end == "separated"
    np.testing.assert_allclose(made.time[-1], wanted.time[-1], atol=0.4)
    np.testing.assert_allclose(np.linalg.norm(made.contact, axis=-1), 0.05, atol=1e-4)
    np.testing.assert_allclose(made.position[-1], wanted.position[-1], atol=1e-4)


def test_sides_are_those_of_the_outline() -> None:
    outer = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]]
    hole = [[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]]
    places = [[2.5, 1.0], [1.0, 3.0], [3.0, -0.1], [0.3, 0.2], [0.0, 0.0], [4.0, 0.3]]
    sides = np.array([_native.nearest_side([outer, hole], place) for place in places])
    at = tj.PointContact(jnp.array(places), jnp.array(2.0 * sides[:, 0]), 0.0)
    reach_of = jax.jit(reach_on)
    for loops in ([outer, hole], [outer[::-1], hole[::-1]]):
        reach = reach_of([jnp.array(loop) for loop in loops], at)
        np.testing.assert_allclose(np.transpose(reach), sides[:, 1], atol=1e-12)
    # Another normal is that of a flat pusher at a corner.
    corner = tj.PointContact(jnp.array([4.0, 0.0]), jnp.array([-1.0, 1.0]), 0.0)
    assert np.isinf(reach_of([jnp.array(outer)], corner)).all()


def test_wrong_pushes_are_refused() -> None:
    two = jnp.ones((2, 2))
    for keys, text in [
        ({"side": "flat"}, "round"),
        ({"side": (1.0,)}, "two"),
        ({"steps": 0}, "steps"),
        ({"start": jnp.zeros(2)}, "start"),
        ({"corners": jnp.zeros((4, 2)), "backend": "callback"}, "corners"),
    ]:
        with pytest.raises(ValueError, match=text):
            tj.push_along(BOX, FINGER, two, 20.0, **{"dt": 1.0, **keys})
    with pytest.raises(ValueError, match="velocity"):
        tj.push(BOX, FINGER, jnp.zeros(3), 20.0)
    with pytest.raises(ValueError, match="load"):
        tj.push(BOX, FINGER, jnp.zeros(2), 0.0)
