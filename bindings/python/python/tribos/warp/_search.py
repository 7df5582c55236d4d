"""The twist at which a strictly convex function of the dissipated power is least, for any patch.

With the power D(t), its gradient g and its Hessian, of a patch under a force limit of 1, a wrench x and
a metric M,

    φ(t) = D(t)²/2 − x·t           is least where t is the normal above x, and D(t) is the gauge of x
    ψ(t) = t·M t/2 + D(t) − x·t    is least where x − M t is the point of the set nearest to x

Newton's method with steps that are halved until they descend, as in the kernel's file search.rs. Torques
are over an arm, the largest torque over the limit.
"""

from __future__ import annotations

import warp as wp

from tribos.warp._edges import box_friction, polygon_friction, vec9
from tribos.warp._round import unit_round_jacobian, unit_round_wrench

# A gradient of this many rounding errors of the wrench is none.
DONE = wp.constant(8.0 * 2.0**-23)
# Least pivot of a matrix, of its diagonal.
PIVOT = wp.constant(4.0 * 2.0**-23)
# Most Newton steps, and halvings of one.
STEPS = wp.constant(30)
HALVINGS = wp.constant(12)
# Share of the linear decrease that a step must bring.
ENOUGH = wp.constant(1e-4)
MOST = wp.constant(1.0 - 2e-4)
# A gradient above this is more than rounding, and one below the other may be.
ROUGH = wp.constant(32.0 * 2.0**-23)
SMALL = wp.constant(2.0**-11.5)
# Half width of the surface, of the gauge.
COLLAR = wp.constant(64.0 * 2.0**-23)
# Force limits from which on a wrench is the unit of its own search.
FAR = wp.constant(1024.0)


# What is not round, beside the numbers of the pressures.
BOX = wp.constant(5)
POLYGON = wp.constant(6)


@wp.struct
class Shape:
    """A patch: a pressure of `_forms`, `BOX` or `POLYGON`."""

    kind: int
    sides: wp.vec2
    corners: wp.array(dtype=wp.vec2)


@wp.func
def round_friction(pressure: int, motion: wp.vec3) -> vec9:
    """Reduced friction and Hessian of the power, as `polygon_friction`."""
    at = unit_round_wrench(pressure, motion)
    slope = unit_round_jacobian(pressure, motion)
    return vec9(
        at[0],
        at[1],
        at[2],
        -slope[0, 0],
        -slope[0, 1],
        -slope[1, 1],
        -slope[0, 2],
        -slope[1, 2],
        -slope[2, 2],
    )


@wp.func
def shape_friction(shape: Shape, frame: wp.vec4, motion: wp.vec3) -> vec9:
    """Reduced friction for a motion of the centre, not zero, and the Hessian of the power."""
    if shape.kind == BOX:
        return box_friction(shape.sides[0], shape.sides[1], frame, motion, True)
    if shape.kind == POLYGON:
        return polygon_friction(shape.corners, frame, motion, True)
    return round_friction(shape.kind, motion)


@wp.func
def box_shape(a: float, b: float) -> Shape:
    shape = Shape()
    shape.kind = BOX
    shape.sides = wp.vec2(a, b)
    return shape


@wp.func
def polygon_shape(corners: wp.array(dtype=wp.vec2)) -> Shape:
    shape = Shape()
    shape.kind = POLYGON
    shape.corners = corners
    return shape


@wp.func
def power_at(shape: Shape, frame: wp.vec4, arm: float, at: wp.vec3) -> vec9:
    """Gradient and Hessian of the power about the origin, with the arm as the unit of length."""
    spin = at[2] / arm
    motion = wp.vec3(at[0] - spin * frame[1], at[1] + spin * frame[0], spin * frame[2])
    unit = shape_friction(shape, frame, motion)
    x = frame[0] / arm
    y = frame[1] / arm
    radius = frame[2] / arm
    xx = unit[3]
    xy = unit[4]
    yy = unit[5]
    xn = radius * unit[6]
    yn = radius * unit[7]
    # The centre moves with (−y, x) for each unit of spin about the origin.
    from_x = xy * x - xx * y
    from_y = yy * x - xy * y
    turned = radius * radius * unit[8] + 2.0 * (yn * x - xn * y) + (from_y * x - from_x * y)
    torque = radius * unit[2] + (x * unit[1] - y * unit[0])
    return vec9(-unit[0], -unit[1], -torque, xx, xy, yy, xn + from_x, yn + from_y, turned)


