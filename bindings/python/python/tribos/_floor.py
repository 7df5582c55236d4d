"""Floors of several surfaces that move, and bodies on several feet."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, pair, reals
from tribos._frozen import Frozen
from tribos._patches import Patch, feet_patch
from tribos._step import Step
from tribos._surface import LimitSurface

Surface = tuple[ArrayLike, ArrayLike]
"""Where a surface lies and how it moves: the corners of a convex polygon, of shape (n, 2), or two points of a border to
whose left it lies, of shape (2, 2), both in m; and its twist."""


class SteadyMotion(NamedTuple):
    """A motion in which friction balances a push."""

    twist: NDArray[np.float64]
    """Velocity in m/s and spin in rad/s of the body, of shape (3,)."""
    friction: NDArray[np.float64]
    """Friction on the body, in N and N m, of shape (3,)."""
    carried_by: int | None
    """The first foot, or piece of the patch, of those that rest on their surface, where some do."""
    evaluations: int
    """How often friction was evaluated in the search."""


def twist_of(name: str, value: ArrayLike) -> tuple[float, float, float]:
    """Velocity and spin of a surface."""
    x, y, spin = three(name, value)
    return x, y, spin


def three(name: str, value: ArrayLike) -> list[float]:
    """Three finite numbers."""
    array = reals(name, value)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{name} must be three finite numbers, not {value!r}")
    return [float(part) for part in array]


def rows_of(surface: Iterable[Surface]) -> list[tuple[list[list[float]], list[float]]]:
    """The surfaces as numbers."""
    rows = []
    for part in surface:
        try:
            region, twist = part
        except (TypeError, ValueError):
            raise ValueError(
                "surface must be a list of pairs: corners of a polygon or two points of a border, and the twist"
            ) from None
        corners = reals("a surface", region)
        if corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 2:
            raise ValueError(
                f"a surface is two points of a border or the corners of a polygon, of shape (n, 2), not {corners.shape}"
            )
        rows.append((corners.tolist(), three("the twist of a surface", twist)))
    return rows


def steady(native: _native.Floor, push: ArrayLike) -> SteadyMotion:
    """The steady motion of feet on surfaces."""
    twist, friction, carried, evaluations = native.steady_motion(three("push", push))
    return SteadyMotion(np.array(twist), np.array(friction), carried, evaluations)


def stepped(
    native: _native.Floor,
    motion: tuple[ArrayLike, ArrayLike],
    body: tuple[float, float, float],
    out: NDArray[Any] | None,
) -> Step:
    """A time step of bodies of one mass, inertia and length of step on feet."""
    twists, friction, at_rest = native.step(*motion, body, out)
    return Step(twists, friction, at_rest if at_rest.ndim else bool(at_rest))


class Feet(Frozen):
    """A body on several feet, each with its load, its coefficient and its surface: made by `feet`.

    Attributes
    ----------
    patch : Patch
        All feet as one patch, which shares the load among them.
    force_limit : float
        What all feet carry together, in N: the sum of coefficients times loads.
    """

    __slots__ = ("_given", "_handle", "force_limit", "patch")

    patch: Patch
    force_limit: float
    _given: tuple[Any, ...]
    _handle: _native.Floor

    def __init__(self, given: tuple[Any, ...], native: _native.Floor) -> None:
        limit = native.limit()
        self._keep(patch=feet_patch(given), force_limit=limit, _given=given, _handle=native)

    def wrench(self, twists: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Force and torque on the body that moves with these twists, against its motion over the surfaces.

        Parameters
        ----------
        twists
            Velocities in m/s and spins in rad/s of the body, of shape (..., 3).
        out
            An array of floats for the result.

        Returns
        -------
        numpy.ndarray
            Forces in N and torques in N m about the origin, of shape (..., 3).
        """
        return self._handle.wrench(twists, out)

    def jacobian(self, twists: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Derivatives of `wrench` with respect to the twist, of shape (..., 3, 3), symmetric."""
        return self._handle.jacobian(twists, out)

    def steady_motion(self, push: ArrayLike = (0.0, 0.0, 0.0)) -> SteadyMotion:
        """The motion in which friction of all feet balances a push: the one that the body comes to.

        Parameters
        ----------
        push
            Force in N and torque in N m on the body, about the origin.

        Raises
        ------
        ValueError
            Where no motion is steady, because the push is more than all feet carry.
        """
        return steady(self._handle, push)

    def step(
        self,
        twists: ArrayLike,
        pushes: ArrayLike,
        dt: float,
        *,
        mass: float,
        inertia: float,
        out: NDArray[Any] | None = None,
    ) -> Step:
        """The motions after one time step under constant pushes, as `PlanarBody.step`.

        The origin of the feet's coordinates is the foot of the centre of mass. A step that ends with feet at rest on
        their surface has the motion of that surface to the last bit.

        Parameters
        ----------
        twists, pushes
            Velocities in m/s and spins in rad/s, and forces in N and torques in N m of all but friction, of shape (..., 3).
        dt
            Length of the step in s, above 0.
        mass, inertia
            Those of the body, in kg and kg m².
        out
            An array of floats for the twists.

        Examples
        --------
        A parcel that is laid on a belt is taken along:

        >>> import numpy as np, tribos
        >>> cardboard = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
        >>> parcel = tribos.feet([(cardboard, 19.62, (0.0, 0.0), 0.0, (0.5, 0.0, 0.0))])
        >>> twist = np.zeros(3)
        >>> for steps in range(1, 100):
        ...     step = parcel.step(twist, np.zeros(3), 0.01, mass=2.0, inertia=0.02, out=twist)
        ...     if step.at_rest: break
        >>> steps, twist.tolist()                                   # 0.5/(0.4 * 9.81) = 0.127 s
        (13, [0.5, 0.0, 0.0])
        """
        return stepped(self._handle, (twists, pushes), (mass, inertia, dt), out)

    def limit_surface(self) -> LimitSurface:
        """All wrenches that the feet carry together while body and surfaces move as one."""
        return LimitSurface(self.patch, 1.0, self.force_limit)

    def __repr__(self) -> str:
        return f"tribos.feet(<{len(self._given)} feet>)"

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self._given,)


def _made(given: tuple[Any, ...]) -> Feet:
    return Feet(given, _native.Floor.feet([(foot[0]._handle, *foot[1:]) for foot in given]))


def feet(feet: Sequence[tuple[Any, ...]]) -> Feet:
    """A body on several feet.

    Parameters
    ----------
    feet
        For each foot ``(friction, load, (x, y))``: a `Friction` with a coefficient, the load in N and the place of the
        origin of its patch on the body, in m; and where they are wanted, the angle by which the patch is turned, in
        degrees, and the twist of the surface under the foot: ``(friction, load, (x, y), angle, (vx, vy, spin))``.

    Examples
    --------
    A robot on four wheels, whose treads run against each other, turns more slowly than its wheels would make it if they
    were points:

    >>> import tribos
    >>> wheel = tribos.Friction(tribos.box(0.04, 0.02), mu=0.7)
    >>> robot = tribos.feet([
    ...     (wheel, 75.0, (x, y), 0.0, (0.2 if y < 0 else -0.2, 0.0, 0.0))
    ...     for x in (-0.2, 0.2) for y in (-0.25, 0.25)
    ... ])
    >>> motion = robot.steady_motion()
    >>> round(float(motion.twist[2]), 3), motion.evaluations <= 20
    (0.488, True)
    """
    rows = []
    for foot in feet:
        try:
            friction, load, place, *rest = foot
            patch, mu = friction.patch, friction.mu
        except (TypeError, ValueError, AttributeError):
            raise ValueError(
                f"a foot is (friction, load, (x, y)[, angle[, twist]]) with a tribos.Friction of a coefficient, not {foot!r}"
            ) from None
        if len(rest) > 2:
            raise ValueError(
                f"a foot has at most an angle and a twist after its place, not {foot!r}"
            )
        newtons = number("load", load)
        if newtons < 0.0:
            raise ValueError(f"load must be >= 0, not {load!r}")
        angle = number("angle", rest[0]) if rest else 0.0
        twist = twist_of("the twist of a surface", rest[1]) if len(rest) > 1 else (0.0, 0.0, 0.0)
        rows.append((patch, mu, newtons, pair("place", place), angle, twist))
    if not rows:
        raise ValueError("feet must not be empty")
    return _made(tuple(rows))
