"""Searches along the curve of a round patch's limit surface, without derivatives: the kernel's.

Both look for the ratio h in [0, 1] of the smaller to the larger speed of the normal. With capitals for the component that
leads, p = (A, a) the given point and (M, m) that of the curve, they solve

    A m - a M = 0                                  (M, m) on the ray of p
    (A - M) h - weight (a - m) = 0                 p - (M, m) along the normal

A start on a polynomial that stands in for the curve is within 1e-4 (on a ring within 5e-3); Newton steps follow.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from tribos._forms import plain
from tribos._forms.coulomb import Pressure, curve_point
from tribos._forms.space import Space

#: Powers of h² in m/h.
TERMS = 6
#: By how much a step may leave its bracket: a residual that is computed twice may be rounded differently.
SLACK = 1e-4
#: A step on the stand-in that no other one needs to follow.
STAND_IN = 0.03
#: The longest step before the last one, in fourth roots of the rounding error; where a step leaves more than its square
#: the longest in rounding errors.
SHARE, SETTLED = 0.125, 256.0
#: More steps than any search needs.
MAX_STEPS = 64


class StandIn(NamedTuple):
    """A curve m = h Σ aₙ xⁿ, M = top - x Σ (2n + 1)/(2n + 2) aₙ xⁿ, with x = h²."""

    top: Any
    terms: tuple[Any, ...]
    equal: tuple[Any, Any]
    """M and m at equal speeds, of the curve itself."""


@cache
def stand_ins(pressure: Pressure) -> tuple[StandIn, StandIn]:
    """Where sliding leads, and where spinning does: right at the points of Chebyshev."""
    # x are the zeros of the polynomial of Chebyshev on [0, 1].
    ratios = np.sin(np.pi * (np.arange(TERMS) + 0.5) / (2 * TERMS))

    def of(slides: bool) -> StandIn:
        lead = np.full(TERMS, slides)
        _, minor, _ = curve_point(plain, pressure, lead, ratios)
        terms = np.linalg.solve(np.vander(ratios**2, increasing=True), minor / ratios)
        ends = curve_point(plain, pressure, lead[:2], np.array([0.0, 1.0]))
        return StandIn(
            float(ends[0][0]), tuple(map(float, terms)), (float(ends[0][1]), float(ends[1][1]))
        )

    return of(True), of(False)


def spin_torque(pressure: Pressure) -> float:
    """T of spinning."""
    return stand_ins(pressure)[1].top


def _chosen(space: Space, pressure: Pressure, slides: Any, like: Any) -> StandIn:
    """In each row that of the speed that leads."""

    def choose(one: float, other: float) -> Any:
        return space.where(slides, space.constant(one, like), space.constant(other, like))

    one, other = stand_ins(pressure)
    terms = tuple(map(choose, one.terms, other.terms))
    equal = tuple(map(choose, one.equal, other.equal))
    return StandIn(choose(one.top, other.top), terms, (equal[0], equal[1]))


def _stand_in_at(curve: StandIn, ratio: Any) -> tuple[Any, Any, Any, Any]:
    """M, m, dm/dh and d²m/dh²."""
    x = ratio * ratio
    # m/h with its first derivative and half of its second.
    bend, slope, sum_ = 0.0, 0.0, curve.terms[-1]
    loss = curve.terms[-1] * (1.0 - 0.5 / TERMS)
    for n in range(TERMS - 2, -1, -1):
        bend, slope, sum_ = bend * x + slope, slope * x + sum_, sum_ * x + curve.terms[n]
        loss = loss * x + curve.terms[n] * (1.0 - 0.5 / (n + 1))
    turn = ratio * (6.0 * slope + 8.0 * x * bend)
    return curve.top - x * loss, ratio * sum_, sum_ + 2.0 * x * slope, turn


Equation = Callable[[Any, Any, Any, Any, Any], tuple[Any, Any, Any]]
"""Value, rate and the rate's rate from h, M, m, dm/dh and d²m/dh²."""


def _on_ray(major: Any, minor: Any) -> Equation:
    def at(h: Any, big: Any, small: Any, rate: Any, bend: Any) -> tuple[Any, Any, Any]:
        along = major + minor * h
        return major * small - minor * big, along * rate, minor * rate + along * bend

    return at


def _along_normal(major: Any, minor: Any, weight: Any) -> Equation:
    def at(h: Any, big: Any, small: Any, rate: Any, bend: Any) -> tuple[Any, Any, Any]:
        ahead, wide = major - big, h * h + weight
        return (
            ahead * h - weight * (minor - small),
            ahead + wide * rate,
            3.0 * h * rate + wide * bend,
        )

    return at


def _kept(space: Space, following: Any, before: Any) -> Any:
    """A step's end where it is a ratio."""
    return space.where((following >= 0.0) & (following <= 1.0), following, before)


def _stepped(space: Space, curve: StandIn, ratio: Any, equation: Equation) -> Any:
    """The ratio after a step of Chebyshev's on the stand-in, which leaves the cube of what was missing."""
    value, rate, bend = equation(ratio, *_stand_in_at(curve, ratio))
    newton = value / rate
    return _kept(space, ratio - newton * (1.0 + 0.5 * newton * bend / rate), ratio)


def _start(
    space: Space, curve: StandIn, first: Any, equation: Equation, steps: int
) -> tuple[Any, Any]:
    """A ratio in [0, 1], and the last step to it."""
    before = after = first
    for _ in range(steps):
        before, after = after, _stepped(space, curve, after, equation)
    is_ratio = (after >= 0.0) & (after <= 1.0)
    return space.where(is_ratio, after, 1.0), space.where(is_ratio, after - before, 1.0)


