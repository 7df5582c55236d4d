"""The space of numpy, without derivatives: for what is prepared once, and for tests."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

where: Callable[..., Any] = np.where
sqrt: Callable[..., Any] = np.sqrt
log: Callable[..., Any] = np.log
cos: Callable[..., Any] = np.cos
sin: Callable[..., Any] = np.sin
abs: Callable[..., Any] = np.abs


def still(x: Any) -> Any:
    return x


apart = still


def stack(parts: Sequence[Any]) -> Any:
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def parts(rows: Any) -> Sequence[Any]:
    return list(np.moveaxis(rows, -1, 0))


def first_axis(x: Any, rank: int) -> Any:
    first = np.moveaxis(x, -1, 0)
    return first.reshape(first.shape[:1] + (1,) * (rank + 1 - first.ndim) + first.shape[1:])


def total(x: Any) -> Any:
    return np.sum(x, axis=0)


def largest(x: Any) -> Any:
    return np.max(x, axis=0)


def following(x: Any) -> Any:
    return np.roll(x, -1, axis=0)


def constant(c: Any, like: Any) -> Any:
    return np.asarray(c, like.dtype)


def type_of(x: Any) -> str:
    return str(x.dtype)


def epsilon(x: Any) -> float:
    return float(np.finfo(x.dtype).eps)


def loop(
    step: Callable[[Any], Any],
    state: Any,
    count: int,
    is_done: Callable[[Any], Any] | None = None,
) -> Any:
    for _ in range(count):
        if is_done is not None and np.all(is_done(state)):
            break
        state = step(state)
    return state


def course(step: Callable[[Any, Any], tuple[Any, Any]], state: Any, rows: Any) -> tuple[Any, Any]:
    raise NotImplementedError("numpy follows no path: the compiled package does")


def pushed(of: Callable[..., Any], arguments: Sequence[Any], tangents: Sequence[Any]) -> Any:
    raise NotImplementedError("numpy has no derivatives")


def ruled(value: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
    return value
