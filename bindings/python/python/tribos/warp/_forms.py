"""Coulomb friction of round patches in reduced units: the kernel's fitted forms, in float32.

With the larger and the smaller m, h m of sliding speed |v| and rim speed |ωR| and z = 1 − h², force is
v Φ/m and torque ωR Χ/m. Φ, Χ and Φ' = dΦ/dh² are polynomials in z − 1/2 with a term in ln z, or in
√z − 1/2.
"""

from __future__ import annotations

from typing import Any

import warp as wp

from tribos._terms import ROUND
from tribos.warp._logarithm import LEAST, log_part

DISK = wp.constant(0)
"""Uniform pressure."""
RING = wp.constant(1)
"""All pressure on the rim."""
PUNCH = wp.constant(2)
"""Pressure of a rigid flat punch, 1/√(1 − r²)."""
HERTZ = wp.constant(3)
"""Hertz' pressure, √(1 − r²)."""
PARABOLOID = wp.constant(4)
"""Pressure 1 − r²."""

ROUNDING = wp.constant(2.0**-23)

KINDS = ("disk", "ring", "punch", "hertz", "paraboloid")
"""The pressures by their number."""
# Order q of each pressure (1 − r²)^q, and 1/(q + 3/2).
ORDERS = (0.0, -1.0, -0.5, 0.5, 1.0)
_INV_MOMENTS = tuple(1.0 / (order + 1.5) for order in ORDERS)


def _sums(name: str, rows: Any) -> Any:
    """A function of u for four sums of powers, even and odd ones apart as the kernel has them."""
    a, b, c, d, e, f = (wp.vec4(*row) for row in rows)

    @wp.func(name=name)
    def sums(u: float) -> wp.vec4:
        square = u * u
        odd = (f * square + d) * square + b
        even = e * square + c
        return a + (odd * u + even * square)

    sums.adj.skip_reverse_codegen = True
    return sums


def _both(kind: str, function: str) -> tuple[Any, Any]:
    spinning, sliding = ROUND[kind]["float32"][function]
    first = _sums(f"tribos_{kind}_{function}_spinning", spinning)
    if spinning == sliding:
        return first, first
    return first, _sums(f"tribos_{kind}_{function}_sliding", sliding)


_disk_torque, _ = _both("disk", "torque")
_ring_torque, _ = _both("ring", "torque")
_punch_torque, _punch_torque_sliding = _both("punch", "torque")
_hertz_torque, _hertz_torque_sliding = _both("hertz", "torque")
_paraboloid_torque, _paraboloid_torque_sliding = _both("paraboloid", "torque")
_disk_slope, _ = _both("disk", "slope")
_ring_slope, _ring_slope_sliding = _both("ring", "slope")
_punch_slope, _punch_slope_sliding = _both("punch", "slope")
_hertz_slope, _hertz_slope_sliding = _both("hertz", "slope")
_paraboloid_slope, _paraboloid_slope_sliding = _both("paraboloid", "slope")


@wp.func
def inv_moment(pressure: int) -> float:
    """1/(q + 3/2)."""
    if pressure == DISK:
        return wp.static(_INV_MOMENTS[0])
    if pressure == RING:
        return wp.static(_INV_MOMENTS[1])
    if pressure == PUNCH:
        return wp.static(_INV_MOMENTS[2])
    if pressure == HERTZ:
        return wp.static(_INV_MOMENTS[3])
    return wp.static(_INV_MOMENTS[4])


@wp.func
def torque_sums(pressure: int, slides: bool, u: float) -> wp.vec4:
    """Regular and singular parts of Φ and Χ; of Φ and Θ for a disk; spinning's for a ring."""
    if pressure == DISK:
        return _disk_torque(u)
    if pressure == RING:
        return _ring_torque(u)
    if pressure == PUNCH:
        if slides:
            return _punch_torque_sliding(u)
        return _punch_torque(u)
    if pressure == HERTZ:
        if slides:
            return _hertz_torque_sliding(u)
        return _hertz_torque(u)
    if slides:
        return _paraboloid_torque_sliding(u)
    return _paraboloid_torque(u)


@wp.func
def slope_sums(pressure: int, slides: bool, u: float) -> wp.vec4:
    """Regular and singular parts of Φ and Φ'."""
    if pressure == DISK:
        return _disk_slope(u)
    if pressure == RING:
        if slides:
            return _ring_slope_sliding(u)
        return _ring_slope(u)
    if pressure == PUNCH:
        if slides:
            return _punch_slope_sliding(u)
        return _punch_slope(u)
    if pressure == HERTZ:
        if slides:
            return _hertz_slope_sliding(u)
        return _hertz_slope(u)
    if slides:
        return _paraboloid_slope_sliding(u)
    return _paraboloid_slope(u)


@wp.func
def argument_and_hooks(pressure: int, z: float) -> wp.vec3:
    """Argument of the sums, and what multiplies the singular parts of Φ and Χ and that of Φ'."""
    if pressure == PUNCH or pressure == HERTZ:
        u = wp.sqrt(z) - 0.5
        return wp.vec3(u * u, u, u)
    log = log_part(wp.max(z, LEAST))
    hook = log
    if pressure == DISK:
        hook = z * log
    if pressure == PARABOLOID:
        hook = z * (z * log)
    return wp.vec3(z - 0.5, z * hook, hook)


@wp.func
def force_and_torque(pressure: int, slides: bool, z: float) -> wp.vec2:
    """Φ and Χ at z in [0, 1]."""
    at = argument_and_hooks(pressure, z)
    sums = torque_sums(pressure, slides, at[0])
    phi = sums[0] + at[1] * sums[2]
    chi = sums[1] + at[1] * sums[3]
    if pressure == DISK:
        # Χ = Θ where sliding leads, Θ + z (Φ/n − Θ) where spinning does.
        if slides:
            return wp.vec2(phi, chi)
        return wp.vec2(phi, chi + z * (inv_moment(DISK) * phi - chi))
    if pressure == RING:
        # Sliding and spinning change places with Φ and Χ.
        if slides:
            return wp.vec2(chi, phi)
    return wp.vec2(phi, chi)


@wp.func
def force_and_slope(pressure: int, slides: bool, z: float) -> wp.vec2:
    """Φ and Φ' at z in [0, 1]; a ring's Φ', infinite at z = 0, ends at what rounding knows of z."""
    at = argument_and_hooks(pressure, z)
    u = at[0]
    hook = at[2]
    if pressure == RING:
        u = z
        hook = log_part(wp.max(z, ROUNDING))
    sums = slope_sums(pressure, slides, u)
    return wp.vec2(sums[0] + at[1] * sums[2], sums[1] + hook * sums[3])


@wp.func
def torque_of_slope(pressure: int, slides: bool, x: float, z: float, at: wp.vec2) -> float:
    """Χ from Φ and Φ', with Θ = (Φ/2 + zΦ')/n: Θ where sliding leads, zΦ/n + xΘ where spinning does."""
    inv_n = inv_moment(pressure)
    theta = inv_n * (0.5 * at[0] + z * at[1])
    if slides:
        return theta
    return inv_n * z * at[0] + x * theta


for _function in (
    inv_moment,
    torque_sums,
    slope_sums,
    argument_and_hooks,
    force_and_torque,
    force_and_slope,
    torque_of_slope,
):
    _function.adj.skip_reverse_codegen = True
