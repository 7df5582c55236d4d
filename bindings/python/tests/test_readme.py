"""The tables of the README and of docs/promises.md, from Python."""

import re
from pathlib import Path

import numpy as np
import pytest
import tribos

# The disk of the first table: R = 8 cm, mu = 0.3, uniform thickness; thrown with 1 m/s.
RADIUS, MU, GRAVITY, SPEED, STEP = 0.08, 0.3, 9.81, 1.0, 1e-3
PUCK = tribos.Friction(tribos.disk(RADIUS), mu=MU)
INERTIA = 0.5 * RADIUS**2  # of 1 kg
SPINS = (5.0, 12.5, 50.0)


def by_exact_law(spin: float) -> float:
    """Distance in m, from times a millisecond apart."""
    rest = tribos.slide(PUCK, SPEED, spin)
    times = np.append(np.arange(0.0, float(rest.time), STEP), rest.time)
    return float(tribos.slide_path(PUCK, SPEED, spin, times).distance[-1])


def by_separate_limits(spin: float) -> float:
    """Sliding and spinning with a limit each, as engines have it."""
    deceleration = MU * GRAVITY
    speed, rim, distance = SPEED, spin * RADIUS, 0.0
    while speed > 0.0 or rim > 0.0:
        speed = max(speed - deceleration * STEP, 0.0)
        rim = max(rim - deceleration * STEP * (2.0 / 3.0) / 0.5, 0.0)
        distance += speed * STEP
    return distance


def by_ellipsoid(spin: float) -> float:
    """Implicit steps with the ellipsoid of the same largest force and torque."""
    surface = PUCK.limit_surface(GRAVITY).ellipsoid()
    masses = np.array([1.0, 1.0, INERTIA])
    twist, distance = np.array([SPEED, 0.0, spin]), 0.0
    while twist.any():
        needed = masses * twist / STEP
        carried = surface.project(needed, length=INERTIA**0.5)
        twist = np.where(carried == needed, 0.0, twist - STEP * carried / masses)
        distance += twist[0] * STEP
    return distance


METHODS = {
    "Tribos": by_exact_law,
    "separate limits": by_separate_limits,
    "ellipsoid": by_ellipsoid,
}


def table(text: str, first: str) -> tuple[list[str], list[list[str]]]:
    """Head and rows of the table whose head begins with a word."""
    found = re.search(rf"^\| {first}.*\n\|[-|]+\|\n((?:\|.*\n)+)", text, re.MULTILINE)
    assert found, first
    lines = found.group(0).splitlines()
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return cells[0], cells[2:]


@pytest.fixture
def readme(repository: Path) -> str:
    return (repository / "README.md").read_text(encoding="utf-8")


def test_errors_of_a_travel_are_those_of_the_readme(readme: str) -> None:
    head, rows = table(readme, "spin at launch")
    assert [row[0] for row in rows] == [f"{spin:g} rad/s" for spin in SPINS]
    for row, spin in zip(rows, SPINS, strict=True):
        exact = tribos.slide(PUCK, SPEED, spin).distance
        assert row[1] == f"{exact:.3f} m"
        for name, cell in zip(head[2:], row[2:], strict=True):
            error = METHODS[name](spin) / exact - 1.0
            if cell.startswith("below"):
                assert abs(error) < float(cell.removeprefix("below "))
            else:
                told = cell.removesuffix(" %").replace("−", "-")
                digits = len(told.partition(".")[2])
                assert f"{100.0 * error:.{digits}f}" == told, (name, spin)


def test_errors_of_tiers_are_those_of_the_promises(repository: Path, table_of_the_disk) -> None:
    _, rows = table((repository / "docs/promises.md").read_text(encoding="utf-8"), "method")
    told = {row[0]: row[1] for row in rows}
    slide, force, torque = table_of_the_disk
    twists = np.stack((slide, 0.0 * slide, np.ones_like(slide)), axis=-1)
    bounds = {
        "exact": float(told["**form**, f64"].split()[0]) * np.finfo(float).eps,
        "quadrature": float(told["**quadrature**, f64 (any local law)"]),
    }
    for tier, bound in bounds.items():
        wrench = -tribos.Friction(tribos.disk(1.0), mu=1.0, tier=tier).wrench(twists, 1.0)
        moves = slide > 0.0
        errors = (
            np.abs(wrench[:, 0] - force)[moves] / force[moves],
            np.abs(wrench[:, 2] / torque - 1),
        )
        assert max(error.max() for error in errors) <= bound, tier


@pytest.fixture
def table_of_the_disk(table) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rows = table("uniform.csv")
    dry = rows["alpha"] == 0.0
    return rows["eps"][dry], rows["F"][dry], rows["T"][dry]


def test_the_first_wrench_is_that_of_the_readme(readme: str) -> None:
    force, _, torque = tribos.Friction(tribos.disk(0.04), mu=0.3).wrench([1.0, 0.0, 20.0], 1.7)
    assert f"wrench.force.x = {force:.3f} N and wrench.torque = {torque:.5f} N m" in readme
