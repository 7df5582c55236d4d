"""Packings in files of any program: read, described, written in another format."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tribos import _native

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Packing:
    """Spheres of a file or a run; its text says what was understood. Any consistent units.

    Attributes
    ----------
    positions : array of shape (n, 3)
        Centres; the box begins at 0 along axes that repeat.
    radii : array of shape (n,)
    densities, materials : arrays of shape (n,), or None
        None where the file has no densities, and where all spheres are of material 1.
    velocities, spins : arrays of shape (n, 3), or None
        None where the file has none.
    periods : tuple of float or None
        Period along x, y and z, None for an open axis.
    tilt : float
        Displacement along x of the images one period higher along z.
    bounds : array of shape (3, 2)
        Low and high end of the box along each axis, or of the spheres where the file has no box.
    """

    positions: Array
    radii: Array
    densities: Array | None
    materials: NDArray[np.uint8] | None
    velocities: Array | None
    spins: Array | None
    periods: tuple[float | None, float | None, float | None]
    tilt: float
    bounds: Array
    _file: _native.PackingFile = field(repr=False)

    def __repr__(self) -> str:
        return "\n".join(f"{name:<14} {what}" for name, what in self._file.about())

    def write(self, path: str | os.PathLike[str]) -> list[str]:
        """Write the spheres as the file has them, in the format of the ending, every bit kept.

        Parameters
        ----------
        path
            ``.xyz`` (extended XYZ), ``.vtp`` (VTK), ``.data`` (LAMMPS), ``.csv`` or ``.txt``
            (table); replaced if it is there.

        Returns
        -------
        list of str
            What the format cannot hold.
        """
        return self._file.write(os.fspath(path))


def read_packing(
    path: str | os.PathLike[str],
    *,
    columns: str | None = None,
    periods: Sequence[float | None] | None = None,
) -> Packing:
    """Read the spheres of a file of any program, known by its content, or of a run's folder.

    Parameters
    ----------
    path
        A file as ``tribos packing`` reads it: XYZ, a table, LAMMPS, LIGGGHTS, VTK, MercuryDPM,
        YADE, Lethe, ESyS-Particle, Kratos, MUSEN, packed by gzip or not; or the folder of a run.
    columns
        What the columns of a table, or the arrays of a file of VTK, are where the file does not
        say it: ``"x,y,z,radius"`` in their order with ``-`` for one that is not read,
        ``"radius=R"`` by heading or number, ``"radius=all:0.5"`` for all spheres.
    periods
        Period along x, y and z, None for an open axis, where the file does not say them.

    Examples
    --------
    >>> import tempfile, tribos
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with open(folder + "/pair.txt", "w") as file:
    ...         _ = file.write("0 0 0 1\\n0 0 1.9 1\\n")
    ...     pair = tribos.read_packing(folder + "/pair.txt", columns="density=all:2")
    ...     lost = pair.write(folder + "/pair.csv")
    >>> pair
    format         table between blanks
    spheres        2, all of radius 1
    density        2
    types          all of one
    velocities     not in the file
    spins          not in the file
    box            not in the file
    contacts       1
    overlap        10 % of the smaller radius at most, spheres 0 and 1 (from 0)
    >>> pair.positions[1], lost
    (array([0. , 0. , 1.9]), [])
    """
    given = None if periods is None else tuple(periods)
    if given is not None and len(given) != 3:
        raise ValueError(f"periods must be three lengths or None, not {given}")
    file = _native.PackingFile(os.fspath(path), columns, given)
    arrays = file.arrays()
    return Packing(
        **{**arrays, "periods": tuple(arrays["periods"]), "bounds": np.array(arrays["bounds"])},
        _file=file,
    )
