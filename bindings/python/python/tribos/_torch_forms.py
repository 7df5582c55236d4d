"""Operations of frictions with a form on tensors, on any device and with derivatives of every order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import torch  # type: ignore[import-not-found, unused-ignore]

from tribos import _gradients
from tribos._forms import sets, soft, step
from tribos._forms import torch as space
from tribos._forms.form import Form
from tribos._forms.of_friction import form_of, kind_of, size_of
from tribos._gradients import Operation


def has_form(operation: Operation) -> bool:
    """Whether tensors do without the compiled kernel."""
    return type(operation) in _MADE and kind_of(_friction(operation)) is not None


def applied(operation: Operation, *given: Any) -> tuple[Any, ...]:
    """The operation on tensors of one type and device, whose leading axes are broadcast."""
    friction = _friction(operation)
    kind = kind_of(friction)
    if kind is None:
        raise ValueError(f"{friction!r} has no form in tensor operations")
    numbers = operation.inputs
    axes = [x.shape[:-1] if row else x.shape for x, row in zip(given, numbers, strict=True)]
    whole = torch.broadcast_shapes(*axes)
    spread = [
        x.broadcast_to((*whole, 3)) if row else x.broadcast_to(whole)
        for x, row in zip(given, numbers, strict=True)
    ]
    size = torch.as_tensor(size_of(friction), dtype=given[0].dtype, device=given[0].device)
    return _MADE[type(operation)](operation, form_of(kind, size), *spread)


def _friction(operation: Any) -> Any:
    return operation.friction


def _wrench(operation: Any, form: Form, twists: Any, load: Any) -> tuple[Any, ...]:
    return (soft.wrench(space, form, twists, operation.friction.mu * load),)


def _support(operation: Any, form: Form, twists: Any, load: Any) -> tuple[Any, ...]:
    return (soft.support(space, form, twists, operation.friction.mu * load),)


def _gauge(operation: Any, form: Form, wrenches: Any, load: Any) -> tuple[Any, ...]:
    return (sets.gauge(space, form, wrenches, operation.friction.mu * load),)


def _normal(operation: Any, form: Form, wrenches: Any) -> tuple[Any, ...]:
    return (sets.normal(space, form, wrenches),)


def _project(operation: Any, form: Form, wrenches: Any, load: Any) -> tuple[Any, ...]:
    length = torch.as_tensor(operation.length, dtype=wrenches.dtype, device=wrenches.device)
    limit = operation.friction.mu * load
    return (sets.project(space, form, wrenches, limit, length)[0],)


def _step(
    operation: Any, form: Form, twists: Any, pushes: Any, load: Any, *body: Any
) -> tuple[Any, ...]:
    limit = operation.friction.mu * load
    after, mean, rests = step.planar_step(space, form, twists, pushes, limit, *body)
    return after, mean, rests.to(after.dtype)


_MADE: dict[type, Callable[..., tuple[Any, ...]]] = {
    _gradients.Wrench: _wrench,
    _gradients.Support: _support,
    _gradients.Gauge: _gauge,
    _gradients.Normal: _normal,
    _gradients.Project: _project,
    _gradients.PlanarStep: _step,
}
