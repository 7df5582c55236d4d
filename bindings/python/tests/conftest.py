"""Where the tables of the repository are, and how JAX compiles in tests.

With TRIBOS_LONG=1 there are tests of minutes besides, and XLA compiles as it does for users.
"""

import csv
import importlib.util
import mmap
import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribos

# A shell that starts the tests in the background has them ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)

HERE = Path(__file__).resolve().parent
REPOSITORY = Path(os.environ.get("TRIBOS_REPOSITORY", HERE.parents[2])).resolve()


LONG = bool(os.environ.get("TRIBOS_LONG"))
takes_long = pytest.mark.skipif(not LONG, reason="takes minutes: TRIBOS_LONG=1")

QUICK = {"xla_backend_optimization_level": 0, "xla_cpu_use_fusion_emitters": False}
"""Options with which XLA compiles in a third of the time, programs that are slower."""
USERS = {"xla_backend_optimization_level": 3, "xla_cpu_use_fusion_emitters": True}
"""What these are by default."""


def knows(option: str) -> bool:
    """Whether this XLA has an option: one that it does not know would end the process."""
    found = importlib.util.find_spec("jaxlib")
    if found is None or found.origin is None:
        return False
    for library in Path(found.origin).parent.glob("*jax_common.*"):
        with open(library, "rb") as file:
            with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as text:
                if text.find(option.encode()) >= 0:
                    return True
    return False


IS_QUICK = not LONG and all(map(knows, QUICK))
if IS_QUICK:
    # Programs that tests start have it from here, too.
    given = [f"--{name}={str(value).lower()}" for name, value in QUICK.items()]
    os.environ["XLA_FLAGS"] = " ".join([*given, os.environ.get("XLA_FLAGS", "")])


PATCHES = [
    tribos.annulus(0.03, 0.04),
    tribos.anisotropic(tribos.box(0.3, 0.2), (0.5, 1.0), 0.3),
    tribos.bar(0.2),
    tribos.bolts(6, 0.05),
    tribos.box(0.3, 0.2, centre=(0.01, 0.02)),
    tribos.disk(0.04),
    tribos.ellipse(0.04, 0.03),
    tribos.hertz(0.04),
    tribos.hertz_ellipse(0.04, 0.03),
    tribos.mesh([[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]], [[0, 1, 2]], [1.0, 2.0, 3.0]),
    tribos.paraboloid(0.04),
    tribos.points([[0.1, 0.0], [-0.1, 0.05], [-0.1, -0.05]], [1.0, 2.0, 1.0]),
    tribos.polygon([[0, 0], [4, 0], [0, 4]], holes=[[[1, 1], [2, 1], [1, 2]]]),
    tribos.polynomial(0.01, [1.0, -0.5]),
    tribos.power(0.01, 0.25),
    tribos.punch(0.04),
    tribos.ring(0.04),
    tribos.worn_annulus(0.03, 0.04),
]
"""A patch of each kind."""


@pytest.fixture(scope="session")
def as_users() -> Callable[..., Any]:
    """Calls a function as JAX compiles it by default."""
    import jax

    def call(of: Callable[..., Any], *arguments: Any) -> Any:
        return jax.jit(of).lower(*arguments).compile(USERS if IS_QUICK else None)(*arguments)

    return call


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
