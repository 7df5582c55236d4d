"""The kernel before the benchmark of friction, with 29 problems that do not know it."""

import sys

import pytest
from conftest import REPOSITORY

sys.path.insert(0, str(REPOSITORY / "tests" / "answers"))

from friction_answers.page import MARKS, Row
from friction_answers.run import run


@pytest.fixture(scope="module")
def row():
    results = run("tribos", ["default"])
    return Row(results, results["runs"][0])


def test_the_kernel_is_within_its_half_step(row):
    # Places are off by half a step of the first speed where nothing else is.
    assert row.overall() < 1e-3
    for mark in MARKS:
        assert row.median(mark) < 3e-3, mark


def test_what_holds_does_not_creep(row):
    assert max(wrong for wrong, _, _ in row.errors("holds")) < 1e-5


def test_it_says_what_it_cannot(row):
    assert set(row.cannot) == {"capsule", "tower", "tripod", "three_ball", "tall", "stack"}
