"""Friction of polygons under uniform pressure: the kernel's one form for every motion, edge by edge.

Lengths are in radii and the motion (v, w) of the centroid has |v|² + w² = 1. The symbols are those of the
kernel's file moving_edge.rs: with tangent τ, outward normal n and H = x·n of an edge

    force = −(v + w Σ τ β/area),     torque = −w [2 + Σ (H β − 2 (v·τ) β″)/area]/3

where β and β″ are integrals along the edge, and second derivatives of the power likewise. Edges without
length count nothing. All terms change their sign with the sense of the outline, as its signed area does.
"""

from __future__ import annotations

import warp as wp

from tribos._terms import BEND
from tribos.warp._logarithm import LEAST, log_part

# Speed of a corner at rest, in rounding errors: the speed along its edges is not known better.
_LEAST_SPEED = 0.25 * 2.0**-23
LEAST_CORNER_SQ = wp.constant(_LEAST_SPEED * _LEAST_SPEED)
_BEND = [wp.vec2(*row) for row in BEND["float32"]]
B0, B1, B2, B3, B4, B5 = _BEND

vec9 = wp.types.vector(length=9, dtype=wp.float32)
"""Force, torque and second derivatives xx, xy, yy, xn, yn, nn of the power."""


@wp.func
def bend(gap: float) -> float:
    """G of z = 1 − y², as P + Q ln z."""
    square = gap * gap
    odd = (B5 * square + B3) * square + B1
    even = B4 * square + B2
    sums = B0 + (odd * gap + even * square)
    return sums[0] + log_part(gap) * sums[1]


@wp.struct
class Corner:
    u: wp.vec2
    q: float
    arm: float
    p: float
    rest: float


@wp.func
def moving_corner(v: wp.vec3, x: wp.vec2) -> Corner:
    """A corner under a motion: its velocity and speed q, α, p and p″."""
    w = v[2]
    corner = Corner()
    corner.u = wp.vec2(v[0] - w * x[1], v[1] + w * x[0])
    corner.q = wp.sqrt(corner.u[0] * corner.u[0] + corner.u[1] * corner.u[1] + LEAST_CORNER_SQ)
    corner.arm = v[1] * x[0] - v[0] * x[1]
    sq = x[0] * x[0] + x[1] * x[1]
    from_rim = sq - 1.0
    inv = 1.0 / (corner.q + 1.0)
    arm = corner.arm
    p = (from_rim - arm * ((arm + arm + w * from_rim) * inv)) * inv
    half = 0.5 * w
    corner.p = p
    corner.rest = half * sq - p * (arm + half * p)
    return corner


