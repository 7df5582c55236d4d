"""Scenes run for all combinations of some keys and seeds."""

from __future__ import annotations

import concurrent.futures
import importlib
import itertools
import multiprocessing
import os
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, overload

from tribos import _native
from tribos._run import Line, of
from tribos._scene import Scene, field_name
from tribos._threads import num_threads

Row = dict[str, Any]
LEFT_OUT = ("scene", "version", "wall_seconds")
"""Members of a summary that are no results: the input, and what differs from machine to machine."""
PAUSE = 0.1
"""Time in s from one look for signals and finished runs to the next."""


def run_case(scene: str, overrides: Mapping[str, object] | None = None, *, threads: int = 1) -> Row:
    """One run of a sweep as a row: a plain function of plain arguments, for any pool of workers.

    Parameters
    ----------
    scene
        The text of a scene file, as `Scene.to_toml` makes it.
    overrides
        Keys that replace those of the scene; the row begins with them.
    threads
        Number of threads of the run. No result depends on it.

    Returns
    -------
    dict
        The overrides, the seed of bodies that have one, and every single number and word of the summary;
        those of an inner table carry its name before theirs. A scene that is refused or whose run fails has
        the reason as ``refusal``.

    Examples
    --------
    >>> import tribos
    >>> disk = tribos.SliderScene().to_toml()
    >>> row = tribos.run_case(disk, {"spin": 0.0})
    >>> row["spin"], round(row["distance"], 4)      # rad/s, m
    (0.0, 0.1699)
    """
    return _case(scene, dict(overrides or {}), threads, None)


def _case(text: str, overrides: Row, threads: int, stop: _native.Stop | None) -> Row:
    row = dict(overrides)
    try:
        scene = Scene.from_toml(text, **{field_name(key): v for key, v in overrides.items()})
    except ValueError as refused:
        summary: dict[str, Any] = {"ending": "refused", "refusal": str(refused)}
    else:
        seed = getattr(scene, "seed", None)
        if seed is not None:
            row.setdefault("seed", seed)
        try:
            summary = _summary(scene, threads, stop)
        except (ValueError, RuntimeError) as refused:
            summary = {"ending": "refused", "refusal": str(refused)}
    for name, value in _flat(summary).items():
        # No two columns have one name: a key of the scene may be called as a result is.
        while name in row:
            name += "_result"
        row[name] = value
    return row


def _summary(scene: Scene, threads: int, stop: _native.Stop | None) -> dict[str, Any]:
    """The summary of a run without pictures and frames."""
    name, text = type(scene).__name__, scene.to_toml()
    made = _native.run_at_once(name, text)
    if made is not None:
        return made[0]
    import json

    with tempfile.TemporaryDirectory(prefix="tribos-") as folder:
        _native.run_scene(
            name,
            text,
            Path(folder),
            resume=False,
            anew=False,
            checkpoint=3600.0,
            frames=0,
            allow_large=False,
            pictures=False,
            threads=threads,
            progress=None,
            stop=stop,
        )
        summary: dict[str, Any] = json.loads(
            (Path(folder) / "summary.json").read_text(encoding="utf-8")
        )
    return summary


def _flat(summary: Mapping[str, Any]) -> Row:
    """Single values of a summary; lists stay out."""
    row: Row = {}
    for name, value in summary.items():
        if name in LEFT_OUT or isinstance(value, list):
            continue
        if isinstance(value, dict):
            row.update({f"{name}_{inner}": found for inner, found in _flat(value).items()})
        else:
            row[name] = value
    return row


def cases(
    scene: Scene | str | os.PathLike[str],
    keys: Mapping[str, Iterable[object]],
    *,
    seeds: int = 1,
) -> list[Row]:
    """Overrides of all runs of a sweep, the seeds changing first and the last key next.

    Parameters and refusals are those of `sweep`. Each is an argument of `run_case`.

    Examples
    --------
    >>> import tribos
    >>> tribos.cases("compaction-small", {"mu_rolling": [0, 1]}, seeds=2)
    [{'mu_rolling': 0, 'seed': 1}, {'mu_rolling': 0, 'seed': 2}, {'mu_rolling': 1, 'seed': 1}, {'mu_rolling': 1, 'seed': 2}]
    """
    text = of(scene).to_toml()
    values = {key.rstrip("_"): list(given) for key, given in keys.items()}
    for key, given in values.items():
        if isinstance(keys.get(key), str) or not given:
            raise ValueError(f"`{key}` must be a list of values")
        if len(set(map(str, given))) < len(given):
            raise ValueError(f"`{key}` takes a value twice")
    if seeds < 1:
        raise ValueError(f"seeds must be 1 or more, not {seeds}")
    combinations = [dict(zip(values, chosen)) for chosen in itertools.product(*values.values())]
    accepted: list[tuple[Row, Scene | ValueError]] = []
    for overrides in combinations:
        named: Row = {field_name(key): value for key, value in overrides.items()}
        try:
            accepted.append((overrides, Scene.from_toml(text, **named)))
        except ValueError as refused:
            accepted.append((overrides, refused))
    _refuse_vain(values, accepted)
    if seeds == 1:
        return combinations
    made: list[Row] = []
    for overrides, known in accepted:
        first = getattr(known, "seed", None)
        if first is None and isinstance(known, Scene):
            raise ValueError("this body has no seed, every run of it is the same; leave seeds out")
        first = of(scene).seed if first is None else first  # type: ignore[attr-defined]
        made += [{**overrides, "seed": first + run} for run in range(seeds)]
    return made


