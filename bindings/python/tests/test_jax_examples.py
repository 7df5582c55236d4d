"""Examples with JAX run and find what they look for."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("jax")
EXAMPLES = Path(__file__).parent.parent / "examples"


def numbers(name: str) -> list[list[float]]:
    """The numbers in each line that an example prints, as a program of its own: JAX keeps what others have chosen."""
    call = [sys.executable, str(EXAMPLES / name)]
    # What compiles quickly is slow in thousands of worlds.
    own = dict(os.environ)
    if name == "jax_randomised_pucks.py":
        own.pop("XLA_FLAGS", None)
    told = subprocess.run(call, check=True, capture_output=True, text=True, env=own).stdout
    return [[float(x) for x in re.findall(r"[-+]?\d+\.?\d*", line)] for line in told.splitlines()]


def test_randomised_pucks_travel_as_far_as_the_exact_law_says() -> None:
    _, (middle, _, low, high), *checked = numbers("jax_randomised_pucks.py")
    assert low < middle < high and len(checked) == 3
    for travel, exact, error in checked:
        assert abs(travel - exact) < 1e-4 * exact and abs(error) < 0.01


def test_a_planned_push_ends_at_its_goal() -> None:
    before, after, ahead, aside = numbers("jax_plan_push.py")
    assert before[1] > 100.0 and before[2] > 50.0
    assert after[1] < 0.05 and after[2] < 0.05
    # A finger could give these forces: it presses, and slides less than a rubber one would.
    assert len(ahead) == len(aside) == 4
    assert min(ahead) > 0.0 and max(map(abs, aside)) < 0.5 * min(ahead)
