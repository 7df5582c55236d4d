"""The limit curve of round patches and the point of it nearest to a given one: the kernel's search.

In reduced units, force over limit and torque over limit times radius, the curve is (M, m) with the
component that leads first, as a function of the ratio h of the smaller to the larger speed. Newton's
method in a bracket for (A − M) h − κ (a − m) starts from polynomials in h² that have the kernel's m/h
at six points.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp

from tribos import _patches
from tribos._friction import Friction
from tribos.warp._forms import (
    DISK,
    HERTZ,
    KINDS,
    PUNCH,
    RING,
    force_and_slope,
    torque_of_slope,
)

vec6 = wp.types.vector(length=6, dtype=wp.float32)
vec9 = wp.types.vector(length=9, dtype=wp.float32)

# Half width of the surface, in rounding errors of the gauge.
COLLAR = wp.constant(64.0 * 2.0**-23)
# The square of a last step, of rounding errors; the error it leaves is about a quarter of it.
SHORT_SQ = wp.constant(0.5 * 2.0**-23)
# The same of a curve whose slope is infinite at equal speeds.
SETTLED = wp.constant(256.0 * 2.0**-23)
SHARE = wp.constant(0.125 * 2.0**-23)
STEPS = wp.constant(40)


def _approximation(kind: str, slides: bool) -> list[float]:
    """M at the pole, M and m at equal speeds, and m/h by powers of h²."""
    friction = Friction(getattr(_patches, kind)(1.0), mu=1.0)

    def point(ratio: float) -> tuple[float, float]:
        twist = [1.0, 0.0, ratio] if slides else [ratio, 0.0, 1.0]
        force, _, torque = -friction.wrench(twist, 1.0)
        return (force, torque) if slides else (torque, force)

    # The zeros of Chebyshev's polynomial of degree 6 for h² in [0, 1].
    squares = 0.5 + 0.5 * np.cos(np.pi * (np.arange(6) + 0.5) / 6)
    slopes = [point(np.sqrt(x))[1] / np.sqrt(x) for x in squares]
    powers = np.linalg.solve(np.vander(squares, increasing=True), slopes)
    return [point(0.0)[0], *point(1.0), *powers]


def _table() -> Any:
    return [[vec9(*_approximation(kind, slides)) for slides in (False, True)] for kind in KINDS]


_APPROXIMATIONS = _table()


@wp.func
def approximation(pressure: int, slides: bool) -> vec9:
    """M at the pole, M and m at equal speeds, and m/h by powers of h², where one speed leads."""
    if slides:
        if pressure == DISK:
            return wp.static(_APPROXIMATIONS[0][1])
        if pressure == RING:
            return wp.static(_APPROXIMATIONS[1][1])
        if pressure == PUNCH:
            return wp.static(_APPROXIMATIONS[2][1])
        if pressure == HERTZ:
            return wp.static(_APPROXIMATIONS[3][1])
        return wp.static(_APPROXIMATIONS[4][1])
    if pressure == DISK:
        return wp.static(_APPROXIMATIONS[0][0])
    if pressure == RING:
        return wp.static(_APPROXIMATIONS[1][0])
    if pressure == PUNCH:
        return wp.static(_APPROXIMATIONS[2][0])
    if pressure == HERTZ:
        return wp.static(_APPROXIMATIONS[3][0])
    return wp.static(_APPROXIMATIONS[4][0])


@wp.func
def curve_point(pressure: int, slides: bool, ratio: float) -> wp.vec3:
    """M, m and dm/dh."""
    x = ratio * ratio
    z = 1.0 - x
    if pressure == RING or pressure == PUNCH:
        z = (1.0 - ratio) * (1.0 + ratio)
    at = force_and_slope(pressure, slides, z)
    chi = torque_of_slope(pressure, slides, x, z, at)
    if slides:
        return wp.vec3(at[0], ratio * chi, -(2.0 * at[1]))
    return wp.vec3(chi, ratio * at[0], at[0] + 2.0 * x * at[1])


@wp.func
def rough_step(curve: vec9, ratio: float, given: wp.vec2, weight: float) -> float:
    """The ratio after a step of Chebyshev's on the approximation."""
    x = ratio * ratio
    # m/h with its first derivative and half of its second, and what M loses of its value at the pole.
    total = curve[8]
    slope = float(0.0)
    bent = float(0.0)
    loss = wp.static(11.0 / 12.0) * curve[8]
    for n in range(5):
        bent = bent * x + slope
        slope = slope * x + total
        total = total * x + curve[7 - n]
        loss = loss * x + wp.static([9 / 10, 7 / 8, 5 / 6, 3 / 4, 1 / 2][n]) * curve[7 - n]
    rate = total + 2.0 * x * slope
    turn = ratio * (6.0 * slope + 8.0 * x * bent)
    ahead = given[0] - (curve[0] - x * loss)
    value = ahead * ratio - weight * (given[1] - ratio * total)
    width = x + weight
    per_rate = 1.0 / (ahead + width * rate)
    newton = value * per_rate
    bend = 0.5 * (3.0 * ratio * rate + width * turn) * per_rate
    after = ratio - newton * (1.0 + newton * bend)
    if after >= 0.0 and after <= 1.0:
        return after
    return ratio