class End(NamedTuple):
    """The end of a search."""

    ratio: Any
    major: Any
    minor: Any
    """The point of the curve there."""
    before: Any
    power: Any
    """The last ratio whose point was computed, and M + h m there."""


def _solved(
    space: Space, pressure: Pressure, slides: Any, start: tuple[Any, Any], equation: Equation
) -> End:
    """The zero in [0, 1] of an equation along the curve, from a ratio and the last step to it on the stand-in."""

    def at(ratio: Any) -> tuple[Any, Any, Any, Any, Any]:
        major, minor, rate = curve_point(space, pressure, slides, ratio)
        value, slope, _ = equation(ratio, major, minor, rate, 0.0)
        return major, minor, rate, value, ratio - value / slope

    def bracketed(state: tuple[Any, Any, Any, Any]) -> tuple[Any, Any, Any, Any]:
        ratio, low, high, _ = state
        *_, value, newton = at(ratio)
        is_below = value < 0.0
        low, high = space.where(is_below, ratio, low), space.where(is_below, high, ratio)
        is_inside = (newton >= low - SLACK) & (newton <= high + SLACK)
        after = space.where(is_inside, _within(space, newton), 0.5 * (low + high))
        # A middle is no step of Newton's; NaN is an end.
        is_middle = (value == value) & ~is_inside
        return after, low, high, space.where(is_middle, 1.0, after - ratio)

    ratio, step = start
    epsilon = space.epsilon(ratio)
    is_smooth = pressure.order >= 0.0
    # A step leaves about its square, and a free one follows; the slope of a thin edge has no bound.
    short = SHARE * epsilon**0.25 if is_smooth else SETTLED * epsilon
    none = 0.0 * ratio
    # The stand-in is as good as half of the digits of f32; a step of 0 may be one that was refused.
    is_near = (space.abs(step) <= STAND_IN) & (step != 0.0) & (is_smooth and epsilon > 1e-10)
    step = space.where(is_near, none, none + 1.0)
    state = space.apart((ratio, none, none + 1.0, step))
    state = space.loop(bracketed, state, MAX_STEPS, lambda now: ~(space.abs(now[3]) > short))
    ratio = space.apart(state[0])
    major, minor, rate, _, newton = at(ratio)
    step = space.where(newton == newton, _within(space, newton) - ratio, 0.0)
    # The last step moves the point along the curve.
    change = space.where(step == 0.0, 0.0, rate * step)
    return End(
        ratio + step,
        major - (ratio + 0.5 * step) * change,
        minor + change,
        ratio,
        major + ratio * minor,
    )


def _within(space: Space, ratio: Any) -> Any:
    """The nearest ratio of speeds."""
    return space.where(ratio < 0.0, 0.0, space.where(ratio > 1.0, 1.0, ratio))


def ray(space: Space, pressure: Pressure, force: Any, torque: Any) -> tuple[Any, Any, Any]:
    """Sliding and rim speed of the normal on the ray of a point with components >= 0, the larger one 1, and the gauge."""
    [force_at_equal, torque_at_equal] = stand_ins(pressure)[0].equal
    slides = torque * force_at_equal <= force * torque_at_equal
    major, minor = _ordered(space, slides, force, torque)
    curve = _chosen(space, pressure, slides, force)
    # Exact at both ends, and on an ellipse everywhere.
    rise = minor / major
    at_pole = curve.terms[0] / curve.top
    first = rise / (at_pole + (1.0 - at_pole * curve.equal[0] / curve.equal[1]) * rise)
    equation = _on_ray(major, minor)
    start = _start(space, curve, first, equation, 1)
    end = _solved(space, pressure, slides, start, equation)
    # The gauge is stationary in the normal.
    gauge = (major + minor * end.before) / end.power
    slide, rim = _ordered(space, slides, 1.0 + 0.0 * gauge, end.ratio)
    return slide, rim, gauge


def nearest(
    space: Space, pressure: Pressure, force: Any, torque: Any, lever_sq: Any
) -> tuple[tuple[Any, Any], tuple[Any, Any], Any]:
    """The normal as of `ray` and the point nearest to one with components >= 0 by f² + t²/lever_sq, and normal · (given -
    point): for one inside a point that proves it."""
    [force_at_equal, torque_at_equal] = stand_ins(pressure)[0].equal
    slides = torque - torque_at_equal <= lever_sq * (force - force_at_equal)
    major, minor = _ordered(space, slides, force, torque)
    weight = space.where(slides, 1.0 / lever_sq, lever_sq)
    curve = _chosen(space, pressure, slides, force)
    equation = _along_normal(major, minor, weight)
    # A cubic h + h³ with the value and the slope at the pole and the value at equal speeds.
    value = weight * minor
    linear = major - curve.top + weight * curve.terms[0]
    both = major - curve.equal[0] + weight * curve.equal[1]
    chord = value / both
    bend = (both - linear) * chord * chord
    first = _kept(space, (2.0 * bend * chord + value) / (linear + 3.0 * bend), chord)
    start = _start(space, curve, first, equation, 2)
    end = _solved(space, pressure, slides, start, equation)
    beyond = (major - end.major) + end.ratio * (minor - end.minor)
    one = 1.0 + 0.0 * beyond
    return (
        _ordered(space, slides, one, end.ratio),
        _ordered(space, slides, end.major * one, end.minor * one),
        beyond,
    )


def _ordered(space: Space, slides: Any, force: Any, torque: Any) -> tuple[Any, Any]:
    """The leading component first; and back."""
    return space.where(slides, force, torque), space.where(slides, torque, force)
