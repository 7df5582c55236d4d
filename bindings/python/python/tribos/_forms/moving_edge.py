"""Edges of a patch under a motion.

The quantities and formulas of the kernel's `coupling/flat/moving_edge.rs` and `uniform.rs`, in terms of the edge
vector d = l τ: with N = l η, Z = l ζ and X = x × d no length of an edge is divided by but in the second derivatives,
so that equal corners are edges without length. Lengths are in units of a radius and a motion (v, w) of the origin has
|v|² + w² = 1. Arrays of corners and edges have these along their first axis.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from tribos._forms.space import Space
from tribos._terms import BEND

Six = tuple[Any, Any, Any, Any, Any, Any]

LEAST_SPEED = 0.25
"""Speed of a corner at rest, in rounding errors, as in the kernel."""

LEAST_GAP = {"float32": 1e-14, "float64": 1e-32}
"""Least 1 − y², and least squared length of an edge that has a direction: about a squared rounding error, whose
square has a reciprocal, so that second derivatives are finite. What an edge contributes vanishes as its root."""

ROUNDING = {"float32": 2.0**-23, "float64": 2.0**-52}
"""Distance of 1 from the next number."""


class Motion(NamedTuple):
    """A velocity (x, y) and a spin."""

    x: Any
    y: Any
    spin: Any


class Corner(NamedTuple):
    """Place, velocity u, speed q, and α, p, p″ of corners."""

    x: Any
    y: Any
    u_x: Any
    u_y: Any
    q: Any
    arm: Any
    p: Any
    rest: Any


class MovingEdge(NamedTuple):
    """Edges under a motion: the names are those of the kernel."""

    d_x: Any
    d_y: Any
    length_sq: Any
    # X, l v·τ, −l v·n and the middle times d.
    offset: Any
    along: Any
    across: Any
    middle: Any
    # N
    eta: Any
    # Means at the ends.
    p: Any
    arm: Any
    rest: Any
    inv_sum: Any
    reach_sq: Any
    sigma: Any
    # Z, Z² and Z²/(1 − y²)
    zeta: Any
    zeta_sq: Any
    open: Any
    # G and g
    bend: Any
    log: Any


def corners_of(space: Space, motion: Motion, x: Any, y: Any) -> Corner:
    """Corners at (x, y) under a motion of length 1."""
    v_x, v_y, w = motion
    least = (LEAST_SPEED * ROUNDING[space.type_of(x)]) ** 2
    u_x, u_y = v_x - w * y, v_y + w * x
    q = space.sqrt(u_x * u_x + u_y * u_y + least)
    arm = v_y * x - v_x * y
    sq = x * x + y * y
    from_rim = sq - 1.0
    inv = 1.0 / (q + 1.0)
    p = (from_rim - arm * ((arm + arm + w * from_rim) * inv)) * inv
    half = 0.5 * w
    rest = half * sq - p * (arm + half * p)
    return Corner(x, y, u_x, u_y, q, arm, p, rest)


def edges_of(space: Space, motion: Motion, x: Any, y: Any) -> MovingEdge:
    """The edges from each corner to the next."""
    v_x, v_y, w = motion
    start = corners_of(space, motion, x, y)
    end = Corner(*(space.following(part) for part in start))
    d_x, d_y = end.x - start.x, end.y - start.y
    length_sq = d_x * d_x + d_y * d_y
    offset, along = start.x * d_y - start.y * d_x, v_x * d_x + v_y * d_y
    eta = along + w * offset
    inv_sum = 1.0 / (start.q + end.q)
    inv_sq = inv_sum * inv_sum
    reach_sq = length_sq * inv_sq
    zeta = eta * inv_sum
    zeta_sq = zeta * zeta
    turn_sq = w * w * inv_sq
    y_sq = turn_sq * length_sq
    opened, gap = _opened(space, (zeta_sq, length_sq, turn_sq), start, end, inv_sq)
    bend = _bend(space, gap)
    p, arm = 0.5 * (start.p + end.p), 0.5 * (start.arm + end.arm)
    return MovingEdge(
        d_x=d_x,
        d_y=d_y,
        length_sq=length_sq,
        offset=offset,
        along=along,
        across=v_x * d_y - v_y * d_x,
        middle=0.5 * ((start.x + end.x) * d_x + (start.y + end.y) * d_y),
        eta=eta,
        p=p,
        arm=arm,
        rest=0.5 * (start.rest + end.rest),
        inv_sum=inv_sum,
        reach_sq=reach_sq,
        sigma=arm + w * p,
        zeta=zeta,
        zeta_sq=zeta_sq,
        open=opened,
        bend=bend,
        log=1.0 / 3.0 + y_sq * bend,
    )


def _opened(
    space: Space, squares: tuple[Any, Any, Any], start: Corner, end: Corner, inv_sq: Any
) -> tuple[Any, Any]:
    """Z²/(1 − y²) and 1 − y², by the sum that does not cancel."""
    zeta_sq, length_sq, turn_sq = squares
    dot = start.u_x * end.u_x + start.u_y * end.u_y
    is_ahead = dot >= 0.0
    both = (start.q * end.q + space.where(is_ahead, dot, -dot)) * inv_sq
    twice = both + both
    inv = 1.0 / space.where(is_ahead, twice, twice * (turn_sq * length_sq))
    opened = space.where(is_ahead, zeta_sq, both * both * length_sq) * inv
    turned = (2.0 * turn_sq) * (2.0 * turn_sq)
    gap = space.where(is_ahead, twice, zeta_sq * (turned * length_sq) * inv)
    return opened, gap + LEAST_GAP[space.type_of(gap)]


def _bend(space: Space, gap: Any) -> Any:
    """G, given 1 − y²."""
    smooth, of_log = zip(*BEND[space.type_of(gap)])
    return _sum(space, smooth, gap) + space.log(gap) * _sum(space, of_log, gap)


def _sum(space: Space, terms: tuple[float, ...], z: Any) -> Any:
    """A polynomial by Estrin's scheme."""
    parts: list[Any] = [space.constant(term, z) for term in terms]
    while len(parts) > 1:
        last = parts[len(parts) & ~1 :]
        parts = [low + z * high for low, high in zip(parts[::2], parts[1::2])] + last
        z = z * z
    return parts[0]


