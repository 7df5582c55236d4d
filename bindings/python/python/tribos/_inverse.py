"""Launches that end at a wanted pose."""

from __future__ import annotations

import math
import operator
from dataclasses import dataclass

from tribos import _native
from tribos._checks import number
from tribos._friction import Friction
from tribos._modes import profiled


@dataclass(frozen=True)
class Launch:
    """A launch that ends at the wanted pose."""

    velocity: tuple[float, float]
    """Velocity of the centre, in m/s."""
    spin: float
    """Spin, in rad/s; positive turns x towards y."""
    speed: float
    """Magnitude of the velocity, in m/s."""
    direction: float
    """Direction of the velocity from x, in rad; 0 for a pure spin, where it is arbitrary."""
    angle: float
    """Angle turned in all, in rad, of either sign."""
    time: float
    """Time from launch to rest, in s."""
    energy_per_mass: float
    """Kinetic energy at the launch per mass, in J/kg."""

    @property
    def turns(self) -> float:
        """Number of turns, of either sign."""
        return self.angle / math.tau

    @property
    def twist(self) -> tuple[float, float, float]:
        """The launch as a twist: velocity in m/s and spin in rad/s."""
        return (*self.velocity, self.spin)


def inverse(
    friction: Friction,
    x: float,
    y: float,
    angle: float,
    *,
    max_speed: float,
    max_spin: float,
    inertia_ratio: float = 0.5,
    gravity: float = 9.81,
    turns: str = "modulo",
    symmetry: int = 1,
    most: int | None = None,
) -> list[Launch]:
    """Every launch after which a body comes to rest at a wanted pose.

    The body starts at the origin with angle 0. To each distance and angle turned belongs exactly one
    launch; several numbers of turns give several launches.

    Parameters
    ----------
    friction
        Coulomb friction, or ``mu * speed**alpha`` with ``alpha < 1``, on a round patch.
    x, y
        Position at rest, in m.
    angle
        Angle at rest, in rad.
    max_speed, max_spin
        The largest speed in m/s and the largest magnitude of spin in rad/s.
    inertia_ratio
        ``I/(m * radius**2)``: 1/2 for a solid disk on its own face.
    gravity
        Acceleration that presses the body down, in m/s².
    turns
        ``"modulo"``: the angle is an orientation, after any number of turns in either sense.
        ``"exact"``: it is the whole angle turned.
    symmetry
        Orientations repeat after ``2π/symmetry``.
    most
        The number of launches to be listed, those with the fewest turns; None for all.

    Returns
    -------
    list of Launch
        In the order of their kinetic energy; at least one.

    Raises
    ------
    ValueError
        If no launch within the limits leads there, with the launch that it would need and the reach of
        the limits; for more than 10,000 launches without ``most``; for ``alpha >= 1``.

    Notes
    -----
    Accuracy: the pose at rest is met to 1e-12 of the distance and of the angle turned.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.08), mu=0.3)
    >>> throws = tribos.inverse(puck, 1.2, 0.3, 1.57, max_speed=3.0, max_spin=100.0)
    >>> len(throws)
    33
    >>> least = throws[0]                                   # the least energy
    >>> round(least.speed, 6), round(least.spin, 6)
    (2.696296, 2.568128)
    >>> rest = tribos.slide(puck, least.speed, least.spin)
    >>> round(rest.distance**2, 12), round(rest.angle, 12)       # 1.2² + 0.3²
    (1.53, 1.57)
    """
    if turns not in ("modulo", "exact"):
        raise ValueError(f"turns must be 'modulo' or 'exact', not {turns!r}")
    order = _count("symmetry", symmetry, 2**32 - 1)
    wanted: dict[str, float | int | None] = {
        "x": number("x", x),
        "y": number("y", y),
        "angle": number("angle", angle),
        "gravity": number("gravity", gravity),
        "inertia_ratio": number("inertia_ratio", inertia_ratio),
        "max_speed": number("max_speed", max_speed),
        "max_spin": number("max_spin", max_spin),
        "symmetry": order if turns == "modulo" else None,
        "most": None if most is None else _count("most", most, 10_000_000),
    }
    return [Launch(*row) for row in _native.launches(profiled(friction), wanted)]


def _count(name: str, value: int, largest: int) -> int:
    """A whole number from 1 on."""
    try:
        count = operator.index(value)
    except TypeError:
        raise ValueError(f"{name} must be a whole number, not {value!r}") from None
    if not 1 <= count <= largest:
        raise ValueError(f"{name} must be from 1 to {largest}, not {count}")
    return count