@wp.func
def edge_sums(
    v: wp.vec3, start: wp.vec2, end: wp.vec2, a: Corner, b: Corner, with_hessian: bool
) -> vec9:
    """What an edge contributes, of the area: τ β, H β − 2 (v·τ) β″, and second derivatives."""
    none = vec9(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    side = end - start
    length = wp.sqrt(side[0] * side[0] + side[1] * side[1])
    if length == 0.0:
        return none
    x = side[0] / length
    y = side[1] / length
    offset = start[0] * y - start[1] * x
    w = v[2]
    along = v[0] * x + v[1] * y
    eta = along + w * offset
    inv_sum = 1.0 / (a.q + b.q)
    reach = length * inv_sum
    zeta = eta * inv_sum
    reach_sq = reach * reach
    zeta_sq = zeta * zeta
    y_sq = w * w * reach_sq
    # ζ²/(1 − y²) and 1 − y², by the sum that does not cancel.
    dot = a.u[0] * b.u[0] + a.u[1] * b.u[1]
    both = (a.q * b.q + wp.abs(dot)) * (inv_sum * inv_sum)
    twice = both + both
    if dot >= 0.0:
        opened = zeta_sq * (1.0 / twice)
        gap = twice
    else:
        inv = 1.0 / (twice * y_sq)
        turned = y_sq + y_sq
        opened = both * both * inv
        gap = zeta_sq * (turned * turned) * inv
    bent = bend(gap + LEAST)
    log = wp.static(1.0 / 3.0) + y_sq * bent
    p = 0.5 * (a.p + b.p)
    arm = 0.5 * (a.arm + b.arm)
    rest = 0.5 * (a.rest + b.rest)
    sigma = arm + w * p
    beta = length * (p - length * reach * (opened - zeta_sq * log))
    zeta_0 = 0.5 * along
    zeta_1 = 0.5 * offset - zeta * sigma
    once = zeta_1 * (zeta + zeta_0) - zeta_0 * zeta_0 * sigma
    closed = opened - zeta_sq * bent
    curved = wp.static(2.0 / 3.0) * once + w * reach_sq * closed
    beta_rest = along * (length * (rest - length * reach * curved))
    found = none
    found[0] = x * beta
    found[1] = y * beta
    found[2] = offset * beta - (beta_rest + beta_rest)
    if not with_hessian:
        return found
    across = v[0] * y - v[1] * x
    middle = 0.5 * ((start[0] + end[0]) * x + (start[1] + end[1]) * y)
    double = inv_sum + inv_sum
    kappa = arm * arm - p + w * arm * p
    spread = double * (kappa + reach_sq * log)
    lengthwise = length * (offset - eta * arm + w * eta * spread)
    rise = length * double * (across * sigma + middle)
    found[3] = lengthwise * x * x - rise * x * y
    found[4] = lengthwise * x * y - 0.5 * rise * (y * y - x * x)
    found[5] = lengthwise * y * y + rise * x * y
    mixed = length * double * (reach_sq * log * eta * along - (p + w * w * kappa))
    found[6] = -(mixed * x)
    found[7] = -(mixed * y)
    total = 2.0 + 2.0 * w * sigma
    share = wp.static(1.0 / 6.0) * sigma * (4.0 + total * (2.0 + total))
    left = wp.static(2.0 / 3.0) * offset - along * share
    turning = left + 2.0 * w * reach_sq * bent * eta
    chi = arm * p - rest - w * double * kappa * (1.0 + p) + reach_sq * inv_sum * along * turning
    found[8] = along * (length * chi)
    return found


@wp.func
def polygon_total(sums: vec9, v: wp.vec3, share: float, rate: float, with_hessian: bool) -> vec9:
    """Reduced force and torque of the sums over the edges, and the Hessian of the power.

    `share` is 1/area, `rate` 1 over the size of the motion.
    """
    w = v[2]
    by = w * share
    found = vec9(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    found[0] = -(v[0] + by * sums[0])
    found[1] = -(v[1] + by * sums[1])
    found[2] = -(wp.static(1.0 / 3.0) * w * (2.0 + share * sums[2]))
    if not with_hessian:
        return found
    xx = share * sums[3]
    xy = share * sums[4]
    yy = share * sums[5]
    xn = share * sums[6] - w * v[0]
    yn = share * sums[7] - w * v[1]
    nn = share * sums[8] + (v[0] * v[0] + v[1] * v[1])
    # The part across the motion, along which dry friction does not change.
    to = wp.vec3(
        xx * v[0] + xy * v[1] + xn * w,
        xy * v[0] + yy * v[1] + yn * w,
        xn * v[0] + yn * v[1] + nn * w,
    )
    to = to - (0.5 * wp.dot(to, v)) * v
    found[3] = rate * (xx - (to[0] * v[0] + to[0] * v[0]))
    found[4] = rate * (xy - (to[0] * v[1] + to[1] * v[0]))
    found[5] = rate * (yy - (to[1] * v[1] + to[1] * v[1]))
    found[6] = rate * (xn - (to[0] * w + to[2] * v[0]))
    found[7] = rate * (yn - (to[1] * w + to[2] * v[1]))
    found[8] = rate * (nn - (to[2] * w + to[2] * w))
    return found


@wp.func
def polygon_frame(corners: wp.array(dtype=wp.vec2)) -> wp.vec4:
    """Centroid, radius and 1/area of a polygon, the area in radii² and signed by its sense."""
    count = corners.shape[0]
    origin = corners[0]
    area = float(0.0)
    centre = wp.vec2(0.0, 0.0)
    for i in range(1, count - 1):
        a = corners[i] - origin
        b = corners[i + 1] - origin
        part = a[0] * b[1] - a[1] * b[0]
        area += part
        centre += part * (a + b)
    centre = origin + centre / (3.0 * area)
    radius_sq = float(0.0)
    for i in range(count):
        x = corners[i] - centre
        radius_sq = wp.max(radius_sq, wp.dot(x, x))
    return wp.vec4(centre[0], centre[1], wp.sqrt(radius_sq), 2.0 * radius_sq / area)


@wp.func
def polygon_friction(
    corners: wp.array(dtype=wp.vec2), frame: wp.vec4, motion: wp.vec3, with_hessian: bool
) -> vec9:
    """Reduced friction for a motion (v, ωR) of the centroid, not zero, and the Hessian of the power."""
    size = wp.length(motion)
    rate = 1.0 / size
    v = motion * rate
    count = corners.shape[0]
    centre = wp.vec2(frame[0], frame[1])
    sums = vec9(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    start = (corners[count - 1] - centre) / frame[2]
    from_corner = moving_corner(v, start)
    for i in range(count):
        end = (corners[i] - centre) / frame[2]
        to_corner = moving_corner(v, end)
        sums += edge_sums(v, start, end, from_corner, to_corner, with_hessian)
        start = end
        from_corner = to_corner
    return polygon_total(sums, v, frame[3], rate, with_hessian)


@wp.func
def box_frame(a: float, b: float) -> wp.vec4:
    """As `polygon_frame`, of a box about its centre."""
    radius_sq = 0.25 * (a * a + b * b)
    return wp.vec4(0.0, 0.0, wp.sqrt(radius_sq), radius_sq / (a * b))


@wp.func
def box_friction(a: float, b: float, frame: wp.vec4, motion: wp.vec3, with_hessian: bool) -> vec9:
    """As `polygon_friction`, of a box with sides a and b along x and y."""
    rate = 1.0 / wp.length(motion)
    v = motion * rate
    x = 0.5 * a / frame[2]
    y = 0.5 * b / frame[2]
    p = wp.vec2(-x, -y)
    q = wp.vec2(x, -y)
    r = wp.vec2(x, y)
    s = wp.vec2(-x, y)
    at_p = moving_corner(v, p)
    at_q = moving_corner(v, q)
    at_r = moving_corner(v, r)
    at_s = moving_corner(v, s)
    sums = (
        edge_sums(v, p, q, at_p, at_q, with_hessian) + edge_sums(v, q, r, at_q, at_r, with_hessian)
    ) + (
        edge_sums(v, r, s, at_r, at_s, with_hessian) + edge_sums(v, s, p, at_s, at_p, with_hessian)
    )
    return polygon_total(sums, v, frame[3], rate, with_hessian)


for _function in (
    bend,
    moving_corner,
    edge_sums,
    polygon_total,
    polygon_frame,
    polygon_friction,
    box_frame,
    box_friction,
):
    _function.adj.skip_reverse_codegen = True
