"""Quasi-static pushing: how a body moves that a pusher moves slowly over the floor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, pair, positive, reals
from tribos._patches import Patch, outline
from tribos._surface import LimitSurface

Array = NDArray[np.float64]
Pair = Sequence[float] | NDArray[np.float64]
# A contact with this angle to a side's normal, in rad, is on that side.
_PARALLEL = 1e-9


class PointContact:
    """Where a pusher touches a body: a finger at a flat side, or a flat pusher at a corner.

    *Left* and *right* are those of somebody who looks along the inward normal. Arrays make a batch.

    Parameters
    ----------
    position
        Places in the coordinates of the body's patch, in m, of shape (..., 2).
    normal
        Directions into the body, of shape (..., 2), of any length but 0.
    mu
        Coefficient of friction between pusher and body, at least 0, of shape (...).

    Examples
    --------
    >>> import tribos
    >>> tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
    tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
    """

    __slots__ = ("_rows", "mu", "normal", "position")

    position: Array
    normal: Array
    mu: Array
    _rows: Array

    def __init__(self, position: ArrayLike, normal: ArrayLike, mu: ArrayLike) -> None:
        places, normals = _rows("position", position, 2), _rows("normal", normal, 2)
        coefficients = _rows("mu", mu, 0)
        if not np.all(np.any(normals != 0.0, axis=-1)):
            raise ValueError("normal must not be zero")
        if not np.all(coefficients >= 0.0):
            raise ValueError("mu must be >= 0")
        rows = _joined(places, normals, coefficients[..., np.newaxis])
        object.__setattr__(self, "position", places)
        object.__setattr__(self, "normal", normals)
        object.__setattr__(self, "mu", coefficients)
        object.__setattr__(self, "_rows", rows)

    @classmethod
    def on(cls, patch: Patch, position: Pair, mu: float) -> PointContact:
        """A contact at the side of a patch that is nearest to a place, with that side's inward normal.

        The place may lie off that side, as where a body overhangs its patch. It is one place; many contacts are made
        from arrays of places and normals by the constructor.

        Parameters
        ----------
        patch
            A patch with straight edges, or a round one, which is touched on the line to its centre.
        position
            The place, in m.
        mu
            Coefficient of friction between pusher and body.

        Examples
        --------
        >>> import tribos
        >>> tribos.PointContact.on(tribos.box(0.3, 0.2), [0.05, -0.1], mu=0.3)
        tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
        """
        x, y = pair("position", position)
        loops = outline(patch)
        if loops:
            normal = _native.nearest_side(loops, [x, y])[0]
            # No -0 for people.
            return cls([x, y], [part + 0.0 for part in normal], mu)
        if patch.kind == "points":
            raise ValueError("points have no sides: give the normal")
        return cls([x, y], [-x, -y], mu)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a contact is immutable; make a new one to change {name}")

    def __repr__(self) -> str:
        parts = _short(self.position), _short(self.normal), f"mu={_short(self.mu)}"
        return f"tribos.PointContact({', '.join(parts)})"

    def __reduce__(self) -> tuple[Any, ...]:
        return PointContact, (self.position, self.normal, self.mu)


@dataclass(frozen=True, eq=False)
class ConeEdge:
    """The motion under an edge of a pusher's friction cone.

    Attributes
    ----------
    wrench : numpy.ndarray
        The push, scaled to the limit surface, in N and N m, of shape (..., 3).
    twist : numpy.ndarray
        Motion of the body under it, scaled as `LimitSurface.normal` does, of shape (..., 3).
    velocity : numpy.ndarray
        Velocity of the body at the contact at this motion, of shape (..., 2).
    """

    wrench: Any
    twist: Any
    velocity: Any


@dataclass(frozen=True, eq=False)
class MotionCone:
    """All motions that a contact can cause without sliding: those between two edges.

    Attributes
    ----------
    right, left : ConeEdge
        Under the largest friction to the right and to the left.
    angles : numpy.ndarray
        Angles of the contact's velocities at both edges, counterclockwise from the inward normal, in
        rad, of shape (..., 2): right, left.
    """

    right: ConeEdge
    left: ConeEdge
    angles: Any


@dataclass(frozen=True, eq=False)
class Push:
    """What a pusher with a given velocity does.

    Attributes
    ----------
    mode : str or numpy.ndarray of str
        ``"sticking"``, ``"sliding left"``, ``"sliding right"``: the pusher slides that way along the
        body; or ``"separating"``: it moves away, and the body rests.
    twist : numpy.ndarray
        Motion of the body, of shape (..., 3).
    contact_velocity : numpy.ndarray
        Velocity of the body at the contact, in m/s, of shape (..., 2).
    slip : numpy.ndarray
        Velocity of the pusher past the body, in m/s, of shape (..., 2).
    wrench : numpy.ndarray
        What the pusher exerts, about the origin, of shape (..., 3).
    """

    mode: Any
    twist: Any
    contact_velocity: Any
    slip: Any
    wrench: Any


@dataclass(frozen=True, eq=False)
class Journey:
    """The path of a pushed body: arrays with one element a moment.

    Attributes
    ----------
    time : numpy.ndarray
        Times since the start, in s.
    position : numpy.ndarray
        Places of the patch's origin on the floor, in m, of shape (moments, 2).
    angle : numpy.ndarray
        Turns counterclockwise, in rad.
    contact : numpy.ndarray
        Where the pusher touches the body, in the coordinates of the body, in m, of shape (moments, 2).
    push : Push
        The pushes, in the coordinates of the body.
    end : str
        ``"done"``; ``"slipped"``: the pusher came to the end of the side; ``"separated"``: the body
        turned until the pusher moved away from it.
    steps : int
        Steps of the integration.
    """

    time: Any
    position: Any
    angle: Any
    contact: Any
    push: Push
    end: str
    steps: int


def motion_cone(surface: LimitSurface, contact: PointContact) -> MotionCone:
    """The motions that a contact can cause without sliding.

    Parameters
    ----------
    surface
        Friction of the body on the floor: ``tribos.Friction(patch, mu).limit_surface(load)``.
    contact
        Where the pusher touches the body; batches are broadcast with the surface's loads.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.05), mu=0.3).limit_surface(load=2.0)
    >>> finger = tribos.PointContact([-0.05, 0.0], [1.0, 0.0], mu=0.5)
    >>> print(tribos.motion_cone(puck, finger).angles.round(4))            # rad
    [-1.0592  1.0592]
    """
    _check(surface, contact)
    rows = _native.motion_cone(surface._handle, surface.force_limit, contact._rows)

    def edge(at: int) -> ConeEdge:
        return ConeEdge(
            wrench=rows[..., at : at + 3].copy(),
            twist=rows[..., at + 3 : at + 6].copy(),
            velocity=rows[..., at + 6 : at + 8].copy(),
        )

    return MotionCone(right=edge(0), left=edge(8), angles=rows[..., 16:18].copy())


def push(surface: LimitSurface, contact: PointContact, velocity: ArrayLike) -> Push:
    """The motion of a body under a pusher of given velocity.

    Friction on the floor balances the pusher at every moment: nothing has inertia.

    Parameters
    ----------
    surface
        Friction of the body on the floor.
    contact
        Where the pusher touches the body.
    velocity
        Velocities of the pusher in m/s, of shape (..., 2), broadcast with contacts and loads.

    Notes
    -----
    Accuracy: contact velocities 1e-14 of the pusher's, motions what the surface's normals allow.

    Examples
    --------
    >>> import tribos
    >>> table = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4).limit_surface(load=20.0)
    >>> finger = tribos.PointContact([0.05, -0.1], [0.0, 1.0], mu=0.3)
    >>> moved = tribos.push(table, finger, [0.0, 0.02])
    >>> moved.mode
    'sliding left'
    >>> print(moved.twist.round(4))
    [-0.0046  0.0164  0.0729]
    """
    _check(surface, contact)
    velocities = _rows("velocity", velocity, 2)
    rows = _joined(contact._rows, velocities)
    return _push(_native.pushes(surface._handle, surface.force_limit, rows))


def push_along(
    surface: LimitSurface,
    contact: PointContact,
    velocity: Pair,
    duration: float,
    *,
    side: tuple[float, float] | str | None = None,
    start: tuple[float, float, float] = (0.0, 0.0, 0.0),
    samples: int = 100,
    tolerance: float = 1e-7,
) -> Journey:
    """The path of a body under a pusher of constant velocity.

    Parameters
    ----------
    surface
        Friction of the body on the floor, under one load.
    contact
        Where the pusher touches the body at the start.
    velocity
        Velocity of the pusher on the floor, in m/s.
    duration
        How long it pushes, in s.
    side
        How far a straight side goes on from the contact, to the right and to the left, in m; or
        ``"round"`` for a circle about the patch's origin. None for the patch's own side next to the
        contact if its normal is the contact's, and for a straight side without ends if not: a flat
        pusher at a corner, or points.
    start
        Place of the patch's origin in m, and its turn in rad, at the start.
    samples
        Number of recorded times after the start, evenly spaced.
    tolerance
        Largest error of the path in m; of the angle, over the patch's radius.

    Examples
    --------
    >>> import tribos
    >>> table = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4).limit_surface(load=20.0)
    >>> finger = tribos.PointContact.on(table.patch, [0.05, -0.1], mu=0.3)
    >>> path = tribos.push_along(table, finger, [0.0, 0.02], 10.0)
    >>> path.end, path.position.shape, round(float(path.angle[-1]), 4)     # rad
    ('done', (101, 2), 0.8386)
    """
    _check(surface, contact)
    force_limit = _one_load(surface)
    if contact._rows.shape != (5,):
        raise ValueError("a path has one contact, not a batch")
    reach = _reach(surface.patch, contact, side)
    x, y, angle = start
    count = int(samples)
    if not 0 < count < 2**32:
        raise ValueError(f"samples must be a whole number > 0, not {samples!r}")
    rows, end, steps = _native.push_along(
        surface._handle,
        force_limit,
        contact._rows.tolist(),
        reach,
        [number("start", x), number("start", y), number("start", angle)],
        list(pair("velocity", velocity)),
        positive("duration", duration),
        count,
        positive("tolerance", tolerance),
    )
    return Journey(
        time=rows[:, 0].copy(),
        position=rows[:, 1:3].copy(),
        angle=rows[:, 3].copy(),
        contact=rows[:, 4:6].copy(),
        push=_push(rows[:, 6:]),
        end=end,
        steps=steps,
    )


@dataclass(frozen=True, eq=False)
class Grip:
    """What a straight pusher has to give for a motion of the body together with it.

    Attributes
    ----------
    is_stable : numpy.ndarray of bool
        Whether it can: the body keeps its place at the pusher.
    wrench : numpy.ndarray
        The push that the motion needs, about the origin, of shape (..., 3).
    place : numpy.ndarray
        Where the force acts along the line: 0 at the first end, 1 at the second.
    friction : numpy.ndarray
        Friction to the left over normal force; infinite if the pusher would have to pull.
    """

    is_stable: Any
    wrench: Any
    place: Any
    friction: Any


class LineContact:
    """A straight pusher along a straight side of a body, between two ends.

    Parameters
    ----------
    first, second
        Its ends, in m; the body lies to the left of the way from the first to the second.
    mu
        Coefficient of friction between pusher and body, at least 0.

    Examples
    --------
    A fence under the lower side of a box pushes straight on, and turns the box about a far centre but
    not about a near one:

    >>> import tribos
    >>> table = tribos.Friction(tribos.box(0.2, 0.1), mu=0.4).limit_surface(load=5.0)
    >>> fence = tribos.LineContact([-0.08, -0.05], [0.08, -0.05], mu=0.4)
    >>> fence.grip(table, [[0, 1, 0], [0, 0.5, 1], [0, 0.02, 1]]).is_stable
    array([ True,  True, False])
    """

    __slots__ = ("_row", "first", "mu", "second")

    first: tuple[float, float]
    second: tuple[float, float]
    mu: float
    _row: list[float]

    def __init__(self, first: Pair, second: Pair, mu: float) -> None:
        start, end = pair("first", first), pair("second", second)
        coefficient = number("mu", mu)
        if start == end:
            raise ValueError("the ends of a line contact must lie apart")
        if coefficient < 0.0:
            raise ValueError(f"mu must be >= 0, not {mu!r}")
        object.__setattr__(self, "first", start)
        object.__setattr__(self, "second", end)
        object.__setattr__(self, "mu", coefficient)
        object.__setattr__(self, "_row", [*start, *end, coefficient])

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a contact is immutable; make a new one to change {name}")

    def grip(self, surface: LimitSurface, twists: ArrayLike) -> Grip:
        """What the pusher has to give for motions of body and pusher, and whether it can.

        Parameters
        ----------
        surface
            Friction of the body on the floor.
        twists
            Motions in the coordinates of the body, of shape (..., 3).
        """
        _check(surface, self)
        rows = _native.line_grip(surface._handle, surface.force_limit, self._row, twists)
        return Grip(
            is_stable=rows[..., 0] == 1.0,
            wrench=rows[..., 1:4].copy(),
            place=rows[..., 4].copy(),
            friction=rows[..., 5].copy(),
        )

    def stable_boundary(self, surface: LimitSurface, count: int = 32) -> Any:
        """Motions at which the pusher begins to slip or the body to tilt off it, in order.

        Returns
        -------
        numpy.ndarray
            Twists of shape (4 * count, 3), scaled as `LimitSurface.normal` does; the centre of rotation
            of one is ``(-velocity_y, velocity_x) / spin``.
        """
        _check(surface, self)
        many = int(count)
        if many <= 0:
            raise ValueError(f"count must be a whole number > 0, not {count!r}")
        return np.array(_native.line_boundary(surface._handle, _one_load(surface), self._row, many))

    def __repr__(self) -> str:
        return f"tribos.LineContact({list(self.first)}, {list(self.second)}, mu={self.mu!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return LineContact, (self.first, self.second, self.mu)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LineContact) and self._row == other._row

    def __hash__(self) -> int:
        return hash(tuple(self._row))


def _reach(
    patch: Patch, contact: PointContact, side: tuple[float, float] | str | None
) -> list[float] | None:
    """How far a straight side goes on to the right and to the left; None for a round one."""
    if side is None:
        loops, (x, y) = outline(patch), contact.position.tolist()
        inward, reach = [-x, -y], None
        if loops:
            inward, reach = _native.nearest_side(loops, [x, y])
        u, v = contact.normal / np.linalg.norm(contact.normal)
        size = np.hypot(*inward)
        is_side = abs(u * inward[1] - v * inward[0]) <= _PARALLEL * size
        is_side = is_side and u * inward[0] + v * inward[1] > 0.0 and patch.kind != "points"
        return reach if is_side else [np.inf, np.inf]
    if isinstance(side, str):
        if side != "round":
            raise ValueError(f"side must be two lengths in m or 'round', not {side!r}")
        return None
    right, left = (float(length) for length in side)
    if not (right >= 0.0 and left >= 0.0):
        raise ValueError(f"side must be two lengths >= 0, not {side!r}")
    return [right, left]


def _push(rows: Array) -> Push:
    names = np.array(_native.push_modes())
    modes = names[rows[..., 0].astype(np.intp)]
    return Push(
        mode=modes if rows.ndim > 1 else str(modes),
        twist=rows[..., 1:4].copy(),
        contact_velocity=rows[..., 4:6].copy(),
        slip=rows[..., 6:8].copy(),
        wrench=rows[..., 8:11].copy(),
    )


def _check(surface: object, contact: object) -> None:
    if not isinstance(surface, LimitSurface):
        raise ValueError(f"the surface must be a tribos.LimitSurface, not {surface!r}")
    if not isinstance(contact, (LineContact, PointContact)):
        raise ValueError(f"the contact must be a tribos.PointContact, not {contact!r}")


def _one_load(surface: LimitSurface) -> float:
    if np.ndim(surface.force_limit) != 0:
        raise ValueError("the limit surface must have one load, not an array of them")
    return float(surface.force_limit)


def _rows(name: str, value: ArrayLike, columns: int) -> Array:
    """Finite numbers, in rows of so many unless that is 0."""
    array = reals(name, value)
    if columns and (array.ndim == 0 or array.shape[-1] != columns):
        raise ValueError(f"{name} must have shape (..., {columns}), not {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite")
    array.flags.writeable = False
    return array


def _joined(*parts: Array) -> Array:
    """Rows side by side, their leading axes broadcast."""
    batch = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    spread = [np.broadcast_to(part, (*batch, part.shape[-1])) for part in parts]
    return np.concatenate(spread, axis=-1)


def _short(array: Array) -> str:
    return repr(array.tolist()) if array.size <= 3 else f"<array {array.shape}>"
