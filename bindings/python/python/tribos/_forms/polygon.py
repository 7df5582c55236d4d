"""Friction of polygons under uniform pressure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from tribos._forms import polygon_search
from tribos._forms.form import Nearest, Ray
from tribos._forms.moving_corners import friction_rates
from tribos._forms.moving_edge import Motion, Six, edges_of, friction, power_hessian
from tribos._forms.outline import Outline, in_its_unit, inverse_area, of_length_one, outline_of
from tribos._forms.polygon_search import Three
from tribos._forms.space import Space


@dataclass(frozen=True)
class Flat:
    """A polygon under uniform pressure.

    Parameters
    ----------
    corners
        In m, of shape (..., n, 2), in the frame that twists and wrenches refer to, in either sense of rotation.
        Corners that repeat make no difference. Leading axes are broadcast with those of twists.
    unit
        Unit of length of spins and torques, in m: a number or of the leading axes.

    Notes
    -----
    Accuracy, of the force limit and that times the distance of the farthest corner: 1e-15 in float64, 3e-7 in float32,
    for aspect ratios up to 10; a longer one is lost in proportion. Edges that cross and areas of zero have no friction
    that is right.
    """

    corners: Any
    unit: Any = 1.0

    @property
    def arrays(self) -> tuple[Any, ...]:
        return self.corners, self.unit

    def of(self, arrays: tuple[Any, ...]) -> Flat:
        return Flat(*arrays)

    def per(self, space: Space, length: Any) -> Flat:
        return Flat(self.corners, self.unit * length)

    def reach(self, space: Space) -> Any:
        outline = outline_of(space, self.corners, 0)
        off_sq = outline.centre_x * outline.centre_x + outline.centre_y * outline.centre_y
        return space.still((outline.radius + space.sqrt(off_sq)) / self.unit)

    def centre(self, space: Space) -> tuple[Any, Any]:
        outline = outline_of(space, self.corners, 0)
        return outline.centre_x / self.unit, outline.centre_y / self.unit

    def spin(self, space: Space) -> Any:
        outline = outline_of(space, self.corners, 0)
        zero = 0.0 * outline.centre_x
        *_, torque = _reduced(space)(zero, zero, 1.0 + zero, *outline.corners)
        return -(outline.radius * torque) / self.unit

    def support(self, space: Space, twists: Any) -> Any:
        made = self.wrench(space, twists)
        x, y, spin = (made[..., axis] * twists[..., axis] for axis in range(3))
        return -(x + y + spin)

    def wrench(self, space: Space, twists: Any) -> Any:
        outline = outline_of(space, self.corners, _rank(twists))
        motion, _, is_rest = in_its_unit(space, self._motion(outline, twists))
        made = _reduced(space)(*motion, *outline.corners)
        x, y, reduced = (space.where(is_rest, 0.0, part) for part in made)
        return space.stack((x, y, outline.torque(x, y, reduced) / self.unit))

    def hessian(self, space: Space, twists: Any) -> Six:
        outline = outline_of(space, self.corners, _rank(twists))
        motion, size, is_rest = in_its_unit(space, self._motion(outline, twists))
        _, hessian = friction_and_hessian(space, motion, outline)
        parts = _about_origin(outline, hessian, self.unit)
        xx, xy, yy, xn, yn, nn = (space.where(is_rest, 0.0, part / size) for part in parts)
        return xx, xy, yy, xn, yn, nn

    def ray(self, space: Space, wrenches: Any) -> Ray:
        outline = outline_of(space, space.still(self.corners), _rank(wrenches))
        size, found = self._above(space, outline, space.still(wrenches))
        return Ray(self._normals(space, outline.twist(found.motion)), size * found.gauge)

    def nearest(self, space: Space, wrenches: Any) -> Nearest:
        outline = outline_of(space, space.still(self.corners), _rank(wrenches))
        wrenches, unit = space.still(wrenches), space.still(self.unit)
        _, above = self._above(space, outline, wrenches)
        # Torques in units of the largest one about the origin.
        zero = 0.0 * outline.centre_x
        arm, _, _ = _power(space, outline, outline.motion(zero, zero, 1.0 + zero))
        x, y, spin = outline.twist(above.motion)
        push = _push_about_origin(outline, above.push, arm)
        found = polygon_search.nearest(
            space,
            lambda at: _power_about_origin(space, outline, at, arm),
            (wrenches[..., 0], wrenches[..., 1], wrenches[..., 2] * (unit / arm)),
            polygon_search.Point((x, y, spin * arm), above.power, push, above.gauge),
            (unit / arm) * (unit / arm),
        )
        x, y, spin = found.motion
        normals = self._normals(space, (x, y, spin / arm))
        x, y, torque = found.push
        return Nearest(space.stack((x, y, torque * (arm / unit))), normals, found.gauge)

    def _motion(self, outline: Outline, twists: Any) -> Motion:
        return outline.motion(twists[..., 0], twists[..., 1], twists[..., 2] / self.unit)

    def _normals(self, space: Space, twist: Three) -> Any:
        """Twists of length 1."""
        x, y, spin = twist
        motion, *_ = in_its_unit(space, Motion(x, y, spin * space.still(self.unit)))
        return space.stack(of_length_one(space, motion)[0])

    def _above(
        self, space: Space, outline: Outline, wrenches: Any
    ) -> tuple[Any, polygon_search.Point]:
        """The sizes of wrenches about the centre, and the points on their rays."""
        x, y = wrenches[..., 0], wrenches[..., 1]
        torque = outline.reduced(x, y, wrenches[..., 2] * space.still(self.unit))
        # Any direction does for no wrench.
        direction, size, _ = in_its_unit(space, Motion(x, y, torque))
        (x, y, torque), per_length = of_length_one(space, direction)
        # From the normal of the ellipsoid with the same largest force and torque on.
        zero = 0.0 * outline.centre_x
        most, _, _ = _power(space, outline, Motion(zero, zero, 1.0 + zero))
        start = x, y, torque / (most * most)
        found = polygon_search.above(
            space, lambda at: _power(space, outline, Motion(*at)), (x, y, torque), start
        )
        return size / per_length, found


def _rank(rows: Any) -> int:
    return len(rows.shape) - 1


def _power(space: Space, outline: Outline, motion: Motion) -> tuple[Any, Three, Six]:
    """Power under a motion, its gradient and its second derivatives."""
    made, hessian = friction_and_hessian(space, motion, outline)
    push = -made.x, -made.y, -made.spin
    return polygon_search.dot(push, motion), push, hessian


def _power_about_origin(
    space: Space, outline: Outline, at: Three, arm: Any
) -> tuple[Any, Three, Six]:
    """The same by the velocity of the frame's origin and the spin times a length."""
    value, push, hessian = _power(space, outline, outline.motion(at[0], at[1], at[2] / arm))
    return value, _push_about_origin(outline, push, arm), _about_origin(outline, hessian, arm)


