#!/usr/bin/env python3
"""Tables of an engine before and after joint friction, beside the exact answers, as Markdown.

    compare.py EXACT.csv RESULTS_DIR

RESULTS_DIR holds before/ and after/, each with throws.csv, rest.csv and tests.txt (the last lines of the engine's own
tests), and cost.csv with the rounds of both, which were run in turn.
"""

import csv
import statistics
import sys
from pathlib import Path

STATES = ("before", "after")


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def throws_by_launch(path):
    """(body, rate, spin) -> travel, left, turn."""
    key = lambda row: (row["body"], float(row["rate_hz"]), float(row["spin_rad_s"]))
    value = lambda row: tuple(float(row[name]) for name in ("travel_m", "left_m", "turn_rad"))
    return {key(row): value(row) for row in rows(path)}


def percent(part, whole):
    return f"{100.0 * part / whole:+.1f}"


def throw_table(exact, engine, rate):
    """One line for each body and spin at this rate of steps."""
    head = ["body", "spin", "exact: travel", "turn", "left"]
    for state in STATES:
        head += [f"{state}: travel", "error", "beyond", "turn", "left"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    launches = [(body, spin) for body, at, spin in engine["before"] if at == rate]
    for body, spin in launches:
        travel, left, turn = exact[body, spin]
        cells = [body, f"{spin:g}", f"{travel:.4f}", f"{turn:.2f}", f"{1e3 * left:.1f}"]
        for state in STATES:
            went, aside, turned = engine[state][body, rate, spin]
            own = engine[state][body, rate, 0.0][0] - exact[body, 0.0][0]
            cells += [
                f"{went:.4f}",
                percent(went - travel, travel),
                percent(went - own - travel, travel),
                f"{turned:.2f}",
                f"{1e3 * aside:.1f}",
            ]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def rest_table(results):
    before, after = (rows(results / state / "rest.csv") for state in STATES)
    lines = ["| scene | quantity | before | after |", "|---|---|---|---|"]
    for old, new in zip(before, after, strict=True):
        assert (old["scene"], old["quantity"]) == (new["scene"], new["quantity"])
        values = f"{float(old['value']):.4g} | {float(new['value']):.4g}"
        lines.append(f"| {old['scene']} | {old['quantity']} | {values} |")
    return lines


def cost_table(path):
    """Least and median time of both, and the ratio within a round."""
    lines = [
        "| scene | before: least, median | after: least, median | least/least | ratio in a round: median, quartiles |",
        "|---|---|---|---|---|",
    ]
    measured = rows(path)
    for scene in dict.fromkeys(row["scene"] for row in measured):
        old, new = (
            [float(row[state]) for row in measured if row["scene"] == scene] for state in STATES
        )
        ratios = [after / before for before, after in zip(old, new, strict=True)]
        low, middle, high = statistics.quantiles(ratios, n=4) if len(ratios) > 1 else 3 * ratios
        times = [f"{min(t):.0f}, {statistics.median(t):.0f} µs" for t in (old, new)]
        spread = f"{middle:.3f}, {low:.3f} to {high:.3f}"
        lines.append(
            f"| {scene} | {times[0]} | {times[1]} | {min(new) / min(old):.3f} | {spread} |"
        )
    return lines


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results = Path(sys.argv[2])
    exact = {
        (row["body"], float(row["spin_rad_s"])): tuple(
            float(row[name]) for name in ("travel_m", "left_m", "turn_rad")
        )
        for row in rows(sys.argv[1])
    }
    engine = {state: throws_by_launch(results / state / "throws.csv") for state in STATES}
    out = ["# Thrown bodies", ""]
    out += [
        "Travel in m, error in % of the exact travel, turn in rad, displacement to the left in mm; launch at 1 m/s,",
        "spin in rad/s. *Beyond* leaves out the engine's own error of time: what the same body misses without spin,",
        "half a step at the speed of the launch.",
    ]
    for rate in sorted({rate for _, rate, _ in engine["before"]}):
        out += ["", f"## {rate:g} steps a second", ""] + throw_table(exact, engine, rate)
    out += ["", "# Rest and slopes", ""] + rest_table(results)
    out += ["", "# Time of a step", ""] + cost_table(results / "cost.csv")
    out += ["", "# The engine's own tests", ""]
    for state in STATES:
        lines = (results / state / "tests.txt").read_text().rstrip().splitlines()
        out += [f"{state.capitalize()}:", "", *("    " + line for line in lines), ""]
    print("\n".join(out).rstrip())


if __name__ == "__main__":
    main()
