"""Bodies that slide and spin to rest."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._friction import Friction


class Rest(NamedTuple):
    """Where and when bodies come to rest: numbers, or arrays of the launches' shape."""

    time: Any
    """Time from launch to rest, in s."""
    distance: Any
    """Distance covered, in m, with the sign of the speed."""
    angle: Any
    """Angle turned, in rad, with the sign of the spin; not reduced to one turn."""
    ratio: Any
    """Ratio of speed to ``|spin| * radius`` in the limit of rest: 0, infinite, or the fixed point
    of `modes`; NaN for a body that does not move."""


class Motion(NamedTuple):
    """Motions at given times: numbers, or arrays of the shape of launches and times together."""

    time: Any
    """Time since the launch, in s."""
    speed: Any
    """Speed, in m/s, with the sign of the speed at the launch."""
    spin: Any
    """Spin, in rad/s."""
    distance: Any
    """Distance covered, in m, with the sign of the speed."""
    angle: Any
    """Angle turned, in rad, with the sign of the spin."""


def slide(
    friction: Friction,
    speed: ArrayLike,
    spin: ArrayLike,
    *,
    inertia_ratio: ArrayLike = 0.5,
    gravity: ArrayLike = 9.81,
) -> Rest:
    """Follow bodies that are launched on a round patch to rest.

    Parameters
    ----------
    friction
        Coulomb friction, or ``mu * speed**alpha`` with ``alpha < 1``, on a round patch.
    speed
        Speeds in m/s. Those below 0 slide the other way.
    spin
        Spins in rad/s, of either sign.
    inertia_ratio
        ``I/(m * radius**2)`` with the moment of inertia I about the normal, the mass m and the
        radius of the patch: 1/2 for a solid disk on its own face, 1 for a hoop. Above 0 and finite.
    gravity
        Acceleration that presses the body down, in m/s², above 0 and finite. The deceleration of
        pure sliding is ``mu * gravity``, so that an array of gravities varies it from launch to
        launch.

    Returns
    -------
    Rest
        Time, distance, angle and the last ratio of sliding to spinning. All arguments are broadcast
        together; numbers give numbers. NaN for launches that are not finite.

    Raises
    ------
    ValueError
        For ``alpha >= 1``, under which no body rests in finite time, for patches that are not
        round, and for laws that are no power of the speed.

    Notes
    -----
    Accuracy: 1e-13 relative in each of time, distance and angle; 1e-8 on an annulus. The mass does
    not matter. A launch takes about 160 evaluations of the friction, 10 to 40 µs by the patch; threads
    share the launches without an influence on the result.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> rest = tribos.slide(puck, 1.0, 5.0)
    >>> round(rest.time, 12), round(rest.ratio, 9)
    (0.369017132105, 0.653001789)
    >>> print(tribos.slide(puck, 1.0, [0.0, 5.0, 50.0]).distance.round(4))   # spun it goes farther
    [0.1699 0.1769 0.606 ]
    """
    rows = _slider(friction).to_rest(speed, spin, inertia_ratio, gravity)
    return Rest(*_columns(rows))


def slide_path(
    friction: Friction,
    speed: ArrayLike,
    spin: ArrayLike,
    times: ArrayLike,
    *,
    inertia_ratio: ArrayLike = 0.5,
    gravity: ArrayLike = 9.81,
) -> Motion:
    """Motions of launched bodies at given times.

    Parameters
    ----------
    friction
        Coulomb friction, or ``mu * speed**alpha`` with any alpha, on a round patch.
    speed, spin
        The launches, as in `slide`.
    times
        Times since the launch in s, at least 0, in any order. From the time of rest on the body
        stays where it is.
    inertia_ratio, gravity
        As in `slide`.

    Returns
    -------
    Motion
        Speed, spin, distance and angle. All arguments are broadcast together: for a path of each of
        several launches give them the shape (n, 1). NaN for launches and times that are not finite.

    Notes
    -----
    Accuracy: distance and angle 1e-13; speed and spin 1e-13 times the time to rest over the time
    that is left. Every time is reached from the launch by itself, so that no error grows along the
    path.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> path = tribos.slide_path(puck, 1.0, 5.0, [0.0, 0.2, 0.4])
    >>> print(path.speed.round(4), path.distance.round(4))
    [1.     0.4291 0.    ] [0.     0.1427 0.1769]
    """
    late = np.asarray(times)
    if late.dtype.kind in "fiu" and bool((late < 0.0).any()):
        raise ValueError("times must be >= 0")
    rows = _slider(friction).advance(speed, spin, times, inertia_ratio, gravity)
    speeds, spins, distances, angles = _columns(rows)
    if np.ndim(speeds) == 0:
        return Motion(float(late), speeds, spins, distances, angles)
    broadcast = np.array(np.broadcast_to(late, np.shape(speeds)), dtype=np.float64)
    return Motion(broadcast, speeds, spins, distances, angles)


def _columns(rows: NDArray[Any]) -> list[Any]:
    """The numbers of the last axis, each as a contiguous array, or as a number."""
    if rows.ndim == 1:
        return list(rows.tolist())
    return list(np.ascontiguousarray(np.moveaxis(rows, -1, 0)))


def _slider(friction: Friction) -> _native.Slider:
    if not isinstance(friction, Friction):
        raise ValueError(f"friction must be a tribos.Friction, not {friction!r}")
    return _made(friction)


@lru_cache(maxsize=64)
def _made(friction: Friction) -> _native.Slider:
    return _native.Slider(friction.patch._handle, friction.law._handle, friction.tier)
