"""Contact dynamics: rigid spheres between walls, step by step.

A billiard ball that is struck through its centre slides at first and finally rolls with 5/7 of its initial
speed, for any friction:

>>> from tribos import cd
>>> ball = cd.World(
...     [[0.0, 0.0, 0.028]], 0.028, density=1700.0, velocities=[[1.0, 0.0, 0.0]],      # m, kg/m³, m/s
...     walls=[cd.Wall((0.0, 0.0, 1.0))], laws=cd.Laws(sliding=0.2), gravity=(0.0, 0.0, -9.81),
... )
>>> ball.step(200)
>>> float(round(ball.velocities[0, 0] * 7.0 / 5.0, 12))
1.0
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, table

__all__ = ["Contacts", "Energy", "Laws", "Wall", "World"]

Vector = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True, slots=True)
class Laws:
    """Laws of a contact. Coefficients are multiples of the normal force plus cohesion. Any consistent units."""

    sliding: float = 0.0
    """Friction coefficient: largest sliding force."""
    rolling: float = 0.0
    """Largest rolling torque over the effective radius."""
    torsion: float = 0.0
    """Largest torque about the normal over the effective radius."""
    restitution: float = 0.0
    """Speed after an impact over speed before, from 0 to 1."""
    cohesion: float = 0.0
    """Strength of cohesion, a force."""
    cohesion_range: float = 0.0
    """Gap up to which cohesion acts, a length."""
    attraction: Literal["pull", "resistance"] = "pull"
    """Cohesion at a gap: a constant pull, or a resistance to opening."""

    def _numbers(self) -> tuple[list[float], bool]:
        if self.attraction not in ("pull", "resistance"):
            raise ValueError(f"attraction must be 'pull' or 'resistance', not {self.attraction!r}")
        names = ("sliding", "rolling", "torsion", "restitution", "cohesion", "cohesion_range")
        return [float(getattr(self, name)) for name in names], self.attraction == "pull"


@dataclass(frozen=True, slots=True)
class Wall:
    """A plane that bounds the space of the spheres: a wall, or a piston if it has a finite mass."""

    normal: Vector
    """Unit normal, into the space of the spheres."""
    place: float = 0.0
    """Position along the normal: points x of the plane have normal · x = place."""
    mass: float = math.inf
    """Mass; infinite for a wall that no force moves."""
    force: float = 0.0
    """Force along the normal; positive pushes it into the space of the spheres."""
    velocity: Vector = (0.0, 0.0, 0.0)
    """Velocity; a wall keeps it."""

    def _numbers(self) -> tuple[Vector, float, float, float, Vector]:
        return (
            _vector("normal", self.normal),
            float(self.place),
            float(self.mass),
            float(self.force),
            _vector("velocity", self.velocity),
        )


@dataclass(frozen=True, slots=True, eq=False)
class Contacts:
    """Contacts of the last step with their mean forces."""

    pairs: NDArray[np.int64]
    """A sphere and its partner, shape (m, 2): -1 - w for wall w."""
    normals: NDArray[np.float64]
    """Unit vectors from the first to the second, shape (m, 3)."""
    forces: NDArray[np.float64]
    """Forces on the second, shape (m, 3)."""
    torques: NDArray[np.float64]
    """Rolling and torsion torques on the second at the contact, shape (m, 3)."""

    @property
    def normal_forces(self) -> NDArray[np.float64]:
        """Components along the normals, shape (m,): positive for pressure, negative for a pull."""
        along: NDArray[np.float64] = (self.forces * self.normals).sum(axis=1)
        return along

    def __len__(self) -> int:
        return len(self.pairs)


@dataclass(frozen=True, slots=True)
class Energy:
    """Energy balance since the start: work is what was lost, stilled and gained as kinetic energy."""

    work: float
    """Work of loads on walls, of moved walls, and of gravity."""
    normal: float
    """Lost in collisions and in closing gaps."""
    sliding: float
    """Lost in sliding."""
    rolling: float
    """Lost in rolling."""
    torsion: float
    """Lost in torsion."""
    cohesion: float
    """Work against cohesion."""
    stilled: float
    """Kinetic energy of spheres at the moment they were put to sleep."""
    kinetic: float
    """Current kinetic energy; 0 before the first step."""
    imbalance: float
    """Residual of the balance: rounding errors."""


class World:
    """Spheres between walls, in motion. Any consistent units.

    Parameters
    ----------
    positions
        Centres, shape (n, 3).
    radii
        Radii, a number or shape (n,).
    density
        Densities of the solid spheres, a number or shape (n,).
    velocities, spins
        Velocities and angular velocities at the start, shape (n, 3); at rest if left out.
    walls
        Walls and pistons.
    laws
        Laws between spheres, and at walls unless `wall_laws` are given.
    wall_laws
        Laws at walls.
    gravity
        Acceleration of all spheres.
    period
        Lengths after which space repeats along x, y, z; None for an open axis.
    longest_step, largest_motion
        Longest time step, and the largest motion of a body that is expected in it.
    tolerance
        Change of a sweep, relative to the normal forces, at which the solver stops.
    sweeps
        Most sweeps of a step.
    sleep_speed
        Groups of touching spheres that are slower are put to sleep until disturbed; 0 keeps all awake.

    Notes
    -----
    A world has one state and cannot be pickled. Steps release the interpreter's lock; their bits do not depend
    on the number of threads.
    """

    __slots__ = ("_inside",)

    _inside: _native.World

    def __init__(
        self,
        positions: ArrayLike,
        radii: ArrayLike,
        *,
        density: ArrayLike = 1.0,
        velocities: ArrayLike | None = None,
        spins: ArrayLike | None = None,
        walls: Sequence[Wall] = (),
        laws: Laws | None = None,
        wall_laws: Laws | None = None,
        gravity: Vector = (0.0, 0.0, 0.0),
        period: tuple[float | None, float | None, float | None] = (None, None, None),
        longest_step: float = 1e-3,
        largest_motion: float = 1e-2,
        tolerance: float = 1e-9,
        sweeps: int = 1000,
        sleep_speed: float = 0.0,
    ) -> None:
        laws = laws or Laws()
        places = table("positions", positions, 3)
        count = len(places)
        if not tolerance > 0.0:
            raise ValueError(f"tolerance must be > 0, not {tolerance!r}")
        if sweeps < 1:
            raise ValueError(f"sweeps must be 1 or more, not {sweeps!r}")
        self._inside = _native.World(
            places,
            _column("radii", radii, count),
            densities=_column("density", density, count),
            velocities=None if velocities is None else table("velocities", velocities, 3),
            spins=None if spins is None else table("spins", spins, 3),
            pairs=laws._numbers(),
            at_walls=(wall_laws or laws)._numbers(),
            walls=[wall._numbers() for wall in walls],
            gravity=_vector("gravity", gravity),
            periods=period,
            longest_step=number("longest_step", longest_step),
            largest_motion=number("largest_motion", largest_motion),
            tolerance=number("tolerance", tolerance),
            sweeps=sweeps,
            sleep_speed=number("sleep_speed", sleep_speed),
        )

    def step(self, count: int = 1) -> None:
        """Take steps.

        Raises
        ------
        RuntimeError
            A number left its range, or two spheres have the same place.
        """
        if count < 0:
            raise ValueError(f"count must be 0 or more, not {count}")
        self._inside.step(count)

    @property
    def time(self) -> float:
        """Elapsed time."""
        return self._inside.clock()[0]

    @property
    def steps(self) -> int:
        """Steps taken."""
        return self._inside.clock()[1]

    @property
    def positions(self) -> NDArray[np.float64]:
        """Centres, shape (n, 3), not wrapped into the periodic box; a new array."""
        return self._inside.positions()

    @property
    def velocities(self) -> NDArray[np.float64]:
        """Velocities of the centres, shape (n, 3); a new array, which can be assigned."""
        return self._inside.velocities()

    @velocities.setter
    def velocities(self, values: ArrayLike) -> None:
        self._inside.set("velocities", table("velocities", values, 3))

    @property
    def spins(self) -> NDArray[np.float64]:
        """Angular velocities in rad per unit of time, shape (n, 3); a new array, which can be assigned."""
        return self._inside.spins()

    @spins.setter
    def spins(self, values: ArrayLike) -> None:
        self._inside.set("spins", table("spins", values, 3))

    @property
    def walls(self) -> list[tuple[float, float]]:
        """Place of each wall along its normal, and its speed along it."""
        return self._inside.walls()

    @property
    def contacts(self) -> Contacts:
        """Contacts of the last step."""
        return Contacts(**self._inside.contacts())

    @property
    def energy(self) -> Energy:
        """Energy balance since the start."""
        report = self._inside.report()
        return Energy(**{name: report[name] for name in Energy.__slots__})

    @property
    def last_step(self) -> dict[str, Any]:
        """The last step: its length dt, number of contacts, sweeps, whether all tolerances were met."""
        report = self._inside.report()
        return {name: report[name] for name in ("dt", "contacts", "sweeps", "is_met")}

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        return f"World({len(self)} spheres, time={self.time:.6g}, {self.steps} steps)"


def _column(name: str, given: ArrayLike, count: int) -> list[float]:
    """A number an element."""
    try:
        column = np.broadcast_to(np.asarray(given, dtype=np.float64), (count,))
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be a number or {count} numbers") from None
    return [float(value) for value in column]


def _vector(name: str, given: Sequence[float]) -> Vector:
    x, y, z = table(name, [given], 3)[0].tolist()
    return x, y, z
