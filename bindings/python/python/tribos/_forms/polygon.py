"""Friction of polygons under uniform pressure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from tribos._forms import polygon_search
from tribos._forms.moving_corners import friction_rates
from tribos._forms.moving_edge import Motion, Six, edges_of, friction, power_hessian
from tribos._forms.space import Space


class Outline(NamedTuple):
    """Corners in units of the radius, about the centre of area.

    The radius is the distance of the farthest corner and takes part in no derivative: friction does not depend on
    the unit of length.
    """

    x: Any
    y: Any
    centre_x: Any
    centre_y: Any
    radius: Any

    def motion(self, twists: Any) -> Motion:
        """Velocity of the centre and rim speed of twists of the frame's origin."""
        spin = twists[..., 2]
        return Motion(
            twists[..., 0] - spin * self.centre_y,
            twists[..., 1] + spin * self.centre_x,
            spin * self.radius,
        )


class Flat:
    """A polygon under uniform pressure.

    Parameters
    ----------
    corners
        In m, of shape (..., n, 2), in the frame that twists and wrenches refer to; in either sense of rotation.
        Corners that repeat count once. Leading axes are broadcast with those of twists.

    Notes
    -----
    Accuracy, of the limits: 1e-15 in float64, 3e-7 in float32, for aspect ratios up to 10; a longer one is lost in
    proportion. Edges that cross and areas of zero have no friction that is right.
    """

    def __init__(self, corners: Any) -> None:
        self.corners = corners

    def wrench(self, space: Space, twists: Any) -> Any:
        """Friction over mu times load, of shape (..., 3): force and torque in m; 0 at rest."""
        outline = self.outline(space, twists)
        motion, _, is_rest = scaled(space, outline.motion(twists))
        made = _ruled(space)(*motion, outline.x, outline.y)
        x, y, n = (space.where(is_rest, 0.0, part) for part in made)
        torque = n * outline.radius + (outline.centre_x * y - outline.centre_y * x)
        return space.stack([x, y, torque])

    def hessian(self, space: Space, twists: Any) -> Any:
        """Second derivatives of the support over mu times load, of shape (..., 3, 3); 0 at rest."""
        outline = self.outline(space, twists)
        motion, size, is_rest = scaled(space, outline.motion(twists))
        _, parts = friction_and_hessian(space, motion, (outline.x, outline.y))
        xx, xy, yy, xn, yn, nn = (space.where(is_rest, 0.0, part / size) for part in parts)
        # The velocity of the centre by the spin.
        c_x, c_y, radius = -outline.centre_y, outline.centre_x, outline.radius
        by_x, by_y = xx * c_x + xy * c_y + radius * xn, xy * c_x + yy * c_y + radius * yn
        by_n = radius * (xn * c_x + yn * c_y + radius * nn) + (c_x * by_x + c_y * by_y)
        return _matrix(space, (xx, xy, yy, by_x, by_y, by_n))

    def ray(self, space: Space, wrenches: Any) -> Any:
        """The normal above each wrench, of shape (..., 3): where its ray meets the unit limit surface.

        Twists of |velocity|² + (spin · radius)² = 1, with the velocity of the centre; without derivatives. NaN for
        no wrench and should the search not end.
        """
        return polygon_search.ray(space, self.outline(space, wrenches), wrenches)

    def nearest(self, space: Space, wrenches: Any, length: Any) -> tuple[Any, Any]:
        """Normal and multiplier of the nearest point, without derivatives.

        With the unit twist n, |velocity|² + (length · spin)² = 1, and λ the wrench is
        −wrench(n) + λ (velocity, length² spin) for wrenches outside; inside λ < 0 and n is that of `ray`.
        """
        return polygon_search.nearest(space, self.outline(space, wrenches), wrenches, length)

    def outline(self, space: Space, rows: Any) -> Outline:
        """The corners for rows of shape (..., 3)."""
        rank = max(len(rows.shape), len(self.corners.shape) - 1) - 1
        x, y = (space.first_axis(self.corners[..., axis], rank) for axis in (0, 1))
        # From a corner, so that the place of the frame costs no digits.
        first_x, first_y = x[:1], y[:1]
        x, y = x - first_x, y - first_y
        next_x, next_y = space.following(x), space.following(y)
        cross = x * next_y - y * next_x
        twice = space.total(cross)
        third = 1.0 / (3.0 * twice)
        centre_x = space.total((x + next_x) * cross) * third
        centre_y = space.total((y + next_y) * cross) * third
        x, y = x - centre_x, y - centre_y
        radius = space.sqrt(space.largest(space.still(x * x + y * y)))
        inv = 1.0 / radius
        centre = first_x[0] + centre_x, first_y[0] + centre_y
        return Outline(x * inv, y * inv, *centre, radius)


