"""The space of JAX."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import jax
import jax.numpy as jnp

where = jnp.where
sqrt = jnp.sqrt
log = jnp.log
cos = jnp.cos
sin = jnp.sin
abs = jnp.abs
still = jax.lax.stop_gradient


def stack(parts: Sequence[Any]) -> Any:
    return jnp.stack(jnp.broadcast_arrays(*parts), axis=-1)


def total(x: Any) -> Any:
    return jnp.sum(x, axis=-1)


def following(x: Any) -> Any:
    return jnp.roll(x, -1, axis=-1)


def constant(c: Any, like: Any) -> Any:
    return jnp.asarray(c, like.dtype)


def type_of(x: Any) -> str:
    return str(x.dtype)


# Fused, every use of a value would compute all before it again.
apart = jax.lax.optimization_barrier


def loop(step: Callable[[Any], Any], state: Any, count: int) -> Any:
    return jax.lax.fori_loop(0, count, lambda _, now: step(now), still(state))


def until(step: Callable[[Any], Any], state: Any, most: int) -> Any:
    def goes_on(now: Any) -> Any:
        count, (*_, is_done) = now
        return (count < most) & ~jnp.all(is_done)

    return jax.lax.while_loop(goes_on, lambda now: (now[0] + 1, step(now[1])), (0, still(state)))[1]


def course(step: Callable[[Any, Any], tuple[Any, Any]], state: Any, rows: Any) -> tuple[Any, Any]:
    made: tuple[Any, Any] = jax.lax.scan(step, state, rows)
    return made


def pushed(of: Callable[..., Any], arguments: Sequence[Any], tangents: Sequence[Any]) -> Any:
    return jax.jvp(of, tuple(arguments), tuple(tangents))[1]


def ruled(value: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
    made = jax.custom_jvp(value)
    made.defjvp(rule)
    return made
