"""Contacts of spheres and plates that may open, slide, roll and spin: impulses under thresholds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, reals
from tribos._patches import Patch

Array = NDArray[np.float64]
# Numbers of a body in a row of the compiled half: velocity, spin, 1/mass, 1/inertia, radius.
_FIELDS = 9


class Spheres:
    """One sphere or a batch of them: motions, masses and radii.

    Arguments are broadcast over their leading axes: one number serves for all. Immutable and
    picklable.

    Parameters
    ----------
    velocity
        Velocities of the centres, in m/s, of shape (..., 3).
    spin
        Angular velocities, in rad/s, of shape (..., 3).
    mass
        Masses in kg, above 0; ``inf`` for what nothing moves.
    radius
        Radii in m, above 0.
    inertia
        Moments of inertia about any axis through the centre, in kg m², above 0. None for solid
        spheres, ``2/5 * mass * radius**2``.

    Examples
    --------
    >>> import tribos
    >>> ball = tribos.Spheres([1.0, 0.0, 0.0], mass=0.17, radius=0.0286)
    >>> print(ball.velocity, round(float(ball.energy), 6))                 # m/s; J
    [1. 0. 0.] 0.085
    """

    __slots__ = ("inertia", "mass", "radius", "spin", "velocity")

    velocity: Array
    spin: Array
    mass: Array
    radius: Array
    inertia: Array

    def __init__(
        self,
        velocity: ArrayLike = (0.0, 0.0, 0.0),
        spin: ArrayLike = (0.0, 0.0, 0.0),
        *,
        mass: ArrayLike,
        radius: ArrayLike,
        inertia: ArrayLike | None = None,
    ) -> None:
        masses, radii = _positive("mass", mass), _positive("radius", radius)
        if not np.isfinite(radii).all():
            raise ValueError("radius must be finite")
        moments = 0.4 * masses * radii * radii if inertia is None else inertia
        object.__setattr__(self, "velocity", _vectors("velocity", velocity))
        object.__setattr__(self, "spin", _vectors("spin", spin))
        object.__setattr__(self, "mass", masses)
        object.__setattr__(self, "radius", radii)
        object.__setattr__(self, "inertia", _positive("inertia", moments))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"tribos.Spheres are immutable; make new ones to change {name}")

    @property
    def shape(self) -> tuple[int, ...]:
        """The leading axes that all arguments are broadcast to."""
        return np.broadcast_shapes(
            self.velocity.shape[:-1],
            self.spin.shape[:-1],
            self.mass.shape,
            self.radius.shape,
            self.inertia.shape,
        )

    @property
    def momentum(self) -> Any:
        """Momenta ``mass * velocity``, in kg m/s."""
        return self.mass[..., np.newaxis] * self.velocity

    @property
    def angular_momentum(self) -> Any:
        """Angular momenta about the own centres, ``inertia * spin``, in kg m²/s."""
        return self.inertia[..., np.newaxis] * self.spin

    @property
    def energy(self) -> Any:
        """Kinetic energies of motion and rotation, in J."""
        straight = 0.5 * self.mass * np.sum(self.velocity * self.velocity, axis=-1)
        return straight + 0.5 * self.inertia * np.sum(self.spin * self.spin, axis=-1)

    def moving(self, velocity: ArrayLike, spin: ArrayLike) -> Spheres:
        """The same spheres with another motion."""
        return Spheres(velocity, spin, mass=self.mass, radius=self.radius, inertia=self.inertia)

    def _after(self, velocity: Array, spin: Array) -> Spheres:
        """The same spheres with the motions of an answer, which need no checks."""
        made = Spheres.__new__(Spheres)
        velocity.flags.writeable = spin.flags.writeable = False
        object.__setattr__(made, "velocity", velocity)
        object.__setattr__(made, "spin", spin)
        for name in ("mass", "radius", "inertia"):
            object.__setattr__(made, name, getattr(self, name))
        return made

    def __repr__(self) -> str:
        shape = f", shape={self.shape}" if self.shape else ""
        return (
            f"tribos.Spheres(velocity={_short(self.velocity)}, spin={_short(self.spin)}, "
            f"mass={_short(self.mass)}, radius={_short(self.radius)}, "
            f"inertia={_short(self.inertia)}{shape})"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return _spheres, (self.velocity, self.spin, self.mass, self.radius, self.inertia)


class Plates:
    """One plate or a batch of them: walls, or pistons that contacts move along the normal alone.

    Parameters
    ----------
    velocity
        Velocities in m/s, of shape (..., 3). The part across the normal is prescribed: a belt.
    mass
        Masses in kg, above 0; ``inf`` for walls.

    Examples
    --------
    >>> import tribos
    >>> tribos.Plates(mass=2.0)
    tribos.Plates(velocity=[0.0, 0.0, 0.0], mass=2.0)
    """

    __slots__ = ("mass", "velocity")

    velocity: Array
    mass: Array

    def __init__(self, velocity: ArrayLike = (0.0, 0.0, 0.0), *, mass: ArrayLike = np.inf) -> None:
        object.__setattr__(self, "velocity", _vectors("velocity", velocity))
        object.__setattr__(self, "mass", _positive("mass", mass))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"tribos.Plates are immutable; make new ones to change {name}")

    @property
    def shape(self) -> tuple[int, ...]:
        """The leading axes that all arguments are broadcast to."""
        return np.broadcast_shapes(self.velocity.shape[:-1], self.mass.shape)

    def __repr__(self) -> str:
        shape = f", shape={self.shape}" if self.shape else ""
        return f"tribos.Plates(velocity={_short(self.velocity)}, mass={_short(self.mass)}{shape})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _plates, (self.velocity, self.mass)


@dataclass(frozen=True, eq=False)
class Collision:
    """What a contact did in one time step. Impulses act on the second body, the first takes the opposite.

    Attributes
    ----------
    first : Spheres
        The first bodies after the step.
    second : Spheres or Plates
        The second bodies after the step.
    normal : numpy.ndarray
        Impulses along the normal, in N s; negative where cohesion pulls.
    sliding : numpy.ndarray
        Friction impulses across the normal, in N s, of shape (..., 3).
    rolling : numpy.ndarray
        Impulses of the rolling torque, in N m s, of shape (..., 3).
    torsion : numpy.ndarray
        Impulses of the torque about the normal, in N m s.
    """

    first: Spheres
    second: Spheres | Plates
    normal: Any
    sliding: Any
    rolling: Any
    torsion: Any


class ContactLaw:
    """What a contact resists: penetration, separation, sliding, rolling and spinning.

    Friction is proportional to ``P = normal force + cohesion``: sliding up to ``mu * P``, rolling up
    to ``mu_rolling * P * r_eff``, torsion up to ``mu_torsion * P * r_eff``, with
    ``r_eff = 1/(1/R1 + 1/R2)``, or the sphere's radius at a plate. With a patch sliding and torsion
    share one exact limit surface: a contact that slides resists spinning less. Immutable and
    picklable.

    Parameters
    ----------
    mu
        Coefficient of sliding friction, at least 0.
    mu_rolling, mu_torsion
        Coefficients of rolling and torsion, ratios of lengths, at least 0.
    patch
        A round patch of any pressure, whose radius is the ratio of contact radius and r_eff. It takes
        the place of mu_torsion.
    restitution
        Speed after an impact over speed before, 0 … 1.
    cohesion
        Force in N that holds a contact together, at least 0.
    cohesion_range
        Gap in m up to which it does, at least 0.
    attraction
        ``"pull"``: cohesion closes gaps within its range; ``"resistance"``: it resists opening alone.

    Notes
    -----
    The impulses are exact for one time step of implicit stepping (Moreau and Jean): in closed form, or
    to rounding where sliding and rolling are coupled, for spheres of different size. Thresholds
    follow the non-smooth contact dynamics of cohesive powders.

    Examples
    --------
    A billiard ball that is struck through its centre and slides over the cloth ends rolling at 5/7 of
    its speed, however large friction is:

    >>> import tribos
    >>> cloth = tribos.ContactLaw(mu=0.2)
    >>> ball = tribos.Spheres([1.0, 0.0, 0.0], mass=0.17, radius=0.0286)
    >>> dt = 1e-3                                                            # s
    >>> for _ in range(400):
    ...     falling = ball.moving(ball.velocity + [0.0, 0.0, -9.81 * dt], ball.spin)
    ...     ball = cloth.collide(falling, tribos.Plates(), normal=[0, 0, -1], dt=dt).first
    >>> round(float(ball.velocity[0]) * 7 / 5, 12)
    1.0

    Two balls of equal mass exchange their velocities if nothing is lost:

    >>> elastic = tribos.ContactLaw(restitution=1.0)
    >>> target = tribos.Spheres(mass=0.17, radius=0.0286)
    >>> cue = tribos.Spheres([2.0, 0.0, 0.0], mass=0.17, radius=0.0286)
    >>> hit = elastic.collide(cue, target, normal=[1.0, 0.0, 0.0])
    >>> print(hit.first.velocity, hit.second.velocity)
    [0. 0. 0.] [2. 0. 0.]
    """

    __slots__ = (
        "_handle",
        "attraction",
        "cohesion",
        "cohesion_range",
        "mu",
        "mu_rolling",
        "patch",
        "restitution",
    )

    mu: float
    mu_rolling: float
    patch: Patch | None
    restitution: float
    cohesion: float
    cohesion_range: float
    attraction: str
    _handle: _native.ContactLaw

    def __init__(
        self,
        mu: float = 0.0,
        *,
        mu_rolling: float = 0.0,
        mu_torsion: float = 0.0,
        patch: Patch | None = None,
        restitution: float = 0.0,
        cohesion: float = 0.0,
        cohesion_range: float = 0.0,
        attraction: str = "pull",
    ) -> None:
        if patch is not None and not isinstance(patch, Patch):
            raise ValueError(f"patch must be made by tribos.disk and the like, not {patch!r}")
        given = number("mu_torsion", mu_torsion)
        if patch is not None and given != 0.0:
            raise ValueError("give either mu_torsion or patch, which has a torsion of its own")
        self.mu = number("mu", mu)
        self.mu_rolling = number("mu_rolling", mu_rolling)
        self.patch = patch
        self.restitution = number("restitution", restitution)
        self.cohesion = number("cohesion", cohesion)
        self.cohesion_range = number("cohesion_range", cohesion_range)
        self.attraction = attraction
        self._handle = _native.ContactLaw(
            [self.mu, self.mu_rolling, given],
            None if patch is None else patch._handle,
            self.restitution,
            [self.cohesion, self.cohesion_range],
            attraction,
        )

    @property
    def mu_torsion(self) -> float:
        """Coefficient of torsion without sliding: largest torque over ``P * r_eff``."""
        return self._handle.mu_torsion()

    def collide(
        self,
        first: Spheres,
        second: Spheres | Plates,
        *,
        normal: ArrayLike,
        gap: ArrayLike = 0.0,
        dt: float | None = None,
    ) -> Collision:
        """Solve contacts that do not depend on each other for one time step.

        Parameters
        ----------
        first
            Spheres, with the velocities that they would have at the end of the step without the contact.
        second
            Spheres or plates.
        normal
            Directions from the first body to the second, of shape (..., 3), of any length but 0.
        gap
            Distances of the surfaces in m, negative where they overlap. A gap closes by at most its
            own width in the step; an overlap is not pushed out.
        dt
            Length of the step in s. It may be left out where there is neither a gap nor cohesion.

        Returns
        -------
        Collision
            The bodies after the step, and the impulses.
        """
        return collide(self, first, second, normal, gap, dt)

    def __repr__(self) -> str:
        given = [f"mu={self.mu!r}"]
        if self.mu_rolling:
            given.append(f"mu_rolling={self.mu_rolling!r}")
        if self.patch is not None:
            given.append(f"patch={self.patch!r}")
        elif self.mu_torsion:
            given.append(f"mu_torsion={self.mu_torsion!r}")
        for name in ("restitution", "cohesion", "cohesion_range"):
            if getattr(self, name):
                given.append(f"{name}={getattr(self, name)!r}")
        if self.attraction != "pull":
            given.append(f"attraction={self.attraction!r}")
        return f"tribos.ContactLaw({', '.join(given)})"

    def _key(self) -> tuple[Any, ...]:
        torsion = 0.0 if self.patch is not None else self.mu_torsion
        return (
            self.mu,
            self.mu_rolling,
            torsion,
            self.patch,
            self.restitution,
            self.cohesion,
            self.cohesion_range,
            self.attraction,
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return _law, self._key()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ContactLaw) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())


def collide(
    law: ContactLaw,
    first: Spheres,
    second: Spheres | Plates,
    normal: ArrayLike,
    gap: ArrayLike,
    dt: float | None,
) -> Collision:
    """See `ContactLaw.collide`."""
    if not isinstance(first, Spheres) or not isinstance(second, (Spheres, Plates)):
        raise ValueError("contacts are between tribos.Spheres and tribos.Spheres or tribos.Plates")
    normals, gaps = unit("normal", normal), _finite("gap", gap)
    if dt is None:
        if law.cohesion > 0.0 or np.any(gaps > 0.0):
            raise ValueError("dt, the length of the step in s, is needed with a gap or cohesion")
        dt = 1.0
    batch = np.broadcast_shapes(first.shape, second.shape, normals.shape[:-1], gaps.shape)
    rows = np.zeros((*batch, 2 * _FIELDS + 4))
    _put(rows, 0, first)
    _put(rows, _FIELDS, second)
    rows[..., 2 * _FIELDS : -1] = normals
    rows[..., -1] = gaps
    solve = law._handle.spheres if isinstance(second, Spheres) else law._handle.plate
    answer = solve(rows, number("dt", dt))
    # The answer in parts: no part refers to the whole.
    after = first._after(answer[..., 0:3].copy(), answer[..., 3:6].copy())
    if isinstance(second, Spheres):
        other: Spheres | Plates = second._after(answer[..., 6:9].copy(), answer[..., 9:12].copy())
    else:
        other = Plates(answer[..., 6:9].copy(), mass=second.mass)
    return Collision(
        first=after,
        second=other,
        normal=answer[..., 18].copy() if batch else float(answer[18]),
        sliding=answer[..., 12:15].copy(),
        rolling=answer[..., 15:18].copy(),
        torsion=answer[..., 19].copy() if batch else float(answer[19]),
    )


def _put(rows: Array, at: int, body: Spheres | Plates) -> None:
    """A body's numbers in rows."""
    rows[..., at : at + 3] = body.velocity
    rows[..., at + 6] = 1.0 / body.mass
    if isinstance(body, Spheres):
        rows[..., at + 3 : at + 6] = body.spin
        rows[..., at + 7] = 1.0 / body.inertia
        rows[..., at + 8] = body.radius