def scaled(space: Space, motion: Motion) -> tuple[Motion, Any, Any]:
    """A motion in units of its largest part, that unit, and where it is rest, in place of which the patch spins.

    The unit takes part in no derivative: dry friction does not depend on it.
    """
    x, y, spin = motion
    size = space.still(space.abs(x) + space.abs(y) + space.abs(spin))
    is_rest = size == 0.0
    size = space.where(is_rest, 1.0, size)
    return Motion(x / size, y / size, space.where(is_rest, 1.0, spin / size)), size, is_rest


def _unit(space: Space, motion: Motion) -> tuple[Motion, Any]:
    """A motion of length 1, and 1 over the length of the given one."""
    x, y, spin = motion
    rate = 1.0 / space.sqrt(x * x + y * y + spin * spin)
    return Motion(x * rate, y * rate, spin * rate), rate


def friction_and_hessian(
    space: Space, motion: Motion, corners: tuple[Any, Any]
) -> tuple[Motion, Six]:
    """Reduced friction under a motion, and second derivatives of the reduced power."""
    unit, rate = _unit(space, motion)
    edge, inv_area = edges_of(space, unit, *corners), inverse_area(space, *corners)
    xx, xy, yy, xn, yn, nn = power_hessian(space, unit, edge, inv_area)
    hessian = rate * xx, rate * xy, rate * yy, rate * xn, rate * yn, rate * nn
    return friction(space, unit, edge, inv_area), hessian


def _ruled(space: Space) -> Any:
    """Reduced friction of (x, y, spin) and the corners' x and y, the first derivatives of which are closed."""

    def value(*given: Any) -> tuple[Any, ...]:
        unit, _ = _unit(space, Motion(*given[:3]))
        corners = given[3:]
        edge = edges_of(space, unit, *corners)
        return tuple(friction(space, unit, edge, inverse_area(space, *corners)))

    def rule(given: Sequence[Any], rates: Sequence[Any]) -> tuple[Any, Any]:
        unit, rate = _unit(space, Motion(*given[:3]))
        x, y = given[3:]
        edge, inv_area = edges_of(space, unit, x, y), inverse_area(space, x, y)
        made = friction(space, unit, edge, inv_area)
        changes = [0.0 * part for part in made]
        if any(moves is not None for moves in rates[:3]):
            xx, xy, yy, xn, yn, nn = power_hessian(space, unit, edge, inv_area)
            for column, moves in zip(((xx, xy, xn), (xy, yy, yn), (xn, yn, nn)), rates[:3]):
                if moves is not None:
                    by = rate * moves
                    changes = [change - part * by for change, part in zip(changes, column)]
        if any(moves is not None for moves in rates[3:]):
            still = [
                0.0 * corner if moves is None else moves for corner, moves in zip((x, y), rates[3:])
            ]
            pushed = friction_rates(space, unit, edge, made, (x, y, inv_area), (still[0], still[1]))
            changes = [change + part for change, part in zip(changes, pushed)]
        return tuple(made), tuple(changes)

    return space.ruled(value, rule)


def inverse_area(space: Space, x: Any, y: Any) -> Any:
    """1 over the area, negative of corners that go clockwise."""
    return 2.0 / space.total(x * space.following(y) - y * space.following(x))


def _matrix(space: Space, parts: Six) -> Any:
    """A symmetric matrix of shape (..., 3, 3)."""
    xx, xy, yy, xn, yn, nn = parts
    rows = (xx, xy, xn, xy, yy, yn, xn, yn, nn)
    flat = space.stack(rows)
    return flat.reshape((*flat.shape[:-1], 3, 3))
