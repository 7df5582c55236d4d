"""The library's Lennard-Jones potential as a calculator of ASE.

>>> import ase.build
>>> from tribos.ase import Calculator
>>> argon = ase.build.bulk("Ar", cubic=True).repeat(4)
>>> argon.calc = Calculator(epsilon=0.0104, sigma=3.4, cutoff=8.5)      # eV, Å
>>> round(argon.get_potential_energy() / len(argon), 3)      # eV
-0.078
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np

from tribos.md import LennardJones

__all__ = ["Calculator"]

_base: Any = importlib.import_module("ase.calculators.calculator")
VOIGT = ([0, 1, 2, 1, 0, 0], [0, 1, 2, 2, 2, 1])
"""Rows and columns of a stress in ASE's order: xx, yy, zz, yz, xz, xy."""


class Calculator(_base.Calculator):  # type: ignore[misc]
    """Energy, forces and stress of atoms with a Lennard-Jones potential.

    Parameters
    ----------
    epsilon, sigma
        Depth in eV and distance of the zero in Å: numbers, or one a chemical symbol.
    cutoff
        Cut-off radius in Å: a number, one a symbol, or None for 2.5 sigma.
    shift
        ``"energy"`` (the default, that of ASE's own `LennardJones`), ``"force"`` or ``"none"``: see
        `tribos.md.LennardJones`.
    mixing
        How parameters of unlike symbols are mixed.

    Notes
    -----
    *Domain*: cells with right angles whose periodic sides are along x, y and z; a slanted cell is refused. A
    cell that is smaller than twice the cut-off is repeated. A symbol without parameters is refused.
    """

    implemented_properties: ClassVar[list[str]] = ["energy", "free_energy", "forces", "stress"]

    def __init__(
        self,
        *,
        epsilon: float | Mapping[str, float] = 1.0,
        sigma: float | Mapping[str, float] = 1.0,
        cutoff: float | Mapping[str, float] | None = None,
        shift: str = "energy",
        mixing: str = "geometric",
        **options: Any,
    ) -> None:
        super().__init__(**options)
        given = [one for one in (epsilon, sigma, cutoff) if isinstance(one, Mapping)]
        self._symbols = sorted(set().union(*given)) if given else []
        rows = []
        for symbol in self._symbols or [""]:
            wide = _of("sigma", sigma, symbol)
            reach = 2.5 * wide if cutoff is None else _of("cutoff", cutoff, symbol)
            rows.append((_of("epsilon", epsilon, symbol), wide, reach))
        # A little more than the cut-off: the list of neighbours has a skin.
        self._reach = 1.01 * max(reach for _, _, reach in rows)
        columns = [list(column) for column in zip(*rows)]
        self._potential = LennardJones(*columns, shift=shift, mixing=mixing)  # type: ignore[arg-type]

    def calculate(
        self,
        atoms: Any = None,
        properties: Any = ("energy",),
        system_changes: Any = _base.all_changes,
    ) -> None:
        """Compute all results for these atoms."""
        super().calculate(atoms, properties, system_changes)
        cell, periodic = self.atoms.cell.array, self.atoms.pbc
        if not np.array_equal(cell[periodic], np.diag(np.diag(cell))[periodic]):
            raise ValueError("the cell must have right angles, its periodic sides along x, y and z")
        sides = [
            float(side) if is_periodic else None
            for side, is_periodic in zip(np.diag(cell), periodic)
        ]
        # As many copies of the cell as the cut-off needs.
        copies = [1 if side is None else math.ceil(2.0 * self._reach / side) for side in sides]
        shifts = np.indices(copies).reshape(3, -1).T * np.diag(cell)
        places = (shifts[:, None, :] + self.atoms.positions).reshape(-1, 3)
        species = self._species()
        x, y, z = (side and side * count for side, count in zip(sides, copies))
        made = self._potential.evaluate(
            places,
            species=None if species is None else species * len(shifts),
            period=(x, y, z),
        )
        energy = made.energy / len(shifts)
        forces = made.forces[: len(self.atoms)].copy()
        self.results = {"energy": energy, "free_energy": energy, "forces": forces}
        if self.atoms.cell.rank == 3:
            stress = -made.virial / (len(shifts) * self.atoms.get_volume())
            self.results["stress"] = 0.5 * (stress + stress.T)[VOIGT]

    def _species(self) -> list[int] | None:
        if not self._symbols:
            return None
        kinds = {symbol: kind for kind, symbol in enumerate(self._symbols)}
        unknown = sorted(set(self.atoms.symbols) - set(kinds))
        if unknown:
            raise ValueError(f"no parameters for {', '.join(unknown)}")
        return [kinds[symbol] for symbol in self.atoms.symbols]


def _of(name: str, given: float | Mapping[str, float], symbol: str) -> float:
    """The number of a symbol."""
    if not isinstance(given, Mapping):
        return float(given)
    if symbol not in given:
        raise ValueError(f"{name} of {symbol} is missing")
    return float(given[symbol])
