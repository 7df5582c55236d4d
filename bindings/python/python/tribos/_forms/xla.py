"""The space of JAX."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import jax
import jax.numpy as jnp
from jax.custom_derivatives import SymbolicZero

where = jnp.where
sqrt = jnp.sqrt
log = jnp.log
abs = jnp.abs
still = jax.lax.stop_gradient


def stack(parts: Sequence[Any]) -> Any:
    return jnp.stack(jnp.broadcast_arrays(*parts), axis=-1)


def parts(rows: Any) -> Sequence[Any]:
    # Reverse mode joins split arrays; the sum of padded slices would compute all before it nine times.
    return [part[..., 0] for part in jnp.split(rows, rows.shape[-1], axis=-1)]


def first_axis(x: Any, rank: int) -> Any:
    first = jnp.moveaxis(x, -1, 0)
    return first.reshape(first.shape[:1] + (1,) * (rank + 1 - first.ndim) + first.shape[1:])


def total(x: Any) -> Any:
    return jnp.sum(x, axis=0)


def largest(x: Any) -> Any:
    return jnp.max(x, axis=0)


def following(x: Any) -> Any:
    return jnp.roll(x, -1, axis=0)


def constant(c: Any, like: Any) -> Any:
    return jnp.asarray(c, like.dtype)


def type_of(x: Any) -> str:
    return str(x.dtype)


@jax.custom_jvp
def apart(x: Any) -> Any:
    # Fused, every use of a value would compute all before it again.
    return jax.lax.optimization_barrier(x)


@apart.defjvp
def _apart_rule(at: Any, by: Any) -> Any:
    return apart(at[0]), by[0]


def epsilon(x: Any) -> float:
    return float(jnp.finfo(x.dtype).eps)


def loop(
    step: Callable[[Any], Any],
    state: Any,
    count: int,
    is_done: Callable[[Any], Any] | None = None,
) -> Any:
    start = still(state)
    if is_done is None:
        return jax.lax.fori_loop(0, count, lambda _, now: step(now), start)

    def goes_on(at: Any) -> Any:
        return (at[0] < count) & ~jnp.all(is_done(at[1]))

    return jax.lax.while_loop(goes_on, lambda at: (at[0] + 1, step(at[1])), (0, start))[1]


def pushed(of: Callable[..., Any], arguments: Sequence[Any], tangents: Sequence[Any]) -> Any:
    return jax.jvp(of, tuple(arguments), tuple(tangents))[1]


def ruled(value: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
    made = jax.custom_jvp(value)

    def of_changing(arguments: Any, tangents: Any) -> Any:
        return rule(arguments, [None if isinstance(t, SymbolicZero) else t for t in tangents])

    made.defjvp(of_changing, symbolic_zeros=True)
    return made