@wp.func
def hessian_of(power: vec9) -> wp.mat33:
    return wp.mat33(
        power[3], power[4], power[6], power[4], power[5], power[7], power[6], power[7], power[8]
    )


@wp.func
def solved(m: wp.mat33, right: wp.vec3) -> wp.vec3:
    """The solution of symmetric equations by L D Lᵀ, with pivots that rounding made too small raised."""
    a = m[0, 1] / m[0, 0]
    b = m[0, 2] / m[0, 0]
    y = wp.max(m[1, 1] - a * m[0, 1], PIVOT * m[1, 1])
    c = (m[1, 2] - a * m[0, 2]) / y
    z = wp.max(m[2, 2] - b * m[0, 2] - c * c * y, PIVOT * m[2, 2])
    second = right[1] - a * right[0]
    third = right[2] - b * right[0] - c * second
    n = third / z
    v = second / y - c * n
    return wp.vec3(right[0] / m[0, 0] - a * v - b * n, v, n)


@wp.func
def goal_value(
    is_gauge: bool, at: wp.vec3, power: float, x: wp.vec3, metric: wp.mat33, reach: float
):
    if is_gauge:
        return 0.5 * power * power - wp.dot(x, at)
    return 0.5 * wp.dot(at, metric * at) + reach * power - wp.dot(x, at)


@wp.func
def goal_gradient(
    is_gauge: bool,
    at: wp.vec3,
    power: float,
    g: wp.vec3,
    x: wp.vec3,
    metric: wp.mat33,
    reach: float,
):
    if is_gauge:
        return power * g - x
    return metric * at + reach * g - x


@wp.func
def minimised(
    shape: Shape,
    frame: wp.vec4,
    arm: float,
    is_gauge: bool,
    x: wp.vec3,
    metric: wp.mat33,
    reach: float,
    start: wp.vec3,
) -> wp.vec3:
    """The twist at which φ or ψ is least.

    Of φ, the first twist that proves the wrench to be outside a force limit of `reach`, if there is one.
    """
    at = start
    power = power_at(shape, frame, arm, at)
    g = wp.vec3(power[0], power[1], power[2])
    size = wp.dot(g, at)
    for _ in range(STEPS):
        if is_gauge and wp.dot(x, at) > (1.0 + 4.0 * COLLAR) * reach * size:
            break
        gradient = goal_gradient(is_gauge, at, size, g, x, metric, reach)
        length = wp.length(gradient)
        if length <= DONE or not wp.isfinite(length):
            break
        matrix = reach * hessian_of(power) + metric
        if is_gauge:
            matrix = wp.outer(g, g) + size * hessian_of(power)
        step = solved(matrix, gradient)
        descent = wp.dot(gradient, step)
        before = goal_value(is_gauge, at, size, x, metric, reach)
        slack = DONE * (1.0 + wp.abs(before))
        factor = float(1.0)
        next_at = at - step
        next_power = power_at(shape, frame, arm, next_at)
        next_g = wp.vec3(next_power[0], next_power[1], next_power[2])
        next_size = wp.dot(next_g, next_at)
        after = goal_value(is_gauge, next_at, next_size, x, metric, reach)
        found = goal_gradient(is_gauge, next_at, next_size, next_g, x, metric, reach)
        for _ in range(HALVINGS):
            # Where rounding hides what a step gains, its slope at the end decides.
            is_level = wp.dot(found, step) >= -MOST * descent
            if after <= before - ENOUGH * factor * descent or (
                after <= before + slack and is_level
            ):
                break
            factor = 0.5 * factor
            next_at = at - factor * step
            next_power = power_at(shape, frame, arm, next_at)
            next_g = wp.vec3(next_power[0], next_power[1], next_power[2])
            next_size = wp.dot(next_g, next_at)
            after = goal_value(is_gauge, next_at, next_size, x, metric, reach)
            found = goal_gradient(is_gauge, next_at, next_size, next_g, x, metric, reach)
        gains = wp.length(found) < length or after < before - slack
        # A step into a narrow bend levels the slope along it before it shortens the gradient.
        bends = length > ROUGH and wp.abs(wp.dot(found, step)) < 0.5 * descent
        if factor == 1.0 and length < SMALL and not gains and not bends:
            # The gradient is its own rounding.
            break
        at = next_at
        power = next_power
        g = next_g
        size = next_size
    return at


