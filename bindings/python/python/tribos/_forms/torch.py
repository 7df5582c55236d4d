"""The space of PyTorch."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any

import torch  # type: ignore[import-not-found, unused-ignore]

sqrt = torch.sqrt
log = torch.log
cos = torch.cos
sin = torch.sin
abs = torch.abs


def where(mask: Any, a: Any, b: Any) -> Any:
    if not isinstance(a, torch.Tensor) and not isinstance(b, torch.Tensor):
        a = torch.as_tensor(a, device=mask.device)
    like = a if isinstance(a, torch.Tensor) else b
    return torch.where(mask, constant(a, like), constant(b, like))


def stack(parts: Sequence[Any]) -> Any:
    return torch.stack(torch.broadcast_tensors(*parts), dim=-1)


def parts(rows: Any) -> Sequence[Any]:
    made: Sequence[Any] = torch.unbind(rows, dim=-1)
    return made


def first_axis(x: Any, rank: int) -> Any:
    first = torch.movedim(x, -1, 0)
    return first.reshape(first.shape[:1] + (1,) * (rank + 1 - first.ndim) + first.shape[1:])


def total(x: Any) -> Any:
    return torch.sum(x, dim=0)


def largest(x: Any) -> Any:
    return torch.amax(x, dim=0)


def following(x: Any) -> Any:
    return torch.roll(x, -1, dims=0)


def constant(c: Any, like: Any) -> Any:
    return (
        c
        if isinstance(c, torch.Tensor)
        else torch.as_tensor(c, dtype=like.dtype, device=like.device)
    )


def type_of(x: Any) -> str:
    return str(x.dtype).removeprefix("torch.")


def epsilon(x: Any) -> float:
    return float(torch.finfo(x.dtype).eps)


def still(x: Any) -> Any:
    return _each(lambda part: part.detach(), x)


def apart(x: Any) -> Any:
    return x


def loop(
    step: Callable[[Any], Any],
    state: Any,
    count: int,
    is_done: Callable[[Any], Any] | None = None,
) -> Any:
    with torch.no_grad():
        for at in range(count):
            if is_done is not None and _is_over(is_done, state, at):
                break
            state = step(state)
        return state


def _is_over(is_done: Callable[[Any], Any], state: Any, at: int) -> bool:
    """Whether a search is over before a step."""
    done = is_done(state)
    # A look at the values waits for the device: not at every step there, and tensors without values have none.
    if done.is_meta or (done.device.type != "cpu" and at % 4 > 0):
        return False
    return bool(torch.all(done))


def course(step: Callable[[Any, Any], tuple[Any, Any]], state: Any, rows: Any) -> tuple[Any, Any]:
    made = []
    first = rows[0] if isinstance(rows, tuple) else rows
    for at in range(len(first)):
        state, one = step(state, _each(lambda part, at=at: part[at], rows))
        made.append(one)
    return state, _each(lambda *column: torch.stack(column), *made)


def pushed(of: Callable[..., Any], arguments: Sequence[Any], tangents: Sequence[Any]) -> Any:
    with torch.enable_grad():
        # Forward mode by two reverse ones: the gradient is linear in its weights. Views, lest others ways count.
        at = [x.view_as(x) if x.requires_grad else x.detach().requires_grad_() for x in arguments]
        value = of(*at)
        values = value if isinstance(value, tuple) else (value,)
        weights = [torch.zeros_like(one, requires_grad=True) for one in values]
        moving = [(x, by) for x, by in zip(at, tangents, strict=True) if by is not None]
        slopes = _gradients(values, [x for x, _ in moving], weights)
        pairs = [(slope, by) for slope, (_, by) in zip(slopes, moving) if slope is not None]
        slopes, by = [slope for slope, _ in pairs], [one for _, one in pairs]
        rates = _gradients(slopes, weights, by)
        made = tuple(
            torch.zeros_like(one) if rate is None else rate for one, rate in zip(values, rates)
        )
        return made if isinstance(value, tuple) else made[0]


def _gradients(values: Sequence[Any], at: Sequence[Any], weights: Sequence[Any]) -> Sequence[Any]:
    """Gradients to differentiate in turn, None for what has no effect."""
    pairs = [(one, weight) for one, weight in zip(values, weights) if one.requires_grad]
    if not pairs or not at:
        return [None] * len(at)
    values, weights = zip(*pairs)
    made: Sequence[Any] = torch.autograd.grad(
        values, at, weights, create_graph=True, allow_unused=True
    )
    return made


def ruled(value: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
    def made(*arguments: Any) -> Any:
        for of, known, values in _known():
            if of is made and all(a is b for a, b in zip(known, arguments, strict=True)):
                return values
        return _Ruled.apply(made, value, rule, *(constant(x, arguments[0]) for x in arguments))

    return made


_here = threading.local()


def _known() -> list[tuple[Any, Any, Any]]:
    """Functions with arguments and their values, while a rule is followed."""
    known: list[tuple[Any, Any, Any]] = _here.__dict__.setdefault("known", [])
    return known


class _Ruled(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    """A function with its own rule, as a node of the graph."""

    @staticmethod
    def forward(ctx: Any, made: Any, value: Any, rule: Any, *arguments: Any) -> Any:
        values = value(*arguments)
        ctx.made, ctx.rule, ctx.count = made, rule, len(arguments)
        ctx.is_one = isinstance(values, torch.Tensor)
        ctx.save_for_backward(*arguments, *((values,) if ctx.is_one else values))
        return values

    @staticmethod
    def backward(ctx: Any, *weights: Any) -> tuple[Any, ...]:
        # Derivatives of derivatives are asked for where a graph is made here.
        again = torch.is_grad_enabled()
        saved = ctx.saved_tensors if again else [x.detach() for x in ctx.saved_tensors]
        at, values = saved[: ctx.count], tuple(saved[ctx.count :])
        moves = ctx.needs_input_grad[3:]
        with torch.enable_grad():
            by = [torch.zeros_like(x, requires_grad=True) if m else None for x, m in zip(at, moves)]
            _known().append((ctx.made, at, values[0] if ctx.is_one else values))
            try:
                _, rates = ctx.rule(at, by)
            finally:
                _known().pop()
            rates = (rates,) if ctx.is_one else rates
            moving = [x for x in by if x is not None]
            pairs = [(rate, w) for rate, w in zip(rates, weights) if rate.requires_grad]
            if not pairs:
                return (None, None, None, *(None for _ in at))
            rates, weights = zip(*pairs)
            slopes = iter(
                torch.autograd.grad(rates, moving, weights, create_graph=again, allow_unused=True)
            )
        return (None, None, None, *(next(slopes) if m else None for m in moves))


def _each(of: Callable[..., Any], *trees: Any) -> Any:
    """A function of the tensors at each place of trees of tuples."""
    first = trees[0]
    if not isinstance(first, tuple):
        return first if first is None else of(*trees)
    made = [_each(of, *branches) for branches in zip(*trees, strict=True)]
    return type(first)(*made) if hasattr(first, "_fields") else tuple(made)
