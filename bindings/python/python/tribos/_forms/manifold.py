"""Friction of contact manifolds: the projection of the kernel's `manifold_friction/project.rs`.

From the impulses that would stop a manifold's contact to the nearest ones that friction can carry, by the energy
k |dp|² + kt dt², in the set (|p|/F, |t|/(F lever)) within a limit curve y = √(1 − X) (1 + h₁ X + h₂ X² + h₄ X⁴), X = x².
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from tribos._forms.space import Space

CURVES = {
    "area": (-0.245, -0.036812603, 0.034142315),
    "points": (-0.5203, 0.2304, 0.0135),
    "ellipsoid": (0.0, 0.0, 0.0),
}
"""h₁, h₂ and h₄ of disks and squares, of rings and feet at the corners of a square, and of x² + y² = 1."""

#: The arguments of functions of arrays in their order, with the curve's coefficients, and whether numbers are above 0 or at least 0.
ARGUMENTS = (
    "impulses",
    "twist",
    "force",
    "lever",
    "k",
    "kt",
    "slip",
    "curve 1",
    "curve 2",
    "curve 4",
)
SIGNS = {"force": False, "lever": False, "k": True, "kt": False, "slip": True}
#: Where denominators that may be zero end, and least argument of a root, so that its second derivative is finite.
TINY = {"float32": 1e-18, "float64": 1e-100}
#: As in the kernel: least share of a weight, widening of the circle from which the search starts, steps for its
#: multiplier, longest step along the curve and the least one from which a second derivative is taken.
LEAST_WEIGHT, WIDENING, STARTING_STEPS = 1e-6, 0.55, 2
LONGEST_STEP, SHORT_STEP = 0.6, 1e-4
#: Least slope of the equation, of the largest weight: its square has a reciprocal.
LEAST_DESCENT = 1e-12
DIAGONAL = 0.5**0.5


def terms_in(name: str, curve: Any, steps: Any) -> tuple[Any, Any, Any]:
    """The three coefficients of a curve, in an argument of a function; its steps are looked at, too."""
    if not isinstance(steps, int) or steps < 1:
        raise ValueError(f"{name}: steps must be a whole number > 0, not {steps!r}")
    terms = CURVES.get(curve) if isinstance(curve, str) else curve
    if terms is None or len(terms) != 3:
        raise ValueError(
            f"{name}: curve must be one of {list(CURVES)} or three numbers, not {curve!r}"
        )
    return terms[0], terms[1], terms[2]


class _Scaled(NamedTuple):
    """Weights of force and torque, and their products with the candidate, none above 1; the curve."""

    a: Any
    b: Any
    a_force: Any
    b_torque: Any
    curve: tuple[Any, Any, Any]


def manifold_friction(
    space: Space,
    p: Any,
    twist: Any,
    force: Any,
    lever: Any,
    *,
    k: Any,
    kt: Any,
    slip: Any = 1.0,
    curve: tuple[Any, Any, Any] = CURVES["area"],
    steps: int = 2,
) -> tuple[Any, Any]:
    """The nearest impulses that friction can carry.

    Parameters
    ----------
    p, twist
        Tangential impulses in N s, of shape (..., 2), and angular ones in N m s, that would stop the contact.
    force, lever
        Largest tangential impulse mu Σλ in N s and mean distance from the friction centre in m, at least 0.
    k, kt
        Inverse effective masses in 1/kg, above 0, and 1/(kg m²), at least 0.
    slip
        Dynamic over static coefficient, above 0 and at most 1.
    curve
        h₁, h₂ and h₄ of the limit curve.
    steps
        Newton steps along the curve.

    Notes
    -----
    Accuracy: 5e-4 of the limits for energy ratios of 0.01 to 100 in two steps, 1e-5 in three; in the set to
    rounding always. First and second derivatives are those of the nearest point, by the theorem of implicit functions, at
    the point found: right to its accuracy, finite everywhere.
    """
    given = (twist, force, lever, k, kt, slip, *curve)
    given = (p[..., 0], p[..., 1], *(space.constant(part, p) for part in given))
    x, y, twist = _projected(space, steps)(*given)
    return space.stack((x, y)), twist


@cache
def _projected(space: Space, steps: int) -> Callable[..., Any]:
    """The same for arrays in a row, the derivatives of which are those of the point that solves the equation."""

    def value(*given: Any) -> tuple[Any, Any, Any]:
        return _carried(space, given, steps, 0)

    def rule(given: Any, rates: Any) -> tuple[Any, Any]:
        # Two of Newton's steps of no length, for first and second derivatives.
        moved = space.pushed(lambda *at: _carried(space, at, steps, 2), given, rates)
        return value(*given), moved

    return space.ruled(value, rule)


def _carried(space: Space, given: Any, steps: int, settling: int) -> tuple[Any, Any, Any]:
    """Impulses, after steps of no length that bring the derivatives."""
    x, y, twist, force, lever, k, kt, slip, *terms = given
    curve = terms[0], terms[1], terms[2]
    tiny = TINY[space.type_of(x)]
    # Without lever nothing turns; NaN passes.
    twist = space.where(lever > 0.0, twist, 0.0 * twist)
    limit = force * lever
    size = space.sqrt(x * x + y * y + tiny * tiny)
    torque = space.abs(twist)
    holds = _holds(space, curve, (size, torque), (force, limit), slip)
    scaled, start = _scaled(space, (x, y), (size, torque), (force, limit), (k, kt), curve)
    s, c = _searched(space, scaled, start, steps)
    for _ in range(settling):
        angle, _ = _step(space, scaled, s, c, None)
        s, c = _turned(space, s, c, angle - space.still(angle))
        s, c = space.apart((s, c))
    height, _, _ = _height(curve, s * s)
    carried = _smaller(space, s * force, size) / size
    angular = _smaller(space, c * height * limit, torque)
    angular = space.where(twist < 0.0, -angular, angular)
    share = space.where(holds, 1.0, carried)
    return share * x, share * y, space.where(holds, twist, angular)


def _smaller(space: Space, a: Any, b: Any) -> Any:
    return space.where(b < a, b, a)


def _larger(space: Space, a: Any, b: Any) -> Any:
    return space.where(a < b, b, a)


def _height(curve: tuple[Any, Any, Any], x_sq: Any) -> tuple[Any, Any, Any]:
    """h and its first two derivatives at X."""
    h1, h2, h4 = curve
    x_fourth = x_sq * x_sq
    return (
        (1.0 + h1 * x_sq) + x_fourth * (h2 + h4 * x_fourth),
        (h1 + 2.0 * h2 * x_sq) + (4.0 * h4 * x_sq) * x_fourth,
        2.0 * h2 + (12.0 * h4) * x_fourth,
    )


def _holds(space: Space, curve: Any, sizes: Any, limits: Any, slip: Any) -> Any:
    """Where static friction holds the candidate."""
    x, y = (
        slip * size / space.where(limit > 0.0, limit, 1.0) for size, limit in zip(sizes, limits)
    )
    x_sq, y_sq = x * x, y * y
    height, _, _ = _height(curve, _smaller(space, x_sq, 1.0))
    turns = limits[1] > 0.0
    y_sq = space.where(turns, y_sq, 0.0 * y_sq)
    return (limits[0] > 0.0) & (y_sq <= (1.0 - x_sq) * height * height)


def _scaled(
    space: Space, p: Any, sizes: Any, limits: Any, inverse: Any, curve: Any
) -> tuple[_Scaled, Any]:
    """The metric in units of the limits, as energies, and a lower bound of the force's part."""
    size, torque = sizes
    force_weight, torque_weight = (one * limit for one, limit in zip(inverse, limits))
    a, b = force_weight * limits[0], torque_weight * limits[1]
    sum_ = a + b
    least = LEAST_WEIGHT * sum_
    a, b = _larger(space, a, least), _larger(space, b, least)
    x, y = space.abs(p[0]), space.abs(p[1])
    longest = _larger(space, _larger(space, x, y), DIAGONAL * (x + y))
    start, b_torque = force_weight * longest, torque_weight * torque
    # Only the ratios count, so that their unit takes part in no derivative.
    most = space.still(start + b_torque + sum_)
    unit = 1.0 / space.where(most > 0.0, most, 1.0)
    force_weight = force_weight * unit
    scaled = _Scaled(a * unit, b * unit, force_weight * size, b_torque * unit, curve)
    return scaled, start * unit