@wp.func
def rough_ratio(curve: vec9, given: wp.vec2, weight: float) -> float:
    """h of the normal through a point, by a cubic with the ends of the equation and two steps."""
    value = -(weight * given[1])
    linear = given[0] - curve[0] + weight * curve[3]
    both = given[0] - curve[1] + weight * curve[2]
    cubic = both - linear
    chord = -(value / both)
    bend = cubic * chord * chord
    first = (2.0 * bend * chord - value) / (linear + 3.0 * bend)
    if not (first >= 0.0 and first <= 1.0):
        first = chord
    if not (first >= 0.0 and first <= 1.0):
        first = 1.0
    return rough_step(curve, rough_step(curve, first, given, weight), given, weight)


@wp.func
def nearest_on_curve(pressure: int, slides: bool, given: wp.vec2, weight: float) -> wp.vec3:
    """h, M and m of the point of the curve nearest to the given one, (A, a), outside."""
    ratio = rough_ratio(approximation(pressure, slides), given, weight)
    low = float(0.0)
    high = float(1.0)
    before = float(0.0)
    for _ in range(STEPS):
        at = curve_point(pressure, slides, ratio)
        ahead = given[0] - at[0]
        value = ahead * ratio - weight * (given[1] - at[1])
        rate = ahead + (ratio * ratio + weight) * at[2]
        if value < 0.0:
            low = ratio
        else:
            high = ratio
        step = -(value / rate)
        after = ratio + step
        is_newton = after >= low and after <= high and value != 0.0
        is_last = step * step <= SHORT_SQ
        if pressure == RING or pressure == PUNCH:
            following = wp.abs(step) * (step * step) <= SHARE * (before * before * after)
            is_last = wp.abs(step) <= SETTLED * after or (is_last and following)
        if value == 0.0 or (not is_newton and high - low <= SETTLED * high):
            return wp.vec3(ratio, at[0], at[1])
        if is_newton and is_last:
            # The last step moves the point along the curve: dM/dh = −h dm/dh.
            change = at[2] * step
            return wp.vec3(after, at[0] - (ratio + 0.5 * step) * change, at[1] + change)
        before = step
        if not is_newton:
            after = 0.5 * (low + high)
            before = 0.0
        ratio = after
    at = curve_point(pressure, slides, ratio)
    return wp.vec3(ratio, at[0], at[1])


@wp.func
def round_nearest(pressure: int, force: float, torque: float, lever: float) -> vec6:
    """Normal and point of the curve nearest to a point, in its two components, and two products.

    They are normal · point, and normal · (given − point), above 0 outside.
    """
    curve = approximation(pressure, True)
    lever_sq = lever * lever
    slides = torque - curve[2] <= lever_sq * (force - curve[1])
    if slides:
        given = wp.vec2(force, torque)
        found = nearest_on_curve(pressure, True, given, 1.0 / lever_sq)
        beyond = (force - found[1]) + found[0] * (torque - found[2])
        power = found[1] + found[0] * found[2]
        return vec6(1.0, found[0], found[1], found[2], power, beyond)
    given = wp.vec2(torque, force)
    found = nearest_on_curve(pressure, False, given, lever_sq)
    beyond = (torque - found[1]) + found[0] * (force - found[2])
    power = found[1] + found[0] * found[2]
    return vec6(found[0], 1.0, found[2], found[1], power, beyond)


@wp.func
def gauge_bound(pressure: int, force: float, torque: float) -> float:
    """A bound from above of the gauge: the set is convex and holds its poles and the equal point."""
    sliding = approximation(pressure, True)
    spinning = approximation(pressure, False)
    of_force = force + (1.0 - sliding[1]) / sliding[2] * torque
    per_pole = 1.0 / spinning[0]
    of_torque = (1.0 - spinning[1] * per_pole) / spinning[2] * force + per_pole * torque
    return wp.max(of_force, of_torque)


for _function in (
    approximation,
    curve_point,
    rough_step,
    rough_ratio,
    nearest_on_curve,
    round_nearest,
    gauge_bound,
):
    _function.adj.skip_reverse_codegen = True
