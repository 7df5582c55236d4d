"""Limit surfaces: what dry friction carries, and how it moves when it is pushed."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, reals
from tribos._frozen import Frozen
from tribos._patches import Patch
from tribos._plot import html, plot_surface, short


class LimitSurface(Frozen):
    """All wrenches that dry friction of a patch carries: a closed convex set.

    Parameters
    ----------
    patch
        The contact patch.
    mu
        Coefficient of friction.
    load
        Normal force in N, at least 0: a number, or an array that is broadcast with the leading axes
        of the arguments of a call.

    Notes
    -----
    Accuracy: gauge 1e-14, surface points and normals 1e-13 of the limits; at points of contact next
    to a facet's rim less, see the documentation of the patch.

    Examples
    --------
    >>> import tribos
    >>> table = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4).limit_surface(load=20.0)
    >>> round(float(table.gauge([0.0, 4.0, 0.5])), 4)              # below 1: it holds
    0.8821
    >>> print(table.normal([0.0, 8.0, 1.0]).round(3))              # pushed harder it moves like this
    [0.    0.457 4.933]
    """

    __slots__ = ("_handle", "_limits", "is_ellipsoid", "load", "mu", "patch")

    patch: Patch
    mu: float
    load: Any
    _handle: _native.LimitSurface
    _limits: Any
    is_ellipsoid: bool

    def __init__(self, patch: Patch, mu: float, load: ArrayLike) -> None:
        coefficient = number("mu", mu)
        if coefficient < 0.0:
            raise ValueError(f"mu must be >= 0, not {mu!r}")
        loads = reals("load", load)
        if not np.all((loads >= 0.0) & (loads < np.inf)):
            raise ValueError("load must be >= 0 and finite")
        loads.flags.writeable = False
        kept = float(loads) if loads.ndim == 0 else loads
        self._keep(patch=patch, mu=coefficient, load=kept, _limits=coefficient * kept)
        self._keep(_handle=patch._limits(), is_ellipsoid=False)

    @property
    def force_limit(self) -> Any:
        """The largest force ``mu * load``, in N."""
        return self._limits

    @property
    def torque_limit(self) -> Any:
        """The largest torque about the origin, in N m."""
        return self.force_limit * self._handle.torque_limit(1.0)

    def ellipsoid(self) -> LimitSurface:
        """The ellipsoid with the same largest force and torque: the usual approximation, to compare.

        Examples
        --------
        >>> import tribos
        >>> puck = tribos.Friction(tribos.disk(0.04), mu=0.3).limit_surface(load=1.7)
        >>> friction = puck.wrench([0.1, 0.0, 3.0])
        >>> print(round(float(puck.gauge(friction)), 4), round(float(puck.ellipsoid().gauge(friction)), 4))
        1.0 0.9356
        """
        made = LimitSurface(self.patch, self.mu, self.load)
        made._keep(_handle=self._handle.ellipsoid(), is_ellipsoid=True)
        return made

    def torque_limits(self, forces: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The lowest and the highest torque about the origin that is carried with each force.

        Of a foot whose pressure is not known, `any_pressure` has the limits; an ellipsoid has none.

        Parameters
        ----------
        forces
            In N, of shape (..., 2).
        out
            An array of floats for the result.

        Returns
        -------
        numpy.ndarray
            Torques in N m, of shape (..., 2); NaN where friction does not carry the force alone.

        Examples
        --------
        >>> import tribos
        >>> sole = tribos.polygon([[-0.06, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]])
        >>> floor = tribos.LimitSurface(sole, mu=0.6, load=700.0)
        >>> print(floor.torque_limits([200.0, 0.0]).round(3))
        [-24.699  24.699]
        """
        return self._handle.torque_limits(self._limits, forces, out)

    def gauge(self, wrenches: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The least factor by which the set must grow to hold each wrench.

        Below 1 friction holds, at 1 the body starts to move. Of shape (...) for wrenches of shape
        (..., 3).
        """
        return self._handle.gauge(self._limits, wrenches, out)

    def contains(self, wrenches: ArrayLike) -> Any:
        """Whether friction can carry each wrench, up to rounding: ``gauge <= 1``."""
        return self.gauge(wrenches) <= 1.0 + 64.0 * np.finfo(np.float64).eps

    def normal(self, wrenches: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The motion that each push causes: the outward normal where its ray meets the surface.

        Twists of shape (..., 3), scaled such that ``|velocity|² + (spin * radius)² = 1`` with a
        radius about the origin: the patch's, plus the distance of its centre of pressure; friction under the push is ``-push / gauge``.
        """
        return self._handle.normal(self._limits, wrenches, out)

    def scale_to_surface(self, wrenches: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The wrench along the same ray on the surface, ``wrench / gauge``."""
        return self._handle.scale_to_surface(self._limits, wrenches, out)

    def project(
        self,
        wrenches: ArrayLike,
        *,
        length: float | None = None,
        out: NDArray[Any] | None = None,
    ) -> Any:
        """The nearest wrench that friction carries.

        Nearest by ``sqrt(|Δforce|² + (Δtorque/length)²)``; wrenches of the set stay as they are, to
        the last bit.

        Parameters
        ----------
        wrenches
            Of shape (..., 3), in N and N m.
        length
            What makes a force of a torque, in m; the radius of gyration makes the distance that of
            kinetic energy. None for the patch's radius.
        """
        return self._handle.project(self._limits, wrenches, length, out)

    def support(self, twists: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The largest power that the set takes from each twist, in W: what friction dissipates."""
        return self._handle.support(self._limits, twists, out)

    def wrench(self, twists: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Friction at each twist: the surface point with the outward normal ``-twist``."""
        return self._handle.wrench(self._limits, twists, out)

    def plot(
        self,
        ax: Any = None,
        *,
        wrenches: ArrayLike | None = None,
        normals: ArrayLike | None = None,
        resolution: int = 24,
        **options: Any,
    ) -> Any:
        """Draw the surface in three dimensions: forces in N and the torque in N m.

        Parameters
        ----------
        ax
            Axes of matplotlib in three dimensions; None for new ones.
        wrenches
            Wrenches that are drawn as points, of shape (..., 3).
        normals
            Pushes, of shape (..., 3): where their rays meet the surface, lines point along the motions
            that they cause.
        resolution
            Number of rays from pole to pole.
        **options
            For matplotlib's ``plot_surface``, such as ``color`` and ``alpha``.

        Returns
        -------
        matplotlib axes
            The given ones, or the new ones. ImportError without matplotlib.

        Examples
        --------
        >>> import matplotlib
        >>> matplotlib.use("Agg")
        >>> import tribos
        >>> table = tribos.LimitSurface(tribos.box(0.3, 0.2), mu=0.4, load=20.0)
        >>> ax = table.plot(normals=[[0.0, 8.0, 1.0]], color="C0")
        >>> ax.get_zlabel()
        'torque [N m]'
        """
        return plot_surface(self, ax, wrenches, normals, resolution, options)

    def _repr_html_(self) -> str:
        """A table of patch and limits, for notebooks."""
        rows = [
            ("patch", repr(self.patch)),
            ("mu", f"{self.mu:.6g}"),
            ("load", short(self.load, "N")),
            ("largest force", short(self.force_limit, "N")),
            ("largest torque", short(self.torque_limit, "N m")),
        ]
        return html("Limit surface", rows, self.patch)

    def _slopes(self) -> _native.SurfaceDerivatives:
        from tribos import _gradients

        made = (
            _gradients.derivatives_of_ellipsoids if self.is_ellipsoid else _gradients.derivatives_of
        )
        return made(self.patch)

    def gauge_gradient(self, wrenches: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Derivatives of `gauge` with respect to the wrench, of shape (..., 3).

        The normal above each wrench, scaled such that its `support` is 1, in 1/N and 1/(N m). NaN
        for the zero wrench, where the gauge has a kink, and without load.

        Examples
        --------
        >>> import tribos
        >>> foot = tribos.Friction(tribos.box(0.3, 0.2), mu=0.4).limit_surface(load=20.0)
        >>> push = [2.0, 4.0, 0.5]
        >>> bool(abs(foot.gauge_gradient(push) @ push - foot.gauge(push)) < 1e-14)
        True
        """
        return self._slopes().gauge_gradient(self._limits, wrenches, out)

    def gauge_hessian(self, wrenches: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Second derivatives of `gauge` with respect to the wrench, of shape (..., 3, 3), symmetric.

        The wrench itself is a null vector. Where points carry the load facets of the surface are
        flat: zero.
        """
        return self._slopes().gauge_hessian(self._limits, wrenches, out)

    def normal_jacobian(self, wrenches: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Derivatives of `normal` with respect to the wrench, of shape (..., 3, 3).

        Components of the normal are rows. Accuracy: 1e-10 of the largest entry where the surface
        is smooth. NaN for the zero wrench and without load.
        """
        return self._slopes().normal_jacobian(self._limits, wrenches, out)

    def project_jacobian(
        self,
        wrenches: ArrayLike,
        *,
        length: float | None = None,
        out: NDArray[Any] | None = None,
    ) -> Any:
        """Derivatives of `project` with respect to the wrench, of shape (..., 3, 3).

        The unit matrix for wrenches of the set, also on its surface. Outside the normal is a null
        vector from the left and, with the torque's component times ``length²``, from the right.

        Parameters
        ----------
        wrenches
            Of shape (..., 3), in N and N m.
        length
            What makes a force of a torque, in m; None for the patch's radius.

        Examples
        --------
        A straight push of 9 N where 5 N are carried: to the side alone the force follows.

        >>> import tribos
        >>> tile = tribos.Friction(tribos.disk(0.1), mu=0.5).limit_surface(load=10.0)
        >>> print(tile.project_jacobian([9.0, 0.0, 0.0]).round(4) + 0.0)
        [[0.     0.     0.    ]
         [0.     0.5556 0.    ]
         [0.     0.     0.2381]]
        """
        return self._slopes().project_jacobian(self._limits, wrenches, length, out)

    def support_gradient(self, twists: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Derivatives of `support` with respect to the twist: ``-wrench``, of shape (..., 3)."""
        wrench = self.wrench(twists, out=out)
        return np.negative(wrench, out=wrench)

    def support_hessian(self, twists: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Second derivatives of `support` with respect to the twist, of shape (..., 3, 3), symmetric.

        Minus the Jacobian of friction. The twist itself is a null vector. At rest there is none: infinite on
        round patches, 0 on straight edges and points, as `Friction.jacobian` has it.
        """
        return self._slopes().support_hessian(self._limits, twists, out)

    def __repr__(self) -> str:
        load = self.load if isinstance(self.load, float) else f"<array {np.shape(self.load)}>"
        end = ".ellipsoid()" if self.is_ellipsoid else ""
        return f"tribos.LimitSurface({self.patch!r}, mu={self.mu!r}, load={load}){end}"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, LimitSurface):
            return NotImplemented
        mine, its = ((s.patch, s.mu, s.is_ellipsoid) for s in (self, other))
        return mine == its and np.array_equal(self.load, other.load)

    def __hash__(self) -> int:
        return hash((self.patch, self.mu, self.is_ellipsoid, np.asarray(self.load).tobytes()))

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self.patch, self.mu, self.load, self.is_ellipsoid)


def _made(patch: Patch, mu: float, load: Any, is_ellipsoid: bool) -> LimitSurface:
    surface = LimitSurface(patch, mu, load)
    return surface.ellipsoid() if is_ellipsoid else surface
