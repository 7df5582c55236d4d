"""A tribometer's record, stroke by stroke."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tribos import _native
from tribos._checks import number, positive
from tribos._log import read

_SHOWN = 6


@dataclass(frozen=True, eq=False)
class Strokes:
    """The strokes of a record. Friction is positive where it resists; NaN stands where there is no number.

    Attributes
    ----------
    start, duration : numpy.ndarray
        Time of the first row of each stroke, and time to its last row, in s.
    direction : numpy.ndarray
        1 forward, -1 backward.
    length, speed : numpy.ndarray
        Distance in m and mean speed in m/s.
    peak, peak_time : numpy.ndarray
        Static peak, and its time in s.
    mean, deviation : numpy.ndarray
        Mean and standard deviation of the friction in the steady part.
    slips, drop, period : numpy.ndarray
        Stick-slip: number of slips, their mean fall, and the mean time between them in s.
    cut_off : numpy.ndarray of bool
        Strokes that the record cuts off; the summary leaves them out.
    rows : numpy.ndarray
        First row and row after the last one of each stroke, of shape (n, 2).
    resistance : numpy.ndarray
        Friction of each row of the record, positive where it resists within a stroke; NaN between strokes.
    summary : dict of str to float
        Over the complete strokes after the run-in: ``strokes``, ``mean`` with its standard ``error`` and
        the ``deviation`` between strokes, ``offset`` of the directions (half of forward less backward), ``peak`` and
        ``peak_deviation``, ``slips``, ``drop``, ``period``; and the ``distance`` of all strokes in m.
    run_in : int
        Number of strokes of the run-in.
    settled : str
        The run-in in words.
    divided_by : str
        ``"velocity"``, ``"position"``, ``"sign of the friction"`` or ``"nothing"``.
    noise : float
        Standard deviation of the noise on the friction, row by row.
    notes : tuple of str
        What was assumed, and what the record does not tell.
    """

    start: Any = field(repr=False)
    duration: Any = field(repr=False)
    direction: Any = field(repr=False)
    length: Any = field(repr=False)
    speed: Any = field(repr=False)
    peak: Any = field(repr=False)
    peak_time: Any = field(repr=False)
    mean: Any = field(repr=False)
    deviation: Any = field(repr=False)
    slips: Any = field(repr=False)
    drop: Any = field(repr=False)
    period: Any = field(repr=False)
    cut_off: Any = field(repr=False)
    rows: Any = field(repr=False)
    resistance: Any = field(repr=False)
    summary: dict[str, float]
    run_in: int
    settled: str
    divided_by: str
    noise: float
    notes: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.start)

    def __repr__(self) -> str:
        told = self.summary
        lines = [
            f"<{len(self)} strokes, divided by the {self.divided_by}>",
            "  number  start [s]  direction  length [m]      mean  deviation      peak  slips",
        ]
        half = _SHOWN // 2
        for at in range(len(self)):
            if len(self) > _SHOWN and half <= at < len(self) - half:
                if at == half:
                    lines.append("       …")
                continue
            lines.append(
                f"  {at + 1:6d} {self.start[at]:10.4g} {self.direction[at]:10.0f}"
                f" {self.length[at]:11.4g} {self.mean[at]:9.4g} {self.deviation[at]:10.3g}"
                f" {self.peak[at]:9.4g} {self.slips[at]:6.0f}"
            )
        lines.append(f"  run-in      {self.settled}")
        lines.append(
            f"  mean        {told['mean']:.5g} ± {told['error']:.2g} over {told['strokes']:.0f} "
            f"strokes, which scatter by {told['deviation']:.2g}"
        )
        lines.append(
            f"  static peak {told['peak']:.4g}, which scatters by {told['peak_deviation']:.2g}"
        )
        lines.append(f"  offset      {told['offset']:.3g}")
        lines.append(
            f"  stick-slip  {told['slips']:.0f} slips of {told['drop']:.4g}, "
            f"one every {told['period']:.4g} s"
            if told["slips"]
            else "  stick-slip  none"
        )
        lines.extend(f"  note        {note}" for note in self.notes)
        return "\n".join(lines)


def strokes(
    data: Any,
    *,
    columns: Mapping[str, str | int] | None = None,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
    load: float | None = None,
    middle: float = 0.5,
    shortest_rest: float = 0.0,
) -> Strokes:
    """Take the record of a reciprocating tribometer or of a start-stop test apart, stroke by stroke.

    Parameters
    ----------
    data
        A table with the columns ``t`` in s and ``f``, a coefficient or a force in N, of either sign or
        a magnitude; with ``v`` in m/s or ``x`` in m or both, and perhaps ``load`` in N, by which f is
        divided. A mapping of columns, a structured array, a data frame, or the path of a CSV file as in `fit`.
        Without v and x strokes are divided by the sign of f.
    columns, units, skip
        As in `fit`.
    load
        Load in N at which f was measured as a force, where it has no column.
    middle
        Share of the way of a stroke, about its middle, over which friction is averaged.
    shortest_rest
        Shortest rest in s that divides strokes of one direction; at least five rows.

    Notes
    -----
    Nothing is fitted. Strokes begin and end at 5 % of the largest speed, or six standard deviations of
    its noise. The run-in ends where leaving out more strokes does not lower the standard error of the mean
    (marginal standard error rule, White 1997), if what is left out differs from the rest. A slip is a fall of more
    than ten standard deviations of the noise and 2 % of the friction, twice as fast as the rise before.

    Examples
    --------
    >>> import numpy as np
    >>> import tribos
    >>> t = np.arange(0.0, 40.0, 0.01)
    >>> sign = np.where(t % 4.0 < 2.0, 1.0, -1.0)
    >>> found = tribos.strokes({"t": t, "v": 0.005 * sign, "f": 6.0 * sign + 0.2}, load=20.0)
    >>> len(found), round(found.summary["mean"], 3), round(found.summary["offset"], 3)
    (20, 0.3, 0.01)
    """
    wanted = [(name, name in "tf", False) for name in ("t", "f", "v", "x")]
    table = read(data, [*wanted, ("load", False, True)], columns, units, skip).columns
    loads = table.get("load")
    if load is not None:
        if loads is not None:
            raise ValueError("the column load and the argument load are both given; leave one out")
        loads = np.full(table["t"].shape, positive("load", load))
    more = (
        None if values is None else values.tolist()
        for values in (table.get("v"), table.get("x"), loads)
    )
    measured = (table["t"].tolist(), table["f"].tolist(), *more)
    made = _native.strokes_of(
        measured, positive("middle", middle), number("shortest_rest", shortest_rest)
    )
    lists = {name: np.array(values) for name, values in made["lists"].items() if name != "number"}
    lists["cut_off"] = lists["cut_off"] > 0.0
    return Strokes(
        **lists,
        rows=np.array(made["rows"], dtype=np.intp).reshape(-1, 2),
        resistance=np.array(made["resistance"]),
        summary=dict(made["summary"]),
        run_in=made["after"],
        settled=made["run_in"],
        divided_by=made["divided_by"],
        noise=made["noise"],
        notes=tuple(made["notes"]),
    )