def _push_about_origin(outline: Outline, push: Three, unit: Any) -> Three:
    x, y, reduced = push
    return x, y, outline.torque(x, y, reduced) / unit


def _about_origin(outline: Outline, hessian: Six, unit: Any) -> Six:
    """Second derivatives by the velocity of the frame's origin and the spin in a unit of length."""
    xx, xy, yy, xn, yn, nn = hessian
    x, y, n = (part / unit for part in outline.motion(0.0, 0.0, 1.0))
    by_x, by_y = xx * x + xy * y + xn * n, xy * x + yy * y + yn * n
    return xx, xy, yy, by_x, by_y, n * (xn * x + yn * y + nn * n) + (x * by_x + y * by_y)


def friction_and_hessian(space: Space, motion: Motion, outline: Outline) -> tuple[Motion, Six]:
    """Reduced friction under a motion, and second derivatives of the reduced power."""
    unit, rate = of_length_one(space, motion)
    edge, inv_area = edges_of(space, unit, *outline.corners), inverse_area(space, *outline.corners)
    xx, xy, yy, xn, yn, nn = power_hessian(space, unit, edge, inv_area)
    hessian = rate * xx, rate * xy, rate * yy, rate * xn, rate * yn, rate * nn
    return friction(space, unit, edge, inv_area), hessian


@cache
def _reduced(space: Space) -> Callable[..., Any]:
    """Reduced friction by motions (x, y, spin) and the corners' x and y, the first derivatives of which are closed."""

    def value(*given: Any) -> tuple[Any, ...]:
        unit, _ = of_length_one(space, Motion(*given[:3]))
        edge, inv_area = edges_of(space, unit, *given[3:]), inverse_area(space, *given[3:])
        return tuple(friction(space, unit, edge, inv_area))

    def rule(given: Sequence[Any], rates: Sequence[Any]) -> tuple[Any, Any]:
        unit, rate = of_length_one(space, Motion(*given[:3]))
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
            moved = [
                0.0 * at if moves is None else moves for at, moves in zip((x, y), rates[3:])
            ]
            by_corners = friction_rates(space, unit, edge, made, (x, y, inv_area), moved)
            changes = [change + part for change, part in zip(changes, by_corners)]
        return tuple(made), tuple(changes)

    return space.ruled(value, rule)
