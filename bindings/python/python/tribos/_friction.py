"""Friction of a patch: force and torque against its motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, pair
from tribos._floor import SteadyMotion, Surface, rows_of, steady
from tribos._frozen import Frozen
from tribos._laws import Law, law_of
from tribos._patches import Patch, anisotropic
from tribos._plot import html, short
from tribos._surface import LimitSurface


class Friction(Frozen):
    """Friction of a patch under a law of the local speed.

    Every element of the patch resists along its own velocity ``v + spin × r``; force and torque are
    the integral over the patch. Immutable and picklable.

    Parameters
    ----------
    patch
        The contact patch: `tribos.disk`, `tribos.box`, ….
    mu
        Coefficient of friction; of ``mu * speed**alpha`` if alpha is given, in (s/m)**alpha. Two of them, ``(mu_x,
        mu_y)``, for dry friction that differs along x and y of the patch, or along an axis and across it.
    axis
        Angle from x to the axis of two coefficients, in rad.
    law
        A `Law`, or its name with parameters, in place of mu.
    alpha
        Exponent of the speed, above -1: any on round patches, at most 10 on polygons; 0 for dry
        friction.
    tier
        On round patches ``"exact"`` (to rounding, powers of the speed; ``"table"`` and ``"compact"`` mean it too) or
        ``"quadrature"`` (1e-8 on a disk). None for the quickest that serves patch and law.

    Notes
    -----
    Accuracy: a few units in the last place on round patches, 2e-14 of the largest friction on
    polygons, 1e-8 for laws other than powers on a disk, 1e-3 for those on other round patches.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
    >>> puck
    tribos.Friction(tribos.disk(radius=0.04), law=tribos.Law('coulomb', mu=0.3))
    >>> print(puck.wrench([[1, 0, 0], [1, 0, 20], [0, 0, 20]], load=1.7).round(5))
    [[-0.51    -0.      -0.     ]
     [-0.465   -0.      -0.00435]
     [ 0.       0.      -0.0136 ]]
    """

    __slots__ = ("_handle", "law", "patch", "tier")

    patch: Patch
    law: Law
    tier: str | None
    _handle: _native.Friction

    def __init__(
        self,
        patch: Patch,
        mu: float | Sequence[float] | None = None,
        *,
        axis: float | None = None,
        law: Law | str | None = None,
        alpha: float | None = None,
        tier: str | None = None,
    ) -> None:
        if not isinstance(patch, Patch):
            raise ValueError(f"the patch must be made by tribos.disk and the like, not {patch!r}")
        if mu is not None and np.ndim(mu) > 0:
            along, across = pair("mu", mu)  # type: ignore[arg-type]
            patch = patch if along == across else anisotropic(patch, (along, across), axis or 0.0)
            mu = max(along, across)
        elif axis is not None:
            raise ValueError("axis goes with two coefficients: mu=(0.5, 0.9)")
        chosen = law_of(mu, law, alpha)  # type: ignore[arg-type]
        handle = _native.Friction(patch._handle, chosen._handle, tier)
        self._keep(patch=patch, law=chosen, tier=tier, _handle=handle)

    @property
    def mu(self) -> float:
        """The coefficient of dry friction; ValueError for other laws."""
        parameters = self.law.parameters
        dry = self.law.name == "power" and parameters["alpha"] == 0.0
        if self.law.name != "coulomb" and not dry:
            raise ValueError(
                f"{self.law!r} has no limit surface: its friction depends on the speed"
            )
        return parameters["gamma" if dry else "mu"]

    def wrench(
        self,
        twists: ArrayLike,
        load: ArrayLike,
        *,
        surface: Iterable[Surface] | None = None,
        out: NDArray[Any] | None = None,
    ) -> Any:
        """Force and torque on the body, against its motion.

        Parameters
        ----------
        twists
            Velocities in m/s and spins in rad/s, of shape (..., 3).
        load
            Normal force in N, at least 0, broadcast with the leading axes of the twists.
        surface
            Parts of the floor that move, in the coordinates of the body: pairs of a place and a twist. A place is the
            corners of a convex polygon, of shape (n, 2), or two points of a border to whose left the surface lies. The
            floor beside them is at rest, and the load one number.
        out
            An array of floats for the result.

        Returns
        -------
        numpy.ndarray
            Forces in N and torques in N m, of shape (..., 3). Zero at rest; NaN for NaN.

        Examples
        --------
        A box whose halves lie on belts that run against each other is turned by ``mu * load * b / 4``:

        >>> import tribos
        >>> parcel = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
        >>> belts = [([[0, 0], [1, 0]], [0.5, 0, 0]), ([[1, 0], [0, 0]], [-0.5, 0, 0])]
        >>> print(parcel.wrench([0, 0, 0], load=20.0, surface=belts).round(12))
        [ 0.   0.  -0.4]
        """
        if surface is not None:
            return self._floor(load, surface).wrench(twists, out)
        return self._handle.wrench(twists, load, out)

    def steady_motion(
        self, load: float, surface: Iterable[Surface], push: ArrayLike = (0.0, 0.0, 0.0)
    ) -> SteadyMotion:
        """The motion in which friction of moving surfaces balances a push: the one that the body comes to.

        Parameters
        ----------
        load
            Normal force in N.
        surface
            Parts of the floor that move, as in `wrench`.
        push
            Force in N and torque in N m on the body, about the origin.

        Raises
        ------
        ValueError
            Where no motion is steady, because the push is more than friction carries.

        Examples
        --------
        >>> import tribos
        >>> parcel = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4)
        >>> belts = [([[0, 0], [1, 0]], [0.5, 0, 0]), ([[1, 0], [0, 0]], [-0.5, 0, 0])]
        >>> round(float(parcel.steady_motion(20.0, belts).twist[2]), 4)    # rad/s
        -2.6103
        """
        return steady(self._floor(load, surface), push)

    def _floor(self, load: ArrayLike, surface: Iterable[Surface]) -> _native.Floor:
        newtons = number("load", load)
        if newtons < 0.0:
            raise ValueError(f"load must be >= 0, not {load!r}")
        return _native.Floor.under(self.patch._handle, self.mu, newtons, rows_of(surface))

    def jacobian(
        self,
        twists: ArrayLike,
        load: ArrayLike,
        *,
        surface: Iterable[Surface] | None = None,
        out: NDArray[Any] | None = None,
    ) -> Any:
        """Derivatives of `wrench` with respect to the twist, of shape (..., 3, 3), symmetric.

        At rest dry friction has no derivative: on round patches the result is the limit of damping, which is
        infinite; on straight edges and points what does not move is left out, which gives 0. A law that
        is smooth there, such as `softened` or ``Law("power", gamma=…, alpha=1)``, has its slope.

        Examples
        --------
        >>> import tribos
        >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3)
        >>> jacobian = puck.jacobian([1.0, 0.0, 20.0], load=1.7)
        >>> bool(abs(jacobian @ [1.0, 0.0, 20.0]).max() < 1e-14)    # twice as fast: the same friction
        True
        """
        if surface is not None:
            return self._floor(load, surface).jacobian(twists, out)
        return self._handle.jacobian(twists, load, out)

    def limit_surface(self, load: ArrayLike) -> LimitSurface:
        """All wrenches that dry friction carries under a load in N.

        Parameters
        ----------
        load
            One load, or an array of them that is broadcast with the wrenches of a call.
        """
        return LimitSurface(self.patch, self.mu, load)

    def __repr__(self) -> str:
        tier = "" if self.tier is None else f", tier={self.tier!r}"
        return f"tribos.Friction({self.patch!r}, law={self.law!r}{tier})"

    def _repr_html_(self) -> str:
        """A table of patch and law, for notebooks."""
        rows = [
            ("patch", repr(self.patch)),
            ("radius", short(self.patch.radius, "m")),
            ("law", repr(self.law)),
        ]
        if self.tier is not None:
            rows.append(("tier", self.tier))
        return html("Friction", rows, self.patch)

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self.patch, self.law, self.tier)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Friction):
            return NotImplemented
        return (self.patch, self.law, self.tier) == (other.patch, other.law, other.tier)

    def __hash__(self) -> int:
        return hash((self.patch, self.law, self.tier))


def _made(patch: Patch, law: Law, tier: str | None) -> Friction:
    return Friction(patch, law=law, tier=tier)
