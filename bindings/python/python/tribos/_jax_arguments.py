"""Arguments of functions of JAX arrays: types, shapes, domains, and which backend takes them."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from tribos import _jax_native
from tribos._friction import Friction

BACKENDS = ("auto", "xla", "callback")
#: What a message says of patches with a form.
WITH_FORM = "Coulomb friction of disk, ring, punch, hertz, paraboloid, box and polygon under uniform pressure"


class Call:
    """A call of a function: its arguments in one type, with axes that fit.

    Attributes
    ----------
    kind : str or None
        The form that serves; None for the compiled kernel.
    size, mu, soft
        Arrays for the form; `soft` is None for dry friction.
    friction : Friction
        The friction for the kernel: that given, or with mu 1 where `mu` is an array.
    """

    def __init__(
        self,
        name: str,
        friction: Friction,
        first: Any,
        *,
        mu: Any = None,
        radius: Any = None,
        corners: Any = None,
        soft: Any = None,
        backend: str = "auto",
    ) -> None:
        self.name = f"tribos.jax.{name}"
        if not isinstance(friction, Friction):
            raise ValueError(f"{self.name}: friction must be a tribos.Friction, not {friction!r}")
        self.result = _type_of(first)
        # Half precision has too few digits to compute with.
        self.type = jnp.dtype(jnp.float32) if self.result.itemsize < 4 else self.result
        self.axes: tuple[int, ...] = ()
        self.friction = friction
        only_forms = {"radius": radius, "corners": corners, "soft": soft}
        self.kind = self._kind(backend, [key for key, x in only_forms.items() if x is not None])
        self.mu = self._coefficient(mu)
        self.size = self._size(radius, corners)
        self.soft = None if _is_zero(soft) else self.number("soft", soft)

    def _kind(self, backend: str, given: list[str]) -> str | None:
        """The form, unless the kernel is to serve."""
        if backend not in BACKENDS:
            raise ValueError(f"{self.name}: backend must be one of {BACKENDS}, not {backend!r}")
        kind = None if backend == "callback" else _jax_native.kind_of(self.friction)
        if kind is None and backend == "xla":
            raise ValueError(
                f"{self.name}: {self.friction!r} has no form in XLA, as {WITH_FORM} has: "
                "leave backend='auto'"
            )
        if kind is None and given:
            raise ValueError(
                f"{self.name}: {', '.join(given)} goes with {WITH_FORM}, without backend='callback'; "
                f"not with {self.friction!r}. Where soft= is wanted tribos.softened has a law that is smooth"
            )
        return kind

    def _coefficient(self, mu: Any) -> Any:
        """The coefficient for a form; for the kernel, that of 1 if one is given for each row."""
        if mu is None:
            return None if self.kind is None else np.asarray(self.friction.mu, self.type)
        if _jax_native.is_dry(self.friction):
            if self.kind is None:
                self.friction = Friction(self.friction.patch, mu=1.0, tier=self.friction.tier)
            return self.number("mu", mu)
        raise ValueError(
            f"{self.name}: mu= takes the place of the coefficient of Coulomb friction, which "
            f"{self.friction.law!r} is not"
        )

    def _size(self, radius: Any, corners: Any) -> Any:
        """Radius or corners for a form."""
        if self.kind is None:
            return None
        is_flat = self.kind == _jax_native.FLAT
        if (radius if is_flat else corners) is not None:
            key, own = ("radius", "corners") if is_flat else ("corners", "radius")
            raise ValueError(f"{self.name}: {key}= is not for {self.friction.patch!r}; give {own}=")
        if is_flat and corners is not None:
            made = _array(corners, self.type)
            if made.ndim < 2 or made.shape[-1] != 2 or made.shape[-2] < 3:
                raise ValueError(
                    f"{self.name}: corners must have shape (..., n, 2) with n > 2, not {made.shape}"
                )
            self.meet("corners", made.shape[:-2])
            return made
        if radius is not None:
            return self.number("radius", radius, above=True)
        return np.asarray(_jax_native.size_of(self.friction), self.type)

    def rows(self, key: str, given: Any) -> Any:
        """Rows of three numbers."""
        made = _array(given, self.type)
        if made.shape[-1:] != (3,):
            raise ValueError(f"{self.name}: {key} must have shape (..., 3), not {made.shape}")
        self.meet(key, made.shape[:-1])
        return made

    def number(self, key: str, given: Any, *, above: bool = False) -> Any:
        """A number for each row, at least 0 or above 0 where it is known."""
        if isinstance(given, (int, float, np.generic, np.ndarray)):
            known = np.asarray(given)
            if np.any(known <= 0.0 if above else known < 0.0):
                least = "> 0" if above else ">= 0"
                raise ValueError(f"{self.name}: {key} must be {least}, not {given!r}")
        made = _array(given, self.type)
        self.meet(key, made.shape)
        return made

    def under(self, load: Any) -> Any:
        """What loads the friction for the kernel."""
        return load if self.mu is None else self.mu * load

    def own(self, made: Any) -> Any:
        """A result in the type of the arguments."""
        return made if made.dtype == self.result else made.astype(self.result)

    def meet(self, key: str, axes: tuple[int, ...]) -> None:
        """Leading axes that are broadcast with all before."""
        try:
            self.axes = np.broadcast_shapes(self.axes, axes)
        except ValueError:
            raise ValueError(
                f"{self.name}: leading axes {axes} of {key} do not fit {self.axes} of the other arguments"
            ) from None


def _type_of(first: Any) -> Any:
    """The type of results: that of the first argument, a float."""
    own = first.dtype if hasattr(first, "dtype") else jnp.asarray(first).dtype
    if not jnp.issubdtype(own, jnp.floating):
        own = jnp.result_type(float, own)
    return jnp.dtype(jax.dtypes.canonicalize_dtype(own))


def _array(given: Any, dtype: Any) -> Any:
    if isinstance(given, (int, float, np.generic, np.ndarray)):
        return np.asarray(given, dtype)
    return jnp.asarray(given, dtype)


def _is_zero(soft: Any) -> bool:
    return soft is None or (isinstance(soft, (int, float)) and soft == 0.0)
