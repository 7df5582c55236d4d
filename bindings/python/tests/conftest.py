"""Where the tables of the repository are."""

import csv
import os
import signal
from pathlib import Path

import numpy as np
import pytest
import tribos

# A shell that starts the tests in the background has them ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)

HERE = Path(__file__).resolve().parent
REPOSITORY = Path(os.environ.get("TRIBOS_REPOSITORY", HERE.parents[2])).resolve()


PATCHES = [
    tribos.annulus(0.03, 0.04),
    tribos.bar(0.2),
    tribos.box(0.3, 0.2, centre=(0.01, 0.02)),
    tribos.disk(0.04),
    tribos.hertz(0.04),
    tribos.mesh([[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]], [[0, 1, 2]], [1.0, 2.0, 3.0]),
    tribos.paraboloid(0.04),
    tribos.points([[0.1, 0.0], [-0.1, 0.05], [-0.1, -0.05]], [1.0, 2.0, 1.0]),
    tribos.polygon([[0, 0], [4, 0], [0, 4]], holes=[[[1, 1], [2, 1], [1, 2]]]),
    tribos.polynomial(0.01, [1.0, -0.5]),
    tribos.power(0.01, 0.25),
    tribos.punch(0.04),
    tribos.ring(0.04),
]
"""A patch of each kind."""


@pytest.fixture
def repository() -> Path:
    """The checkout, where the tests run in one."""
    if not (REPOSITORY / "tests/tables").is_dir():
        pytest.skip("needs the repository")
    return REPOSITORY


@pytest.fixture
def table(repository: Path):
    """Reads a table of reference values: an array a column."""

    def read(name: str) -> dict[str, np.ndarray]:
        with open(repository / "tests/tables" / name, encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))

        def column(key: str) -> np.ndarray:
            values = [row[key] for row in rows]
            try:
                return np.array([float(value or "nan") for value in values])
            except ValueError:
                return np.array(values)

        return {key: column(key) for key in rows[0]}

    return read
