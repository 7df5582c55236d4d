#!/usr/bin/env python3
"""Makes docs/engines.md: simulators against the reference answers.

    pip install mujoco drake pybullet
    make -C engines/mujoco
    engines/box3d/run.sh BOX3D
    engines/jolt/run.sh JOLT
    python3 engines/ranking/rank.py [--rows FOLDER] [--engines NAME ...]

BOX3D and JOLT are git checkouts at the commits that the scripts name; their results stay in target/engines, from where they
are read here. All others run here, one after the other, which takes some minutes: the Python packages under the Python of
this script, MuJoCo's repair if its plugin is built, and Rapier by the example `answers` of tribos-rapier. Whatever is missing is left out, and the page says so. The page has the time of a step: nothing else should
run. --rows keeps the raw rows in a folder and takes from there what is there already.
"""

import argparse
import csv
import math
import platform
import statistics
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

from scenes import EXACT, THROWN, compare

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PAGE = ROOT / "docs" / "engines.md"
# Shown in this order; the first three, which every engine with faces has, give the rank.
RANKED = ("puck", "box", "plank")
FACES = (*RANKED, "ring", "bar", "tall")
FEET = ("tripod", "three_ball_low", "three_ball")
TIMEOUT = 3600  # s
# An error of ten times the answer: the simulation diverges.
ABSURD = 10.0
NAMES = {"box3d": "box3d", "jolt": "Jolt"}


@dataclass
class Way:
    """An engine in one setting."""

    engine: str
    way: str
    repaired: bool
    values: dict = field(default_factory=dict)


def python(name):
    return [sys.executable, str(HERE / f"in_{name}.py")]


COMMANDS = {
    "mujoco": python("mujoco"),
    "drake": python("drake"),
    "bullet": python("bullet"),
    "rapier": [
        "cargo",
        "run",
        "--quiet",
        "--release",
        "--manifest-path=engines/Cargo.toml",
        "-p",
        "tribos-rapier",
        "--example",
        "answers",
        "tests/answers/v1",
    ],
}


class Missing(Exception):
    """An engine that is not there."""


def run(name):
    """The CSV of an engine."""
    try:
        done = subprocess.run(
            COMMANDS[name], cwd=ROOT, capture_output=True, text=True, timeout=TIMEOUT
        )
    except FileNotFoundError:
        raise Missing(f"{COMMANDS[name][0]} is not installed") from None
    except subprocess.TimeoutExpired:
        raise Missing(f"it takes more than {TIMEOUT} s") from None
    sys.stderr.write(done.stderr)
    if done.returncode:
        raise Missing((done.stderr.strip().splitlines() or ["it fails"])[-1])
    return done.stdout


def parse(text):
    lines = text.splitlines()
    engine = lines[0].removeprefix("# ")
    ways = {}
    for row in csv.DictReader(lines[1:]):
        way = ways.setdefault(row["way"], Way(engine, row["way"], row["repaired"] == "1"))
        way.values[row["scene"], float(row["spin_rad_s"]), row["quantity"]] = float(row["value"])
    return list(ways.values())


def from_run(name):
    """The results of engines/<name>/run.sh."""
    script = (ROOT / "engines" / name / "run.sh").read_text().splitlines()
    commit = next(line.removeprefix("commit=") for line in script if line.startswith("commit="))
    engine = f"{NAMES[name]} {commit[:8]}, MIT, steps of 1/240 s"
    found = []
    for state, way, repaired in (("before", "as it is", False), ("after", "friction.diff", True)):
        path = ROOT / "target" / "engines" / name / state / "answers.csv"
        try:
            found.append(Way(engine, way, repaired, compare.read(path)))
        except (OSError, ValueError):
            file = path.relative_to(ROOT)
            raise Missing(f"no whole {file}; engines/{name}/run.sh makes it") from None
    return found


def spins_of(way, scene):
    return sorted(
        {spin for name, spin, quantity in way.values if name == scene and quantity == "along_m"},
        key=abs,
    )


def place_errors(way, scene):
    """Distance between the places of rest over the displacement, by spin."""
    off = compare.errors(EXACT, way.values)
    return [
        math.hypot(off[scene, spin, "along_m"], off[scene, spin, "left_m"])
        for spin in spins_of(way, scene)
        if (scene, spin, "along_m") in off
    ]


