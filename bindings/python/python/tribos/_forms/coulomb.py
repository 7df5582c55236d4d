"""Coulomb friction of round patches in reduced units: the fitted form of the kernel, its curve and its drags.

With x the square of the smaller over the larger of sliding and rim speed and z = 1 - x, force per speed is Phi/m and torque
per rim speed Chi/m, m the larger speed; Phi' = dPhi/dx. Everything depends on squares of speeds, so that pure sliding and
pure spinning are ordinary points of every derivative. At equal speeds Phi' of a ring and Phi'' of every pressure up to the
disk's are infinite; finite numbers stand in for them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from tribos._forms.space import Space
from tribos._terms import ROUND

#: Orders q of the pressures (1 - r²)^q.
ORDERS = {"ring": -1.0, "punch": -0.5, "disk": 0.0, "hertz": 0.5, "paraboloid": 1.0}
#: Stands in for a smaller z, the squares of the rounding errors: its own square still has a reciprocal.
LEAST = {"float32": 1.4e-14, "float64": 4.9e-32}


@dataclass(frozen=True)
class Pressure:
    """A pressure by its name."""

    name: str

    @property
    def order(self) -> float:
        """q"""
        return ORDERS[self.name]

    @property
    def arm(self) -> float:
        """Torque of spinning over the slope of the force there, 1/n."""
        return 1.0 / (self.order + 1.5)

    @property
    def has_roots(self) -> bool:
        """Powers of the root of z stand in for the logarithm."""
        return self.order % 1.0 != 0.0


def torque_at(space: Space, pressure: Pressure, slides: Any, z: Any) -> tuple[Any, Any]:
    """Phi and Chi; sliding leads where `slides`."""
    argument, hook, _ = _argument_and_hooks(space, pressure, z)
    p, r, q, s = _sums(space, pressure, "torque", slides, argument)
    phi, chi = p + hook * q, r + hook * s
    if pressure.name == "disk":
        # Chi is Theta where sliding leads, Theta + z (Phi/n - Theta) where spinning does.
        return phi, chi + space.where(slides, 0.0, z) * (pressure.arm * phi - chi)
    if pressure.name == "ring":
        return space.where(slides, chi, phi), space.where(slides, phi, chi)
    return phi, chi


def slope_at(space: Space, pressure: Pressure, slides: Any, z: Any) -> tuple[Any, Any]:
    """Phi and Phi'."""
    argument, hook, slope_hook = _argument_and_hooks(space, pressure, z)
    # What multiplies the logarithm in the slope of a ring has its expansion at equal speeds.
    given = z if pressure.name == "ring" else argument
    p, r, q, s = _sums(space, pressure, "slope", slides, given)
    return p + hook * q, r + slope_hook * s


def torque_of_slope(
    space: Space, pressure: Pressure, slides: Any, z: Any, phi: Any, slope: Any
) -> Any:
    """Chi from Phi and Phi'."""
    theta = pressure.arm * (0.5 * phi + z * slope)
    return space.where(slides, theta, pressure.arm * z * phi + (1.0 - z) * theta)


def _argument_and_hooks(space: Space, pressure: Pressure, z: Any) -> tuple[Any, Any, Any]:
    """Argument of the sums, and what multiplies the singular parts of Phi and Chi, and that of Phi'."""
    least = space.constant(LEAST[space.type_of(z)], z)
    positive = space.where(z < least, least, z)
    if pressure.has_roots:
        u = space.sqrt(positive) - 0.5
        return u * u, u, u
    log = space.log(positive)
    hook = {"ring": log, "disk": z * log, "paraboloid": z * (z * log)}[pressure.name]
    return z - 0.5, z * hook, hook


def _sums(space: Space, pressure: Pressure, kind: str, slides: Any, u: Any) -> list[Any]:
    """The four sums of a table where its side leads."""
    spinning, sliding = ROUND[pressure.name][space.type_of(u)][kind]

    def term(a: float, b: float) -> Any:
        own = space.constant(a, u)
        return own if a == b else space.where(slides, space.constant(b, u), own)

    rows = [
        [term(a, b) for a, b in zip(*pair, strict=True)]
        for pair in zip(spinning, sliding, strict=True)
    ]
    return [_sum([row[n] for row in rows], u) for n in range(4)]


def _sum(terms: list[Any], u: Any) -> Any:
    """A polynomial, constant term first, by even and odd powers."""
    square = u * u

    def of(powers: list[Any]) -> Any:
        made = powers[-1]
        for term in powers[-2::-1]:
            made = made * square + term
        return made

    return of(terms[::2]) + u * of(terms[1::2])


class Speeds(NamedTuple):
    """Squares of sliding and rim speed, not both 0, in their larger one."""

    slides: Any
    """Sliding leads."""
    per_square: Any
    """One over the larger square."""
    z: Any


def speeds_of(space: Space, slide_sq: Any, rim_sq: Any) -> Speeds:
    """From the squares."""
    # One mask for all selects: the gradient of a maximum is half of each at a tie, and wrong here.
    slides = rim_sq < slide_sq
    major = space.where(slides, slide_sq, rim_sq)
    per_square = 1.0 / major
    return Speeds(slides, per_square, (major - space.where(slides, rim_sq, slide_sq)) * per_square)


def drags(space: Space, pressure: Pressure, slide_sq: Any, rim_sq: Any) -> tuple[Any, Any]:
    """Force per speed and torque per rim speed."""
    at = speeds_of(space, slide_sq, rim_sq)
    phi, chi = torque_at(space, pressure, at.slides, at.z)
    per_speed = space.sqrt(at.per_square)
    return per_speed * phi, per_speed * chi


def drags_and_slopes(
    space: Space, pressure: Pressure, slide_sq: Any, rim_sq: Any
) -> tuple[Any, Any, Any, Any, Any]:
    """Force per speed a, torque per rim speed, da/dV, da/dW for V and W the squares, and the torque's slope by the rim
    speed."""
    at = speeds_of(space, slide_sq, rim_sq)
    phi, slope = slope_at(space, pressure, at.slides, at.z)
    chi = torque_of_slope(space, pressure, at.slides, at.z, phi, slope)
    per_speed = space.sqrt(at.per_square)
    per_cube = per_speed * at.per_square
    # a is of degree -1/2 in V and W; the mixed slopes of force and torque are equal.
    bend = phi + 2.0 * (1.0 - at.z) * slope
    along, across = -0.5 * bend * per_cube, slope * per_cube
    turn = per_speed * space.where(at.slides, -2.0 * slope, (1.0 - at.z) * bend)
    return (
        per_speed * phi,
        per_speed * chi,
        space.where(at.slides, along, across),
        space.where(at.slides, across, along),
        turn,
    )


def curve_point(space: Space, pressure: Pressure, slides: Any, ratio: Any) -> tuple[Any, Any, Any]:
    """The curve of the limit surface: the leading component M, the other one m and dm/dh at the ratio h of speeds.

    dM/dh is -h dm/dh.
    """
    # Where Phi has an infinite slope z keeps its digits.
    z = (1.0 - ratio) * (1.0 + ratio)
    phi, slope = slope_at(space, pressure, slides, z)
    chi = torque_of_slope(space, pressure, slides, z, phi, slope)
    minor = ratio * space.where(slides, chi, phi)
    rate = space.where(slides, -2.0 * slope, phi + 2.0 * (ratio * ratio) * slope)
    return space.where(slides, phi, chi), minor, rate
