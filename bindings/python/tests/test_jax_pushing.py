"""Pushes in JAX programs against those of the compiled half, and their derivatives against its differences."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
import tribos

jax = pytest.importorskip("jax")
import jax.numpy as jnp  # noqa: E402
import tribos.jax as tj  # noqa: E402

MODES = np.array(["sticking", "sliding left", "sliding right", "separating"])
BOX, DISK = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4), tribos.Friction(tribos.disk(0.05), 0.3)
FRICTIONS = [BOX, DISK, tribos.Friction(tribos.ring(0.05), mu=0.3)]
FINGER = tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
COUNT = 400


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
    return np.concatenate([place, normal, rng.uniform(0.0, 1.0, (count, 1)), velocity], axis=1)


def split(rows: Any) -> tuple[Any, ...]:
    return rows[..., :2], rows[..., 2:4], rows[..., 4], rows[..., 5:7]


def compiled(friction: tribos.Friction, rows: Any) -> tribos.Push:
    *contact, velocity = split(rows)
    surface = friction.limit_surface(load=20.0)
    return tribos.push(surface, tribos.PointContact(*contact), velocity)


def traced(friction: tribos.Friction) -> Callable[..., tj.Push]:
    def of(rows: Any, load: Any = 20.0) -> tj.Push:
        *contact, velocity = split(rows)
        return tj.push(friction, tj.PointContact(*contact), velocity, load)

    return of


@pytest.mark.parametrize("friction", FRICTIONS, ids=repr)
def test_pushes_are_those_of_the_compiled_half(friction: tribos.Friction) -> None:
    rows = random_pushes(friction, COUNT)
    made, wanted = jax.jit(traced(friction))(rows), compiled(friction, rows)
    assert set(wanted.mode) == set(MODES)
    np.testing.assert_array_equal(MODES[made.mode], wanted.mode)
    for name in ("twist", "contact_velocity", "slip", "wrench"):
        a, b = getattr(made, name), getattr(wanted, name)
        np.testing.assert_allclose(a, b, rtol=1e-9, atol=1e-12 * np.abs(b).max(), err_msg=name)


def settled(friction: tribos.Friction, rows: Any, step: float) -> tuple[Any, Any]:
    """Pushes whose mode does not change within steps of their numbers, and the differences over these."""
    ends = [
        compiled(friction, rows + sign * step * one) for one in np.eye(7) for sign in (1.0, -1.0)
    ]
    modes = np.stack([end.mode for end in ends])
    slopes = [
        np.concatenate([up.twist - down.twist, up.wrench - down.wrench], axis=-1) / (2.0 * step)
        for up, down in zip(ends[::2], ends[1::2], strict=True)
    ]
    return (modes == modes[0]).all(axis=0), np.stack(slopes, axis=-1)


@pytest.mark.parametrize("friction", FRICTIONS[:2], ids=repr)
def test_slopes_of_pushes_are_those_of_differences(friction: tribos.Friction) -> None:
    rows = random_pushes(friction, 200)
    is_settled, wanted = settled(friction, rows, 1e-6)

    def both(row: Any) -> Any:
        made = traced(friction)(row)
        return jnp.concatenate([made.twist, made.wrench])

    slopes = jax.jit(jax.vmap(jax.jacfwd(both)))(rows)
    assert is_settled.sum() > 180
    scale = np.abs(wanted).max(axis=(1, 2), keepdims=True) + 1e-9
    np.testing.assert_allclose(
        (slopes / scale)[is_settled], (wanted / scale)[is_settled], atol=1e-6
    )
    # Reverse mode, by the load too: the push is in proportion to it, the motion does not depend on it.
    weights = np.random.default_rng(2).normal(size=(200, 6))

    def loss(rows: Any, load: Any) -> Any:
        made = traced(friction)(rows, load)
        return jnp.sum(jnp.concatenate([made.twist, made.wrench], axis=-1) * weights)

    by_rows, by_load = jax.jit(jax.grad(loss, argnums=(0, 1)))(rows, 20.0)
    np.testing.assert_allclose(by_rows, np.einsum("nij,ni->nj", slopes, weights), rtol=1e-9)
    pushed = np.sum(compiled(friction, rows).wrench * weights[:, 3:]) / 20.0
    np.testing.assert_allclose(by_load, pushed, rtol=1e-9)
    # All of them are finite, and zero where nothing is pushed.
    assert np.isfinite(slopes).all() and not slopes[compiled(friction, rows).mode == MODES[3]].any()


def test_slopes_at_the_edges_of_modes_are_finite() -> None:
    cone = tribos.motion_cone(BOX.limit_surface(20.0), FINGER)
    edges = [cone.right.velocity, cone.left.velocity]
    rows = [[0.05, -0.1, 0.0, 1.0, 0.3, *velocity] for velocity in edges]
    # A push through the centre without friction; one along the side; none.
    rows += [[0.0, -0.1, 0.0, 1.0, 0.0, 0.0, 1.0], [0.05, -0.1, 0.0, 1.0, 0.3, 1.0, 0.0]]
    rows += [[0.05, -0.1, 0.0, 1.0, 0.3, 0.0, 0.0]]
    slopes = jax.vmap(jax.jacfwd(lambda row: traced(BOX)(row).twist))(np.array(rows))
    assert np.isfinite(slopes).all()
    made = traced(BOX)(np.array(rows))
    np.testing.assert_allclose(made.twist[2], [0.0, 1.0, 0.0], atol=1e-12)
    assert MODES[made.mode[3]] == MODES[made.mode[4]] == "separating"
    assert np.array_equal(made.slip[3:], [[1.0, 0.0], [0.0, 0.0]])


def path(velocity: Any, intervals: int, duration: float, contact: Any = FINGER, **keys: Any) -> Any:
    velocities = jnp.broadcast_to(jnp.asarray(velocity), (intervals, 2))
    return tj.push_along(BOX, contact, velocities, 20.0, dt=duration / intervals, **keys)


def test_a_path_is_that_of_the_compiled_half() -> None:
    start, velocity = (0.2, -0.1, 0.3), [-0.003, 0.02]
    surface = BOX.limit_surface(20.0)
    keys = {"start": start, "samples": 8, "tolerance": 1e-11}
    wanted = tribos.push_along(surface, FINGER, velocity, 2.0, **keys)
    assert set(wanted.push.mode) == {"sliding left"} or set(wanted.push.mode) == {"sticking"}
    made = path(velocity, 8, 2.0, start=start, steps=4)
    for name in ("time", "position", "angle", "contact"):
        np.testing.assert_allclose(getattr(made, name), getattr(wanted, name), atol=1e-9)
    np.testing.assert_allclose(made.push.wrench, wanted.push.wrench, atol=1e-7)
    np.testing.assert_array_equal(MODES[made.push.mode], wanted.push.mode)
    assert not made.end.any()
    # Errors fall with the fourth power of the number of steps.
    errors = [
        abs(path(velocity, 1, 2.0, start=start, steps=n).angle[-1] - wanted.angle[-1])
        for n in (2, 4)
    ]
    assert 10.0 < errors[0] / errors[1] < 25.0


def test_a_pusher_may_change_its_velocity() -> None:
    surface = BOX.limit_surface(20.0)
    first = tribos.push_along(surface, FINGER, [0.0, 0.02], 2.0, samples=1, tolerance=1e-11)
    there = tribos.PointContact(first.contact[-1], [0.0, 1.0], mu=0.3)
    start = (*first.position[-1], first.angle[-1])
    second = tribos.push_along(
        surface, there, [0.01, 0.01], 2.0, start=start, samples=1, tolerance=1e-11
    )
    made = tj.push_along(BOX, FINGER, np.array([[0.0, 0.02], [0.01, 0.01]]), 20.0, dt=2.0, steps=16)
    for name in ("position", "angle", "contact"):
        both = [getattr(part, name)[-1] for part in (first, second)]
        np.testing.assert_allclose(getattr(made, name)[1:], both, atol=1e-5, err_msg=name)


def test_paths_end_where_the_side_ends_or_the_pusher_leaves() -> None:
    slippery = tribos.PointContact([0.12, -0.1], [0.0, 1.0], mu=0.0)
    made = path([0.01, 0.01], 40, 20.0, slippery)
    assert made.end[0] == 0 and made.end[-1] == 1
    np.testing.assert_allclose(made.contact[-1], [0.15, -0.1], atol=3e-5)
    assert not made.push.twist[-1].any() and made.time[-1] < 20.0
    # The sides are batched too.
    reach = jnp.array([0.005, 0.01, jnp.inf])
    made = path([0.01, 0.01], 10, 3.0, slippery, side=(reach, reach))
    assert made.position.shape == (3, 11, 2) and list(made.end[:, -1]) == [1, 1, 0]
    np.testing.assert_allclose(made.contact[:2, -1, 0], [0.125, 0.13], atol=3e-5)
    left = tribos.PointContact([-0.05, 0.0], [1.0, 0.0], mu=0.1)
    velocities = jnp.broadcast_to(jnp.array([0.01, 0.004]), (100, 2))
    made = tj.push_along(DISK, left, velocities, 2.0, dt=0.4)
    wanted = tribos.push_along(DISK.limit_surface(2.0), left, [0.01, 0.004], 40.0, tolerance=1e-9)
    assert made.end[-1] == 2 and wanted.end == "separated"
    np.testing.assert_allclose(made.time[-1], wanted.time[-1], atol=0.4)
    np.testing.assert_allclose(np.linalg.norm(made.contact, axis=-1), 0.05, atol=1e-4)


def test_slopes_of_a_path_are_those_of_differences() -> None:
    def end(numbers: Any) -> Any:
        contact = tj.PointContact(numbers[:2], jnp.array([0.0, 1.0]), numbers[2])
        made = path(numbers[3:5], 2, 2.0, contact, side=(0.2, 0.2), steps=16)
        return jnp.concatenate([made.position[-1], made.angle[-1:]])

    def exact(numbers: Any) -> Any:
        contact = tribos.PointContact(numbers[:2], [0.0, 1.0], numbers[2])
        keys = {"side": (0.2, 0.2), "samples": 1, "tolerance": 1e-12}
        made = tribos.push_along(BOX.limit_surface(20.0), contact, numbers[3:5], 2.0, **keys)
        return np.append(made.position[-1], made.angle[-1])

    at = np.array([0.05, -0.1, 0.3, -0.003, 0.02])
    steps = np.array([1e-4, 1e-4, 1e-3, 1e-5, 1e-5])
    wanted = [(exact(at + step) - exact(at - step)) / (2.0 * step.sum()) for step in np.diag(steps)]
    np.testing.assert_allclose(
        jax.jit(jax.jacrev(end))(at), np.transpose(wanted), rtol=1e-4, atol=1e-6
    )


def test_single_precision_is_kept() -> None:
    jax.config.update("jax_enable_x64", False)
    rows = random_pushes(DISK, COUNT)
    made, wanted = jax.jit(traced(DISK))(jnp.asarray(rows)), compiled(DISK, rows)
    assert made.twist.dtype == made.wrench.dtype == jnp.float32
    speed = np.linalg.norm(rows[:, 5:], axis=1, keepdims=True)
    np.testing.assert_allclose(made.twist[:, :2] / speed, wanted.twist[:, :2] / speed, atol=1e-4)


def test_wrong_pushes_are_refused() -> None:
    for keys, text in [
        ({"side": "flat"}, "round"),
        ({"side": (1.0,)}, "two"),
        ({"steps": 0}, "steps"),
    ]:
        with pytest.raises(ValueError, match=text):
            path([0.0, 0.02], 2, 1.0, **keys)
