"""Arguments that are one number or a table of numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray


def number(name: str, value: object) -> float:
    """A finite number."""
    try:
        made = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        hint = ""
        if type(value).__module__.startswith("jax") and name in ("mu", "radius"):
            hint = f"; where it is traced or an array give {name}= to the function of tribos.jax"
        raise ValueError(f"{name} must be a number, not {value!r}{hint}") from None
    except OverflowError:
        made = math.inf
    if isinstance(value, str) or not math.isfinite(made):
        raise ValueError(f"{name} must be a finite number, not {value!r}")
    return made


def positive(name: str, value: object) -> float:
    """A finite number above 0."""
    made = number(name, value)
    if not made > 0.0:
        raise ValueError(f"{name} must be > 0, not {value!r}")
    return made


def reals(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """An array of one's own, of real numbers."""
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be real numbers: {error}") from None
    if array.dtype.kind not in "fiub":
        raise ValueError(f"{name} must be real numbers, not {array.dtype}")
    return np.array(array, dtype=np.float64)


def table(name: str, value: ArrayLike, columns: int) -> NDArray[np.float64]:
    """Rows of finite numbers."""
    array = reals(name, value)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} must have shape (n, {columns}), not {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite")
    return array


def pair(name: str, value: Sequence[float] | NDArray[np.float64]) -> tuple[float, float]:
    """Two finite numbers."""
    try:
        x, y = value
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be two numbers, not {value!r}") from None
    return number(name, x), number(name, y)
