"""Laws of friction with a memory: bristles and contact ages."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number


class LuGre:
    """The LuGre model: friction by bristles that bend, with break-away and the Stribeck effect.

    With the velocity v and the mean deflection z of the bristles, the state::

        dz/dt = v - stiffness * abs(v) * z / g(v)
        force = stiffness * z + bristle_damping * dz/dt + viscous_damping * v
        g(v)  = coulomb_force + (static_force - coulomb_force) * exp(-(v/stribeck_speed)**2)

    Immutable and picklable; the caller keeps the state of each contact in an array.

    Parameters
    ----------
    coulomb_force, static_force
        Force of fast sliding, and the most that the bristles carry, in N, with
        ``0 < coulomb_force <= static_force``.
    stribeck_speed
        In m/s, above 0.
    stiffness
        Stiffness of the bristles in N/m, above 0.
    bristle_damping, viscous_damping
        In N s/m, at least 0.

    Notes
    -----
    The force has the sign of the velocity and acts on the body with the opposite one. Under a
    constant force below ``static_force`` a body comes to rest and stays; under one that swings
    around it, it creeps, which is a property of the model. *Source*: Canudas de Wit, Olsson, Åström
    and Lischinsky 1995.

    Examples
    --------
    A block of 1 kg that bristles hold on an incline: it slips by some micrometres until they carry
    its weight, and then rests.

    >>> import math, tribos
    >>> joint = tribos.LuGre(
    ...     coulomb_force=4.0, static_force=6.0, stribeck_speed=0.1,     # N, N, m/s
    ...     stiffness=1e5, bristle_damping=700.0, viscous_damping=0.4,   # N/m, N s/m, N s/m
    ... )
    >>> pull, dt = 9.81 * math.sin(math.radians(20.0)), 1e-4             # N on 1 kg; s
    >>> place, velocity, deflection = 0.0, 0.0, 0.0
    >>> for step in range(20_000):
    ...     deflection, force = joint.step(deflection, velocity, dt)
    ...     velocity += dt * (pull - force)
    ...     place += dt * velocity
    >>> round(1e6 * place, 2), round(1e6 * pull / 1e5, 2), abs(velocity) < 1e-12     # µm
    (49.58, 33.55, True)
    """

    __slots__ = ("_handle", "_parameters")

    _handle: _native.LuGre
    _parameters: tuple[float, ...]

    def __init__(
        self,
        *,
        coulomb_force: float,
        static_force: float,
        stribeck_speed: float,
        stiffness: float,
        bristle_damping: float = 0.0,
        viscous_damping: float = 0.0,
    ) -> None:
        self._parameters = (
            number("coulomb_force", coulomb_force),
            number("static_force", static_force),
            number("stribeck_speed", stribeck_speed),
            number("stiffness", stiffness),
            number("bristle_damping", bristle_damping),
            number("viscous_damping", viscous_damping),
        )
        self._handle = _native.LuGre(list(self._parameters))

    @property
    def parameters(self) -> dict[str, float]:
        """Its parameters, as the class takes them."""
        return dict(zip(_LUGRE, self._parameters, strict=True))

    @property
    def largest_deflection(self) -> float:
        """Largest deflection of bristles that start within it, ``static_force/stiffness``, in m."""
        return self._handle.largest_deflection()

    @property
    def passive_up_to(self) -> float:
        """Speed in m/s up to which friction dissipates at any deflection; infinite if always."""
        return self._handle.passive_up_to()

    def step(self, deflection: ArrayLike, velocity: ArrayLike, dt: ArrayLike) -> tuple[Any, Any]:
        """The deflections after a time at constant velocity, and the mean forces over that time.

        Exact for every step: ``force * dt`` is the impulse. With the velocity at the middle of a
        step a changing one is followed to second order.

        Parameters
        ----------
        deflection
            Deflections in m; 0 for bristles that are relaxed.
        velocity
            Velocities in m/s, of either sign.
        dt
            Length of the step in s, at least 0.

        Returns
        -------
        deflection, force
            In m and N, of the shape that the arguments are broadcast to.
        """
        rows = self._handle.step(deflection, velocity, dt)
        if rows.ndim == 1:
            after, force = rows.tolist()
            return after, force
        columns = np.ascontiguousarray(np.moveaxis(rows, -1, 0))
        return columns[0], columns[1]

    def force(
        self, deflection: ArrayLike, velocity: ArrayLike, *, out: NDArray[Any] | None = None
    ) -> Any:
        """The force at this moment, in N."""
        return self._handle.force(deflection, velocity, out)

    def rate(
        self, deflection: ArrayLike, velocity: ArrayLike, *, out: NDArray[Any] | None = None
    ) -> Any:
        """The rate of the deflection at this moment, in m/s."""
        return self._handle.rate(deflection, velocity, out)

    def steady_force(self, velocity: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The force of steady sliding, in N: ``sign(v) * g(v) + viscous_damping * v``."""
        return self._handle.steady_force(velocity, out)

    def __repr__(self) -> str:
        given = ", ".join(f"{name}={value!r}" for name, value in self.parameters.items())
        return f"tribos.LuGre({given})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _lugre, self._parameters

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LuGre) and self._parameters == other._parameters

    def __hash__(self) -> int:
        return hash(("LuGre", self._parameters))


