"""Measurements from files and tables: columns by name, in SI."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tribos import _native

Array = NDArray[np.float64]
# A role, whether a log without it is refused, and whether only its own name counts.
_Role = tuple[str, bool, bool]
# Roles of a fit.
_FIT = (
    ("t", False, False),
    ("v", True, False),
    ("f", True, False),
    ("sigma", False, False),
    ("x", False, False),
    ("a", False, True),
    ("load", False, True),
)


@dataclass(frozen=True, eq=False)
class Log:
    """Columns of a log in SI, and what was understood of it."""

    columns: dict[str, Array]
    brief: tuple[str, ...]
    dropped: dict[str, int]


@dataclass(frozen=True, eq=False)
class Look:
    """A first look at a log; its text shows all of it.

    Attributes
    ----------
    understood : list of str
        What is understood of the file.
    trouble : str or None
        Why the log cannot be read so, and what cures it.
    columns : list of dict
        Of each column its ``name``, ``role``, ``unit``, the counts ``numbers``, ``missing`` and
        ``words``, and the smallest and largest number, ``min`` and ``max``, as the file has them.
    first : list of list of str
        The cells of the first rows.
    rows : int
        Number of rows.
    """

    understood: list[str]
    trouble: str | None
    columns: list[dict[str, Any]]
    first: list[list[str]]
    rows: int
    text: str = field(repr=False)

    def __repr__(self) -> str:
        return self.text.rstrip()


def look(
    data: str | os.PathLike[str],
    *,
    columns: Mapping[str, str | int] | None = None,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
) -> Look:
    """Show how `fit` would read a file: its columns, their units and ranges, the first rows.

    Parameters
    ----------
    data
        Path of the file.
    columns, units, skip
        As in `fit`.

    Examples
    --------
    >>> import tempfile, tribos
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with open(folder + "/log.txt", "w") as file:
    ...         _ = file.write("Zeit [s];Kraft [N];Weg [mm]\\n0;1,5;0\\n0,5;1,25;2\\n")
    ...     seen = tribos.look(folder + "/log.txt")
    >>> [(column["role"], column["unit"], column["max"]) for column in seen.columns]
    [('t', 's', 0.5), ('f', 'N', 1.5), ('x', 'mm', 2.0)]
    """
    path = _existing(data)
    text, found = _native.look_at(path, list(_FIT), _given(columns, units, skip))
    return Look(**json.loads(found), text=text)


def roles(usual: tuple[str, ...] = ()) -> list[_Role]:
    """Velocity, friction and what else a fit reads; roles whose usual names count as well."""
    wanted = [(name, needed, own and name not in usual) for name, needed, own in _FIT]
    return [role for role in wanted if role[0] != "a" or "a" in usual]


def read(
    data: Any,
    wanted: list[_Role],
    columns: Mapping[str, str | int] | None,
    units: Mapping[str, str] | None,
    skip: int,
) -> Log:
    """Columns of these roles of a file or a table."""
    given = _given(columns, units, skip)
    if isinstance(data, (str, os.PathLike)):
        made = _native.read_file(_existing(data), wanted, given)
    else:
        names = names_of(data, tuple(name for name, needed, _ in wanted if needed))
        places = set(_native.log_places(names, wanted, given))
        rows = [
            (name, column(name, data[name]).tolist() if at in places else [])
            for at, name in enumerate(names)
        ]
        made = _native.log_columns(rows, wanted, given)
    arrays = {name: np.array(values, dtype=np.float64) for name, values in made["columns"].items()}
    return Log(columns=arrays, brief=tuple(made["brief"]), dropped=made["dropped"])


def read_pushes(path: str | os.PathLike[str]) -> Array:
    """Rows of the pushes of a file."""
    rows = _native.read_pushes(_existing(path), _given(None, None, 0))
    return np.array(rows, dtype=np.float64).reshape(-1, 6)


def names_of(table: Any, needed: tuple[str, ...]) -> list[str]:
    """Names of the columns of a table."""
    if isinstance(table, np.ndarray) and table.dtype.names:
        return list(table.dtype.names)
    if hasattr(table, "keys"):
        return [str(name) for name in table.keys()]
    raise ValueError(
        f"the data must be a table with the columns {', '.join(needed)}: a mapping, a structured "
        f"array, a data frame or the path of a file, not {type(table).__name__}"
    )


def column(name: str, values: Any) -> Array:
    """A column of real numbers."""
    try:
        made = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be real numbers: {error}") from None
    if made.ndim != 1:
        raise ValueError(f"{name} must have one axis, not {made.ndim}")
    return made


def _existing(path: str | os.PathLike[str]) -> str:
    """The path of a file; OSError if there is none."""
    os.stat(path)
    return os.fspath(path)


def _given(
    columns: Mapping[str, str | int] | None, units: Mapping[str, str] | None, skip: int
) -> tuple[list[tuple[str, str]], list[tuple[str, str]], int]:
    if skip < 0:
        raise ValueError(f"skip must be a number of lines, not {skip!r}")
    chosen = [(str(role), str(name)) for role, name in (columns or {}).items()]
    return chosen, [(str(role), str(unit)) for role, unit in (units or {}).items()], int(skip)