def _array(name: str, value: ArrayLike) -> Array:
    array = reals(name, value)
    array.flags.writeable = False
    return array


def _vectors(name: str, value: ArrayLike) -> Array:
    """Vectors along the last axis."""
    array = _array(name, value)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(f"{name} must have shape (..., 3), not {array.shape}")
    return array


def _positive(name: str, value: ArrayLike) -> Array:
    """Numbers above 0, which may be infinite."""
    array = _array(name, value)
    if not np.all(array > 0.0):
        raise ValueError(f"{name} must be > 0")
    return array


def _finite(name: str, value: ArrayLike) -> Array:
    array = _array(name, value)
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite")
    return array


def unit(name: str, value: ArrayLike) -> Array:
    """Vectors scaled to length 1."""
    array = _vectors(name, value)
    largest = np.max(np.abs(array), axis=-1, keepdims=True)
    if not (np.isfinite(largest).all() and np.all(largest > 0.0)):
        raise ValueError(f"{name} must be finite and have a direction")
    scaled = array / largest
    made: Array = scaled / np.sqrt(np.sum(scaled * scaled, axis=-1, keepdims=True))
    return made


def vector(name: str, value: Sequence[float] | ArrayLike) -> list[float]:
    """One vector of finite numbers."""
    array = _vectors(name, value)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{name} must be three finite numbers, not {value!r}")
    made: list[float] = array.tolist()
    return made


def _short(array: Array) -> str:
    return repr(array.tolist()) if array.size <= 3 else f"<array {array.shape}>"


def _spheres(velocity: Array, spin: Array, mass: Array, radius: Array, inertia: Array) -> Spheres:
    return Spheres(velocity, spin, mass=mass, radius=radius, inertia=inertia)


def _plates(velocity: Array, mass: Array) -> Plates:
    return Plates(velocity, mass=mass)


def _law(
    mu: float,
    mu_rolling: float,
    mu_torsion: float,
    patch: Patch | None,
    restitution: float,
    cohesion: float,
    cohesion_range: float,
    attraction: str,
) -> ContactLaw:
    return ContactLaw(
        mu,
        mu_rolling=mu_rolling,
        mu_torsion=mu_torsion,
        patch=patch,
        restitution=restitution,
        cohesion=cohesion,
        cohesion_range=cohesion_range,
        attraction=attraction,
    )
