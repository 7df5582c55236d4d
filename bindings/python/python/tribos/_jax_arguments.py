"""Arguments of functions of JAX arrays."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from tribos import _arguments
from tribos._friction import Friction


class Call(_arguments.Call):
    """A call of a function whose first argument has the type of the results."""

    MODULE = "tribos.jax"
    BACKENDS = ("auto", "xla", "callback")
    OPERATIONS = "XLA"

    def __init__(self, name: str, friction: Friction, first: Any, **given: Any) -> None:
        super().__init__(name, friction, (first,), **given)

    def _types(self, given: tuple[Any, ...]) -> tuple[Any, Any]:
        result = _type_of(self.name, given[0])
        # Half precision has too few digits to compute with.
        return result, jnp.dtype(jnp.float32) if result.itemsize < 4 else result

    def _array(self, given: Any) -> Any:
        # What numpy has stays there until a compiled function takes it.
        if isinstance(given, (int, float, np.generic, np.ndarray)):
            return np.asarray(given, self.type)
        return jnp.asarray(given, self.type)

    def _above_zero(self, made: Any) -> Any:
        return made if isinstance(made, np.ndarray) else jnp.where(made > 0.0, made, jnp.nan)

    def own(self, made: Any) -> Any:
        return made if made.dtype == self.result else made.astype(self.result)


def _type_of(name: str, first: Any) -> Any:
    """The type of results: that of the first argument, a float."""
    own = first.dtype if hasattr(first, "dtype") else jnp.asarray(first).dtype
    if not jnp.issubdtype(own, jnp.floating):
        if jnp.issubdtype(own, jnp.complexfloating):
            raise ValueError(f"{name}: arguments must be real numbers, not {own}")
        own = jnp.result_type(float, own)
    return jnp.dtype(jax.dtypes.canonicalize_dtype(own))
