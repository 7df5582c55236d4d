"""Friction of round patches."""

from __future__ import annotations

import warp as wp

from tribos.warp._forms import DISK, force_and_slope, force_and_torque
from tribos.warp._logarithm import power_of_two_next_to

# Speeds between this one and its reciprocal have squares and quotients that are normal numbers.
LEAST_SPEED = wp.constant(1e-15)
MOST_SPEED = wp.constant(1e15)
# Brings numbers below the normal ones to normal ones.
RAISED = wp.constant(2.0**64)


@wp.func
def ordinary(motion: wp.vec3) -> wp.vec3:
    """The motion times a power of two that makes its largest part an ordinary number, if it is not."""
    size = wp.max(wp.max(wp.abs(motion[0]), wp.abs(motion[1])), wp.abs(motion[2]))
    if size > LEAST_SPEED and size < MOST_SPEED:
        return motion
    if size == 0.0:
        return motion
    if size < LEAST_SPEED:
        motion = motion * RAISED
        size = size * RAISED
        if size < LEAST_SPEED:
            motion = motion * RAISED
            size = size * RAISED
    return motion / power_of_two_next_to(size)


@wp.func
def round_drag(pressure: int, at: wp.vec3) -> wp.vec2:
    """Force over velocity and torque, over limit and radius, for an ordinary motion (vx, vy, ωR)."""
    rim_sq = at[2] * at[2]
    slide_sq = at[0] * at[0] + at[1] * at[1]
    slides = rim_sq < slide_sq
    major = wp.max(slide_sq, rim_sq)
    if major == 0.0:
        return wp.vec2(0.0, 0.0)
    per_major = 1.0 / major
    z = 1.0
    if slide_sq > 0.0:
        z = (major - wp.min(slide_sq, rim_sq)) * per_major
    factors = force_and_torque(pressure, slides, z)
    per_speed = wp.sqrt(per_major)
    if slides:
        return wp.vec2(per_speed * factors[0], at[2] * per_speed * factors[1])
    return wp.vec2(per_speed * factors[0], wp.sign(at[2]) * factors[1])


@wp.func
def unit_round_wrench(pressure: int, motion: wp.vec3) -> wp.vec3:
    """Force and torque over limit and radius for a motion (vx, vy, ωR); zero at rest."""
    at = ordinary(motion)
    drag = round_drag(pressure, at)
    return wp.vec3(-drag[0] * at[0], -drag[0] * at[1], -drag[1])


@wp.func
def unit_round_jacobian(pressure: int, motion: wp.vec3) -> wp.mat33:
    """∂wrench/∂motion of `unit_round_wrench`, in closed form; zero at rest.

    With V = |v|², W = (ωR)² and force v a, torque ωR b: c = ∂a/∂W = ∂b/∂V, and dry friction does not
    grow with the motion, so that c and ∂a/∂V follow from Φ and Φ' by the side that leads.
    """
    size = wp.max(wp.max(wp.abs(motion[0]), wp.abs(motion[1])), wp.abs(motion[2]))
    if size == 0.0:
        return wp.mat33(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    x = motion[0] / size
    y = motion[1] / size
    r = motion[2] / size
    rim_sq = r * r
    slide_sq = x * x + y * y
    slides = rim_sq < slide_sq
    per_major = 1.0 / wp.max(slide_sq, rim_sq)
    minor = wp.min(slide_sq, rim_sq)
    z = (wp.max(slide_sq, rim_sq) - minor) * per_major
    at = force_and_slope(pressure, slides, z)
    rate = wp.sqrt(per_major) / size
    steep = -(rate * per_major * at[1])
    rest = rate * per_major * (0.5 * at[0] + minor * per_major * at[1])
    own = 2.0 * wp.where(slides, rest, steep)
    mixed = 2.0 * wp.where(slides, steep, rest)
    # a = own V + mixed W: nothing cancels.
    xx = own * y * y + mixed * rim_sq
    xy = -own * x * y
    yy = own * x * x + mixed * rim_sq
    xn = -mixed * r * x
    yn = -mixed * r * y
    nn = mixed * slide_sq
    return wp.mat33(-xx, -xy, -xn, -xy, -yy, -yn, -xn, -yn, -nn)


@wp.func
def round_wrench(pressure: int, twist: wp.vec3, limit: float, radius: float) -> wp.vec3:
    """Coulomb friction of a round patch.

    Parameters
    ----------
    pressure
        `DISK`, `RING`, `PUNCH`, `HERTZ` or `PARABOLOID`.
    twist
        Velocity along x and y in m/s and spin in rad/s of the patch's centre.
    limit
        mu times load, in N, at least 0.
    radius
        In m.

    Returns
    -------
    vec3
        Force along x and y in N and torque in N m on the body; zero at rest.
    """
    at = ordinary(wp.vec3(twist[0], twist[1], twist[2] * radius))
    drag = round_drag(pressure, at)
    along = limit * drag[0]
    return wp.vec3(-(along * at[0]), -(along * at[1]), -(limit * radius * drag[1]))


@wp.func_grad(round_wrench)
def _adj_round_wrench(
    pressure: int, twist: wp.vec3, limit: float, radius: float, adj_ret: wp.vec3
) -> None:
    motion = wp.vec3(twist[0], twist[1], twist[2] * radius)
    unit = unit_round_wrench(pressure, motion)
    slope = unit_round_jacobian(pressure, motion)
    along = wp.vec3(adj_ret[0], adj_ret[1], radius * adj_ret[2])
    by_motion = limit * (slope * along)
    wp.adjoint[twist] += wp.vec3(by_motion[0], by_motion[1], radius * by_motion[2])
    wp.adjoint[limit] += wp.dot(unit, along)
    wp.adjoint[radius] += twist[2] * by_motion[2] + limit * unit[2] * adj_ret[2]


@wp.func
def disk_wrench(twist: wp.vec3, limit: float, radius: float) -> wp.vec3:
    """Coulomb friction of a disk under uniform pressure; `round_wrench` has the parameters."""
    return round_wrench(DISK, twist, limit, radius)


for _function in (ordinary, round_drag, unit_round_wrench, unit_round_jacobian):
    _function.adj.skip_reverse_codegen = True
