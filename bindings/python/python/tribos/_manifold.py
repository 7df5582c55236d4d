"""A few contacts solved together: a ball between fingers, a stack."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, positive
from tribos._contact import ContactLaw, unit, vector

Vector = Sequence[float] | NDArray[np.float64]
_ZERO = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class SolverReport:
    """Result of a step of a `Manifold`.

    Attributes
    ----------
    sweeps : int
        Number of sweeps over the contacts.
    residual : float
        Relative change of the impulses in the last sweep.
    converged : bool
        Whether the residual is within the tolerance.
    """

    sweeps: int
    residual: float
    converged: bool


@dataclass(frozen=True)
class ContactForce:
    """Force and torque of a contact on its second body, impacts included: impulse over dt.

    Attributes
    ----------
    normal : float
        Force along the normal, in N; negative where cohesion pulls.
    sliding : tuple of float
        Friction force across the normal, in N.
    rolling : tuple of float
        Rolling torque, in N m.
    torsion : float
        Torque about the normal, in N m.
    """

    normal: float
    sliding: tuple[float, float, float]
    rolling: tuple[float, float, float]
    torsion: float


class Manifold:
    """Up to 64 spheres and plates with up to 256 contacts of one law, solved together.

    Bodies and contacts are numbered from 0 in the order in which they are added. A step takes the
    bodies' velocities through gravity, forces, impacts and contacts, by the non-linear Gauss-Seidel
    method (Jean 1999); the caller moves the bodies and says where the contacts are then.

    Parameters
    ----------
    law
        Normal law and friction of all contacts.
    gravity
        Acceleration of spheres of finite mass, in m/s². Plates follow their force alone.

    Notes
    -----
    A copy (`copy`) keeps the impulses of the last step, from which the next one starts; a pickled
    manifold starts from zero, which changes results within the tolerance.

    Examples
    --------
    A ball of 1 kg is held by two fingers, each of which presses with 40 N:

    >>> import tribos
    >>> grip = tribos.Manifold(tribos.ContactLaw(mu=0.3, mu_torsion=0.02), gravity=(0, 0, -9.81))
    >>> ball = grip.add_sphere(mass=1.0, radius=0.05)
    >>> contacts = []
    >>> for inwards in (1.0, -1.0):
    ...     finger = grip.add_plate(mass=0.1)
    ...     grip.set_force(finger, (40.0 * inwards, 0.0, 0.0))
    ...     contacts.append(grip.add_contact(ball, finger, normal=(-inwards, 0.0, 0.0)))
    >>> report = grip.solve(1e-3)
    >>> report.converged, round(grip.force(contacts[0]).normal, 6)
    (True, 40.0)
    >>> bool(abs(grip.velocities[ball]).max() < 1e-9)                     # it does not fall
    True
    """

    __slots__ = ("_bodies", "_contacts", "_gravity", "_handle", "_loads", "law")

    law: ContactLaw
    _handle: _native.Manifold
    # Mass, inertia and radius of spheres; mass of plates.
    _bodies: list[tuple[float, float, float] | tuple[float]]
    # First and second body, normal, gap.
    _contacts: list[tuple[int, int, list[float], float]]
    _gravity: list[float]
    _loads: dict[int, tuple[list[float], list[float]]]

    def __init__(self, law: ContactLaw, *, gravity: Vector = _ZERO) -> None:
        if not isinstance(law, ContactLaw):
            raise ValueError(f"the law must be a tribos.ContactLaw, not {law!r}")
        self.law = law
        self._handle = _native.Manifold(law._handle)
        self._bodies, self._contacts, self._loads = [], [], {}
        self.gravity = gravity

    @property
    def gravity(self) -> Any:
        """Acceleration of spheres of finite mass, in m/s²."""
        return np.array(self._gravity)

    @gravity.setter
    def gravity(self, gravity: Vector) -> None:
        self._gravity = vector("gravity", gravity)
        self._handle.set_gravity(self._gravity)

    def add_sphere(
        self,
        *,
        mass: float,
        radius: float,
        velocity: Vector = _ZERO,
        spin: Vector = _ZERO,
        inertia: float | None = None,
    ) -> int:
        """Add a sphere and return its number; ValueError when there is no room.

        Parameters
        ----------
        mass
            In kg, above 0; ``inf`` for what nothing moves.
        radius
            In m.
        velocity, spin
            In m/s and rad/s.
        inertia
            In kg m²; None for a solid sphere.
        """
        size = positive("radius", radius)
        weight = _mass("mass", mass)
        moment = 0.4 * weight * size * size if inertia is None else _mass("inertia", inertia)
        motion = vector("velocity", velocity), vector("spin", spin)
        body = self._handle.add_sphere((*motion, 1.0 / weight, 1.0 / moment))
        self._bodies.append((weight, moment, size))
        return body

    def add_plate(self, *, velocity: Vector = _ZERO, mass: float = np.inf) -> int:
        """Add a plate and return its number: a wall, a belt, or a piston of finite mass in kg."""
        weight = _mass("mass", mass)
        body = self._handle.add_plate(vector("velocity", velocity), 1.0 / weight)
        self._bodies.append((weight,))
        return body

    def add_contact(self, first: int, second: int, *, normal: ArrayLike, gap: float = 0.0) -> int:
        """Add a contact and return its number; ValueError when there is no room.

        Parameters
        ----------
        first
            A sphere.
        second
            A sphere or a plate.
        normal
            Direction from the first body to the second, of any length but 0.
        gap
            Distance of the surfaces in m, negative where they overlap.
        """
        place = self._place(first, second, normal, gap)
        contact = self._handle.add_contact(first, second, *place)
        self._contacts.append((first, second, place[0], place[1]))
        return contact

    def set_contact(self, contact: int, *, normal: ArrayLike, gap: float = 0.0) -> None:
        """Say where a contact is now; its impulses stay as the next initial guess."""
        first, second = self._contact(contact)[:2]
        place = self._place(first, second, normal, gap)
        self._handle.set_contact(contact, *place)
        self._contacts[contact] = (first, second, place[0], place[1])

    def clear_contacts(self) -> None:
        """Forget all contacts and their numbers; bodies stay."""
        self._handle.clear_contacts()
        self._contacts.clear()

    def set_force(self, body: int, force: Vector, torque: Vector = _ZERO) -> None:
        """Force in N and torque in N m on a body from outside, from the next step on."""
        load = vector("force", force), vector("torque", torque)
        self._handle.set_force(self._number(body), *load)
        self._loads[body] = load

    def set_motion(self, body: int, velocity: Vector, spin: Vector = _ZERO) -> None:
        """Set the velocity in m/s and the spin in rad/s of a body; plates do not spin."""
        motion = vector("velocity", velocity), vector("spin", spin)
        self._handle.set_motion(self._number(body), *motion)

    def solve(
        self, dt: float, *, sweeps: int = 200, tolerance: float = 1e-10, start: str = "last"
    ) -> SolverReport:
        """Take all velocities through one time step.

        Parameters
        ----------
        dt
            Its length, in s.
        sweeps
            Largest number of sweeps over the contacts.
        tolerance
            Relative change of the impulses in a sweep below which the sweeps end.
        start
            ``"last"`` starts from the impulses of the last step, ``"zero"`` from none.
        """
        most = int(sweeps)
        if not 0 < most < 2**32:
            raise ValueError(f"sweeps must be a whole number > 0, not {sweeps!r}")
        small = number("tolerance", tolerance)
        if small < 0.0:
            raise ValueError(f"tolerance must be >= 0, not {tolerance!r}")
        return SolverReport(*self._handle.solve(number("dt", dt), start, most, small))

    @property
    def velocities(self) -> Any:
        """Velocities of all bodies in m/s, of shape (bodies, 3)."""
        return self._motions(0)

    @property
    def spins(self) -> Any:
        """Angular velocities of all bodies in rad/s, of shape (bodies, 3)."""
        return self._motions(1)

    def force(self, contact: int) -> ContactForce:
        """The forces of a contact in the last step; ValueError before the first one."""
        self._contact(contact)
        force = self._handle.force(contact)
        if force is None:
            raise ValueError(f"contact {contact} was not solved yet")
        normal, sliding, rolling, torsion = force
        return ContactForce(normal, _triple(sliding), _triple(rolling), torsion)

    def copy(self) -> Manifold:
        """The same once more, with the impulses of the last step."""
        made = Manifold.__new__(Manifold)
        made.law = self.law
        made._handle = self._handle.copy()
        made._bodies, made._contacts = self._bodies.copy(), self._contacts.copy()
        made._gravity, made._loads = self._gravity, self._loads.copy()
        return made

    def __copy__(self) -> Manifold:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Manifold:
        return self.copy()

    def _motions(self, part: int) -> NDArray[np.float64]:
        count = len(self._bodies)
        rows = [self._handle.motion(body)[part] for body in range(count)]
        return np.array(rows).reshape(count, 3)

    def _number(self, body: int) -> int:
        if not 0 <= body < len(self._bodies):
            raise ValueError(f"there is no body {body}")
        return body

    def _contact(self, contact: int) -> tuple[int, int, list[float], float]:
        if not 0 <= contact < len(self._contacts):
            raise ValueError(f"there is no contact {contact}")
        return self._contacts[contact]

    def _place(
        self, first: int, second: int, normal: ArrayLike, gap: float
    ) -> tuple[list[float], float, tuple[float, float | None]]:
        """Unit normal, gap and radii of a contact."""
        ball, other = self._bodies[self._number(first)], self._bodies[self._number(second)]
        if len(ball) != 3:
            raise ValueError("the first body of a contact must be a sphere")
        direction = vector("normal", unit("normal", normal))
        radius = other[2] if len(other) == 3 else None
        return direction, number("gap", gap), (ball[2], radius)

    def __repr__(self) -> str:
        return (
            f"tribos.Manifold({self.law!r}, gravity={tuple(self._gravity)!r}): "
            f"{len(self._bodies)} bodies, {len(self._contacts)} contacts"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        motions = [self._handle.motion(body) for body in range(len(self._bodies))]
        return _restored, (
            self.law,
            self._gravity,
            self._bodies,
            motions,
            self._contacts,
            self._loads,
        )


def _restored(
    law: ContactLaw,
    gravity: list[float],
    bodies: list[Any],
    motions: list[Any],
    contacts: list[tuple[int, int, list[float], float]],
    loads: dict[int, tuple[list[float], list[float]]],
) -> Manifold:
    made = Manifold(law, gravity=gravity)
    for body, (velocity, spin) in zip(bodies, motions):
        if len(body) == 3:
            mass, inertia, radius = body
            made.add_sphere(mass=mass, radius=radius, velocity=velocity, spin=spin, inertia=inertia)
        else:
            made.add_plate(velocity=velocity, mass=body[0])
    for first, second, normal, gap in contacts:
        made.add_contact(first, second, normal=normal, gap=gap)
    for number_of_body, (force, torque) in loads.items():
        made.set_force(number_of_body, force, torque)
    return made


def _mass(name: str, value: float) -> float:
    """A number above 0, which may be infinite."""
    try:
        made = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be a number, not {value!r}") from None
    if not made > 0.0:
        raise ValueError(f"{name} must be > 0, not {value!r}")
    return made


def _triple(values: Sequence[float]) -> tuple[float, float, float]:
    x, y, z = values
    return x, y, z
