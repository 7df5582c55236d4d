"""Operations of the compiled kernel in JAX programs, by callback on the processor, with first derivatives."""

from __future__ import annotations

import re
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.custom_derivatives import SymbolicZero

from tribos._gradients import Operation, finite_derivatives


def applied(operation: Operation, *arrays: Any) -> tuple[Any, ...]:
    """The operation on arrays of one type, whose leading axes get one rank."""
    aligned = _aligned(operation, arrays)
    made: tuple[Any, ...] = compiled(operation, *aligned)
    return made


def slope(operation: Operation, *arrays: Any) -> Any:
    """The first output's derivatives by the first input."""
    return _compiled_slopes(operation, ((0, 0),), *_aligned(operation, arrays))[-1]


def _aligned(operation: Operation, arrays: tuple[Any, ...]) -> list[Any]:
    """Arrays whose leading axes have one rank."""
    ranks = [array.ndim - (row > 0) for array, row in zip(arrays, operation.inputs, strict=True)]
    missing = [(1,) * (max(ranks) - rank) for rank in ranks]
    return [array.reshape(more + array.shape) for array, more in zip(arrays, missing, strict=True)]


def _axes(operation: Operation, given: tuple[Any, ...]) -> tuple[int, ...]:
    """The leading axes of arguments together."""
    rows = zip(given, operation.inputs, strict=True)
    return np.broadcast_shapes(*(array.shape[:-1] if row else array.shape for array, row in rows))


def _called(
    operation: Operation, of: Any, rows: list[tuple[int, ...]], given: tuple[Any, ...]
) -> tuple[Any, ...]:
    """What a function of numpy arrays makes, in the arguments' type and over all their leading axes."""
    dtype = given[0].dtype

    def call(*arrays: Any) -> tuple[Any, ...]:
        numbers = [np.asarray(array) for array in arrays]
        axes = _axes(operation, tuple(numbers))
        made = zip(of(*numbers), rows, strict=True)
        return tuple(np.broadcast_to(np.asarray(one, dtype), axes + row) for one, row in made)

    axes = _axes(operation, given)
    results = tuple(
        jax.ShapeDtypeStruct(axes + row, dtype)  # type: ignore[no-untyped-call, unused-ignore]
        for row in rows
    )
    made: tuple[Any, ...] = jax.pure_callback(call, results, *given, vmap_method="expand_dims")
    return made


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _operate(operation: Operation, *given: Any) -> tuple[Any, ...]:
    rows = [(row,) * (row > 0) for row in operation.outputs]
    return _called(operation, operation.value, rows, given)


@partial(jax.custom_jvp, nondiff_argnums=(0, 1))
def _slopes(
    operation: Operation, pairs: tuple[tuple[int, int], ...], *given: Any
) -> tuple[Any, ...]:
    """The outputs, and derivatives of pairs of an output and an input."""

    def every(*arrays: Any) -> list[Any]:
        values, by = finite_derivatives(operation, *arrays)
        return [*values, *(by[output][at] for output, at in pairs)]

    rows = [(row,) * (row > 0) for row in operation.outputs]
    for output, at in pairs:
        rows.append(tuple(n for n in (operation.outputs[output], operation.inputs[at]) if n))
    return _called(operation, every, rows, given)


def _refuse(operation: Operation, *_: Any) -> Any:
    name = re.sub(r"(?<!^)(?=[A-Z])", "_", type(operation).__name__).lower()
    friction = getattr(operation, "friction", None)
    raise NotImplementedError(
        f"tribos.jax.{name} of {friction!r} runs in the compiled kernel, which has first derivatives only: "
        "difference them for second ones, or take jax.lax.stop_gradient of the inner one. Coulomb friction of disk, "
        "ring, punch, hertz, paraboloid, box and polygon under uniform pressure has all derivatives"
    )


_slopes.defjvp(_refuse)


def _rule(
    operation: Operation, given: tuple[Any, ...], tangents: tuple[Any, ...]
) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Values, and the derivatives in a direction: linear in it, so that reverse mode transposes them."""
    moving = [at for at, tangent in enumerate(tangents) if not isinstance(tangent, SymbolicZero)]
    pairs = [(output, at) for output in operation.smooth for at in moving]
    found = _slopes(operation, tuple(pairs), *given)
    count = len(operation.outputs)
    values = found[:count]
    rates = [jnp.zeros_like(value) for value in values]
    for (output, at), matrix in zip(pairs, found[count:], strict=True):
        i, j = "i" if operation.outputs[output] else "", "j" if operation.inputs[at] else ""
        rates[output] = rates[output] + jnp.einsum(
            f"...{i}{j},...{j}->...{i}", matrix, tangents[at]
        )
    return tuple(values), tuple(rates)


_operate.defjvp(_rule, symbolic_zeros=True)
# Without it every call outside of a compiled function would compile its callback anew.
compiled = jax.jit(_operate, static_argnums=0)
_compiled_slopes = jax.jit(_slopes, static_argnums=(0, 1))
