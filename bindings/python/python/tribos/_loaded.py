"""Friction of patches whose radius follows the load."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import reals
from tribos._frozen import Frozen
from tribos._laws import Law


class LoadedFriction(Frozen):
    """Dry friction of a round patch whose radius follows the load: spheres, fingertips, wheels.

    Parameters
    ----------
    radius
        What makes the radius of the load, as on the command line: ``"hertz:modulus=1e6,radius=0.01"`` for an elastic
        sphere (effective modulus in Pa, radius of the sphere in m), ``"jkr:modulus=1e6,radius=0.01,work=0.05"`` for one
        that sticks (work of adhesion in J/m²), ``"finger:scale=3e-3,exponent=0.33"`` for a soft finger, ``scale *
        load**exponent``; or a number in m.
    mu
        Coefficient of friction.
    pressure
        How the load is spread: ``"hertz"``, ``"disk"``, ``"punch"``, ….

    Notes
    -----
    Accuracy: 4 units in the last place of the radius, and that of `Friction`. The effective modulus of two bodies is
    ``1/E* = (1 - nu1**2)/E1 + (1 - nu2**2)/E2``, the radius ``R1 R2/(R1 + R2)`` (Johnson, Contact Mechanics, 1985).

    Examples
    --------
    >>> import tribos
    >>> tip = tribos.LoadedFriction("finger:scale=3e-3", mu=0.8)     # 3 mm under 1 N, exponent 1/3
    >>> float(tip.radius(8.0))
    0.006
    >>> print(tip.wrench([0.0, 0.0, 1.0], [1.0, 8.0]).round(6))      # N m, as load**(4/3)
    [[ 0.        0.       -0.001414]
     [ 0.        0.       -0.022619]]
    >>> print(tip.slope_by_load([0.0, 0.0, 1.0], 8.0).round(6))      # 4/3 of the torque over the load
    [ 0.       0.      -0.00377]
    """

    __slots__ = ("_handle", "_text", "mu", "pressure")

    mu: float
    pressure: str
    _text: str
    _handle: _native.LoadedFriction

    def __init__(self, radius: str | float, mu: float, pressure: str = "hertz") -> None:
        law = Law("coulomb", mu=mu)
        text = str(radius)
        handle = _native.LoadedFriction(pressure, law._handle, text)
        self._keep(mu=law.parameters["mu"], pressure=pressure, _text=text, _handle=handle)

    def radius(self, load: ArrayLike) -> Any:
        """The radius in m under loads in N, zero where there is no contact."""
        return self._each(load, 0)

    def growth(self, load: ArrayLike) -> Any:
        """d ln radius / d ln load: 1/3 of an elastic sphere."""
        return self._each(load, 1)

    def wrench(self, twists: ArrayLike, load: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Force in N and torque in N m on the body, of shape (..., 3), as `Friction.wrench` under the radius of each load."""
        return self._handle.wrench(twists, load, out)

    def slope_by_load(
        self, twists: ArrayLike, load: ArrayLike, *, out: NDArray[Any] | None = None
    ) -> Any:
        """Derivative of `wrench` by the load while the motion stays, of shape (..., 3): no unit, and m."""
        return self._handle.slope_by_load(twists, load, out)

    def _each(self, load: ArrayLike, part: int) -> Any:
        loads = reals("load", load)
        values = np.array([self._handle.radius(float(x))[part] for x in loads.flat])
        return values.reshape(loads.shape)[()]

    def __repr__(self) -> str:
        return f"tribos.LoadedFriction({self._text!r}, mu={self.mu!r}, pressure={self.pressure!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return LoadedFriction, (self._text, self.mu, self.pressure)
