"""The implicit planar step of forms, as the kernel's."""

from __future__ import annotations

from typing import Any

from tribos._forms.form import Form
from tribos._forms.sets import dot, nearest
from tribos._forms.space import Space


def planar_step(
    space: Space,
    form: Form,
    twists: Any,
    pushes: Any,
    limit: Any,
    mass: Any,
    inertia: Any,
    dt: Any,
) -> tuple[Any, Any, Any]:
    """Motion after the step, mean friction, and whether friction holds the body.

    Friction is the wrench, of those that the patch carries, nearest by kinetic energy to the one that would end the motion
    within half the step, or within the whole step where the motion would turn about and that takes power; if the patch
    carries the latter, the body is at rest.
    """
    # With the radius of gyration as the unit of length the mass is the same along all three axes.
    gyration = space.sqrt(inertia / mass)
    form = form.per(space, gyration)
    x, y, spin = space.parts(twists)
    before = space.stack((x, y, spin * gyration))
    fx, fy, torque = space.parts(pushes)
    push = space.stack((fx, fy, torque / gyration))
    momentum, rate = (mass / dt)[..., None], (dt / mass)[..., None]

    def moved(friction: Any) -> Any:
        return before + rate * (push + friction)

    # Friction that would end the step at rest.
    at_end = -(momentum * before + push)
    ended, holds = nearest(space, form, at_end, limit)
    # The motion at half time under the friction that it meets itself.
    midway, is_carried = nearest(space, form, -(2.0 * momentum * before + push), limit)
    midway = space.where(is_carried[..., None], -(2.0 * momentum * before + push), midway)
    after = moved(midway)
    # The motion at the end under the friction that it meets there, if that takes power.
    late = moved(ended)
    gains = dot(space, ended, before + late) > 0.0
    takes_late = (_turns_about(space, before, after) & ~gains)[..., None]
    rests = holds[..., None]
    after = space.where(rests, 0.0 * after, space.where(takes_late, late, after))
    friction = space.where(rests, at_end, space.where(takes_late, ended, midway))
    return (
        _with_length(space, after, 1.0 / gyration),
        _with_length(space, friction, gyration),
        holds,
    )


def _turns_about(space: Space, before: Any, after: Any) -> Any:
    """Whether velocity or spin have another sense after."""
    x, y, spin = (a * b for a, b in zip(space.parts(before), space.parts(after), strict=True))
    return (x + y < 0.0) | (spin < 0.0)


def _with_length(space: Space, rows: Any, length: Any) -> Any:
    x, y, turn = space.parts(rows)
    return space.stack((x, y, turn * length))
