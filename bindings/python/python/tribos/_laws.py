"""Laws of friction by name."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number
from tribos._frozen import Frozen


class Law(Frozen):
    """A law of the local sliding speed: friction per load as a function of the speed.

    Parameters
    ----------
    name
        Its name in the catalogue `laws`, or the whole law as the command writes it:
        ``"stribeck:mu_s=0.4,mu_d=0.2,vs=0.05"``.
    **parameters
        Its parameters, in SI units; those with defaults may be left out.

    Examples
    --------
    >>> import tribos
    >>> oil = tribos.Law("stribeck", mu_s=0.4, mu_d=0.2, vs=0.05)
    >>> oil
    tribos.Law('stribeck', mu_s=0.4, mu_d=0.2, vs=0.05, delta=2.0, k=0.0)
    >>> print(oil.friction([0.0, 0.05, 1.0]).round(4))
    [0.4    0.2736 0.2   ]
    """

    __slots__ = ("_handle",)

    _handle: _native.Law

    def __init__(self, name: str, **parameters: float) -> None:
        if not isinstance(name, str):
            raise ValueError(f"a law has a name such as 'coulomb', not {name!r}")
        text = name
        if parameters:
            given = [f"{key}={number(key, value)!r}" for key, value in parameters.items()]
            text = f"{name}{',' if ':' in name else ':'}{','.join(given)}"
        self._keep(_handle=_native.Law(text))

    @property
    def text(self) -> str:
        """The law as the command and scenes write it."""
        return self._handle.text()

    @property
    def name(self) -> str:
        """Its name in the catalogue."""
        return self.text.partition(":")[0]

    @property
    def parameters(self) -> dict[str, float]:
        """Its parameters, defaults included."""
        given = self.text.partition(":")[2]
        return {key: float(value) for key, value in (item.split("=") for item in given.split(","))}

    def friction(self, speed: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Friction per load at sliding speeds in m/s; signs are ignored."""
        return self._handle.friction(speed, out)

    def slope(self, speed: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Derivative of `friction` with respect to the speed, in s/m."""
        return self._handle.slope(speed, out)

    def __repr__(self) -> str:
        given = "".join(f", {key}={value!r}" for key, value in self.parameters.items())
        return f"tribos.Law({self.name!r}{given})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Law, (self.text,)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)


def laws() -> list[dict[str, Any]]:
    """All laws of the library: name, summary, formula, source, parameters with units.

    Those with ``is_local`` are laws of the local speed, which `Law` makes.

    Examples
    --------
    >>> import tribos
    >>> [law["name"] for law in tribos.laws()][:3]
    ['coulomb', 'dry', 'power']
    """
    return _native.laws()


def law_of(mu: float | None, law: Law | str | None, alpha: float | None) -> Law:
    """The law that the keywords mu, law and alpha ask for."""
    if (mu is None) == (law is None):
        raise ValueError("give either mu, the coefficient of friction, or law")
    if law is not None:
        if alpha is not None:
            raise ValueError("alpha goes with mu: friction is mu * speed**alpha")
        return law if isinstance(law, Law) else Law(law)
    if alpha is None or np.all(alpha == 0.0):
        return Law("coulomb", mu=number("mu", mu))
    return Law("power", gamma=number("mu", mu), alpha=number("alpha", alpha))
