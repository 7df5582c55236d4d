"""Friction of a patch whose corners move.

The power of a patch, area · D = ∫q dA, changes with its outline by ∮q δn dl, and its derivatives by the motion, which
are friction, by

    area δ(force, torque) = −∮(u, x × u)/q δn dl − (force, torque) δarea

With ξ from −1/2 to 1/2 along an edge d the velocity is ū + w ξ z × d, and the displacements δ of its ends sweep
(1/2 − ξ) δ₀ × d + (1/2 + ξ) δ₁ × d. What remains are the integrals Jₖ = ∫ξᵏ/q dξ. With the speeds q₀ and q₁ of the
ends, S = q₀ + q₁, y = w l/S, g and G of `moving_edge`, r = (q₁ − q₀)²/S² and ρ = r/y²

    J₀ = 2 (1 + y² g)/S,     J₁ = −(q₁ − q₀) g/S²,     J₂ = [2 + y² − r + 3 G (3 r − y² − r y² + y⁴)]/(12 S)
    J₃ = (q₁ − q₀) [−(1 − ρ)/8 + G (3 (1 + r − y²) − 5 ρ)/8]/S²

from the ends of q, ξ q and ξ² q. Nothing is divided by a speed or a spin here either.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tribos._forms.moving_edge import LEAST_GAP, Motion, MovingEdge
from tribos._forms.space import Space


def friction_rates(
    space: Space,
    motion: Motion,
    edge: MovingEdge,
    made: Motion,
    corners: tuple[Any, Any, Any],
    rates: Sequence[Any],
) -> tuple[Any, Any, Any]:
    """Rates of the reduced friction `made` under a motion of length 1.

    `corners` are x, y and 1/area, `rates` those of x and y.
    """
    v_x, v_y, w = motion
    x, y, inv_area = corners
    m_x, m_y = x + 0.5 * edge.d_x, y + 0.5 * edge.d_y
    u_x, u_y = v_x - w * m_y, v_y + w * m_x
    j0, j1, j2, j3 = _integrals(space, w, edge, u_y * edge.d_x - u_x * edge.d_y)
    # What the mean displacement sweeps, and half the difference of what the ends do.
    next_x, next_y = (space.following(rate) for rate in rates)
    sum_x, sum_y = rates[0] + next_x, rates[1] + next_y
    swept = 0.5 * (sum_x * edge.d_y - sum_y * edge.d_x)
    tilt = (next_x - rates[0]) * edge.d_y - (next_y - rates[1]) * edge.d_x
    # Velocity and x × u at the middle, and their coefficients of ξ and ξ².
    turn_x, turn_y = -(w * edge.d_y), w * edge.d_x
    turn = (m_x * v_y - m_y * v_x) + w * (m_x * m_x + m_y * m_y)
    turn_1 = 2.0 * w * edge.middle - edge.across
    turn_2 = w * edge.length_sq
    along_0, along_1 = swept * j0 + tilt * j1, swept * j1 + tilt * j2
    along_2 = swept * j2 + tilt * j3
    grown = space.total(swept)
    parts = (
        u_x * along_0 + turn_x * along_1,
        u_y * along_0 + turn_y * along_1,
        turn * along_0 + turn_1 * along_1 + turn_2 * along_2,
    )
    x_rate, y_rate, n_rate = (
        -(inv_area * (space.total(part) + own * grown)) for part, own in zip(parts, made)
    )
    return x_rate, y_rate, n_rate


def _integrals(space: Space, w: Any, edge: MovingEdge, swing: Any) -> tuple[Any, Any, Any, Any]:
    """J₀ to J₃; `swing` is the middle's velocity across the edge, times its length, inwards."""
    inv = edge.inv_sum
    inv_sq = inv * inv
    y_sq = w * w * edge.reach_sq
    rise = 2.0 * w * swing * inv
    least = LEAST_GAP[space.type_of(swing)]
    rho = 4.0 * swing * swing * inv_sq / (edge.length_sq + least)
    r = rho * y_sq
    bend = 3.0 * edge.bend * (3.0 * r - y_sq - r * y_sq + y_sq * y_sq)
    j0 = 2.0 * inv * (1.0 + y_sq * edge.log)
    j1 = -(rise * inv_sq * edge.log)
    j2 = (1.0 / 12.0) * inv * (2.0 + y_sq - r + bend)
    closed = edge.bend * (3.0 * (1.0 + r - y_sq) - 5.0 * rho)
    j3 = 0.125 * rise * inv_sq * (closed - (1.0 - rho))
    return j0, j1, j2, j3