def turn_errors(way, scene):
    off = compare.errors(EXACT, way.values)
    return [
        abs(off[scene, spin, "turn_rad"])
        for spin in spins_of(way, scene)
        if spin and (scene, spin, "turn_rad") in off
    ]


def percent(errors):
    """The mean; a diverged launch spoils it."""
    if not errors:
        return "–"
    mean = statistics.fmean(errors)
    return (
        "diverges"
        if not mean < ABSURD
        else f"{100 * mean:.2g}"
        if mean < 0.995
        else f"{100 * mean:.0f}"
    )


def rank(way):
    errors = [
        statistics.fmean(place_errors(way, scene)) for scene in RANKED if place_errors(way, scene)
    ]
    mean = statistics.fmean(errors) if len(errors) == len(RANKED) else math.inf
    return math.inf if math.isnan(mean) else mean


def name_of(way):
    short = way.engine.split(",")[0]
    return f"{short}, {way.way}" + (" (repaired)" if way.repaired else "")


def summary(ways, scenes, errors):
    lines = ["| engine | " + " | ".join(scenes) + " |", "|---" * (len(scenes) + 1) + "|"]
    for way in ways:
        cells = [percent(errors(way, scene)) for scene in scenes]
        if any(cell != "–" for cell in cells):
            lines.append(f"| {name_of(way)} | " + " | ".join(cells) + " |")
    return lines


def along_table(ways, scene):
    spins = sorted(
        {spin for name, spin, quantity in EXACT if name == scene and quantity == "along_m"}, key=abs
    )
    head = ["engine", *(f"{spin:g} rad/s" for spin in spins)]
    exact = [
        f"{EXACT[scene, spin, 'along_m']:.4f}, {1e3 * EXACT[scene, spin, 'left_m']:+.1f}"
        for spin in spins
    ]
    lines = [
        "| " + " | ".join(head) + " |",
        "|---" * len(head) + "|",
        "| exact: along in m, left in mm | " + " | ".join(exact) + " |",
    ]
    for way in ways:
        cells = []
        for spin in spins:
            along = way.values.get((scene, spin, "along_m"))
            left = way.values.get((scene, spin, "left_m"))
            if along is None:
                cells.append("–")
            elif not abs(along / EXACT[scene, spin, "along_m"] - 1) < ABSURD:
                cells.append("diverges")
            else:
                cells.append(
                    f"{100 * (along / EXACT[scene, spin, 'along_m'] - 1):+.1f} %, {1e3 * left:+.1f}"
                )
        if any(cell != "–" for cell in cells):
            lines.append(f"| {name_of(way)} | " + " | ".join(cells) + " |")
    return lines


def other_table(ways):
    lines = [
        "| engine | ball: rolling speed, % | capsule: creep, µm/s | disk spun down: turn, % | time of a step, µs |",
        "|---|---|---|---|---|",
    ]
    for way in ways:
        off = compare.errors(EXACT, way.values)
        ball = [
            abs(error)
            for (scene, _, quantity), error in off.items()
            if quantity == "rolling_speed_m_s"
        ]
        creep = way.values.get(("capsule", 0.0, "creep_m_s"))
        creep = "–" if creep is None else "falls" if creep > 2e-3 else f"{1e6 * creep:.3g}"
        cost = way.values.get(("cost", 50.0, "step_us"))
        cost = "–" if cost is None else f"{cost:.3g}"
        cells = [percent(ball), creep, percent(turn_errors(way, "spin_down")), cost]
        if any(cell != "–" for cell in cells):
            lines.append(f"| {name_of(way)} | " + " | ".join(cells) + " |")
    return lines


