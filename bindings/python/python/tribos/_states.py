"""States of runs: frames of a film, and the first and the last state to the bit."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from tribos import _native

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """A state of a run as its film keeps it. *Units*: those of the run.

    *Accuracy*: positions to half a 65535th of the box's side, velocities and forces to 2⁻⁸ of each component.
    """

    step: int
    """Steps since the start."""
    time: float
    """Time."""
    height: float
    """Height of the piston's face, or mean height of the driven atoms."""
    measure: float
    """Porosity of a powder, angle of a tip's driven layers in degrees."""
    tilt: float
    """Displacement along x of the images one period higher along z, 0 unless the cell is sheared."""
    positions: Floats
    """Centres, shape (n, 3)."""
    radii: Floats
    """Radii, shape (n,)."""
    speeds: NDArray[np.float32]
    """Speeds, shape (n,)."""
    velocities: NDArray[np.float32]
    """Velocities, shape (n, 3); (0, 3) of a tip and of films of earlier versions."""
    contacts: Indices
    """Pairs in contact, shape (m, 2): a sphere and its partner, -1 - w for wall w."""
    normal_forces: NDArray[np.float32]
    """Normal forces, shape (m,): positive for pressure, negative for a pull."""
    tangential_forces: NDArray[np.float32]
    """Forces across the contacts on the partners, shape (m, 3); (0, 3) of films of earlier versions."""
    holds: NDArray[np.uint8]
    """Bits of the modes at their thresholds, shape (m,): 1 slides, 2 rolls, 4 spins, 128 open."""

    def __repr__(self) -> str:
        return (
            f"Frame(step={self.step}, time={self.time:.6g}, {len(self.positions)} bodies, "
            f"{len(self.contacts)} contacts)"
        )


class Frames(Sequence[Frame]):
    """The frames of a run, each read when it is asked for."""

    __slots__ = ("_film", "_kept", "_radii", "_steps")

    def __init__(self, folder: Path | None, kept: Sequence[Frame] | None = None) -> None:
        self._kept = kept
        self._film = None if folder is None else _native.Film.open(folder)
        if kept is not None:
            self._steps = [frame.step for frame in kept]
        else:
            self._steps = [] if self._film is None else self._film.steps()
        self._radii: Floats = np.empty(0) if self._film is None else self._film.bodies()["radii"]

    @property
    def steps(self) -> list[int]:
        """Steps of the run that frames are of."""
        return list(self._steps)

    def __len__(self) -> int:
        return len(self._steps)

    @overload
    def __getitem__(self, index: int) -> Frame: ...
    @overload
    def __getitem__(self, index: slice) -> list[Frame]: ...
    def __getitem__(self, index: int | slice) -> Frame | list[Frame]:
        if isinstance(index, slice):
            return [self[at] for at in range(*index.indices(len(self)))]
        if self._kept is not None:
            return self._kept[index]
        step = self._steps[index]
        assert self._film is not None
        return Frame(radii=self._radii, **self._film.read(step))

    def __repr__(self) -> str:
        return f"Frames({len(self)} frames)"

    def __reduce__(self) -> tuple[Any, ...]:
        return Frames, (None, list(self))


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """A state of a powder, to the bit. *Units*: R, F_coh, sqrt(rho R^4/F_coh)."""

    time: float
    """Time."""
    cell: Floats
    """Sides of the cell, shape (3,); periodic along x and y, the piston's height along z."""
    positions: Floats
    """Centres, shape (n, 3)."""
    radii: Floats
    """Radii, shape (n,)."""
    velocities: Floats | None
    """Velocities, shape (n, 3); None before the first step."""
    spins: Floats | None
    """Angular velocities in rad per unit of time, shape (n, 3); None before the first step."""
    contacts: Indices
    """Pairs in contact, shape (m, 2): a sphere and its partner, -1 - w for wall w."""
    gaps: Floats
    """Gaps, shape (m,): negative for an overlap."""
    normal_forces: Floats | None
    """Normal forces, shape (m,), positive for pressure; None before the first step."""
    forces: Floats | None
    """Forces on the second of each pair, shape (m, 3); None before the first step."""
    torques: Floats | None
    """Torques on the second of each pair at the contact, shape (m, 3); None before the first step."""

    def __repr__(self) -> str:
        bodies, contacts = len(self.positions), len(self.contacts)
        return f"State(time={self.time:.6g}, {bodies} spheres, {contacts} contacts)"


def read_state(folder: Path, stem: str) -> State | None:
    """The state that a powder's run left as files of this stem, if it did."""
    spheres = folder / f"{stem}.xyz"
    if not spheres.exists():
        return None
    with spheres.open(encoding="utf-8") as file:
        count = int(file.readline())
        head = file.readline()
        rows = np.loadtxt(file, usecols=None, converters={0: lambda _: 0.0}, ndmin=2)
    rows = rows.reshape(count, -1)
    words = dict(_words(head))
    columns: dict[str, Floats] = {}
    at = 0
    kinds = words["Properties"].split(":")
    for name, width in zip(kinds[::3], map(int, kinds[2::3]), strict=True):
        columns[name] = rows[:, at : at + width]
        at += width
    # Spheres of a gas touch for no time: there is no such file.
    file_of_contacts = folder / f"{stem}-contacts.vtp"
    none: dict[str, Any] = {"a": np.empty(0, int), "b": np.empty(0, int), "gap": np.empty(0)}
    contacts = _arrays(file_of_contacts) if file_of_contacts.exists() else none
    lattice = np.array(words["Lattice"].split(), dtype=float).reshape(3, 3)

    def block(table: dict[str, Any], name: str) -> Floats | None:
        return np.ascontiguousarray(table[name]) if name in table else None

    return State(
        time=float(words["Time"]),
        cell=lattice.diagonal().copy(),
        positions=np.ascontiguousarray(columns["pos"]),
        radii=np.ascontiguousarray(columns["radius"][:, 0]),
        velocities=block(columns, "velo"),
        spins=block(columns, "omega"),
        contacts=np.column_stack([contacts["a"], contacts["b"]]),
        gaps=contacts["gap"],
        normal_forces=block(contacts, "normal_force"),
        forces=block(contacts, "force"),
        torques=block(contacts, "torque"),
    )


def _words(head: str) -> list[tuple[str, str]]:
    """The settings of an extended XYZ file's second line."""
    import shlex

    return [(key, value) for key, _, value in (word.partition("=") for word in shlex.split(head))]


def _arrays(file: Path) -> dict[str, Any]:
    """The arrays of a cell of a VTK file, as the library writes them: base64 after their length."""
    kinds = {"Int64": np.dtype("<i8"), "Float64": np.dtype("<f8")}
    made: dict[str, Any] = {}
    cells = ElementTree.parse(file).getroot().find(".//CellData")
    for array in cells if cells is not None else ():
        data = base64.b64decode((array.text or "").strip())[8:]
        values = np.frombuffer(data, kinds[array.attrib["type"]]).copy()
        width = int(array.attrib.get("NumberOfComponents", "1"))
        made[array.attrib["Name"]] = values if width == 1 else values.reshape(-1, width)
    return made
