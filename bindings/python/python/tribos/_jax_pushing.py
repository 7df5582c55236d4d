"""Quasi-static pushes in JAX programs."""

from __future__ import annotations

import operator
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from tribos._forms import pushed_path, pushing, xla
from tribos._forms.pushed_path import Journey
from tribos._forms.pushing import PointContact, Push
from tribos._friction import Friction
from tribos._patches import outline

# A contact with this angle to an edge's normal, in rad, is on that edge.
_PARALLEL = {"float64": 1e-9, "float32": 1e-5}


def _functions() -> Any:
    """Those of `tribos.jax`, which imports this module."""
    import tribos.jax

    return tribos.jax


class _Floor(NamedTuple):
    """Friction of a body on the floor, by the functions of `tribos.jax`."""

    friction: Friction
    limit: Any
    sizes: dict[str, Any]

    def wrench(self, twists: Any) -> Any:
        return _functions().wrench(self.friction, twists, 1.0 / self.friction.mu, **self.sizes)

    def change(self, twists: Any, rates: Any) -> Any:
        return jax.jvp(self.wrench, (twists,), (rates,))[1]

    def normal(self, wrenches: Any) -> Any:
        return _functions().normal(self.friction, wrenches, **self.sizes)

    def still(self) -> _Floor:
        return _Floor(self.friction, *jax.lax.stop_gradient((self.limit, self.sizes)))


def push(
    friction: Friction,
    contact: Any,
    velocity: Any,
    load: Any,
    *,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
) -> Push:
    """The motion of a body under a pusher of given velocity, as `tribos.push`.

    Parameters
    ----------
    friction
        Coulomb friction of the body on the floor.
    contact
        A `PointContact` of arrays, or a `tribos.PointContact`.
    velocity
        Velocities of the pusher in m/s, of shape (..., 2), broadcast with contacts and loads.
    load
        Normal force of the body on the floor in N, above 0. The motion does not depend on it.
    mu, radius, corners
        Arrays in place of those of `friction`, as in `wrench`.

    Returns
    -------
    Push
        Its `mode` is a number: 0 sticking, 1 sliding left, 2 sliding right, 3 separating.

    Notes
    -----
    Differentiable in all arguments but the friction. Derivatives are those of the mode: where it changes, they jump while
    the motion does not, and the one of the mode taken is given. A body that is not pushed has derivatives of exactly zero.

    Accuracy: that of `tribos.push`, with derivatives to 1e-9, in float64; 1e-5 of the motion in float32.

    Examples
    --------
    A finger off the middle of a box; how the spin changes with its place:

    >>> import jax, tribos, tribos.jax
    >>> table = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
    >>> def spin(x):
    ...     place = jax.numpy.array([x, -0.1])
    ...     finger = tribos.jax.PointContact(place, jax.numpy.array([0.0, 1.0]), 0.3)
    ...     return tribos.jax.push(table, finger, jax.numpy.array([0.0, 0.02]), 20.0).twist[2]
    >>> print(f"{spin(0.05):.4f} rad/s {jax.grad(spin)(0.05):.3f} rad/s/m")
    0.0729 rad/s 1.798 rad/s/m
    """
    arrays = _typed((_point(contact), velocity, load, _sizes(mu, radius, corners)))
    (at, velocity, load, sizes), _ = arrays
    return pushing.push(xla, _floor(friction, load, sizes), at, velocity)


def push_along(
    friction: Friction,
    contact: Any,
    velocities: Any,
    load: Any,
    *,
    dt: Any,
    side: tuple[Any, Any] | str | None = None,
    start: Any = (0.0, 0.0, 0.0),
    steps: int = 1,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
) -> Journey:
    """The path of a body under a pusher that moves at a constant velocity in each interval of time.

    Parameters
    ----------
    friction
        Coulomb friction of the body on the floor.
    contact
        Where the pusher touches the body at the start.
    velocities
        Velocities of the pusher on the floor in m/s, one an interval, of shape (..., intervals, 2); for one velocity
        ``jax.numpy.broadcast_to(velocity, (intervals, 2))``.
    load
        Normal force of the body on the floor in N, above 0.
    dt
        Length of an interval in s.
    side
        How far a straight side goes on from the contact, to the right and to the left, in m; or ``"round"`` for a circle
        about the patch's origin. None as in `tribos.push_along`, but that a round patch is touched on the line to its centre,
        whatever the normal.
    start
        Place of the patch's origin in m, and its turn in rad, at the start, of shape (..., 3).
    steps
        Steps of an interval.
    mu, radius, corners
        Arrays in place of those of `friction`, as in `wrench`.

    Returns
    -------
    Journey
        Arrays with an axis of intervals + 1 moments after those of the batch. Its `end` is a number a moment: 0 done so far,
        1 slipped, 2 separated.

    Notes
    -----
    Differentiable in all arguments but the friction, `steps` and "round". Steps have an equal length and fourth order: errors
    fall with the fourth power of their number, those of a step in which sticking begins or ends or the side ends with the
    second.

    Examples
    --------
    >>> import jax, tribos, tribos.jax
    >>> table = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
    >>> finger = tribos.PointContact.on(table.patch, [0.05, -0.1], mu=0.3)
    >>> velocities = jax.numpy.broadcast_to(jax.numpy.array([0.0, 0.02]), (20, 2))
    >>> path = tribos.jax.push_along(table, finger, velocities, 20.0, dt=0.5)
    >>> print(path.position.shape, f"{path.angle[-1]:.3f} rad", path.end[-1])
    (21, 2) 0.839 rad 0
    """
    given = (_point(contact), velocities, load, dt, start, _sizes(mu, radius, corners))
    lengths = () if side is None or side == "round" else side
    if isinstance(lengths, str) or len(lengths) not in (0, 2):
        raise ValueError(f"side must be two lengths in m or 'round', not {side!r}")
    count = operator.index(steps)
    if count < 1:
        raise ValueError(f"steps must be a whole number > 0, not {steps!r}")
    (at, velocities, load, dt, start, sizes, lengths), dtype = _typed((*given, lengths))
    if isinstance(start, tuple):
        start = jnp.stack(jnp.broadcast_arrays(*start), axis=-1)
    if side is None:
        lengths = _own_side(friction, at, sizes, dtype)
    # One batch for all: what goes from step to step has its shape.
    shapes = [row.shape[:-1] for row in (at.position, at.normal, start)]
    shapes += [x.shape for x in (at.mu, load, dt, *lengths)] + [velocities.shape[:-2]]
    shapes += [x.shape[:-2] if name == "corners" else x.shape for name, x in sizes.items()]
    batch = jnp.broadcast_shapes(*shapes)

    def over(array: Any, *own: int) -> Any:
        return jnp.broadcast_to(array, batch + own)

    at = PointContact(over(at.position, 2), over(at.normal, 2), over(at.mu))
    pusher = pushed_path.Pusher(at, lengths or None, _floor(friction, load, sizes))
    # One row a step; a first one of no length gives the start.
    rows = jnp.moveaxis(over(velocities, *velocities.shape[-2:]), -2, 0)
    rows = jnp.concatenate([rows[:1], jnp.repeat(rows, count, axis=0)])
    length = jnp.broadcast_to(dt / count, rows.shape[:-1]).at[0].set(0.0)
    path = pushed_path.follow(xla, pusher, over(start, 3), rows, length)
    made: Journey = jax.tree.map(lambda x: jnp.moveaxis(x[::count], 0, len(batch)), path)
    return made


