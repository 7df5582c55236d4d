"""Corners of a polygon in units of its radius, and motions in them."""

from __future__ import annotations

from typing import Any, NamedTuple

from tribos._forms.moving_edge import Motion, Six
from tribos._forms.space import Space


class Outline(NamedTuple):
    """Corners in units of the radius, about the centre of area, along the first axis.

    The radius is the distance of the farthest corner and takes part in no derivative: friction does not depend on
    the unit of length.
    """

    x: Any
    y: Any
    centre_x: Any
    centre_y: Any
    radius: Any

    @property
    def corners(self) -> tuple[Any, Any]:
        return self.x, self.y

    def motion(self, x: Any, y: Any, spin: Any) -> Motion:
        """Velocity of the centre and rim speed of a twist of the frame's origin."""
        return Motion(x - spin * self.centre_y, y + spin * self.centre_x, spin * self.radius)

    def twist(self, motion: Any) -> tuple[Any, Any, Any]:
        """The twist of a motion."""
        x, y, rim = motion
        spin = rim / self.radius
        return x + spin * self.centre_y, y - spin * self.centre_x, spin

    def torque(self, x: Any, y: Any, reduced: Any) -> Any:
        """Torque about the frame's origin of a force and a reduced torque about the centre."""
        return reduced * self.radius + (self.centre_x * y - self.centre_y * x)

    def reduced(self, x: Any, y: Any, torque: Any) -> Any:
        """Reduced torque about the centre of a force and a torque about the frame's origin."""
        return (torque - (self.centre_x * y - self.centre_y * x)) / self.radius


def outline_of(space: Space, corners: Any, rank: int) -> Outline:
    """Corners of shape (..., n, 2) for twists with so many leading axes."""
    x, y = (space.first_axis(corners[..., axis], rank) for axis in (0, 1))
    # From a corner, so that the place of the frame costs no digits.
    first_x, first_y = x[:1], y[:1]
    x, y = x - first_x, y - first_y
    next_x, next_y = space.following(x), space.following(y)
    cross = x * next_y - y * next_x
    third = 1.0 / (3.0 * space.total(cross))
    centre_x = space.total((x + next_x) * cross) * third
    centre_y = space.total((y + next_y) * cross) * third
    x, y = x - centre_x, y - centre_y
    radius = space.sqrt(space.largest(space.still(x * x + y * y)))
    inv = 1.0 / radius
    return Outline(x * inv, y * inv, first_x[0] + centre_x, first_y[0] + centre_y, radius)


def inverse_area(space: Space, x: Any, y: Any) -> Any:
    """1 over the area, negative of corners that go clockwise."""
    return 2.0 / space.total(x * space.following(y) - y * space.following(x))


def in_its_unit(space: Space, motion: Motion) -> tuple[Motion, Any, Any]:
    """A motion in units of its size, that unit, and where it is rest, in place of which the patch spins.

    The unit takes part in no derivative: dry friction does not depend on it.
    """
    x, y, spin = motion
    size = space.still(space.abs(x) + space.abs(y) + space.abs(spin))
    is_rest = size == 0.0
    size = space.where(is_rest, 1.0, size)
    return Motion(x / size, y / size, space.where(is_rest, 1.0, spin / size)), size, is_rest


def of_length_one(space: Space, motion: Motion) -> tuple[Motion, Any]:
    """A motion of length 1, and 1 over the length of the given one."""
    x, y, spin = motion
    rate = 1.0 / space.sqrt(x * x + y * y + spin * spin)
    return Motion(x * rate, y * rate, spin * rate), rate