def page(ways, missing):
    ways = sorted(ways, key=rank)
    engines = sorted({way.engine for way in ways})
    out = [
        "# Simulators against the reference answers",
        "",
        "Made by `python3 engines/ranking/rank.py`, which runs the scenes of [tests/answers](../tests/answers/README.md) in the",
        "simulators that are installed. The problems and their answers do not depend on any of them, nor on this library: anyone can",
        "repeat the comparison with `tests/answers/compare.py`. *Repaired* engines have the friction of this library: the MuJoCo plugin",
        "`tribos.patch`, `tribos-rapier`, and the diffs for box3d and Jolt.",
        "",
        *(f"- {engine}" for engine in engines),
        *(f"- {name}: skipped, {reason}" for name, reason in missing.items()),
        "",
        f"Python {platform.python_version()}, {platform.system()} on {platform.machine()}.",
        "",
        "## Where bodies with faces come to rest",
        "",
        "Distance from the exact place of rest in % of the displacement, mean over the spins 0, 5, 12.5, 25 and 50 rad/s; the engines",
        "are in the order of the mean over the first three columns.",
        "",
        *summary(ways, FACES, place_errors),
        "",
        "Error of the angle turned until rest, in %, mean over the spins other than 0:",
        "",
        *summary(ways, FACES, turn_errors),
        "",
        "## Bodies on three points",
        "",
        "Place of rest and angle in the same way. Such bodies have no faces: engines with Coulomb's law at points can be right without repair.",
        "",
        *summary(ways, FEET, place_errors),
        "",
        *summary(ways, FEET, turn_errors),
        "",
        "## Other scenes, and the price of a step",
        "",
        "The time is the least of several runs of one sliding puck (Drake's points: of the tripod), each a mean over its steps, on a machine",
        "that did other work as well; that of Python packages contains the call of a step where they have no call for many.",
        "",
        *other_table(ways),
        "",
        "## Throw by throw",
        "",
        "Error of the displacement along the launch in %, displacement to the left in mm.",
    ]
    for scene in THROWN:
        if scene != "spin_down":
            out += ["", f"### {scene}", "", *along_table(ways, scene)]
    out += [
        "",
        "## How the engines were set up",
        "",
        "- One body of 1 kg, no restitution, no damping, no sleep, half a second to settle, then the launch. Flat bodies are 2 cm high with",
        "  their centre of mass in the plane of contact, as the problems have it.",
        "- `ring` is a full cylinder in engines alone, which most of them carry on points of the rim, and under the two diffs, where its whole face counts.",
        "- Cylinders are prisms of 16 sides in box3d; such a puck itself goes up to 1 % less far.",
        "- The bar is a box of 2 mm width. Feet are balls of 1 cm radius; `tribos.patch` and `tribos-rapier` have a disk of their own on each.",
        "- Jolt's body on feet has no manifold reduction (`mUseManifoldReduction`), which would make one contact of the three; the diff leaves",
        "  contacts of one point as they are.",
        "- `tall` under `tribos.patch` and `tribos-rapier` has a uniform pressure, which does not follow the moment of friction: the body goes straight.",
        "- MuJoCo loses the contacts of a cylinder that spins exactly upright for tens of milliseconds, in which it drops or is thrown up by 1 to 2 mm",
        "  (`spin_down`). Under `tribos.patch` a puck that slides tilts enough to keep all three.",
        "- Rapier's contacts of an upright cylinder now and then have a normal that is 2° to 9° off for a step, alone as with `tribos-rapier`, which throws the",
        "  body up: `puck` and `ring` alone and `ring` with the patch at 12.5 rad/s, `puck` with the patch at 50.",
        "- Drake: its points serve bodies on feet, hydroelastic contact (1e7 Pa) those with faces, with the default contact approximation.",
        "- Place and angle are read half a second later than 1.5 times the exact time until rest after the launch.",
        "",
    ]
    return "\n".join(out)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    names = (*COMMANDS, *NAMES)
    parser.add_argument("--rows", type=Path)
    parser.add_argument("--engines", nargs="+", choices=names, default=names)
    args = parser.parse_args()
    ways, missing = [], {name: "not asked for" for name in names if name not in args.engines}
    for name in args.engines:
        try:
            if name in NAMES:
                ways += from_run(name)
                continue
            kept = args.rows / f"{name}.csv" if args.rows else None
            if kept and kept.exists():
                text = kept.read_text()
            else:
                print(f"running {name}", file=sys.stderr, flush=True)
                text = run(name)
                if kept:
                    args.rows.mkdir(parents=True, exist_ok=True)
                    kept.write_text(text)
            ways += parse(text)
            if name == "mujoco" and not any(way.repaired for way in parse(text)):
                missing["MuJoCo's plugin"] = "it is not built; make -C engines/mujoco builds it"
        except Missing as reason:
            missing[name] = str(reason)
    PAGE.write_text(page(ways, missing))
    print(PAGE)


if __name__ == "__main__":
    main()