def _own_side(friction: Friction, at: PointContact, sizes: dict[str, Any], dtype: Any) -> Any:
    """How far the patch's own side goes on; nothing for a round patch."""
    if "corners" in sizes:
        return _reach(sizes["corners"], jnp.roll(sizes["corners"], -1, axis=-2), at)
    loops = [np.array(loop) for loop in outline(friction.patch)]
    if not loops and friction.patch.kind != "points":
        return ()
    if friction.patch.kind in ("mesh", "points"):
        return (jnp.asarray(jnp.inf, dtype),) * 2
    # The body lies to the left of the outer loop's edges and to the right of the holes'.
    loops = [loop[:: _sense(loop) * (1 if at == 0 else -1)] for at, loop in enumerate(loops)]
    ends = [np.roll(loop, -1, axis=0) for loop in loops]
    starts, ends = (jnp.asarray(np.concatenate(rows), dtype) for rows in (loops, ends))
    return _reach(starts, ends, at)


def _sense(loop: Any) -> int:
    """1 for a loop that runs counterclockwise, and for a bar."""
    x, y = loop.T
    return 1 if x @ np.roll(y, -1) - y @ np.roll(x, -1) >= 0.0 else -1


def _reach(starts: Any, ends: Any, at: PointContact) -> tuple[Any, Any]:
    """How far the side that the contact is on goes on, to the right and to the left: from one of these edges, which have
    the body to their left.

    Without ends where the contact's normal is not that of the nearest edge, as of a flat pusher at a corner.
    """
    edges, off = ends - starts, at.position[..., None, :] - starts
    length = jnp.hypot(edges[..., 0], edges[..., 1])
    along = edges / length[..., None]
    place = jnp.sum(along * off, axis=-1)
    beyond = jnp.maximum(jnp.maximum(-place, place - length), 0.0)
    distance = jax.lax.stop_gradient(jnp.hypot(_cross(along, off), beyond))
    # The inward normal is the edge turned to the left.
    normal = at.normal[..., None, :] / jnp.hypot(*jnp.moveaxis(at.normal, -1, 0))[..., None, None]
    finest = _PARALLEL[str(distance.dtype)]
    is_along = jnp.abs(jnp.sum(along * normal, axis=-1)) <= finest
    is_along &= _cross(along, normal) > 0.0
    nearest = jnp.min(distance, axis=-1, keepdims=True)
    is_along &= distance <= nearest + finest * length
    which = jnp.argmin(jnp.where(is_along, distance, jnp.inf), axis=-1, keepdims=True)

    def kept(reach: Any) -> Any:
        chosen = jnp.take_along_axis(reach, which, axis=-1)[..., 0]
        return jnp.where(jnp.any(is_along, axis=-1), chosen, jnp.inf)

    # Looking along the normal, the edge leads to the right.
    return kept(length - place), kept(place)


def _cross(a: Any, b: Any) -> Any:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _point(contact: Any) -> PointContact:
    return PointContact(contact.position, contact.normal, contact.mu)


def _sizes(mu: Any, radius: Any, corners: Any) -> dict[str, Any]:
    """What takes the place of a friction's own numbers."""
    given = {"mu": mu, "radius": radius, "corners": corners}
    return {name: value for name, value in given.items() if value is not None}


def _floor(friction: Friction, load: Any, sizes: dict[str, Any]) -> _Floor:
    others = {name: value for name, value in sizes.items() if name != "mu"}
    return _Floor(friction, sizes.get("mu", friction.mu) * load, others)


def _typed(given: Any) -> tuple[Any, Any]:
    """Arrays of one type; numbers of Python take that of the others."""
    leaves, tree = jax.tree.flatten(given)
    leaves = [x if isinstance(x, (bool, int, float)) else jnp.asarray(x) for x in leaves]
    dtype = jnp.result_type(float, *leaves)
    return jax.tree.unflatten(tree, [jnp.asarray(x, dtype) for x in leaves]), dtype
