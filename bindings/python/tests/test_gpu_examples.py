"""Examples with JAX, MJX and Warp run and find what they look for.

TRIBOS_LONG=1: pucks in MJX, MuJoCo Warp and Newton.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import takes_long

pytest.importorskip("jax")
EXAMPLES = Path(__file__).parent.parent / "examples"


def numbers(name: str, below: str = "") -> list[list[float]]:
    """The numbers in each line that an example prints below a word, as a program of its own: JAX keeps what others have chosen."""
    call = [sys.executable, str(EXAMPLES / name)]
    # What compiles quickly is slow in thousands of worlds.
    own = dict(os.environ)
    if name == "jax_randomised_pucks.py":
        own.pop("XLA_FLAGS", None)
    told = subprocess.run(call, check=True, capture_output=True, text=True, env=own).stdout
    if below:
        told = told.partition(below)[2]
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


@takes_long
@pytest.mark.parametrize(
    ("name", "packages"),
    [
        ("mjx_puck.py", ["mujoco.mjx"]),
        ("mujoco_warp_puck.py", ["mujoco_warp"]),
        ("newton_puck.py", ["newton"]),
    ],
)
def test_pucks_travel_as_far_as_the_exact_law_says(name: str, packages: list[str]) -> None:
    for package in packages:
        pytest.importorskip(package)
    launches = [row for row in numbers(name, below="spin rad/s") if len(row) in (4, 5)]
    assert [row[0] for row in launches] == [0.0, 5.0, 12.5, 25.0, 50.0]
    for _, exact, off, *_ in launches:
        # Engines add half a step of the first speed, 0.5 mm.
        assert off == pytest.approx(-100.0 * 0.0005 / exact, abs=0.03)