def _searched(space: Space, scaled: _Scaled, start: Any, steps: int) -> tuple[Any, Any]:
    """The point (s, c h(s²)) of the curve, without derivatives."""
    h1, h2, h4 = (space.still(term) for term in scaled.curve)
    a, b, a_force, b_torque = (space.still(part) for part in scaled[:4])
    scaled = _Scaled(a, b, a_force, b_torque, (h1, h2, h4))
    tiny = TINY[space.type_of(scaled.a)]
    multiplier, spinning_sq = _nearest_of_circle(space, scaled, space.still(start), tiny)
    s, c = _start(space, scaled, multiplier, spinning_sq, tiny)
    last = None
    for _ in range(steps):
        last = _step(space, scaled, s, c, last)
        s, c = _turned(space, s, c, last[0])
    s, c = space.apart((s, c))
    return s, c


def _nearest_of_circle(space: Space, scaled: _Scaled, start: Any, tiny: float) -> tuple[Any, Any]:
    """The multiplier of the nearest point of a circle like the curve, and nearly its share of spin."""
    a, b, p, q, (h1, h2, _) = scaled
    between = DIAGONAL * start + (DIAGONAL * q - _larger(space, a, b))
    multiplier = _larger(space, _larger(space, start - a, q - b), _larger(space, between, 0.0))
    widening = WIDENING * (h1 + 0.5 * h2)
    spinning_sq, radius = 0.0 * multiplier, 1.0
    for _ in range(STARTING_STEPS):
        over_a, over_b = a + multiplier, b + multiplier
        x, y = p * over_b, q * over_a
        x_sq, y_sq = x * x, y * y
        sum_, circle = x_sq + y_sq, (over_a * over_b) * radius
        circle_sq = circle * circle
        rise = (sum_ * (circle + circle)) * (sum_ - circle_sq)
        slope = (sum_ + 3.0 * circle_sq) * (x_sq * over_b + y_sq * over_a)
        multiplier = _larger(space, multiplier + rise / _larger(space, slope, tiny), 0.0)
        spinning_sq = y_sq / _larger(space, sum_, tiny)
        radius = 1.0 + widening * (spinning_sq * (1.0 - spinning_sq))
    return multiplier, spinning_sq