def friction(space: Space, motion: Motion, edge: MovingEdge, inv_area: Any) -> Motion:
    """Reduced force and torque about the origin under a motion of length 1.

    force = −(v + w Σ d β/l/area),     torque = −w [2 + Σ (X β − 2 (v·d) β″)/l/area]/3
    """
    v_x, v_y, w = motion
    beta = edge.p - edge.inv_sum * (edge.open - edge.zeta_sq * edge.log)
    zeta_0 = 0.5 * edge.along
    zeta_1 = 0.5 * edge.offset - edge.zeta * edge.sigma
    once = zeta_1 * (edge.zeta + zeta_0) - zeta_0 * zeta_0 * edge.sigma
    closed = edge.open - edge.zeta_sq * edge.bend
    bent = (2.0 / 3.0) * once + w * edge.reach_sq * closed
    beta_rest = edge.rest - edge.inv_sum * bent
    turn = edge.offset * beta - 2.0 * (edge.along * beta_rest)
    by = w * inv_area
    return Motion(
        -(v_x + by * space.total(edge.d_x * beta)),
        -(v_y + by * space.total(edge.d_y * beta)),
        -((1.0 / 3.0) * w * (2.0 + inv_area * space.total(turn))),
    )


def power_hessian(space: Space, motion: Motion, edge: MovingEdge, inv_area: Any) -> Six:
    """Second derivatives xx, xy, yy, xn, yn, nn of the power at a motion of length 1."""
    v_x, v_y, w = motion
    twice = edge.inv_sum + edge.inv_sum
    kappa = edge.arm * edge.arm - edge.p + w * edge.arm * edge.p
    # Velocities.
    bent = twice * (kappa + edge.reach_sq * edge.log)
    lengthwise = edge.offset - edge.eta * edge.arm + w * edge.eta * bent
    rise = twice * (edge.across * edge.sigma + edge.middle)
    inv_length_sq = 1.0 / (edge.length_sq + LEAST_GAP[space.type_of(edge.length_sq)])
    t_x, t_y = edge.d_x * inv_length_sq, edge.d_y * inv_length_sq
    t_xx, t_xy, t_yy = edge.d_x * t_x, edge.d_x * t_y, edge.d_y * t_y
    xx = lengthwise * t_xx - rise * t_xy
    xy = lengthwise * t_xy - 0.5 * rise * (t_yy - t_xx)
    yy = lengthwise * t_yy + rise * t_xy
    # Velocities and spin: ε.
    inv_sq = edge.inv_sum * edge.inv_sum
    mixed = twice * (inv_sq * edge.log * edge.eta * edge.along - (edge.p + w * w * kappa))
    # Spin: χ.
    sum_ = 2.0 + 2.0 * w * edge.sigma
    spread = (1.0 / 6.0) * edge.sigma * (4.0 + sum_ * (2.0 + sum_))
    turned = (2.0 / 3.0) * edge.offset - edge.along * spread
    turned = turned + 2.0 * w * edge.reach_sq * edge.bend * edge.eta
    chi = edge.arm * edge.p - edge.rest - w * twice * kappa * (1.0 + edge.p)
    chi = chi + inv_sq * edge.inv_sum * edge.along * turned
    share = inv_area
    return _across(
        motion,
        (
            share * space.total(xx),
            share * space.total(xy),
            share * space.total(yy),
            -(share * space.total(mixed * edge.d_x)) - w * v_x,
            -(share * space.total(mixed * edge.d_y)) - w * v_y,
            share * space.total(edge.along * chi) + (v_x * v_x + v_y * v_y),
        ),
    )


def _across(motion: Motion, hessian: Six) -> Six:
    """The part across a motion of length 1, along which dry friction does not change."""
    x, y, n = motion
    xx, xy, yy, xn, yn, nn = hessian
    to_x, to_y, to_n = xx * x + xy * y + xn * n, xy * x + yy * y + yn * n, xn * x + yn * y + nn * n
    half = 0.5 * (to_x * x + to_y * y + to_n * n)
    to_x, to_y, to_n = to_x - half * x, to_y - half * y, to_n - half * n
    return (
        xx - (to_x * x + to_x * x),
        xy - (to_x * y + to_y * x),
        yy - (to_y * y + to_y * y),
        xn - (to_x * n + to_n * x),
        yn - (to_y * n + to_n * y),
        nn - (to_n * n + to_n * n),
    )
