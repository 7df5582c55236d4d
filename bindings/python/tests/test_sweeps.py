"""Sweeps: the rows of the command's table, from threads, processes and other pools."""

from __future__ import annotations

import csv
import os
import pickle
import runpy
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
import tribos
from tribos._sweep import Row

SMALL = tribos.PowderScene(width=7.0, height=14.0, pressure=0.02, max_steps=60)
EXAMPLES = Path(__file__).parent.parent / "examples"


def table(scene: tribos.Scene, home: Path, *options: str) -> list[dict[str, str]]:
    """The table runs.csv of the command."""
    file, out = home / "scene.toml", home / "out"
    file.write_text(scene.to_toml())
    line = [sys.executable, "-m", "tribos", "sweep", str(file), "--out", str(out), *options]
    subprocess.run(line, check=True, capture_output=True)
    with (out / "runs.csv").open(newline="") as text:
        return list(csv.DictReader(text))


def same(rows: list[Row], there: list[dict[str, str]]) -> None:
    """Whether a table has these rows: the same columns, words and bits of numbers."""
    assert len(rows) == len(there) > 1
    for row, told in zip(rows, there):
        for name, text in told.items():
            value = row.get(name)
            if value is None:
                assert text == ""
            elif isinstance(value, float):
                assert float(text) == value, name
            elif isinstance(value, int) and not isinstance(value, bool):
                assert float(text) == value, name
            elif isinstance(value, bool):
                assert text == str(value).lower(), name
            else:
                assert text == value, name
        assert set(row) - set(told) == set()


def test_the_rows_are_those_of_the_command(tmp_path: Path) -> None:
    options = ["--set", "mu_rolling=0,1", "--set", "mu_torsion=0,0.5", "--seeds", "2"]
    there = table(SMALL, tmp_path, *options)
    keys = {"mu_rolling": [0, 1], "mu_torsion": [0, 0.5]}
    rows = tribos.sweep(SMALL, keys, seeds=2)
    same(rows, there)
    assert [row["seed"] for row in rows] == [1, 2] * 4
    assert tribos.sweep(SMALL, keys, seeds=2, threads=1) == rows
    # One by one, as another pool would.
    jobs = tribos.cases(SMALL, keys, seeds=2)
    assert [tribos.run_case(SMALL.to_toml(), job) for job in jobs] == rows


def test_a_combination_that_fails_has_a_row_with_the_reason(tmp_path: Path) -> None:
    tall = tribos.scene("cylinder")
    there = table(tall, tmp_path, "--set", "height=0.1,10", "--set", "on_tipping=refuse,clamp")
    rows = tribos.sweep(tall, {"height": [0.1, 10], "on_tipping": ["refuse", "clamp"]})
    same(rows, there)
    assert ["refusal" in row for row in rows] == [False, False, True, False]


def test_values_that_are_refused_everywhere_are_refused_at_once() -> None:
    with pytest.raises(ValueError, match='`spin` must be a finite number, got "a"'):
        tribos.sweep("disk", {"spin": [1.0, "a"], "speed": [1.0, 2.0]})
    with pytest.raises(ValueError, match="unknown key `spinn`"):
        tribos.sweep("disk", {"spinn": [1.0]})
    with pytest.raises(ValueError, match="has no seed"):
        tribos.sweep("disk", {"spin": [1.0]}, seeds=2)
    with pytest.raises(ValueError, match="twice"):
        tribos.sweep("disk", {"spin": [1.0, 1.0]})
    with pytest.raises(ValueError, match="list of values"):
        tribos.sweep("disk", {"spin": []})
    with pytest.raises(ValueError, match="seeds must be"):
        tribos.sweep("disk", {}, seeds=0)


def test_a_key_that_is_called_as_a_result_leaves_both() -> None:
    (row,) = tribos.sweep(tribos.GasScene(count=100), {"collisions": [7]})
    assert row["collisions"] == 7 and row["collisions_result"] >= 7


def test_processes_and_frames_give_the_same_rows() -> None:
    keys = {"spin": [0.0, 5.0], "alpha": [0.0, 0.5]}
    rows = tribos.sweep("disk", keys)
    assert tribos.sweep("disk", keys, processes=2) == rows
    pandas = pytest.importorskip("pandas")
    frame = tribos.sweep("disk", keys, frame=True)
    assert isinstance(frame, pandas.DataFrame)
    assert frame.to_dict("records") == rows
    job = pickle.loads(pickle.dumps((tribos.run_case, tribos.scene("disk").to_toml(), rows[:0])))
    assert job[0] is tribos.run_case


def test_an_interrupted_sweep_ends_soon() -> None:
    long = SMALL.replace(width=20.0, height=61.5, max_steps=1_000_000)
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        tribos.sweep(long, {"mu_rolling": [0, 1]}, seeds=3)
    assert time.monotonic() - began < 5.0


@pytest.mark.parametrize("name", ["ray_sweep", "dask_sweep"])
def test_other_pools_give_the_same_rows(name: str) -> None:
    pytest.importorskip(name.partition("_")[0])
    keys = {"spin": [0.0, 5.0], "alpha": [0.0, 0.5]}
    example = runpy.run_path(str(EXAMPLES / f"{name}.py"))
    rows = example["rows"](tribos.scene("disk"), keys)
    assert rows == tribos.sweep("disk", keys)