def _start(
    space: Space, scaled: _Scaled, multiplier: Any, spinning_sq: Any, tiny: float
) -> tuple[Any, Any]:
    """The point (s, c h(s²)) of the curve that has the multiplier of the circle."""
    a, b, p, q, curve = scaled
    height, slope, _ = _height(curve, 1.0 - spinning_sq)
    steep = height - (spinning_sq + spinning_sq) * slope
    s, c = p * (multiplier + steep * height * b), steep * q * (a + multiplier)
    scale = 1.0 / space.sqrt(_larger(space, s * s + c * c, tiny))
    return s * scale, c * scale


def _step(
    space: Space, scaled: _Scaled, s: Any, c: Any, last: tuple[Any, Any] | None
) -> tuple[Any, Any]:
    """Newton's step for the angle φ, s = sin φ, at which a (P − x) x′ + b (Q − y) y′ = 0, and minus its derivative."""
    a, b, p, q, curve = scaled
    s_sq, c_sq, sc = s * s, c * c, s * c
    height, slope, bend = _height(curve, s_sq)
    double = c_sq + c_sq
    steep = height - double * slope
    half_steep_slope = sc * (3.0 * slope - double * bend)
    y_slope = s * steep
    y_bend = c * steep + s * (half_steep_slope + half_steep_slope)
    from_x, from_y = p - a * s, q - b * (c * height)
    residual = from_x * c - from_y * y_slope
    along = a * c_sq + from_x * s
    descent = _larger(
        space, along + ((b * s_sq) * (steep * steep) + from_y * y_bend), LEAST_DESCENT
    )
    angle = _larger(space, _smaller(space, residual / descent, LONGEST_STEP), -LONGEST_STEP)
    if last is not None:
        # Second derivative by the difference of the first ones; none after a step too short for it.
        is_short = space.abs(last[0]) < SHORT_STEP
        change = space.where(is_short, 0.0, descent - last[1])
        over = space.where(is_short, 1.0, last[0]) * descent
        factor = 1.0 - 0.5 * angle * (change / over)
        angle = angle * _larger(space, _smaller(space, factor, 1.5), 0.5)
    return angle, descent


def _turned(space: Space, s: Any, c: Any, angle: Any) -> tuple[Any, Any]:
    """(s, c) + angle (c, −s), on the unit circle to the fourth power of the angle."""
    onto = 1.5 - 0.5 * (s * s + c * c)
    s, c = s * onto, c * onto
    scale = 1.0 - 0.5 * (angle * angle)
    return space.abs((s + angle * c) * scale), space.abs((c - angle * s) * scale)
