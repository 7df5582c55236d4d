"""Molecular dynamics: atoms with a Lennard-Jones potential, step by step.

>>> from tribos import md
>>> pair = md.System([[0.0, 0.0, 0.0], [1.2, 0.0, 0.0]], md.LennardJones())
>>> pair.step(1000)
>>> abs(pair.conserved_energy - md.LennardJones().evaluate([[0, 0, 0], [1.2, 0, 0]]).energy) < 1e-3
True
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tribos import _native
from tribos._checks import number, positive, table

__all__ = ["Forces", "Langevin", "LennardJones", "NoseHoover", "System"]

Period = tuple["float | None", "float | None", "float | None"]
OPEN: Period = (None, None, None)


@dataclass(frozen=True, slots=True, eq=False)
class Forces:
    """Forces of an interaction and its sums."""

    energy: float
    """Potential energy."""
    forces: NDArray[np.float64]
    """Forces, shape (n, 3)."""
    virial: NDArray[np.float64]
    """Σ r ⊗ F over pairs, an energy, shape (3, 3): its trace over 3V is the pressure of the interaction."""


class LennardJones:
    """U = 4ε((σ/r)¹² − (σ/r)⁶) between all pairs nearer than their cut-off. Any consistent units.

    Parameters
    ----------
    epsilon, sigma, cutoff
        Depth, distance of the zero, and cut-off radius: numbers, or one for each species.
    shift
        ``"none"``: the energy jumps at the cut-off; ``"energy"``: U − U(cutoff); ``"force"``: energy and force
        are continuous.
    mixing
        How parameters of unlike species are mixed: ``"geometric"``, ``"arithmetic"`` (sigma; epsilon
        geometric) or ``"sixthpower"``.

    Examples
    --------
    >>> from tribos import md
    >>> made = md.LennardJones().evaluate([[0, 0, 0], [1, 0, 0]])
    >>> round(made.energy, 12) + 0.0, made.forces.round(9)[1].tolist()
    (0.0, [24.0, 0.0, 0.0])
    """

    __slots__ = ("_arguments", "_inside")

    _arguments: tuple[Any, ...]
    _inside: _native.Potential

    def __init__(
        self,
        epsilon: ArrayLike = 1.0,
        sigma: ArrayLike = 1.0,
        cutoff: ArrayLike = 2.5,
        *,
        shift: Literal["none", "energy", "force"] = "none",
        mixing: Literal["geometric", "arithmetic", "sixthpower"] = "geometric",
    ) -> None:
        try:
            rows = np.stack(
                np.broadcast_arrays(
                    *np.atleast_1d(*(np.asarray(x, float) for x in (epsilon, sigma, cutoff)))
                ),
                axis=-1,
            )
        except (TypeError, ValueError):
            raise ValueError("epsilon, sigma and cutoff must be numbers, one a species") from None
        species = table("epsilon, sigma and cutoff", rows, 3).tolist()
        self._arguments = (species, mixing, shift)
        self._inside = _native.Potential(species, mixing, shift)

    def evaluate(
        self, positions: ArrayLike, *, species: Sequence[int] | None = None, period: Period = OPEN
    ) -> Forces:
        """Energy, forces and virial of atoms.

        Parameters
        ----------
        positions
            Positions, shape (n, 3).
        species
            Species of each atom, from 0; all 0 if left out.
        period
            Lengths after which space repeats along x, y, z, at least twice the cut-off; None for an open axis.
        """
        places = table("positions", positions, 3)
        kinds = _species(species, len(places))
        energy, forces, virial = self._inside.evaluate(places, kinds, period)
        return Forces(energy, forces, np.array(virial))

    def __repr__(self) -> str:
        species, mixing, shift = self._arguments
        epsilon, sigma, cutoff = ([row[at] for row in species] for at in range(3))
        return f"LennardJones({epsilon}, {sigma}, {cutoff}, shift={shift!r}, mixing={mixing!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LennardJones) and self._arguments == other._arguments

    def __hash__(self) -> int:
        return hash(repr(self))

    def __reduce__(self) -> tuple[Any, ...]:
        species, mixing, shift = self._arguments
        epsilon, sigma, cutoff = ([row[at] for row in species] for at in range(3))
        return _potential, (epsilon, sigma, cutoff, shift, mixing)


def _potential(epsilon: Any, sigma: Any, cutoff: Any, shift: Any, mixing: Any) -> LennardJones:
    return LennardJones(epsilon, sigma, cutoff, shift=shift, mixing=mixing)


@dataclass(frozen=True, slots=True)
class NoseHoover:
    """A deterministic thermostat with a conserved quantity."""

    temperature: float
    """Target temperature, in units of energy (k_B = 1)."""
    relaxation: float = 0.5
    """Relaxation time."""


@dataclass(frozen=True, slots=True)
class Langevin:
    """A thermostat of friction and noise."""

    temperature: float
    """Target temperature, in units of energy (k_B = 1)."""
    friction: float = 1.0
    """Rate of the friction, in 1/time."""


class System:
    """Atoms in motion. Any consistent units, with k_B = 1.

    Parameters
    ----------
    positions
        Positions, shape (n, 3).
    potential
        The interaction.
    velocities
        Velocities at the start, shape (n, 3); at rest if left out.
    masses
        Mass of each species, or one number for all.
    species
        Species of each atom, from 0; all 0 if left out.
    period
        Lengths after which space repeats along x, y, z; None for an open axis.
    thermostat
        `NoseHoover`, `Langevin`, or None.
    integrator
        ``"velocity-verlet"`` or ``"leap-frog"``; positions differ only by rounding.
    time_step
        Time step.
    skin
        Reach of the list of neighbours beyond the cut-off; it changes no more than rounding.
    seed
        Seed of the thermostat's noise.

    Notes
    -----
    A pickled system goes on to the same bits. Steps release the interpreter's lock.
    """

    __slots__ = ("_arguments", "_inside")

    _arguments: tuple[LennardJones, dict[str, Any]]
    _inside: _native.System

    def __init__(
        self,
        positions: ArrayLike,
        potential: LennardJones,
        *,
        velocities: ArrayLike | None = None,
        masses: ArrayLike = 1.0,
        species: Sequence[int] | None = None,
        period: Period = OPEN,
        thermostat: NoseHoover | Langevin | None = None,
        integrator: Literal["velocity-verlet", "leap-frog"] = "velocity-verlet",
        time_step: float = 0.005,
        skin: float = 0.3,
        seed: int = 1,
    ) -> None:
        places = table("positions", positions, 3)
        kinds = len(potential._arguments[0])
        bath = ("none", 0.0, 1.0)
        if isinstance(thermostat, NoseHoover):
            bath = ("nose-hoover", float(thermostat.temperature), float(thermostat.relaxation))
        elif isinstance(thermostat, Langevin):
            bath = ("langevin", float(thermostat.temperature), float(thermostat.friction))
        elif thermostat is not None:
            raise ValueError(f"thermostat must be NoseHoover, Langevin or None, not {thermostat!r}")
        options: dict[str, Any] = {
            "species": _species(species, len(places)),
            "masses": [
                float(mass) for mass in np.broadcast_to(np.asarray(masses, float), (kinds,))
            ],
            "periods": period,
            "thermostat": bath,
            "integrator": integrator,
            "time_step": positive("time_step", time_step),
            "skin": number("skin", skin),
            "seed": seed,
        }
        self._arguments = (potential, options)
        self._inside = _native.System(
            potential._inside,
            places,
            velocities=None if velocities is None else table("velocities", velocities, 3),
            kept=None,
            **options,
        )

    def step(self, count: int = 1) -> None:
        """Take steps.

        Raises
        ------
        RuntimeError
            An atom moved by more than half the cut-off in a step.
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
        """Positions, shape (n, 3), not wrapped into the box; a new array."""
        return self._inside.positions()

    @property
    def velocities(self) -> NDArray[np.float64]:
        """Velocities at the time of the positions, shape (n, 3); a new array."""
        return self._inside.velocities()

    @property
    def forces(self) -> NDArray[np.float64]:
        """Forces at the positions, shape (n, 3); a new array."""
        return self._inside.forces()

    @property
    def potential_energy(self) -> float:
        """Energy of the interaction."""
        return self._inside.energies()[0][0]

    @property
    def kinetic_energy(self) -> float:
        """Energy of the motion."""
        return self._inside.energies()[0][1]

    @property
    def conserved_energy(self) -> float:
        """Energy of interaction, motion and of a Nosé-Hoover thermostat: conserved without noise."""
        return self._inside.energies()[0][2]

    @property
    def temperature(self) -> float:
        """Twice the kinetic energy over the degrees of freedom.

        These are 3n with a Langevin thermostat, whose noise changes the total momentum, and 3n - 3 else: start
        without momentum (subtract the mean of m v), which would be taken for heat. NaN for a single atom without
        noise.
        """
        return self._inside.energies()[0][3]

    @property
    def virial(self) -> NDArray[np.float64]:
        """Σ r ⊗ F over pairs, shape (3, 3)."""
        return np.array(self._inside.energies()[1])

    def __len__(self) -> int:
        return len(self._arguments[1]["species"])

    def __repr__(self) -> str:
        return (
            f"System({len(self)} atoms, time={self.time:.6g}, temperature={self.temperature:.4g})"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        potential, options = self._arguments
        return _resumed, (potential, options, self._inside.state())


def _resumed(potential: LennardJones, options: dict[str, Any], state: Any) -> System:
    """The system of a state, which goes on to the same bits."""
    made = object.__new__(System)
    made._arguments = (potential, options)
    made._inside = _native.System(
        potential._inside, state[1], velocities=state[2], kept=state, **options
    )
    return made


def _species(given: Sequence[int] | None, count: int) -> list[int]:
    """A species an atom."""
    if given is None:
        return [0] * count
    kinds = [int(kind) for kind in given]
    if not all(0 <= kind < 256 for kind in kinds):
        raise ValueError("species must be numbers from 0")
    return kinds
