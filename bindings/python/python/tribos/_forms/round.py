"""Coulomb friction of disk, ring, punch, Hertz' and paraboloid pressure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from tribos._forms import coulomb, meridian
from tribos._forms.coulomb import Pressure
from tribos._forms.form import Nearest, Ray
from tribos._forms.space import Space


@dataclass(frozen=True)
class Round:
    """A round patch about the origin.

    Parameters
    ----------
    pressure
        Its pressure.
    radius
        Its radius, of the leading axes of twists and wrenches.
    """

    pressure: Pressure
    radius: Any

    @property
    def arrays(self) -> tuple[Any, ...]:
        return (self.radius,)

    def of(self, arrays: tuple[Any, ...]) -> Round:
        return Round(self.pressure, *arrays)

    def per(self, space: Space, length: Any) -> Round:
        return Round(self.pressure, self.radius / length)

    def reach(self, space: Space) -> Any:
        return self.radius

    def centre(self, space: Space) -> tuple[Any, Any]:
        return 0.0 * self.radius, 0.0 * self.radius

    def spin(self, space: Space) -> Any:
        return meridian.spin_torque(self.pressure) * self.radius

    def support(self, space: Space, twists: Any) -> Any:
        x, y, r, size, is_rest = self._speeds(space, twists)
        return space.where(is_rest, 0.0, size * _power(space, self.pressure)(x, y, r))

    def wrench(self, space: Space, twists: Any) -> Any:
        x, y, r, _, is_rest = self._speeds(space, twists)
        along, across, turn = _pull(space, self.pressure)(x, y, r)
        sign = space.where(is_rest, 0.0, -1.0 + 0.0 * x)
        return space.stack((sign * along, sign * across, sign * self.radius * turn))

    def hessian(self, space: Space, twists: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
        x, y, r, size, is_rest = self._speeds(space, twists)
        share = space.where(is_rest, 0.0, 1.0 / size)
        _, parts = _pull_and_bend(space, self.pressure, x, y, r)
        xx, xy, yy, xr, yr, rr = (share * part for part in parts)
        radius = self.radius
        return xx, xy, yy, radius * xr, radius * yr, radius * radius * rr

    def nearest(self, space: Space, wrenches: Any) -> Nearest:
        radius = space.still(self.radius)
        x, y, force, sense, torque = _lengths(space, space.still(wrenches), radius)
        lever_sq = 1.0 / (radius * radius)
        normal, point, beyond = meridian.nearest(space, self.pressure, force, torque, lever_sq)
        slide, spin, share = _unit(space, normal, radius)
        return Nearest(
            space.stack((point[0] * x, point[0] * y, sense * radius * point[1])),
            space.stack((slide * x, slide * y, sense * spin)),
            beyond * share,
        )

    def ray(self, space: Space, wrenches: Any) -> Ray:
        radius = space.still(self.radius)
        x, y, force, sense, torque = _lengths(space, space.still(wrenches), radius)
        *normal, gauge = meridian.ray(space, self.pressure, force, torque)
        slide, spin, _ = _unit(space, normal, radius)
        return Ray(space.stack((slide * x, slide * y, sense * spin)), gauge)

    def _speeds(self, space: Space, twists: Any) -> tuple[Any, Any, Any, Any, Any]:
        """Velocity and rim speed in units of the largest, which is a constant to every derivative as friction does not
        depend on it, that unit, and whether all are 0; then any regular point stands in."""
        x, y, spin = space.parts(twists)
        r = spin * self.radius
        is_rest = (x == 0.0) & (y == 0.0) & (r == 0.0)
        size = space.abs(space.still(x))
        for part in (y, r):
            part = space.abs(space.still(part))
            size = space.where(size < part, part, size)
        size = space.where(is_rest, 1.0, size)
        share = 1.0 / size
        return space.where(is_rest, 1.0, x * share), y * share, r * share, size, is_rest


def _lengths(space: Space, wrenches: Any, radius: Any) -> tuple[Any, Any, Any, Any, Any]:
    """Direction and size of the forces, sense and size of the torques per radius."""
    x, y, torque = space.parts(wrenches)
    torque = torque / radius
    size = space.abs(x)
    size = space.where(size < space.abs(y), space.abs(y), size)
    is_none = size == 0.0
    share = 1.0 / space.where(is_none, 1.0, size)
    x, y = x * share, y * share
    length = space.sqrt(space.where(is_none, 1.0, x * x + y * y))
    sense = space.where(torque < 0.0, -1.0, 1.0)
    return x / length, y / length, size * length, sense, sense * torque


def _unit(space: Space, normal: Any, radius: Any) -> tuple[Any, Any, Any]:
    """Speed and spin of a twist of length 1 along a normal, and the factor to it."""
    slide, spin = normal[0], normal[1] / radius
    share = 1.0 / space.sqrt(slide * slide + spin * spin)
    return slide * share, spin * share, share


@cache
def _pull(space: Space, pressure: Pressure) -> Callable[..., Any]:
    """Push of friction against velocity and rim speed, not all 0."""

    def value(x: Any, y: Any, r: Any) -> Any:
        force, torque = coulomb.drags(space, pressure, x * x + y * y, r * r)
        return force * x, force * y, torque * r

    def rule(at: Any, by: Any) -> Any:
        made, (xx, xy, yy, xr, yr, rr) = space.apart(_pull_and_bend(space, pressure, *at))
        rows = (xx, xy, xr), (xy, yy, yr), (xr, yr, rr)
        return made, tuple(_along(row, by) for row in rows)

    return space.ruled(value, rule)


@cache
def _power(space: Space, pressure: Pressure) -> Callable[..., Any]:
    """Power of friction."""
    pull = _pull(space, pressure)

    def value(x: Any, y: Any, r: Any) -> Any:
        along, across, turn = pull(x, y, r)
        return along * x + across * y + turn * r

    def rule(at: Any, by: Any) -> Any:
        made = pull(*at)
        return _along(made, at), _along(made, by)

    return space.ruled(value, rule)


def _along(slopes: Any, by: Any) -> Any:
    """The rate along tangents, of which None are none."""
    return sum(slope * rate for slope, rate in zip(slopes, by, strict=True) if rate is not None)


def _pull_and_bend(space: Space, pressure: Pressure, x: Any, y: Any, r: Any) -> tuple[Any, Any]:
    """The push, and the second derivatives xx, xy, yy, xr, yr, rr of the power."""
    force, torque, by_slide, by_rim, turn = coulomb.drags_and_slopes(
        space, pressure, x * x + y * y, r * r
    )
    bend, mixed = 2.0 * by_slide, 2.0 * by_rim * r
    push = (force * x, force * y, torque * r)
    return push, (
        force + bend * x * x,
        bend * x * y,
        force + bend * y * y,
        mixed * x,
        mixed * y,
        turn,
    )
