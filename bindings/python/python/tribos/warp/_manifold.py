"""Friction of a contact manifold: one projection in place of the clamps of two impulses."""

from __future__ import annotations

import warp as wp

# h₁, h₂, h₄ of the limit curve y = √(1 − X) (1 + h₁ X + h₂ X² + h₄ X⁴), X = x²: those of the C header.
CURVE_AREA = wp.constant(wp.vec3(-0.245, -0.036812603, 0.034142315))
"""Limit curve of an area: disk, square."""
CURVE_POINTS = wp.constant(wp.vec3(-0.5203, 0.2304, 0.0135))
"""Limit curve of points: ring, feet."""
CURVE_ELLIPSOID = wp.constant(wp.vec3(0.0, 0.0, 0.0))
"""The ellipsoid."""

TINY = wp.constant(1e-30)
DIAGONAL = wp.constant(0.70710678)
# Weights below this fraction of their sum act as it; what the circle of the start is wider than the curve.
LEAST_WEIGHT = wp.constant(1e-6)
WIDENING = wp.constant(0.55)
# Longest step along the curve, and the least one from which a second derivative is taken, in radians.
LONGEST_STEP = wp.constant(0.6)
SHORT_STEP = wp.constant(1e-4)


@wp.func
def length_of(x: float, y: float) -> float:
    """√(x² + y²), whose derivative at 0 is 0."""
    return wp.sqrt(x * x + y * y)


@wp.func_grad(length_of)
def _adj_length_of(x: float, y: float, adj_ret: float) -> None:
    length = wp.sqrt(x * x + y * y)
    if length > 0.0:
        wp.adjoint[x] += adj_ret * x / length
        wp.adjoint[y] += adj_ret * y / length


@wp.func
def curve_height(curve: wp.vec3, x: float) -> wp.vec3:
    """h and its first two derivatives at X."""
    square = x * x
    twice = curve[1] + curve[1]
    four = 4.0 * curve[2]
    return wp.vec3(
        (1.0 + curve[0] * x) + square * (curve[1] + curve[2] * square),
        (curve[0] + twice * x) + (four * x) * square,
        twice + (3.0 * four) * square,
    )


@wp.func
def manifold_friction(
    impulse: wp.vec3,
    force: float,
    lever: float,
    inv_mass: float,
    inv_inertia: float,
    slip: float,
    curve: wp.vec3,
) -> wp.vec3:
    """The impulses of friction nearest to those that would stop the contact.

    Parameters
    ----------
    impulse
        Along both tangents in N s and about the normal in N m s, at the friction centre.
    force
        mu times the sum of normal impulses, in N s.
    lever
        Mean distance of the contact from the friction centre, in m; 0 for one point.
    inv_mass, inv_inertia
        Inverse effective masses, in 1/kg and 1/(kg m²).
    slip
        Dynamic over static coefficient, above 0 and at most 1.
    curve
        `CURVE_AREA`, `CURVE_POINTS` or `CURVE_ELLIPSOID`.
    """
    turn = wp.where(lever > 0.0, impulse[2], 0.0)
    limit = force * lever
    planar = length_of(impulse[0], impulse[1])
    turning = wp.abs(turn)
    inv = 1.0 / (planar + TINY)
    # An impulse that static friction holds is left as it is.
    x = slip * planar / (force + TINY)
    y = slip * turning / (limit + TINY)
    x_sq = x * x
    at = curve_height(curve, wp.min(x_sq, 1.0))
    if y * y <= (1.0 - x_sq) * at[0] * at[0]:
        return wp.vec3(impulse[0], impulse[1], turn)
    # Only ratios of a, b, a P and b Q count.
    weight = inv_mass * force
    turn_weight = inv_inertia * limit
    a = weight * force
    b = turn_weight * limit
    total = a + b
    least = LEAST_WEIGHT * total
    a = wp.max(a, least)
    b = wp.max(b, least)
    x = wp.abs(impulse[0])
    y = wp.abs(impulse[1])
    start = weight * wp.max(wp.max(x, y), DIAGONAL * (x + y))
    b_turn = turn_weight * turning
    unit = 1.0 / wp.max(start + b_turn + total, TINY)
    a = a * unit
    b = b * unit
    a_force = weight * unit * planar
    b_turn = b_turn * unit
    start = start * unit
    # Multiplier of the nearest point of a circle like the curve: Newton's method from below.
    between = DIAGONAL * start + (DIAGONAL * b_turn - wp.max(a, b))
    multiplier = wp.max(wp.max(start - a, b_turn - b), wp.max(between, 0.0))
    spinning = 0.0
    radius = 1.0
    widening = WIDENING * (curve[0] + 0.5 * curve[1])
    for _ in range(2):
        over_a = a + multiplier
        over_b = b + multiplier
        u = a_force * over_b
        v = b_turn * over_a
        u_sq = u * u
        v_sq = v * v
        sum_sq = u_sq + v_sq
        circle = over_a * over_b * radius
        circle_sq = circle * circle
        rise = sum_sq * (circle + circle) * (sum_sq - circle_sq)
        slope = (sum_sq + 3.0 * circle_sq) * (u_sq * over_b + v_sq * over_a)
        multiplier = wp.max(multiplier + rise / wp.max(slope, TINY), 0.0)
        spinning = v_sq / wp.max(sum_sq, TINY)
        radius = 1.0 + widening * (spinning * (1.0 - spinning))
    # The point (s, c h) of the curve with this multiplier.
    at = curve_height(curve, 1.0 - spinning)
    steep = at[0] - (spinning + spinning) * at[1]
    s = a_force * (multiplier + steep * at[0] * b)
    c = steep * b_turn * (a + multiplier)
    inv_size = 1.0 / wp.sqrt(wp.max(s * s + c * c, TINY))
    s = s * inv_size
    c = c * inv_size
    # Newton steps along the curve, corrected by the change of the slope.
    last = 0.0
    before = 0.0
    for i in range(2):
        s_sq = s * s
        c_sq = c * c
        twice = c_sq + c_sq
        at = curve_height(curve, s_sq)
        steep = at[0] - twice * at[1]
        half_slope = s * c * (3.0 * at[1] - twice * at[2])
        bent = c * steep + s * (half_slope + half_slope)
        from_x = a_force - a * s
        from_y = b_turn - b * (c * at[0])
        residual = from_x * c - from_y * (s * steep)
        descent = (a * c_sq + from_x * s) + ((b * s_sq) * (steep * steep) + from_y * bent)
        descent = wp.max(descent, TINY)
        angle = wp.max(wp.min(residual / descent, LONGEST_STEP), -LONGEST_STEP)
        if i > 0:
            is_short = wp.abs(last) < SHORT_STEP
            change = wp.where(is_short, 0.0, descent - before)
            over = wp.where(is_short, 1.0, last) * descent
            factor = 1.0 - (0.5 * angle) * (change / over)
            angle = angle * wp.max(wp.min(factor, 1.5), 0.5)
        last = angle
        before = descent
        # Back onto the unit circle.
        onto = 1.5 - 0.5 * (s_sq + c_sq)
        s = s * onto
        c = c * onto
        scale = 1.0 - 0.5 * (angle * angle)
        turned = wp.abs((s + angle * c) * scale)
        c = wp.abs((c - angle * s) * scale)
        s = turned
    at = curve_height(curve, s * s)
    carried = wp.min(s * force, planar)
    carried_turn = wp.min(c * at[0] * limit, turning)
    return wp.vec3(
        carried * (impulse[0] * inv),
        carried * (impulse[1] * inv),
        wp.where(turn < 0.0, -1.0 * carried_turn, carried_turn),
    )