@wp.func
def arm_of(shape: Shape, frame: wp.vec4) -> float:
    """The torque about the origin of spinning in place, over the force limit."""
    unit = shape_friction(shape, frame, wp.vec3(-frame[1], frame[0], frame[2]))
    return -(frame[2] * unit[2] + (frame[0] * unit[1] - frame[1] * unit[0]))


@wp.func
def shape_motion(shape: Shape, frame: wp.vec4, arm: float, x: wp.vec3, metric: wp.mat33) -> wp.vec4:
    """The motion t with x − M t the point of the set nearest to x, and 1; or 0 where x is in the set.

    x and the set are in units of the force limit and the arm.
    """
    size = wp.length(x)
    if size == 0.0:
        return wp.vec4(0.0, 0.0, 0.0, 0.0)
    unit = x / size
    # No patch carries more force, or more torque about the origin, than in one motion alone.
    above = minimised(shape, frame, arm, True, unit, metric, 1.0 / size, unit)
    power = power_at(shape, frame, arm, above)
    reached = wp.dot(wp.vec3(power[0], power[1], power[2]), above)
    if not size * wp.dot(unit, above) > (1.0 + COLLAR) * reached:
        return wp.vec4(0.0, 0.0, 0.0, 0.0)
    given = x
    reach = float(1.0)
    if size > FAR:
        given = unit
        reach = 1.0 / size
    # Along the normal ψ is a parabola.
    far = (wp.dot(given, above) - reach * reached) / wp.dot(above, metric * above)
    at = minimised(shape, frame, arm, False, given, metric, reach, far * above)
    return wp.vec4(at[0] / reach, at[1] / reach, at[2] / reach, 1.0)


@wp.func
def shape_projected(
    shape: Shape, frame: wp.vec4, wrench: wp.vec3, limit: float, metric: wp.mat33
) -> wp.vec3:
    """The nearest wrench that a patch carries, by the distance √(x·M⁻¹x) of force and torque."""
    if limit <= 0.0:
        return wp.vec3(0.0, 0.0, 0.0)
    arm = arm_of(shape, frame)
    x = wp.vec3(wrench[0] / limit, wrench[1] / limit, wrench[2] / limit / arm)
    at = shape_motion(shape, frame, arm, x, in_arms(metric, arm))
    if at[3] == 0.0:
        return wrench
    power = power_at(shape, frame, arm, wp.vec3(at[0], at[1], at[2]))
    return limit * wp.vec3(power[0], power[1], arm * power[2])


@wp.func
def in_arms(metric: wp.mat33, arm: float) -> wp.mat33:
    """A matrix that makes wrenches of twists, with another unit of length."""
    per = 1.0 / arm
    return wp.mat33(
        metric[0, 0],
        metric[0, 1],
        per * metric[0, 2],
        metric[1, 0],
        metric[1, 1],
        per * metric[1, 2],
        per * metric[2, 0],
        per * metric[2, 1],
        per * per * metric[2, 2],
    )


for _function in (
    round_friction,
    shape_friction,
    box_shape,
    polygon_shape,
    power_at,
    hessian_of,
    solved,
    goal_value,
    goal_gradient,
    minimised,
    arm_of,
    shape_motion,
    shape_projected,
    in_arms,
):
    _function.adj.skip_reverse_codegen = True