class RateState:
    """Rate-and-state friction: it rises with the speed at once and with the age of the contact.

    With the age θ, the state::

        friction = a * asinh(V/q) + viscous * V,   q = 2 * V0 * exp(-(mu + b * log(V0 * θ/D))/a)

    which is ``mu + a * log(V/V0) + b * log(V0 * θ/D)`` for V above q, and vanishes at rest.
    Immutable and picklable; the caller keeps the age of each contact in an array.

    Parameters
    ----------
    mu
        Coefficient of steady sliding at the reference speed, at least 0.
    a, b
        Effects of the speed, above 0, and of the age, at least 0, per e-fold.
    reference_speed
        V0 in m/s, above 0.
    slip_distance
        D in m, above 0: the memory length.
    viscous
        In s/m, at least 0.
    evolution
        ``"ageing"``: ``dθ/dt = 1 - Vθ/D``, contacts age at rest (Dieterich 1979). ``"slip"``:
        ``dθ/dt = -(Vθ/D) log(Vθ/D)``, ages change only by sliding (Ruina 1983).

    Notes
    -----
    Signs of speeds are ignored; ages below 0 give NaN.

    Examples
    --------
    >>> import tribos
    >>> rock = tribos.RateState(mu=0.6, a=0.010, b=0.015, reference_speed=1e-6, slip_distance=1e-5)
    >>> age = rock.steady_age(1e-6)                        # s
    >>> later = rock.step(age, 1e-5, dt=100.0)             # ten times as fast for 100 s
    >>> [round(float(mu), 4) for mu in (
    ...     rock.friction(1e-6, age), rock.friction(1e-5, age), rock.friction(1e-5, later))]
    [0.6, 0.623, 0.5885]
    """

    __slots__ = ("_handle", "_parameters", "evolution")

    evolution: str
    _handle: _native.RateState
    _parameters: tuple[float, ...]

    def __init__(
        self,
        *,
        mu: float,
        a: float,
        b: float,
        reference_speed: float,
        slip_distance: float,
        viscous: float = 0.0,
        evolution: str = "ageing",
    ) -> None:
        self._parameters = (
            number("mu", mu),
            number("a", a),
            number("b", b),
            number("reference_speed", reference_speed),
            number("slip_distance", slip_distance),
            number("viscous", viscous),
        )
        if not isinstance(evolution, str):
            raise ValueError(f"evolution must be 'ageing' or 'slip', not {evolution!r}")
        self.evolution = evolution
        self._handle = _native.RateState(list(self._parameters), evolution)

    @property
    def parameters(self) -> dict[str, float]:
        """Its parameters, as the class takes them, without the evolution."""
        return dict(zip(_RATE_STATE, self._parameters, strict=True))

    def friction(self, speed: ArrayLike, age: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Friction per load at speeds in m/s and ages in s; 0 at rest."""
        return self._handle.friction(speed, age, out)

    def slope(self, speed: ArrayLike, age: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Derivative of `friction` with respect to the speed at constant age, in s/m."""
        return self._handle.slope(speed, age, out)

    def step(
        self,
        age: ArrayLike,
        speed: ArrayLike,
        dt: ArrayLike,
        *,
        out: NDArray[Any] | None = None,
    ) -> Any:
        """The ages in s after a time ``dt`` in s, at least 0, at constant speed; exact."""
        return self._handle.step(age, speed, dt, out)

    def steady_age(self, speed: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """The age that steady sliding keeps, ``slip_distance/speed``, in s; infinite at rest."""
        return self._handle.steady_age(speed, out)

    def steady_friction(self, speed: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Friction per load of steady sliding at speeds in m/s."""
        return self._handle.steady_friction(speed, out)

    @property
    def slowest_speed(self) -> float | None:
        """Speed of least steady friction in m/s, about ``(b - a)/viscous``, or None."""
        return self._handle.minimum()

    def critical_stiffness(self, load: float, speed: float | None = None) -> float:
        """Stiffness in N/m below which a spring pulls a load by stick and slip, not steadily.

        Parameters
        ----------
        load
            Normal force, in N.
        speed
            Speed of the pull in m/s; None for slow ones, ``load * (b - a)/slip_distance`` or 0. At
            speeds at which friction rises it is negative: every spring pulls steadily.
        """
        speed = None if speed is None else number("speed", speed)
        return self._handle.critical_stiffness(number("load", load), speed)

    def __repr__(self) -> str:
        given = ", ".join(f"{name}={value!r}" for name, value in self.parameters.items())
        return f"tribos.RateState({given}, evolution={self.evolution!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _rate_state, (*self._parameters, self.evolution)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, RateState):
            return NotImplemented
        mine, theirs = (self._parameters, self.evolution), (other._parameters, other.evolution)
        return mine == theirs

    def __hash__(self) -> int:
        return hash(("RateState", self._parameters, self.evolution))


_LUGRE = (
    "coulomb_force",
    "static_force",
    "stribeck_speed",
    "stiffness",
    "bristle_damping",
    "viscous_damping",
)
_RATE_STATE = ("mu", "a", "b", "reference_speed", "slip_distance", "viscous")


def _lugre(*values: float) -> LuGre:
    return LuGre(**dict(zip(_LUGRE, values, strict=True)))


def _rate_state(*values: Any) -> RateState:
    *numbers, evolution = values
    return RateState(**dict(zip(_RATE_STATE, numbers, strict=True)), evolution=evolution)
