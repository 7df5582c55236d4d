"""Friction of forms by twists, dry or softened.

With D the support per mu N, a speed, softened friction is minus the gradient of mu N (sqrt(D² + soft²) - soft), which is
convex for every patch: D of dry friction far above `soft`, and proportional to the twist far below. At rest D² has no
second derivative, as it depends on the sense of the motion; u² + (T w)² of the centre of pressure's velocity u and the spin
w stands in for it, T the torque of spinning per mu N.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from tribos._forms import sets
from tribos._forms.form import Form
from tribos._forms.sets import is_none, not_negative
from tribos._forms.space import Space


def support(space: Space, form: Form, twists: Any, limit: Any, soft: Any = None) -> Any:
    """Power of dry friction, or the potential of softened friction; NaN under a negative limit."""
    limit = not_negative(space, limit)
    if soft is None:
        return limit * sets.support(space, form, twists)
    at = _softened(space, form, twists, soft)
    return limit * at.unit * (at.square / (at.root + at.soft))


def wrench(space: Space, form: Form, twists: Any, limit: Any, soft: Any = None) -> Any:
    """Friction, minus the gradient of the support."""
    limit = not_negative(space, limit)
    if soft is None:
        return sets.scaled(space, limit, form.wrench(space, twists))
    at = _softened(space, form, twists, soft)
    slow = (sum(a * b for a, b in zip(row, space.parts(twists), strict=True)) for row in at.slopes)
    share = -limit / at.root
    return space.stack(
        [
            share * space.where(at.is_rest, one / at.unit, at.power * other)
            for one, other in zip(slow, at.push, strict=True)
        ]
    )


def jacobian(space: Space, form: Form, twists: Any, limit: Any, soft: Any = None) -> Any:
    """Derivatives of friction by the twist, of shape (..., 3, 3); without softening 0 at rest."""
    limit = not_negative(space, limit)
    xx, xy, yy, xt, yt, tt = form.hessian(space, twists)
    rows: Any = ((xx, xy, xt), (xy, yy, yt), (xt, yt, tt))
    if soft is None:
        return -limit[..., None, None] * _matrix(space, rows)
    at = _softened(space, form, twists, soft)
    # D H/root + soft² g g/root³
    bend = at.soft * at.soft / (at.unit * at.root * at.root)
    moving = [
        [at.power * a + bend * (one * other) for a, other in zip(row, at.push, strict=True)]
        for row, one in zip(rows, at.push, strict=True)
    ]
    made = [
        [space.where(at.is_rest, a / at.unit, b) for a, b in zip(*pair, strict=True)]
        for pair in zip(at.slopes, moving, strict=True)
    ]
    return -(limit / at.root)[..., None, None] * _matrix(space, made)


class _Softened(NamedTuple):
    """D, its square and its root with the softening speed in a unit of speed."""

    is_rest: Any
    push: Sequence[Any]
    unit: Any
    """A constant to every derivative."""
    power: Any
    soft: Any
    square: Any
    root: Any
    slopes: Any
    """Half of the second derivatives of what stands in for D² at rest, in units of nothing."""


def _softened(space: Space, form: Form, twists: Any, soft: Any) -> _Softened:
    push = space.apart(-form.wrench(space, twists))
    power = sets.support(space, form, twists)
    unit = space.still(space.where(power < soft, soft + 0.0 * power, power))
    unit = space.where(unit == 0.0, 1.0, unit)
    # Without softening there is nothing at rest.
    is_soft = space.still(space.where(soft > 0.0, 1.0 + 0.0 * power, 0.0 * power))
    slopes = _slopes_at_rest(form.centre(space), form.spin(space), is_soft)
    x, y, spin = (part / unit for part in space.parts(twists))
    (cx, cy), arm = form.centre(space), form.spin(space)
    u, v, turn = x - spin * cy, y + spin * cx, spin * arm
    is_rest, power, soft = is_none(space, twists), power / unit, soft / unit
    square = space.where(is_rest, is_soft * (u * u + v * v + turn * turn), power * power)
    whole = square + soft * soft
    root = space.sqrt(space.where(whole == 0.0, 1.0, whole))
    return _Softened(is_rest, space.parts(push), unit, power, soft, square, root, slopes)


def _slopes_at_rest(centre: tuple[Any, Any], arm: Any, one: Any) -> Any:
    """Half of the second derivatives of u² + (T w)² by the motion of the origin, times a number."""
    x, y = one * centre[0], one * centre[1]
    none, turn = 0.0 * x, one * (arm * arm)
    return (one, none, -y), (none, one, x), (-y, x, turn + x * centre[0] + y * centre[1])


def _matrix(space: Space, rows: Any) -> Any:
    """Three rows of three as an array of shape (..., 3, 3)."""
    made = space.stack([part for row in rows for part in row])
    return made.reshape((*made.shape[:-1], 3, 3))
