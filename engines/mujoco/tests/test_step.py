"""The step of feet alone, without MuJoCo around it."""

import subprocess

import pytest

from conftest import library


def numbers_of(name):
    program = library().parent / name
    if not program.exists():
        pytest.skip("the program is not built: make test")
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return {name: float(number) for name, number in map(str.split, said.splitlines())}


def test_friction_of_a_step_is_the_kernels_and_meets_its_conditions():
    found = numbers_of("step")
    # A body on a disk, beside the kernel's step: friction in units of the largest one, and rest.
    assert found["kernel"] < 1e-8
    assert found["others"] == 0
    assert 4000 < found["held"] < 16000
    # Any mechanism: friction opposes the motion.
    assert found["conditions"] < 1e-6
    assert 1000 < found["held_alone"] < 19000
    # Four feet of a body that they can hold: forces in N that are left or change.
    assert found["held_together"] == 1000
    assert found["left"] < 1e-5
    assert found["changed"] < 1e-6
    # Four feet that slide and move each other.
    assert found["found"] > 100
    assert found["opposed"] < 1e-6
    # And that slide fast.
    assert found["fast"] > 900
    assert found["followed"] < 1e-7


def test_searches_that_stop_early_leave_friction_in_its_sets_without_power_and_count():
    for name, fewest in (("step", 1), ("step_cut", 900)):
        found = numbers_of(name)
        assert found["outside"] == 0
        assert -1 < found["given"] <= 1e-15
        assert fewest <= found["missed"] <= 1000
