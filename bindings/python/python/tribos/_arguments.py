"""Arguments of functions of another library's arrays: types, shapes, domains, and what computes them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np

from tribos._forms import of_friction
from tribos._friction import Friction

#: What a message says of patches with a form.
WITH_FORM = "Coulomb friction of disk, ring, punch, hertz, paraboloid, box and polygon under uniform pressure"


def friction_in(name: str, friction: Any) -> Friction:
    """The friction, if it is one."""
    if not isinstance(friction, Friction):
        raise ValueError(f"{name}: friction must be a tribos.Friction, not {friction!r}")
    return friction


def check_sign(name: str, key: str, given: Any, *, above: bool = False) -> None:
    """Whether a number is at least 0 or above 0, where it is known."""
    if isinstance(given, (int, float, np.generic, np.ndarray)):
        known = np.asarray(given)
        if known.dtype.kind in "fiub" and np.any(known <= 0.0 if above else known < 0.0):
            least = "> 0" if above else ">= 0"
            raise ValueError(f"{name}: {key} must be {least}, not {given!r}")


def check_area(name: str, corners: Any) -> None:
    """Whether corners bound an area, where they are known."""
    if isinstance(corners, np.ndarray):
        x, y = np.moveaxis(corners.astype(np.float64), -1, 0)
        x, y = x - x[..., :1], y - y[..., :1]
        twice = x * np.roll(y, -1, axis=-1) - y * np.roll(x, -1, axis=-1)
        if np.any(np.abs(twice.sum(axis=-1)) <= 1e-12 * np.abs(twice).sum(axis=-1)):
            raise ValueError(f"{name}: corners must bound an area")


def axes_of(name: str, shapes: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The axes of arguments together."""
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        raise ValueError(f"{name}: shapes do not fit: {dict(shapes)}") from None


class Call:
    """A call of a function: its arguments in one type, with axes that fit.

    Attributes
    ----------
    result, type
        The types of results and of what is computed.
    kind : str or None
        The form that serves; None for the compiled kernel.
    size, mu, soft
        Arrays for the form; `soft` is None for dry friction.
    friction : Friction
        The friction for the kernel: that given, or with mu 1 where `mu` is an array.
    """

    MODULE: ClassVar[str]
    #: What chooses, what takes forms and what takes the kernel.
    BACKENDS: ClassVar[tuple[str, str, str]]
    #: What forms are made of.
    OPERATIONS: ClassVar[str]

    def __init__(
        self,
        name: str,
        friction: Friction,
        given: tuple[Any, ...],
        *,
        mu: Any = None,
        radius: Any = None,
        corners: Any = None,
        soft: Any = None,
        backend: str = "auto",
    ) -> None:
        self.name = f"{self.MODULE}.{name}"
        self.friction = friction_in(self.name, friction)
        self.result, self.type = self._types((*given, mu, radius, corners, soft))
        self.axes: tuple[int, ...] = ()
        only_forms = {"radius": radius, "corners": corners, "soft": soft}
        self.kind = self._kind(backend, [key for key, x in only_forms.items() if x is not None])
        self.mu = self._coefficient(mu)
        self.size = self._size(radius, corners)
        self.soft = None if _is_zero(soft) else self.number("soft", soft)

    def _types(self, given: tuple[Any, ...]) -> tuple[Any, Any]:
        """Types of the results and of what is computed; `given` has None for what is not given."""
        raise NotImplementedError

    def _array(self, given: Any) -> Any:
        """An array in the type of what is computed."""
        raise NotImplementedError

    def _above_zero(self, made: Any) -> Any:
        """An array with NaN for what is not above 0."""
        raise NotImplementedError

    def own(self, made: Any) -> Any:
        """A result in the type of the arguments."""
        raise NotImplementedError

    def _chooses_kernel(self, given: list[str]) -> bool:
        """Whether the kernel serves what has a form, where none is asked for; `given` goes with forms only."""
        return False

    def _kind(self, backend: str, given: list[str]) -> str | None:
        """The form, unless the kernel is to serve."""
        auto, forms, kernel = self.BACKENDS
        if backend not in self.BACKENDS:
            raise ValueError(
                f"{self.name}: backend must be one of {self.BACKENDS}, not {backend!r}"
            )
        kind = None if backend == kernel else of_friction.kind_of(self.friction)
        if kind is None and backend == forms:
            raise ValueError(
                f"{self.name}: {self.friction!r} has no form in {self.OPERATIONS}, as {WITH_FORM} has: "
                f"leave backend={auto!r}"
            )
        if kind is None and given:
            raise ValueError(
                f"{self.name}: {', '.join(given)} goes with {WITH_FORM}, without backend={kernel!r}; "
                f"not with {self.friction!r}. Where soft= is wanted tribos.softened has a law that is smooth"
            )
        return None if backend == auto and self._chooses_kernel(given) else kind

    def _coefficient(self, mu: Any) -> Any:
        """The coefficient for a form; for the kernel, that of 1 if one is given for each row."""
        if mu is None:
            return None if self.kind is None else self._array(self.friction.mu)
        if of_friction.is_dry(self.friction):
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
        is_flat = self.kind == of_friction.FLAT
        if (radius if is_flat else corners) is not None:
            key, own = ("radius", "corners") if is_flat else ("corners", "radius")
            raise ValueError(f"{self.name}: {key}= is not for {self.friction.patch!r}; give {own}=")
        if is_flat and corners is not None:
            made = self._array(corners)
            shape = tuple(made.shape)
            if len(shape) < 2 or shape[-1] != 2 or shape[-2] < 3:
                raise ValueError(
                    f"{self.name}: corners must have shape (..., n, 2) with n > 2, not {shape}"
                )
            self.meet("corners", shape[:-2])
            check_area(self.name, corners)
            return made
        if radius is not None:
            return self.number("radius", radius, above=True)
        return self._array(of_friction.size_of(self.friction))

    def rows(self, key: str, given: Any) -> Any:
        """Rows of three numbers."""
        made = self._array(given)
        shape = tuple(made.shape)
        if shape[-1:] != (3,):
            raise ValueError(f"{self.name}: {key} must have shape (..., 3), not {shape}")
        self.meet(key, shape[:-1])
        return made

    def number(self, key: str, given: Any, *, above: bool = False) -> Any:
        """A number for each row, at least 0 or above 0 where it is known; else forms take NaN for what is not above 0."""
        check_sign(self.name, key, given, above=above)
        made = self._array(given)
        self.meet(key, tuple(made.shape))
        return made if self.kind is None or not above else self._above_zero(made)

    def under(self, load: Any) -> Any:
        """What loads the friction for the kernel."""
        return load if self.mu is None else self.mu * load

    def meet(self, key: str, axes: tuple[int, ...]) -> None:
        """Leading axes that are broadcast with all before."""
        try:
            self.axes = np.broadcast_shapes(self.axes, axes)
        except ValueError:
            raise ValueError(
                f"{self.name}: leading axes {axes} of {key} do not fit {self.axes} of the other arguments"
            ) from None


def _is_zero(soft: Any) -> bool:
    return soft is None or (isinstance(soft, (int, float)) and soft == 0.0)
