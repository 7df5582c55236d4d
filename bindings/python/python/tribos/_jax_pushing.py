"""Quasi-static pushes in JAX programs."""

from __future__ import annotations

import operator
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from tribos import _gradients, _jax_callback, _jax_native
from tribos._forms import pushed_path, pushing, xla
from tribos._forms.of_friction import FLAT
from tribos._forms.pushed_path import Journey
from tribos._forms.pushing import PointContact, Push
from tribos._friction import Friction
from tribos._jax_arguments import Call
from tribos._jax_sides import reach_on
from tribos._patches import outline


class _Floor(NamedTuple):
    """Friction of a body on the floor: of a form, or of the compiled kernel."""

    friction: Friction
    kind: str | None
    size: Any
    limit: Any

    def wrench(self, twists: Any) -> Any:
        if self.kind is None:
            unit = jnp.asarray(1.0 / self.friction.mu, twists.dtype)
            return _jax_callback.applied(_gradients.Wrench(self.friction), twists, unit)[0]
        one = np.ones((), twists.dtype)
        return _jax_native.wrench(self.kind, self.size, twists, one, one, None)

    def changing(self, twists: Any, rates: Any) -> tuple[Any, Any]:
        made: tuple[Any, Any] = jax.jvp(self.wrench, (twists,), (rates,))
        return made

    def normal(self, wrenches: Any) -> Any:
        if self.kind is None:
            return _jax_callback.applied(_gradients.Normal(self.friction), wrenches)[0]
        return _jax_native.normal(self.kind, self.size, wrenches)

    def still(self) -> _Floor:
        kept = [
            jax.lax.stop_gradient(x) if isinstance(x, jax.Array) else x
            for x in (self.size, self.limit)
        ]
        return _Floor(self.friction, self.kind, *kept)


def push(
    friction: Friction,
    contact: Any,
    velocity: Any,
    load: Any,
    *,
    mu: Any = None,
    radius: Any = None,
    corners: Any = None,
    backend: str = "auto",
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
    mu, radius, corners, backend
        As of `wrench`.

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
    A finger off the middle of a puck, and how the spin changes with its place:

    >>> import jax, tribos, tribos.jax
    >>> puck = tribos.Friction(tribos.disk(0.05), mu=0.3)
    >>> def spin(x):
    ...     place = jax.numpy.array([x, -0.05])
    ...     finger = tribos.jax.PointContact(place, jax.numpy.array([0.0, 1.0]), 0.3)
    ...     return tribos.jax.push(puck, finger, jax.numpy.array([0.0, 0.02]), 2.0).twist[2]
    >>> found, slope = jax.jit(jax.value_and_grad(spin))(0.01)
    >>> print(f"{found:.4f} rad/s, {slope:.2f} rad/s more for each metre")
    0.0620 rad/s, 5.80 rad/s more for each metre
    """
    call = Call("push", friction, velocity, mu=mu, radius=radius, corners=corners, backend=backend)
    at, velocity = _contact(call, contact), _pair(call, "velocity", velocity)
    made = pushing.push(xla, _floor(call, load), at, velocity)
    return Push(made.mode, *(call.own(part) for part in made[1:]))


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
    backend: str = "auto",
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
    mu, radius, corners, backend
        As of `wrench`.

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
    >>> puck = tribos.Friction(tribos.disk(0.05), mu=0.3)
    >>> finger = tribos.PointContact.on(puck.patch, [0.01, -0.05], mu=0.3)
    >>> @jax.jit
    ... def path(velocities):
    ...     return tribos.jax.push_along(puck, finger, velocities, 2.0, dt=0.5)
    >>> made = path(jax.numpy.broadcast_to(jax.numpy.array([0.0, 0.02]), (8, 2)))
    >>> print(made.position.shape, f"{made.angle[-1]:.3f} rad", made.end[-1])
    (9, 2) 0.473 rad 0
    """
    sizes = {"mu": mu, "radius": radius, "corners": corners}
    call = Call("push_along", friction, velocities, backend=backend, **sizes)
    count = operator.index(steps)
    if count < 1:
        raise ValueError(f"{call.name}: steps must be a whole number > 0, not {steps!r}")
    at, floor = _contact(call, contact), _floor(call, load)
    velocities = jnp.asarray(velocities, call.type)
    if velocities.ndim < 2 or velocities.shape[-1] != 2:
        shape = velocities.shape
        raise ValueError(
            f"{call.name}: velocities must have shape (..., intervals, 2), not {shape}"
        )
    call.meet("velocities", velocities.shape[:-2])
    dt = call.number("dt", dt, above=True)
    if isinstance(start, (tuple, list)):
        start = jnp.stack(jnp.broadcast_arrays(*(jnp.asarray(x, call.type) for x in start)), -1)
    start, reach = call.rows("start", start), _side(call, at, side)
    batch = call.axes

    def over(array: Any, *own: int) -> Any:
        # One batch for all: what goes from step to step has its shape.
        return jnp.broadcast_to(array, batch + own)

    at = PointContact(over(at.position, 2), over(at.normal, 2), over(at.mu))
    pusher = pushed_path.Pusher(at, reach or None, floor)
    # One row a step; a first one of no length gives the start.
    rows = jnp.moveaxis(over(velocities, *velocities.shape[-2:]), -2, 0)
    rows = jnp.concatenate([rows[:1], jnp.repeat(rows, count, axis=0)])
    length = jnp.broadcast_to(dt / count, rows.shape[:-1]).at[0].set(0.0)
    path = pushed_path.follow(xla, pusher, over(start, 3), rows, length)

    def recorded(rows: Any) -> Any:
        moments = jnp.moveaxis(rows[::count], 0, len(batch))
        return call.own(moments) if jnp.issubdtype(rows.dtype, jnp.floating) else moments

    made: Journey = jax.tree.map(recorded, path)
    return made


def _contact(call: Call, contact: Any) -> PointContact:
    return PointContact(
        _pair(call, "position", contact.position),
        _pair(call, "normal", contact.normal),
        call.number("mu of the contact", contact.mu),
    )


def _pair(call: Call, key: str, given: Any) -> Any:
    """Rows of two numbers."""
    made = jnp.asarray(given, call.type)
    if made.shape[-1:] != (2,):
        raise ValueError(f"{call.name}: {key} must have shape (..., 2), not {made.shape}")
    call.meet(key, made.shape[:-1])
    return made


def _floor(call: Call, load: Any) -> _Floor:
    load = call.number("load", load, above=True)
    limit = load * (call.friction.mu if call.mu is None else call.mu)
    return _Floor(call.friction, call.kind, call.size, jnp.asarray(limit, call.type))


def _side(call: Call, at: PointContact, side: Any) -> Any:
    """How far a side goes on to the right and to the left; nothing for a round one."""
    if side is None:
        return _own_side(call, at)
    if isinstance(side, str) and side == "round":
        return ()
    if isinstance(side, str) or len(side) != 2:
        raise ValueError(f"{call.name}: side must be two lengths in m or 'round', not {side!r}")
    right, left = side
    return call.number("side", right), call.number("side", left)


def _own_side(call: Call, at: PointContact) -> Any:
    """The patch's own side next to a contact."""
    patch = call.friction.patch
    if call.kind == FLAT:
        return reach_on([jnp.asarray(call.size)], at)
    loops = outline(patch)
    if not loops and patch.kind != "points":
        return ()
    if patch.kind in ("mesh", "points"):
        return (jnp.asarray(jnp.inf, call.type),) * 2
    return reach_on([jnp.asarray(loop, call.type) for loop in loops], at)
