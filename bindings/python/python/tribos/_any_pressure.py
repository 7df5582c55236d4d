"""What a foot carries of which the load and the centre of pressure are known, not the pressure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, pair, table

Pair = Sequence[float] | NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class TorqueLimits:
    """Torques about the origin that friction can carry together with forces, from both sides.

    Attributes
    ----------
    carried : numpy.ndarray
        Lowest and highest torque that a pressure was found for, in N m, of shape (..., 2); NaN where
        no pressure carries the force.
    outer : numpy.ndarray
        Torques below the first and above the second are carried by no pressure.
    """

    carried: Any
    outer: Any


class AnyPressure:
    """All wrenches that dry friction carries under any pressure with a known centre.

    Made by `any_pressure`. Immutable, comparable and picklable.
    """

    __slots__ = ("_handle", "centre", "corners", "load", "mu")

    corners: NDArray[np.float64]
    centre: tuple[float, float]
    mu: float
    load: float
    _handle: _native.AnyPressure

    def __init__(self, corners: ArrayLike, centre: Pair, mu: float, load: float) -> None:
        places = table("corners", corners, 2).copy()
        places.flags.writeable = False
        self.corners = places
        self.centre = pair("centre", centre)
        self.mu, self.load = number("mu", mu), number("load", load)
        if self.mu < 0.0 or self.load < 0.0:
            raise ValueError("mu and load must be >= 0")
        limit = self.mu * self.load
        self._handle = _native.AnyPressure(places.tolist(), list(self.centre), limit)

    @property
    def force_limit(self) -> float:
        """The largest force ``mu * load``, in N."""
        return self.mu * self.load

    @property
    def radius(self) -> float:
        """Distance of the farthest corner from the centre of pressure, in m."""
        return self._handle.radius()

    def torque_limits(self, forces: ArrayLike) -> TorqueLimits:
        """The torques about the origin that can be carried together with each force.

        Parameters
        ----------
        forces
            In N, of shape (..., 2).

        Notes
        -----
        Both limits are sound to rounding and differ by less than 1e-9 of force limit times radius for
        forces up to 1 - 1e-11 of the limit, by less than 1e-7 beyond.
        """
        rows = self._handle.torque_limits(forces)
        return TorqueLimits(carried=rows[..., :2].copy(), outer=rows[..., 2:].copy())

    def gauge_bounds(self, wrenches: ArrayLike) -> Any:
        """Lower and upper bounds of the gauge of each wrench, of shape (..., 2).

        A lower bound above 1 proves that no pressure carries the wrench, an upper one of at most 1 that
        some pressure does; they differ by less than 1e-9 of the gauge.
        """
        return self._handle.gauge_bounds(wrenches)

    def support(self, twists: ArrayLike) -> Any:
        """The largest power that any pressure takes from each twist, in W."""
        return self._handle.support(twists)

    def wrench(self, twists: ArrayLike) -> Any:
        """Friction at each twist under a pressure that dissipates most, of shape (..., 3)."""
        return self._handle.wrench(twists)

    def __repr__(self) -> str:
        corners = self.corners.tolist() if len(self.corners) <= 4 else f"<{len(self.corners)} rows>"
        return (
            f"tribos.any_pressure({corners}, centre={self.centre!r}, mu={self.mu!r}, "
            f"load={self.load!r})"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return AnyPressure, (self.corners, self.centre, self.mu, self.load)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, AnyPressure):
            return NotImplemented
        numbers = (self.centre, self.mu, self.load) == (other.centre, other.mu, other.load)
        return numbers and np.array_equal(self.corners, other.corners)

    def __hash__(self) -> int:
        return hash((self.corners.tobytes(), self.centre, self.mu, self.load))


def any_pressure(corners: ArrayLike, centre: Pair, mu: float, load: float) -> AnyPressure:
    """The wrenches that friction of a support can carry if only the centre of pressure is known.

    Load and centre of pressure of a foot on the floor are measured, the pressure is not. What this set
    does not contain, no pressure carries; `LimitSurface.torque_limits` has the limits of one pressure.

    Parameters
    ----------
    corners
        Corners of the support in m, of shape (n, 2), in any order; those inside of the hull of the
        others change nothing.
    centre
        Centre of pressure in m, in the convex hull of the corners.
    mu
        Coefficient of friction.
    load
        Normal force in N.

    Examples
    --------
    >>> import tribos
    >>> sole = [[-0.06, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]]
    >>> foot = tribos.any_pressure(sole, centre=[0.05, 0.01], mu=0.6, load=700.0)
    >>> print(foot.torque_limits([200.0, 0.0]).carried.round(3))           # N m
    [-48.685  44.39 ]
    """
    return AnyPressure(corners, centre, mu, load)
