"""Runs: the command's files to the byte, the same bits after an interruption, results as arrays."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import pytest
import tribos
from tribos import _native

POWDER = tribos.PowderScene(width=8.0, height=24.0, pressure=0.02, max_steps=400, duration=60.0)
"""Some forty spheres, in less than a second."""

LONG = tribos.PowderScene(width=20.0, height=57.0, pressure=0.02, max_steps=1000)
"""Four hundred spheres; it takes seconds and is interrupted within the first half of one."""


def files(folder: Path) -> dict[str, bytes]:
    """All files of a run by their names, without the line with the time that it took."""
    there = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            data = path.read_bytes()
            if path.name == "summary.json":
                data = b"\n".join(line for line in data.splitlines() if b"wall_seconds" not in line)
            there[str(path.relative_to(folder))] = data
    return there


def command(*arguments: str) -> None:
    subprocess.run([sys.executable, "-m", "tribos", *arguments], check=True, capture_output=True)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The powder's run by the command."""
    home = tmp_path_factory.mktemp("whole")
    (home / "powder.toml").write_text(POWDER.to_toml())
    command("run", str(home / "powder.toml"), "--out", str(home / "out"))
    return home / "out"


def test_a_powders_files_are_those_of_the_command_to_the_byte(whole: Path, tmp_path: Path) -> None:
    for threads in (None, 1, 3):
        out = tmp_path / str(threads)
        run = tribos.run(POWDER, out, threads=threads)
        assert run.folder == out
        here, there = files(out), files(whole)
        assert here.keys() == there.keys() and len(here) > 20
        for name, data in there.items():
            assert here[name] == data, name


def in_motion() -> list[str]:
    """A scene of every body whose run takes a moment."""
    names: dict[str, str] = {}
    for name, _, _ in _native.library_scenes():
        names.setdefault(tribos.scene(name).BODY, name)
    return [name for body, name in names.items() if body not in {"powder", "grains", "gas", "tip"}]


@pytest.mark.parametrize("name", in_motion())
def test_a_sliding_bodys_files_are_those_of_the_command(name: str, tmp_path: Path) -> None:
    command("run", name, "--out", str(tmp_path / "command"))
    run = tribos.run(name, tmp_path / "python")
    assert files(tmp_path / "command") == files(tmp_path / "python")
    # The same results without a folder.
    memory = tribos.run(name)
    assert memory.summary == run.summary and memory.folder is None
    assert np.array_equal(memory.series, run.series) and memory.columns == run.columns


def test_a_tips_files_are_those_of_the_command(tmp_path: Path) -> None:
    tip = tribos.TipScene(
        substrate_columns=12,
        substrate_rows=12,
        tip_side_atoms=4,
        equilibration=0.1,
        drive_time=0.2,
        rest_time=0.1,
        sample_every=10,
    )
    (tmp_path / "tip.toml").write_text(tip.to_toml())
    command("run", str(tmp_path / "tip.toml"), "--out", str(tmp_path / "command"))
    run = tribos.run(tip, tmp_path / "python")
    assert files(tmp_path / "command") == files(tmp_path / "python")
    assert run.scene == tip and run.series["time"][-1] == pytest.approx(0.3)
    assert len(run.frames[-1].positions) == len(run.frames[0].radii) > 400


