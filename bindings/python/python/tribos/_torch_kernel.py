"""Operations of the compiled kernel as nodes of PyTorch's graph, on the processor."""

from __future__ import annotations

from typing import Any

import numpy as np
import torch  # type: ignore[import-not-found, unused-ignore]
from torch.autograd.function import (  # type: ignore[import-not-found, unused-ignore]
    once_differentiable,
)

from tribos import _torch_forms
from tribos._gradients import Operation, finite_derivatives


def applied(operation: Operation, *tensors: Any) -> tuple[Any, ...]:
    """The operation on tensors of one type, whose leading axes are broadcast."""
    node = _OperatedTwice if _torch_forms.has_form(operation) else _Operated
    made: tuple[Any, ...] = node.apply(operation, *tensors)
    return made


def slope(operation: Operation, *tensors: Any) -> Any:
    """The first output's derivatives by the first input; where there is a form they have derivatives in turn."""
    return _Slope.apply(operation, *tensors)


class _Operated(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    """An operation with first derivatives."""

    @staticmethod
    def forward(ctx: Any, operation: Operation, *given: Any) -> tuple[Any, ...]:
        return _forward(ctx, operation, *given)

    @staticmethod
    @once_differentiable  # type: ignore[misc, untyped-decorator, unused-ignore]
    def backward(ctx: Any, *gradients: Any) -> tuple[Any, ...]:
        return _backward(ctx, *gradients)


class _OperatedTwice(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    """The same with a form, which derivatives of derivatives follow."""

    @staticmethod
    def forward(ctx: Any, operation: Operation, *given: Any) -> tuple[Any, ...]:
        return _forward(ctx, operation, *given)

    @staticmethod
    def backward(ctx: Any, *gradients: Any) -> tuple[Any, ...]:
        if not torch.is_grad_enabled():
            return _backward(ctx, *gradients)
        # Views, lest ways from one argument to another count.
        at = [x.view_as(x) for x in ctx.saved_tensors[: len(ctx.shapes)]]
        operation = ctx.operation
        made = _torch_forms.applied(operation, *at)
        outputs = [made[output] for output in operation.smooth]
        weights = [gradients[output] for output in operation.smooth]
        wanted = [at[n] for n in ctx.needed]
        slopes = iter(
            torch.autograd.grad(outputs, wanted, weights, create_graph=True, allow_unused=True)
        )
        results: list[Any] = [None] * (1 + len(ctx.shapes))
        for n in ctx.needed:
            results[1 + n] = next(slopes)
        return tuple(results)


class _Slope(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    """Derivatives, which have those of the form in turn."""

    @staticmethod
    def forward(ctx: Any, operation: Operation, *given: Any) -> Any:
        ctx.operation = operation
        ctx.save_for_backward(*given)
        _, by = finite_derivatives(operation, *(x.detach().numpy() for x in given))
        return _tensor(by[0][0], given[0].dtype)

    @staticmethod
    def backward(ctx: Any, weights: Any) -> tuple[Any, ...]:
        if not _torch_forms.has_form(ctx.operation):
            raise NotImplementedError(
                f"tribos.torch.jacobian of {ctx.operation.friction!r} runs in the compiled kernel, which has first "
                "derivatives of friction only: difference them for second ones, or detach them"
            )
        again = torch.is_grad_enabled()
        needed = [at for at, is_needed in enumerate(ctx.needs_input_grad[1:]) if is_needed]
        with torch.enable_grad():
            given = [x if again else x.detach() for x in ctx.saved_tensors]
            # Views, lest ways from one argument to another count.
            at = [
                x.view_as(x) if x.requires_grad else x.requires_grad_(n in needed)
                for n, x in enumerate(given)
            ]
            made = _torch_forms.slope(ctx.operation, *at)
            wanted = [at[n] for n in needed]
            slopes = torch.autograd.grad(
                made, wanted, weights, create_graph=again, allow_unused=True
            )
        results: list[Any] = [None] * (1 + len(at))
        for n, slope in zip(needed, slopes, strict=True):
            results[1 + n] = slope
        return tuple(results)


def _forward(ctx: Any, operation: Operation, *given: Any) -> tuple[Any, ...]:
    """The outputs; the arguments and derivatives are kept."""
    dtype = given[0].dtype
    arrays = [tensor.detach().numpy() for tensor in given]
    ctx.operation = operation
    ctx.needed = [at for at, is_needed in enumerate(ctx.needs_input_grad[1:]) if is_needed]
    slopes: list[Any] = []
    if ctx.needed:
        values, by = finite_derivatives(operation, *arrays)
        slopes = [by[output][at] for at in ctx.needed for output in operation.smooth]
    else:
        values = operation.value(*arrays)
    ctx.shapes = [tensor.shape for tensor in given]
    ctx.save_for_backward(*given, *(_tensor(slope, dtype) for slope in slopes))
    made = tuple(_tensor(value, dtype) for value in values)
    constant = [one for at, one in enumerate(made) if at not in operation.smooth]
    ctx.mark_non_differentiable(*constant)
    return made


def _backward(ctx: Any, *gradients: Any) -> tuple[Any, ...]:
    """Gradients by the derivatives that are kept."""
    operation = ctx.operation
    slopes = iter(ctx.saved_tensors[len(ctx.shapes) :])
    results: list[Any] = [None] * (1 + len(ctx.shapes))
    for at in ctx.needed:
        total: Any = 0.0
        for output in operation.smooth:
            i, j = "i" if operation.outputs[output] else "", "j" if operation.inputs[at] else ""
            formula = f"...{i}{j},...{i}->...{j}"
            total = total + torch.einsum(formula, next(slopes), gradients[output])
        results[1 + at] = total.sum_to_size(ctx.shapes[at])
    return tuple(results)


def _tensor(array: Any, dtype: Any) -> Any:
    return torch.as_tensor(np.asarray(array), dtype=dtype)
