"""Operations on patches that have a form, on tensors of any device and with derivatives of every order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import torch  # type: ignore[import-not-found, unused-ignore]

from tribos import _gradients
from tribos._forms import sets, soft, step
from tribos._forms import torch as space
from tribos._forms.form import Form
from tribos._forms.of_friction import FLAT, form_of, kind_of, size_of
from tribos._gradients import Operation


def has_form(operation: Operation) -> bool:
    """Whether tensors do without the compiled kernel."""
    return type(operation) in _MADE and kind_of(_friction(operation)) is not None


def applied(operation: Operation, *given: Any) -> tuple[Any, ...]:
    """The operation on tensors of one type and device, whose leading axes are broadcast."""
    return _MADE[type(operation)](operation, *_form(operation, given[0]), *given)


def slope(operation: _gradients.Wrench, twists: Any, load: Any) -> Any:
    """The derivatives of friction by the twist."""
    return jacobian(*_form(operation, twists), twists, operation.friction.mu * load)


def _form(operation: Operation, like: Any) -> tuple[str, Any]:
    """The kind and the size of what an operation is of."""
    friction = _friction(operation)
    kind = kind_of(friction)
    if kind is None:
        raise ValueError(f"{friction!r} has no form in tensor operations")
    return kind, torch.tensor(size_of(friction), dtype=like.dtype, device=like.device)


def _friction(operation: Any) -> Any:
    return operation.friction


def _prepared(
    kind: str, size: Any, rows: Sequence[Any], numbers: Sequence[Any]
) -> tuple[Form, Any, list[Any]]:
    """The form, the leading axes of all arguments together, and the rows over them."""
    shapes = [row.shape[:-1] for row in rows]
    shapes += [number.shape for number in numbers if number is not None]
    whole = torch.broadcast_shapes(*shapes, size.shape[:-2] if kind == FLAT else size.shape)
    return form_of(kind, size), whole, [row.broadcast_to((*whole, 3)) for row in rows]


def wrench(kind: str, size: Any, twists: Any, limit: Any, speed: Any = None) -> Any:
    form, whole, (twists,) = _prepared(kind, size, (twists,), (limit, speed))
    return soft.wrench(space, form, twists, limit.broadcast_to(whole), speed)


def jacobian(kind: str, size: Any, twists: Any, limit: Any, speed: Any = None) -> Any:
    form, whole, (twists,) = _prepared(kind, size, (twists,), (limit, speed))
    return soft.jacobian(space, form, twists, limit.broadcast_to(whole), speed)


def support(kind: str, size: Any, twists: Any, limit: Any, speed: Any = None) -> Any:
    form, whole, (twists,) = _prepared(kind, size, (twists,), (limit, speed))
    return soft.support(space, form, twists, limit.broadcast_to(whole), speed)


def gauge(kind: str, size: Any, wrenches: Any, limit: Any) -> Any:
    form, whole, (wrenches,) = _prepared(kind, size, (wrenches,), (limit,))
    return sets.gauge(space, form, wrenches, limit.broadcast_to(whole))


def normal(kind: str, size: Any, wrenches: Any) -> Any:
    form, _, (wrenches,) = _prepared(kind, size, (wrenches,), ())
    return sets.normal(space, form, wrenches)


def project(kind: str, size: Any, wrenches: Any, limit: Any, length: Any) -> Any:
    form, whole, (wrenches,) = _prepared(kind, size, (wrenches,), (limit, length))
    length = form.reach(space) if length is None else length
    return sets.project(space, form, wrenches, limit.broadcast_to(whole), length)[0]


def planar_step(
    kind: str,
    size: Any,
    twists: Any,
    pushes: Any,
    limit: Any,
    mass: Any,
    inertia: Any,
    dt: Any,
) -> tuple[Any, Any, Any]:
    """Motion, mean friction, and whether the body is at rest."""
    numbers = (limit, mass, inertia, dt)
    form, whole, (twists, pushes) = _prepared(kind, size, (twists, pushes), numbers)
    limit = limit.broadcast_to(whole)
    return step.planar_step(space, form, twists, pushes, limit, mass, inertia, dt)


def _project(operation: Any, kind: str, size: Any, wrenches: Any, load: Any) -> tuple[Any, ...]:
    length = torch.as_tensor(operation.length, dtype=wrenches.dtype, device=wrenches.device)
    return (project(kind, size, wrenches, operation.friction.mu * load, length),)


def _step(
    operation: Any, kind: str, size: Any, twists: Any, pushes: Any, load: Any, *body: Any
) -> tuple[Any, ...]:
    limit = operation.friction.mu * load
    after, mean, rests = planar_step(kind, size, twists, pushes, limit, *body)
    return after, mean, rests.to(after.dtype)


def _loaded(of: Callable[..., Any]) -> Callable[..., tuple[Any, ...]]:
    """An operation by its rows and load."""
    return lambda operation, kind, size, rows, load: (
        of(kind, size, rows, operation.friction.mu * load),
    )


_MADE: dict[type, Callable[..., tuple[Any, ...]]] = {
    _gradients.Wrench: _loaded(wrench),
    _gradients.Support: _loaded(support),
    _gradients.Gauge: _loaded(gauge),
    _gradients.Normal: lambda _, kind, size, wrenches: (normal(kind, size, wrenches),),
    _gradients.Project: _project,
    _gradients.PlanarStep: _step,
}
