"""Searches on the limit surface of a polygon, without derivatives: those of the kernel's `limit_surface/search.rs`.

With the power D of a motion t about the centre of area, its gradient g, which is a point of the surface, and a wrench x
of length 1, the first search is the kernel's

    φ(t) = D²/2 − x·t       D g = x where it is least: t is the normal above x, D(t) the gauge of x

The second is for wrenches outside. Its unknowns are the normal n of length 1 in the metric M and the distance λ ≥ 0,

    ψ(λ n) = λ²/2 + λ (D(n) − x·n)       g + λ M n = x where it is least: g is the point of the set nearest to x

the same function and the same steps as the kernel's, but well conditioned next to the surface. Steps of Newton's method
are halved until they descend, one evaluation in each round; a row that has ended is left as it is. A search that misses
gives NaN.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from tribos._forms.moving_edge import Six
from tribos._forms.space import Space

Three = tuple[Any, Any, Any]
Power = Callable[[Three], tuple[Any, Three, Six]]
"""Power, its gradient and its second derivatives at a motion."""

#: In rounding errors: least pivot of a matrix, of its diagonal; a residual that is none; what values are known to; a
#: residual that may be rounding; one that is, if a step does not halve it.
PIVOT, DONE, SLACK, ROUGH, SETTLED = 4.0, 1.0, 8.0, 32.0, 1024.0
#: A residual above so many roots of the rounding error is a miss, as in the kernel.
MISSED = 64.0
#: Share of the linear decrease that a step must bring.
ENOUGH = 1e-4
#: Rounds of a search, and the shortest step.
MOST, SHORTEST = 60, 2.0**-30


class Point(NamedTuple):
    """A motion, its power and the point of the surface that has it as a normal."""

    motion: Three
    power: Any
    push: Three
    gauge: Any
    """Of the wrench on whose ray it lies, or the distance of that to which it is the nearest."""


class _Trial(NamedTuple):
    """What is known where a step leads to: power and push, the value that is to be least and its derivative along the
    step, the length of what is to be zero, the next step and the decrease along that one to first order."""

    power: Any
    push: Three
    value: Any
    slope: Any
    residual: Any
    step: Any
    fall: Any


class _State(NamedTuple):
    at: Any
    """Motion, or normal and distance."""
    power: Any
    push: Three
    value: Any
    residual: Any
    step: Any
    fall: Any
    factor: Any
    ended: Any


def above(space: Space, power: Power, wrench: Three, start: Three) -> Point:
    """Where the ray of a wrench of length 1 meets the surface, from a motion on; NaN for a miss."""
    pivot = PIVOT * space.epsilon(wrench[0])

    def trial(at: Three, last: Three) -> _Trial:
        value, g, hessian = power(at)
        gradient = _plus(_times(value, g), _times(-1.0, wrench))
        back = _solved(space, _sum(_outer(g), _times(value, hessian)), gradient, pivot)
        return _Trial(
            value,
            g,
            0.5 * value * value - dot(wrench, at),
            dot(gradient, last),
            space.sqrt(dot(gradient, gradient)),
            _times(-1.0, back),
            dot(gradient, back),
        )

    def moved(at: Three, step: Three, factor: Any) -> Three:
        return _plus(at, _times(factor, step))

    zero = 0.0 * start[0]
    none = zero, zero, zero
    found = _searched(space, trial, moved, (start, none), (zero, none), zero > 0.0)
    return Point(found.at, found.power, found.push, dot(wrench, found.at) / found.power)


def nearest(space: Space, power: Power, wrench: Three, found: Point, weight: Any) -> Point:
    """The nearest point to a wrench by |force|² + torque²/weight, whose normal has the length 1.

    `found` is the point on the ray; where its tangent does not separate the wrench from the set, it is the answer.
    """
    # A wrench of any size is one of order 1 to the search.
    size = space.sqrt(dot(wrench, wrench))
    reach = 1.0 / space.where(size > 1.0, size, 1.0)
    wrench = _times(reach, wrench)
    zero = 0.0 * size
    metric = 1.0 + zero, zero, 1.0 + zero, zero, zero, weight + zero
    pivot = PIVOT * space.epsilon(wrench[0])

    def trial(at: Any, last: Any) -> _Trial:
        n, distance = at
        value, g, hessian = power(n)
        along = n[0], n[1], weight * n[2]
        balance = _plus(_plus(_times(distance, along), _times(reach, g)), _times(-1.0, wrench))
        # The step's part across n: (M n)(M n)ᵀ makes the matrix regular and does not change it.
        matrix = _sum(_times(distance, metric), _times(reach, hessian))
        matrix = _sum(matrix, _outer(along))
        by_balance = _solved(space, matrix, balance, pivot)
        by_along = _solved(space, matrix, along, pivot)
        rise = dot(along, by_balance) / dot(along, by_along)
        turn = _plus(_times(rise, by_along), _times(-1.0, by_balance))
        step = _plus(_times(distance, turn), _times(-rise, n))
        return _Trial(
            value,
            g,
            distance * (0.5 * distance + (reach * value - dot(wrench, n))),
            dot(balance, last[2]),
            space.sqrt(dot(balance, balance)),
            (turn, -rise, step),
            -dot(balance, step),
        )

    def moved(at: Any, step: Any, factor: Any) -> Any:
        n = _plus(at[0], _times(factor, step[0]))
        return _times(_per_length(space, n, weight), n), at[1] + factor * step[1]

    share = _per_length(space, found.motion, weight)
    n, value = _times(share, found.motion), share * found.power
    distance = dot(wrench, n) - reach * value
    none = zero, zero, zero
    start = (n, distance), (none, zero, none)
    stays = ~(distance > 0.0)
    found = _searched(space, trial, moved, start, (value, found.push), stays)
    n, _ = found.at
    return Point(n, found.power, found.push, dot(wrench, n) / reach - found.power)


def _searched(
    space: Space, trial: Any, moved: Any, start: tuple[Any, Any], known: Any, ended: Any
) -> _State:
    """Newton's method in rows that have not ended, from a place and no step on."""
    rounding = space.epsilon(known[0])
    at, none = start
    value, push = known
    zero = 0.0 * value
    infinite = space.constant(float("inf"), zero) + zero
    state = _State(at, value, push, infinite, infinite, none, zero, 1.0 + zero, ended)

    def round_(now: _State) -> _State:
        to = moved(now.at, now.step, now.factor)
        new = trial(to, now.step)
        slack = SLACK * rounding * (1.0 + space.abs(now.value))
        # Where rounding hides what a step gains, its slope at the end decides.
        is_level = (new.value <= now.value + slack) & (
            new.slope <= (1.0 - 2.0 * ENOUGH) * now.fall
        )
        descends = new.value <= now.value - ENOUGH * now.factor * now.fall
        takes = descends | is_level | (now.factor < SHORTEST)
        # A full step that gains nothing shows rounding, unless it levels the slope in a narrow bend; a short residual
        # that is not halved shows it too.
        gains = (new.residual < now.residual) | (new.value < now.value - slack)
        bends = (now.residual > ROUGH * rounding) & (space.abs(new.slope) < 0.5 * now.fall)
        is_short = now.residual < rounding**0.5
        stops = (now.factor == 1.0) & is_short & ~(gains | bends)
        is_rough = (now.residual <= SETTLED * rounding) & ~(
            new.residual < 0.5 * now.residual
        )
        takes = (takes | is_rough) & (new.residual < now.residual) | takes & ~(stops | is_rough)
        takes = takes & ~now.ended
        is_odd = ~(new.residual >= 0.0)

        def chosen(a: Any, b: Any) -> Any:
            if isinstance(a, tuple):
                return tuple(chosen(*pair) for pair in zip(a, b))
            return space.where(takes, a, b)

        return _State(
            chosen(to, now.at),
            chosen(new.power, now.power),
            chosen(new.push, now.push),
            chosen(new.value, now.value),
            chosen(new.residual, now.residual),
            chosen(new.step, now.step),
            chosen(new.fall, now.fall),
            space.where(takes, 1.0, 0.5 * now.factor),
            now.ended | stops | is_rough | is_odd | (takes & (new.residual <= DONE * rounding)),
        )

    found = space.loop(lambda now: round_(_State(*now)), state, MOST, lambda now: now[-1])
    found = _State(*found)
    is_missed = ~((found.residual <= MISSED * rounding**0.5) | ended)
    power = space.where(is_missed, space.constant(float("nan"), zero), found.power)
    return found._replace(power=power)


