"""Runs of scenes, and their results."""

from __future__ import annotations

import csv
import html
import json
import os
import shutil
import sys
import tempfile
import weakref
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tribos import _native
from tribos._scene import Scene
from tribos._states import Frames, State, read_state

Progress = Callable[["float | None", str], object]

__all__ = ["Run", "open_run", "resume", "run"]


class Run:
    """Results of a run. *Units*: those of its scene.

    Made by `run`, `resume` and `open_run`.
    """

    __slots__ = ("_columns", "_ends", "_folder", "_frames", "_held", "_rows", "_summary")

    _summary: dict[str, Any]
    _columns: tuple[str, ...]
    _rows: NDArray[np.float64]
    _folder: Path | None
    _held: _Held | None
    _frames: Frames
    _ends: tuple[State | None, State | None]

    def __init__(
        self,
        summary: dict[str, Any],
        columns: tuple[str, ...],
        rows: NDArray[np.float64],
        frames: Frames,
        ends: tuple[State | None, State | None],
        folder: Path | None = None,
        held: _Held | None = None,
    ) -> None:
        self._summary = summary
        self._columns = columns
        self._rows = rows
        self._frames = frames
        self._ends = ends
        self._folder = folder
        self._held = held

    @property
    def summary(self) -> dict[str, Any]:
        """The results, as summary.json of the command has them."""
        return self._summary

    @property
    def scene(self) -> Scene:
        """The scene that was run."""
        values = self._summary["scene"]
        return Scene._of(values.get("body", "disk"), values)

    @property
    def series(self) -> NDArray[Any]:
        """The course of the run: a structured array, one field a column of series.csv.

        Of a disk: time [s], speed [m/s], spin [rad/s], distance [m], angle [rad], ratio [-],
        kinetic_energy and dissipated_energy [J]; in dimensionless units without them. Of a body in the
        plane x and y [m] and vx and vy [m/s] too. Of powders and tips in the units of the scene; angles of
        tips are in degrees.
        """
        kind = np.dtype([(name, np.float64) for name in self._columns])
        return self._rows.view(kind).reshape(-1)

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns of the series."""
        return self._columns

    @property
    def frames(self) -> Frames:
        """The film of a powder or a tip: selected states from the first to the last."""
        return self._frames

    @property
    def initial(self) -> State | None:
        """The first state of a powder, to the bit."""
        return self._ends[0]

    @property
    def final(self) -> State | None:
        """The last state of a powder, to the bit."""
        return self._ends[1]

    @property
    def folder(self) -> Path | None:
        """The folder with the results; None of a run that was not given one."""
        return self._folder

    def plot(self, ax: Any = None, columns: Sequence[str] | None = None) -> Any:
        """Draw the course of the run with matplotlib; returns the axes.

        With the names of `columns` these are drawn over the first one; of grains each with a band about its mean over
        time, as wide as its standard error.
        """
        if ax is None:
            import matplotlib.pyplot as plt

            _, ax = plt.subplots()
        names = self._columns
        series = self.series
        if columns is None and "solid_fraction" in names:
            columns = ("solid_fraction",)
        if columns is not None:
            for name in columns:
                self._plot_column(ax, name)
            ax.set(xlabel=names[0])
            ax.legend()
        elif "piston_height" in names:
            ax.plot(series["time"], series["porosity"])
            ax.set(xlabel="time [sqrt(rho R^4/F_coh)]", ylabel="porosity")
        elif {"x", "y"} <= set(names):
            ax.plot(series["x"], series["y"])
            ax.set(xlabel="forward [m]", ylabel="to the left [m]")
        elif "speed" in names:
            ax.plot(series["time"], series["speed"], label="sliding")
            radius = self._summary["scene"]["radius"]
            ax.plot(series["time"], abs(series["spin"]) * radius, label="rim")
            ax.set(xlabel="time", ylabel="speed")
            ax.legend()
        else:
            for name in names[1:]:
                if name == "angle" or name.startswith("layer_"):
                    ax.plot(series["time"], series[name], label=name)
            ax.set(xlabel="time [tau]", ylabel="angle [degree]")
            ax.legend()
        return ax

    def _plot_column(self, ax: Any, name: str) -> None:
        """A column over the first one, with a band about its mean if that is known."""
        time = self.series[self._columns[0]]
        (line,) = ax.plot(time, self.series[name], label=name)
        mean = self._summary.get("averages", {}).get(name)
        if mean is not None and isinstance(mean["error"], float):
            low, high = mean["mean"] - mean["error"], mean["mean"] + mean["error"]
            ax.fill_between([mean["from"], time[-1]], low, high, color=line.get_color(), alpha=0.3)

    def _told(self) -> list[tuple[str, str]]:
        """Single results, for people."""
        rows = []
        for name, value in self._summary.items():
            if isinstance(value, float):
                rows.append((name, f"{value:.6g}"))
            elif isinstance(value, (int, str)):
                rows.append((name, str(value)))
        return rows

    def __repr__(self) -> str:
        told = self._told()[:5]
        body = self._summary["scene"].get("body", "disk")
        place = "" if self._folder is None else f", folder={str(self._folder)!r}"
        return f"Run({body}: " + ", ".join(f"{name} {value}" for name, value in told) + place + ")"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(name)}</th>"
            f"<td style='text-align:right'>{html.escape(value)}</td></tr>"
            for name, value in self._told()
        )
        body = html.escape(self._summary["scene"].get("body", "disk"))
        return f"<table><caption>tribos: {body}</caption>{rows}</table>"

    def __reduce__(self) -> tuple[Any, ...]:
        if self._folder is not None:
            return open_run, (str(self._folder),)
        parts = (self._summary, self._columns, self._rows, self._frames, self._ends)
        return Run, parts


def run(
    scene: Scene | str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    progress: bool | Progress = False,
    resume: bool = False,
    anew: bool = False,
    threads: int | None = None,
    checkpoint: float = 60.0,
    frames: int | None = None,
    allow_large: bool = False,
) -> Run:
    """Run a scene to its end.

    The interpreter's lock is free meanwhile. Ctrl-C ends the run: in a folder it leaves a checkpoint, from
    which `resume` goes on to the same bits.

    Parameters
    ----------
    scene
        A scene, the path of a scene file, or the name of a scene that comes with the program.
    out
        Folder for the files of ``tribos run``, the same bytes; without one the results are in memory only.
    progress
        Whether to show a line about the progress, or a function that is called a few times a second with
        the share that is done (None if the end is not known) and with words.
    resume
        Whether the interrupted run in `out` goes on, to the same result as without the interruption; one
        that has not begun starts, a finished one is opened.
    anew
        Whether an interrupted run in `out` is discarded.
    threads
        Number of threads; those of `set_num_threads` if None. No result depends on it.
    checkpoint
        Time between checkpoints of a powder or a tip, in s.
    frames
        Largest number of frames of a powder or a tip, 0 for none; None for 100, or the number that the run
        began with.
    allow_large
        Whether to run if more than 4 GB of memory is expected.

    Raises
    ------
    ValueError
        The scene or the folder cannot be used.
    KeyboardInterrupt
        The run was interrupted.
    RuntimeError
        The run failed: a number left its range, or a folder was moved away.
    OSError
        The disk is full.

    Examples
    --------
    >>> import tribos
    >>> puck = tribos.run(tribos.SliderScene(speed=1.0, spin=5.0))
    >>> round(puck.summary["distance"], 4)      # m
    0.1769
    >>> round(float(puck.series["speed"][0]), 4)      # m/s
    1.0
    """
    if threads is not None and threads < 1:
        raise ValueError(f"threads must be 1 or more, not {threads}")
    known = of(scene)
    name, text = type(known).__name__, known.to_toml()
    if out is None:
        if resume or anew:
            raise ValueError("resume and anew need the folder of the run: give out")
        made = _native.run_at_once(name, text)
        if made is not None:
            summary, columns, rows = made
            return Run(summary, tuple(columns), rows, Frames(None), (None, None))
    elif resume and not Path(out).is_dir():
        # Nothing is there yet: it starts.
        resume = False
    held = None if out is not None else _Held()
    folder = Path(held.name if held is not None else os.fspath(out))  # type: ignore[arg-type]
    line = Line() if progress is True else None
    told = line if isinstance(progress, bool) else progress
    try:
        _native.run_scene(
            name,
            text,
            folder,
            resume=resume,
            anew=anew,
            checkpoint=checkpoint,
            frames=frames,
            allow_large=allow_large,
            pictures=held is None,
            threads=threads,
            progress=told,
            stop=None,
        )
    except KeyboardInterrupt:
        if held is None:
            raise
        reason = "interrupted; a run without a folder keeps nothing: give out to go on later"
        raise KeyboardInterrupt(reason) from None
    finally:
        if line is not None:
            line.end()
    return _opened(folder, held)


def resume(out: str | os.PathLike[str], **options: Any) -> Run:
    """Go on with the interrupted run in a folder; a finished one is opened. Options are those of `run`."""
    values = _native.folder_scene(Path(out))
    if values is None:
        raise ValueError(f"{os.fspath(out)} holds no run")
    return run(Scene._of(values.get("body", "disk"), values), out, resume=True, **options)


def open_run(folder: str | os.PathLike[str]) -> Run:
    """The finished run in a folder, of `run` or of the command."""
    place = Path(folder)
    if _native.folder_scene(place) is None:
        raise ValueError(f"{place} holds no run")
    if not (place / "summary.json").exists():
        raise ValueError(f'the run in {place} is not finished; tribos.resume("{place}") goes on')
    return _opened(place, None)


def _opened(folder: Path, held: _Held | None) -> Run:
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    with (folder / "series.csv").open(encoding="utf-8", newline="") as file:
        columns = tuple(next(csv.reader(file)))
        rows = np.loadtxt(file, delimiter=",", ndmin=2).reshape(-1, len(columns))
    ends = read_state(folder, "initial"), read_state(folder, "final")
    frames = Frames(folder / "frames")
    return Run(summary, columns, rows, frames, ends, None if held is not None else folder, held)


class _Held:
    """A folder that goes with the last object that holds it."""

    def __init__(self) -> None:
        self.name = tempfile.mkdtemp(prefix="tribos-")
        weakref.finalize(self, shutil.rmtree, self.name, ignore_errors=True)


def of(scene: Scene | str | os.PathLike[str]) -> Scene:
    """A scene as it was given: itself, a file, or one that comes with the program."""
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, str) and not os.path.exists(scene):
        known = {name: text for name, text, _ in _native.library_scenes()}
        if scene in known:
            return Scene.from_toml(known[scene], name=scene)
    return Scene.read(scene)


class Line:
    """The progress as one line on standard error, written again and again."""

    BAR = 20
    WIDTH = 100

    def __init__(self) -> None:
        self.length = 0

    def __call__(self, done: float | None, words: str) -> None:
        head = ""
        if done is not None:
            full = int(min(max(done, 0.0), 1.0) * self.BAR)
            head = f"[{'=' * full:<{self.BAR}}] {done:4.0%} "
        text = (head + words)[: self.WIDTH]
        print(f"\r{text:<{self.length}}", end="", file=sys.stderr, flush=True)
        self.length = len(text)

    def end(self) -> None:
        """Leaves the line."""
        if self.length:
            print(file=sys.stderr)