def _refuse_vain(
    values: Mapping[str, Sequence[object]], accepted: Sequence[tuple[Row, Scene | ValueError]]
) -> None:
    """Refuses a value that every combination with it refuses."""
    for key, given in values.items():
        for value in given:
            found = [known for overrides, known in accepted if overrides[key] is value]
            if found and all(isinstance(known, ValueError) for known in found):
                assert isinstance(found[0], ValueError)
                raise found[0]
    for _, known in accepted:
        if not values and isinstance(known, ValueError):
            raise known


@overload
def sweep(
    scene: Scene | str | os.PathLike[str],
    keys: Mapping[str, Iterable[object]],
    *,
    seeds: int = ...,
    threads: int | None = ...,
    processes: int | None = ...,
    progress: bool = ...,
    frame: Literal[False] = ...,
) -> list[Row]: ...
@overload
def sweep(
    scene: Scene | str | os.PathLike[str],
    keys: Mapping[str, Iterable[object]],
    *,
    seeds: int = ...,
    threads: int | None = ...,
    processes: int | None = ...,
    progress: bool = ...,
    frame: Literal[True],
) -> Any: ...
def sweep(
    scene: Scene | str | os.PathLike[str],
    keys: Mapping[str, Iterable[object]],
    *,
    seeds: int = 1,
    threads: int | None = None,
    processes: int | None = None,
    progress: bool = False,
    frame: bool = False,
) -> Any:
    """Run a scene for every combination of the values of its keys: the rows of runs.csv of ``tribos sweep``.

    Parameters
    ----------
    scene
        A scene, the path of a scene file, or the name of a scene that comes with the program.
    keys
        Keys of the scene, each with its values; the last one changes first.
    seeds
        Runs for each combination: the scene's seed and those after it.
    threads
        Runs at a time in this process; None for `num_threads`.
    processes
        Runs at a time, each in a process of its own, in place of threads.
    progress
        Whether to show a line about the progress.
    frame
        Whether to return a pandas DataFrame.

    Returns
    -------
    list of dict, or pandas.DataFrame
        One row a run, as `run_case` returns it, in the order of the combinations. No row depends on the
        number of threads or processes.

    Raises
    ------
    ValueError
        A value that every combination with it refuses; nothing runs then.

    Examples
    --------
    >>> import tribos
    >>> rows = tribos.sweep("disk", {"spin": [0.0, 5.0, 50.0]})
    >>> [round(row["distance"], 4) for row in rows]      # m
    [0.1699, 0.1769, 0.606]
    """
    text = of(scene).to_toml()
    jobs = cases(scene, keys, seeds=seeds)
    stop = _native.Stop()
    pool: concurrent.futures.Executor
    if processes is not None:
        context = multiprocessing.get_context("spawn")
        pool = concurrent.futures.ProcessPoolExecutor(processes, context)
        futures = [pool.submit(run_case, text, job) for job in jobs]
    else:
        pool = concurrent.futures.ThreadPoolExecutor(threads or num_threads())
        futures = [pool.submit(_case, text, job, 1, stop) for job in jobs]
    line = Line() if progress else None
    try:
        left: set[concurrent.futures.Future[Row]] = set(futures)
        while left:
            _, left = concurrent.futures.wait(
                left, PAUSE, return_when=concurrent.futures.FIRST_EXCEPTION
            )
            done = len(futures) - len(left)
            if line is not None:
                line(done / len(futures), f"{done} of {len(futures)} runs")
            failed = (one for one in futures if one.done() and one.exception() is not None)
            if any(failed):
                break
        rows = [one.result() for one in futures]
    except BaseException:
        stop.stop()
        pool.shutdown(cancel_futures=True)
        raise
    finally:
        if line is not None:
            line.end()
    pool.shutdown()
    if not frame:
        return rows
    return importlib.import_module("pandas").DataFrame(rows)