def dot(a: Three, b: Three) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _plus(a: Three, b: Three) -> Three:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _times(factor: Any, parts: Any) -> Any:
    return tuple(factor * part for part in parts)


def _sum(a: Six, b: Six) -> Six:
    xx, xy, yy, xn, yn, nn = (one + other for one, other in zip(a, b))
    return xx, xy, yy, xn, yn, nn


def _outer(a: Three) -> Six:
    x, y, n = a
    return x * x, x * y, y * y, x * n, y * n, n * n


def _per_length(space: Space, a: Three, weight: Any) -> Any:
    x, y, n = a
    return 1.0 / space.sqrt(x * x + y * y + weight * (n * n))


def _solved(space: Space, m: Six, right: Three, least: float) -> Three:
    """By L D Lᵀ; pivots that rounding has made too small are raised."""
    xx, xy, yy, xn, yn, nn = m

    def raised(pivot: Any, diagonal: Any) -> Any:
        floor = least * diagonal
        return space.where(pivot < floor, floor, pivot)

    per = 1.0 / xx
    a, b = xy * per, xn * per
    y = raised(yy - a * xy, yy)
    c = (yn - b * xy) / y
    z = raised(nn - b * xn - c * c * y, nn)
    second = right[1] - a * right[0]
    third = right[2] - b * right[0] - c * second
    n = third / z
    v = second / y - c * n
    return right[0] * per - a * v - b * n, v, n
