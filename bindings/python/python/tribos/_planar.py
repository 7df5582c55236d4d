"""Bodies that are pushed and turned on their patch, many at once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, positive, reals
from tribos._floor import Surface, stepped
from tribos._friction import Friction
from tribos._step import Step


class Rollout(NamedTuple):
    """The course of many bodies over many time steps: the state after each step."""

    twists: Any
    """Motions, in m/s and rad/s, of shape (..., steps, 3)."""
    poses: Any
    """Positions in m and angles in rad, of shape (..., steps, 3)."""
    at_rest: Any
    """Whether friction holds the body, of shape (..., steps)."""


class PlanarBody:
    """Bodies that lie flat on a patch under dry friction, stepped in time together.

    Each step is implicit: friction is the wrench nearest to the one that would stop the body,
    measured by kinetic energy. A body that friction holds rests exactly and does not creep, and
    without a push no step gains energy, however long it is.

    Parameters
    ----------
    friction
        Coulomb friction on any patch: round, polygon, bar, mesh, or points. The origin of the
        patch's coordinates is the foot of the centre of mass, to which twist and wrench refer.
    mass
        Mass in kg, above 0: a number, or an array that is broadcast with the leading axes of a
        call.
    inertia
        Moment of inertia in kg m² about the normal through the centre of mass, above 0.
    load
        Normal force in N, at least 0; None for ``mass * gravity``.
    gravity
        Acceleration that presses the body down, in m/s².
    mu_s
        Coefficient at rest, at least that of the friction: a body at rest stays until the push exceeds it, and then slides
        under the friction in the same step. None for the same coefficient. Such bodies are stepped one by one.

    Notes
    -----
    Accuracy: of second order in the time step while a body slides, of first order in the step in
    which it starts, stops or turns about. Results do not depend on the number of threads, and a
    batch gives the bits of its bodies one by one. NaN in twist or push gives NaN.

    Cost: a step takes 0.2 to 0.3 µs on a disk, where bodies of one mass, inertia and `dt` go side by
    side, and 2 to 4 µs on a box or four points, on one thread, and a call of its own 3 µs more;
    `rollout` makes one call of many steps.

    Only the product ``mu * load`` matters: an array of loads also varies the coefficient, on round
    patches at the same cost.

    Examples
    --------
    >>> import numpy as np, tribos
    >>> wood = tribos.Friction(tribos.box(0.4, 0.3), mu=0.5)
    >>> crate = tribos.PlanarBody(wood, mass=8.0, inertia=0.17)
    >>> pushes = np.array([[30.0, 0.0, 0.0], [60.0, 0.0, 0.0]])      # friction carries 39.24 N
    >>> step = crate.step(np.zeros((2, 3)), pushes, dt=0.01)
    >>> step.at_rest
    array([ True, False])
    >>> print(step.twists[1].round(5))                               # (60 - 39.24)/8 * 0.01 m/s
    [0.02595 0.      0.     ]
    >>> stuck = tribos.PlanarBody(wood, mass=8.0, inertia=0.17, mu_s=0.8)    # 62.78 N hold it at rest
    >>> stuck.step(np.zeros((2, 3)), pushes, dt=0.01).at_rest
    array([ True,  True])
    """

    __slots__ = ("_limit", "_surface", "friction", "inertia", "load", "mass", "mu_s")

    friction: Friction
    mass: Any
    inertia: Any
    load: Any
    mu_s: float
    _limit: Any
    _surface: _native.LimitSurface

    def __init__(
        self,
        friction: Friction,
        mass: ArrayLike,
        inertia: ArrayLike,
        *,
        load: ArrayLike | None = None,
        gravity: float = 9.81,
        mu_s: float | None = None,
    ) -> None:
        if not isinstance(friction, Friction):
            raise ValueError(f"friction must be a tribos.Friction, not {friction!r}")
        mu = friction.mu
        set_ = object.__setattr__
        set_(self, "friction", friction)
        set_(self, "mass", _positive("mass", mass))
        set_(self, "inertia", _positive("inertia", inertia))
        weight = np.multiply(self.mass, positive("gravity", gravity)) if load is None else load
        set_(self, "load", _load(weight))
        static = mu if mu_s is None else number("mu_s", mu_s)
        if static < mu:
            raise ValueError(
                f"mu_s must be at least the coefficient of sliding, {mu!r}, not {mu_s!r}"
            )
        set_(self, "mu_s", static)
        set_(self, "_limit", mu * self.load)
        set_(self, "_surface", friction.patch._limits())
        # The kernel refuses wrong bodies here rather than in the first step.
        nothing = np.zeros(3)
        self.step(nothing, nothing, 1.0)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a tribos.PlanarBody is immutable: {name!r} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a tribos.PlanarBody is immutable: {name!r} cannot be deleted")

    def step(
        self,
        twists: ArrayLike,
        pushes: ArrayLike,
        dt: ArrayLike,
        *,
        angle: ArrayLike = 0.0,
        load: ArrayLike | None = None,
        surface: Iterable[Surface] | None = None,
        out: NDArray[Any] | None = None,
    ) -> Step:
        """The motions after one time step under constant pushes.

        Parameters
        ----------
        twists
            Velocities in m/s and spins in rad/s, of shape (..., 3).
        pushes
            Forces in N and torques in N m of all but friction, of shape (..., 3).
        dt
            Length of the step in s, above 0.
        angle
            Angle in rad by which the patch is turned against the axes of twists and pushes. It does
            not matter to a round patch.
        load
            Normal force in N for this step; None for that of the bodies.
        surface
            Parts of the floor that move, as `Friction.wrench` takes them, along the axes of the patch; for bodies of one
            mass, inertia and load that do not turn against it and have no `mu_s` of their own. A body at rest then has
            the motion of the surface that holds it.
        out
            An array of floats for the twists, which may be the given ones.

        Returns
        -------
        Step
            Twists, friction, and whether each body rests. All arguments are broadcast together.

        Examples
        --------
        >>> import numpy as np, tribos
        >>> puck = tribos.PlanarBody(tribos.Friction(tribos.disk(0.04), mu=0.3), 0.17, 1.36e-4)
        >>> twists = np.array([[1.0, 0.0, 20.0], [0.5, 0.5, -3.0]])
        >>> for _ in range(100):
        ...     step = puck.step(twists, [0.0, 0.0, 0.0], dt=0.005, out=twists)
        >>> bool(step.at_rest.all()), float(abs(twists).max())
        (True, 0.0)

        On two belts that run against each other it is turned, and stays where it is:

        >>> belts = [([[0, 0], [1, 0]], [0.5, 0, 0]), ([[1, 0], [0, 0]], [-0.5, 0, 0])]
        >>> twist = np.zeros(3)
        >>> for _ in range(1000):
        ...     twist = puck.step(twist, [0.0, 0.0, 0.0], dt=0.005, surface=belts).twists
        >>> steady = puck.friction.steady_motion(0.17 * 9.81, belts)
        >>> bool(abs(twist - steady.twist).max() < 1e-9)
        True
        """
        if surface is not None:
            return self._on_surfaces(surface, (twists, pushes), (dt, angle, load), out)
        bodies = self._given(load, dt)
        patch = self.friction.patch._handle
        after, friction, at_rest = _native.planar_step(
            patch, self._surface, bodies, twists, pushes, angle, out
        )
        return Step(after, friction, at_rest if at_rest.ndim else bool(at_rest))

    def rollout(
        self,
        twists: ArrayLike,
        pushes: ArrayLike,
        dt: ArrayLike,
        *,
        poses: ArrayLike = (0.0, 0.0, 0.0),
        load: ArrayLike | None = None,
    ) -> Rollout:
        """Many time steps of each body, without a return to Python in between.

        Twists and pushes refer to axes that stay; the patch turns with the body. Position and angle
        advance by the mean of the twists before and after a step, which is exact for constant
        friction and of second order in the time step otherwise: a plate of 0.3 m that spins to rest
        in 1000 steps is at most 3e-7 m from its exact place. A patch that is not round is taken at
        the angle that the spin at the start of the step gives for half time:
        ``step(..., angle=angle + dt / 2 * spin)`` in a loop gives the same bits.

        Parameters
        ----------
        twists
            Motions at the start, of shape (..., 3).
        pushes
            A push a step, of shape (..., steps, 3), in N and N m; for the same push in all steps
            ``numpy.broadcast_to(push, (steps, 3))``.
        dt
            Length of a step in s, above 0; one for all steps of a body.
        poses
            Positions in m and angles in rad at the start, of shape (..., 3).
        load
            Normal force in N; None for that of the bodies.

        Returns
        -------
        Rollout
            Twists, poses and rests after each step. The leading axes of all arguments, those before
            the steps, are broadcast together.

        Examples
        --------
        >>> import numpy as np, tribos
        >>> puck = tribos.PlanarBody(tribos.Friction(tribos.disk(0.08), mu=0.3), 1.0, 0.0032)
        >>> course = puck.rollout([1.0, 0.0, 5.0], np.zeros((400, 3)), dt=0.001)
        >>> course.twists.shape, int(course.at_rest.argmax())         # rests after 0.369 s
        ((400, 3), 369)
        >>> print(course.poses[-1].round(3))                          # m, m, rad, as tribos.slide
        [0.177 0.    1.155]
        """
        bodies = self._given(load, dt)
        patch = self.friction.patch._handle
        return Rollout(*_native.planar_rollout(patch, self._surface, bodies, twists, pushes, poses))

    def _on_surfaces(
        self,
        surface: Iterable[Surface],
        motion: tuple[ArrayLike, ArrayLike],
        given: tuple[ArrayLike, ArrayLike, ArrayLike | None],
        out: NDArray[Any] | None,
    ) -> Step:
        """A step on a floor of several surfaces."""
        dt, angle, load = given
        if np.any(np.asarray(angle) != 0.0) or self.mu_s != self.friction.mu:
            raise ValueError(
                "surface is along the axes of the patch: angle must be 0, and mu_s that of sliding"
            )
        names = ("mass", "inertia", "dt", "load")
        all_ = (self.mass, self.inertia, dt, self.load if load is None else load)
        for name, value in zip(names, all_, strict=True):
            if np.ndim(value):
                raise ValueError(f"with surface, {name} must be one number")
        mass, inertia, seconds, newtons = (
            number(name, value) for name, value in zip(names, all_, strict=True)
        )
        floor = self.friction._floor(newtons, surface)
        return stepped(floor, motion, (mass, inertia, seconds), out)

    def energy(self, twists: ArrayLike) -> Any:
        """Kinetic energy in J at twists of shape (..., 3)."""
        rows = np.asarray(twists, dtype=np.float64)
        slide = rows[..., 0] ** 2 + rows[..., 1] ** 2
        return 0.5 * (self.mass * slide + self.inertia * rows[..., 2] ** 2)

    def _given(self, load: ArrayLike | None, dt: ArrayLike) -> dict[str, Any]:
        """The bodies as the compiled half takes them."""
        limit = self._limit if load is None else self.friction.mu * _load(load)
        return {
            "force_limit": limit,
            "mass": self.mass,
            "inertia": self.inertia,
            "dt": dt,
            "strength": self.mu_s / self.friction.mu if self.friction.mu > 0.0 else 1.0,
        }

    def __repr__(self) -> str:
        given = (
            f"{name}={_short(value)}"
            for name, value in (("mass", self.mass), ("inertia", self.inertia), ("load", self.load))
        )
        static = "" if self.mu_s == self.friction.mu else f", mu_s={self.mu_s!r}"
        return f"tribos.PlanarBody({self.friction!r}, {', '.join(given)}{static})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self.friction, self.mass, self.inertia, self.load, self.mu_s)


def _made(friction: Friction, mass: Any, inertia: Any, load: Any, mu_s: float) -> PlanarBody:
    return PlanarBody(friction, mass, inertia, load=load, mu_s=mu_s)


def _kept(name: str, value: ArrayLike) -> Any:
    """A number, or an array of one's own."""
    array = reals(name, value)
    array.flags.writeable = False
    return float(array) if array.ndim == 0 else array


def _positive(name: str, value: ArrayLike) -> Any:
    kept = _kept(name, value)
    if not np.all((kept > 0.0) & (kept < np.inf)):
        raise ValueError(f"{name} must be > 0 and finite")
    return kept


def _load(value: ArrayLike) -> Any:
    kept = _kept("load", value)
    if not np.all((kept >= 0.0) & (kept < np.inf)):
        raise ValueError("load must be >= 0 and finite")
    return kept


def _short(value: Any) -> str:
    return repr(value) if isinstance(value, float) else f"<array {np.shape(value)}>"
