#!/usr/bin/env python3
"""Errors of a simulator against the reference answers, as a Markdown table.

    python3 compare.py RESULTS.csv [--answers v1]

RESULTS.csv has the columns scene, spin_rad_s, quantity, value, as `v1/answers.csv`; rows may be missing. Needs Python
3.10 alone.
"""

import argparse
import csv
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
KEY = ("scene", "spin_rad_s", "quantity")


def read(path):
    """(scene, spin, quantity) -> value."""
    with open(path, newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        missing = {*KEY, "value"} - set(rows.fieldnames or ())
        if missing:
            raise ValueError(
                f"{path} has no column {sorted(missing)[0]}; it needs {', '.join(KEY)} and value"
            )
        found = {}
        for number, row in enumerate(rows, start=2):
            try:
                key = row["scene"], float(row["spin_rad_s"]), row["quantity"]
                found[key] = float(row["value"])
            except ValueError as error:
                raise ValueError(f"{path}, row {number}: {error}") from None
        return found


def answers(version="v1"):
    return read(HERE / version / "answers.csv")


def is_displacement(quantity):
    return quantity in ("along_m", "left_m")


def unit_of(exact, scene, spin, quantity):
    """What an error is relative to: the whole displacement for its components, else the answer."""
    if is_displacement(quantity):
        return math.hypot(exact[scene, spin, "along_m"], exact[scene, spin, "left_m"])
    return abs(exact[scene, spin, quantity])


def errors(exact, got):
    """(scene, spin, quantity) -> relative error; absolute where the answer is zero."""
    found = {}
    for key, value in got.items():
        if key in exact:
            unit = unit_of(exact, *key)
            found[key] = (value - exact[key]) / unit if unit else value - exact[key]
    return found


def table(exact, got):
    lines = [
        "| scene | spin, rad/s | quantity | exact | yours | error |",
        "|---|---|---|---|---|---|",
    ]
    for key, error in errors(exact, got).items():
        scene, spin, quantity = key
        text = f"{100 * error:+.3g} %" if unit_of(exact, *key) else f"{error:+.3g}"
        lines.append(
            f"| {scene} | {spin:g} | {quantity} | {exact[key]:.6g} | {got[key]:.6g} | {text} |"
        )
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("results", type=Path)
    parser.add_argument("--answers", default="v1", help="version of the set")
    args = parser.parse_args()
    try:
        exact, got = answers(args.answers), read(args.results)
    except (OSError, ValueError) as error:
        sys.exit(f"compare.py: {error}")
    unknown = [key for key in got if key not in exact]
    print(table(exact, got))
    for scene, spin, quantity in unknown:
        print(f"compare.py: no answer for {scene}, {spin:g} rad/s, {quantity}", file=sys.stderr)
    if len(unknown) == len(got):
        sys.exit("compare.py: nothing to compare")


if __name__ == "__main__":
    main()