@pytest.fixture(scope="module")
def long(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The longer run by the command."""
    home = tmp_path_factory.mktemp("long")
    (home / "powder.toml").write_text(LONG.to_toml())
    command("run", str(home / "powder.toml"), "--out", str(home / "out"), "--frames", "10")
    return home / "out"


def interrupted(delay: float, out: Path) -> str:
    """Runs or goes on and presses Ctrl-C `delay` seconds after the begin; what the interruption says."""

    def press() -> None:
        while not (out / ".tribos-lock").exists():
            time.sleep(0.001)
        time.sleep(delay)
        os.kill(os.getpid(), signal.SIGINT)

    finger = threading.Thread(target=press)
    finger.start()
    with pytest.raises(KeyboardInterrupt, match="interrupted") as raised:
        tribos.run(LONG, out, frames=10, resume=out.exists())
    finger.join()
    return str(raised.value)


@pytest.mark.parametrize("delays", [[0.02], [0.12], [0.25], [0.06, 0.06, 0.06]])
def test_an_interrupted_run_goes_on_to_the_same_bytes(
    delays: list[float], long: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    for delay in delays:
        told = interrupted(delay, out)
    assert not (out / "summary.json").exists()
    with pytest.raises(ValueError, match="not finished"):
        tribos.open_run(out)
    if (out / "checkpoint.json").exists():
        assert "after step" in told and "tribos.resume(" in told
        # Another run there is refused while this one can go on.
        with pytest.raises(ValueError, match="resume=True, give another out"):
            tribos.run(LONG.replace(seed=2), out)
    done = tribos.run(LONG, out, resume=True)
    assert files(out) == files(long)
    # A finished run is opened.
    assert tribos.resume(out).summary == done.summary


def test_the_command_goes_on_with_a_run_from_python(long: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    interrupted(0.2, out)
    (tmp_path / "powder.toml").write_text(LONG.to_toml())
    command("run", str(tmp_path / "powder.toml"), "--out", str(out), "--resume")
    assert files(out) == files(long)


def test_a_callback_that_raises_ends_the_run_with_its_error(tmp_path: Path) -> None:
    scene = POWDER.replace(width=20.0, height=61.5, max_steps=100_000, duration=None)

    def raises(done: float | None, words: str) -> None:
        assert words
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        tribos.run(scene, tmp_path, progress=raises)
    assert (tmp_path / "checkpoint.json").exists()
    tribos.run(POWDER, tmp_path, anew=True)
    assert (tmp_path / "summary.json").exists()


def test_states_and_frames_are_arrays_that_agree_with_each_other() -> None:
    run = tribos.run(POWDER)
    first, last = run.initial, run.final
    assert first is not None and last is not None
    count = run.summary["particles"]
    assert last.positions.shape == (count, 3) and last.radii.shape == (count,)
    assert last.time == run.summary["time"] == run.series["time"][-1]
    assert len(last.contacts) == run.series["contacts"][-1]
    assert first.velocities is None and last.velocities is not None
    # The piston's height and the porosity from the spheres themselves.
    assert last.cell[2] == run.summary["height_final"]
    solid = 4.0 / 3.0 * np.pi * (last.radii**3).sum() / last.cell.prod()
    assert 1.0 - solid == pytest.approx(run.summary["porosity_final"], rel=1e-12)
    frames = run.frames
    assert len(frames) == len(frames.steps) > 10 and frames[-1].step == run.summary["steps"]
    box = last.cell.max()
    assert np.abs(frames[-1].positions - last.positions).max() <= 0.6 * box / 65535.0
    assert [tuple(pair) for pair in frames[-1].contacts] == [tuple(pair) for pair in last.contacts]
    assert last.normal_forces is not None and last.forces is not None
    assert np.allclose(frames[-1].normal_forces, last.normal_forces, rtol=2.0**-7, atol=1e-30)
    # Gaps from the positions, periodic in x and y.
    pairs = last.contacts[last.contacts[:, 1] >= 0]
    apart = last.positions[pairs[:, 1]] - last.positions[pairs[:, 0]]
    apart[:, :2] -= last.cell[:2] * np.round(apart[:, :2] / last.cell[:2])
    gaps = np.linalg.norm(apart, axis=1) - last.radii[pairs].sum(axis=1)
    assert np.allclose(gaps, last.gaps[last.contacts[:, 1] >= 0], atol=1e-12)
    assert [frame.step for frame in frames[:3]] == frames.steps[:3]


@pytest.mark.parametrize("scene", [tribos.SliderScene(), POWDER])
def test_results_survive_pickling(scene: tribos.Scene, tmp_path: Path) -> None:
    for out in (None, tmp_path / "out"):
        run = tribos.run(scene, out)
        same = pickle.loads(pickle.dumps(run))
        assert same.summary == run.summary and same.scene == run.scene == scene
        assert np.array_equal(same.series, run.series)
        assert len(same.frames) == len(run.frames)
        if len(run.frames):
            assert np.array_equal(same.frames[-1].positions, run.frames[-1].positions)
        assert repr(same) == repr(run) and "<table>" in run._repr_html_()


def test_the_distance_of_a_disk_without_spin_is_the_closed_form() -> None:
    scene = tribos.SliderScene(speed=1.5, spin=0.0, gamma=0.25, gravity=9.81)
    run = tribos.run(scene)
    assert run.summary["distance"] == pytest.approx(1.5**2 / (2 * 0.25 * 9.81), rel=1e-12)
    assert run.series["speed"][0] == 1.5 and run.series["time"][-1] == run.summary["end_time"]


def test_the_progress_is_a_line_that_ends(capsys: pytest.CaptureFixture[str]) -> None:
    from tribos._run import Line

    line = Line()
    line(0.25, "step 3")
    line(None, "x")
    line.end()
    told = capsys.readouterr().err
    assert told.startswith("\r[=====               ]  25% step 3\rx ") and told.endswith("\n")


def test_what_cannot_be_run_is_refused_before_the_folder_is_touched(tmp_path: Path) -> None:
    out = tmp_path / "out"
    with pytest.raises(ValueError, match="more than the 4 GB that are taken without allow_large"):
        tribos.run(POWDER.replace(width=1000.0, height=1000.0), out)
    for bad in ({"frames": 1}, {"checkpoint": -1.0}):
        with pytest.raises(ValueError, match="frames must|checkpoint must"):
            tribos.run(POWDER, out, **bad)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="give out"):
        tribos.run(POWDER, resume=True)
    assert not out.exists()
    for call in (tribos.resume, tribos.open_run):
        with pytest.raises(ValueError, match="holds no run"):
            call(tmp_path)
    (tmp_path / "summary.json").write_text("mine")
    with pytest.raises(ValueError, match="does not say that tribos wrote it"):
        tribos.run("disk", tmp_path)
    with pytest.raises(OSError, match="cannot read the scene"):
        tribos.run("nowhere.toml")


def test_a_run_can_be_drawn() -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for scene, label in (
            ("disk", "speed"),
            ("pipe-a", "to the left [m]"),
            (POWDER, "porosity"),
        ):
            run = tribos.run(scene)
            assert run.plot().get_ylabel() == label
        # Columns of a flow, each with the band of its mean over time.
        flow = tribos.run(tribos.scene("shear-periodic", duration=0.1, average_from=0.04))
        mean = flow.summary["averages"]["stress_ratio"]
        ax = flow.plot(columns=["stress_ratio", "speed"])
        assert [line.get_label() for line in ax.lines] == ["stress_ratio", "speed"]
        low, high = ax.collections[0].get_datalim(ax.transData).intervaly
        assert low == pytest.approx(mean["mean"] - mean["error"])
        assert high == pytest.approx(mean["mean"] + mean["error"])
        assert [line.get_label() for line in flow.plot().lines] == ["solid_fraction"]


def test_spheres_of_a_gas_touch_for_no_time() -> None:
    last = tribos.run(tribos.scene("gas-haff", count=100, collisions=2)).final
    assert (
        len(last.positions) == 100 and last.contacts.shape == (0, 2) and last.normal_forces is None
    )
