#!/usr/bin/env python3
"""Makes docs/engines.md: simulators against the reference answers.

    pip install mujoco drake pybullet
    make -C engines/mujoco
    engines/box3d/run.sh BOX3D
    engines/jolt/run.sh JOLT
    python3 engines/ranking/rank.py [--rows FOLDER] [--engines NAME ...]
    python3 engines/ranking/rank.py --page

BOX3D and JOLT are git checkouts at the commits that the scripts name; their results stay in target/engines, from where they
are read here. All others run here, one after the other, which takes some minutes: the Python packages under the Python of
this script, MuJoCo's repair if its plugin is built, and Rapier by the example `answers` of tribos-rapier. Whatever is missing
is left out, and the page says so. The page has the time of a step: nothing else should run. --rows keeps the raw rows in a
folder and takes from there what is there already.

The results go to docs/tables/engines.csv and engines-throws.csv, the page and its picture are made from these two: --page
does this alone, without any engine.
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

from picture import drawn, stops
from scenes import EXACT, THROWN, compare

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PAGE = ROOT / "docs" / "engines.md"
PICTURE = ROOT / "docs" / "pictures" / "engines.svg"
# Of docs/games.md: a puck by an engine alone and with this library's friction.
STOPS = ROOT / "docs" / "pictures" / "puck-stops.svg"
SHOWN = (("Rapier", "alone"), ("Rapier", "tribos-rapier"))
MEANS = ROOT / "docs" / "tables" / "engines.csv"
THROWS = ROOT / "docs" / "tables" / "engines-throws.csv"
# Shown in this order; the first three, which every engine with faces has, give the rank.
RANKED = ("puck", "box", "plank")
FACES = (*RANKED, "ring", "bar", "tall")
FEET = ("tripod", "three_ball_low", "three_ball")
TIMEOUT = 3600  # s
# An error of ten times the answer: the simulation diverges.
ABSURD = 10.0
BAD = 10  # %
CREEPS = 1.0  # µm/s
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
        return ""
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


def means(way):
    """A row of engines.csv."""
    engine, about = way.engine.split(", ", 1)
    off = compare.errors(EXACT, way.values)
    ball = [abs(error) for (_, _, name), error in off.items() if name == "rolling_speed_m_s"]
    creep = way.values.get(("capsule", 0.0, "creep_m_s"))
    cost = way.values.get(("cost", 50.0, "step_us"))
    return {
        "engine": engine,
        "setting": way.way,
        "repaired": int(way.repaired),
        "about": about,
        "run_on": f"Python {platform.python_version()}, {platform.system()} on {platform.machine()}",
        **{
            f"place_percent_{scene}": percent(place_errors(way, scene)) for scene in (*FACES, *FEET)
        },
        **{
            f"turn_percent_{scene}": percent(turn_errors(way, scene))
            for scene in (*FACES, *FEET, "spin_down")
        },
        "ball_rolling_speed_percent": percent(ball),
        "capsule_creep_um_s": ""
        if creep is None
        else "falls"
        if creep > 2e-3
        else f"{1e6 * creep:.3g}",
        "step_us": "" if cost is None else f"{cost:.3g}",
    }


def throws(ways):
    """Rows of engines-throws.csv."""
    rows = []
    for scene in THROWN:
        spins = {spin for name, spin, quantity in EXACT if (name, quantity) == (scene, "along_m")}
        for spin in sorted(spins, key=abs):
            if scene == "spin_down":
                continue
            along, left = EXACT[scene, spin, "along_m"], EXACT[scene, spin, "left_m"]
            here = {"scene": scene, "spin_rad_s": f"{spin:g}"}
            exact = {"engine": "exact", "along_m": f"{along:.4f}", "left_mm": f"{1e3 * left:+.1f}"}
            rows.append({**here, **exact})
            for way in ways:
                found = way.values.get((scene, spin, "along_m"))
                if found is None:
                    continue
                off, left = found / along - 1, way.values[scene, spin, "left_m"]
                rows.append(
                    {
                        **here,
                        "engine": way.engine.split(",")[0],
                        "setting": way.way,
                        **(
                            {"along_percent": f"{100 * off:+.1f}", "left_mm": f"{1e3 * left:+.1f}"}
                            if abs(off + 1) < ABSURD
                            else {"along_percent": "diverges"}
                        ),
                    }
                )
    return rows


def written(path, columns, rows):
    path.parent.mkdir(exist_ok=True)
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def number(cell):
    """Of a cell that has one: infinite where the simulation diverges."""
    return math.inf if cell in ("diverges", "falls") else float(cell)


def mean_of(row, quantity, scenes):
    cells = [row[f"{quantity}_percent_{scene}"] for scene in scenes]
    return statistics.fmean(map(number, cells)) if all(cells) else None


def shown(cell, note=""):
    """An error in %, bold where it is bad."""
    return (f"**{plain(cell)}**" if cell and number(cell) > BAD else plain(cell)) + note


def plain(cell):
    """A number as people read it."""
    if not cell or not math.isfinite(number(cell)):
        return cell or "–"
    return "<0.001" if 0 < number(cell) < 1e-3 else f"{number(cell):g}"


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"] + [
        "| " + " | ".join(cells) + " |" for cells in rows
    ]


def place_table(rows):
    shapes = (*RANKED, "tall", "three_ball")
    head = ["engine", *RANKED, "tall", "balls", "angle"]
    cells = []
    for row in rows:
        angle = mean_of(row, "turn", RANKED)
        errors = [shown(row[f"place_percent_{scene}"], note_of(row, scene)) for scene in shapes]
        angle = "" if angle is None else f"{angle:.2g}"
        cells.append([name_of(row), *errors, shown(angle)])
    return table(head, cells)


def note_of(row, scene):
    """The mark of the note that concerns a cell."""
    own = row["setting"] in ("plugin tribos.patch", "tribos-rapier")
    return "¹" if scene == "tall" and own else ""


def other_table(rows):
    head = ["engine", "ball, %", "disk, %", "capsule, µm/s", "step, µs"]
    cells = []
    for row in rows:
        ball, angle = row["ball_rolling_speed_percent"], row["turn_percent_spin_down"]
        creep = row["capsule_creep_um_s"]
        creeps = creep and number(creep) > CREEPS
        creep = f"**{plain(creep)}**" if creeps else plain(creep)
        cells.append([name_of(row), shown(ball), shown(angle), creep, plain(row["step_us"])])
    return table(head, cells)


def name_of(row):
    short = f"{row['engine'].split()[0]}, {row['setting'].removeprefix('plugin ')}"
    return short + (" \\*" if row["repaired"] == "1" else "")


def span(rows, quantity, scenes=RANKED):
    """The least and the largest mean over the scenes, in %."""
    found = [mean_of(row, quantity, scenes) for row in rows]
    found = [float(f"{mean:.2g}") for mean in found if mean is not None]
    return f"{min(found):g} to {max(found):g} %" if found else "–"


def page(rows):
    bare = [row for row in rows if row["repaired"] == "0"]
    mended = [row for row in rows if row["repaired"] == "1"]
    diffs = [row for row in mended if row["setting"] == "friction.diff"]
    engines = sorted({f"{row['engine']}, {row['about']}" for row in rows})
    known = {"MuJoCo", "Drake", "Bullet", "Rapier", *NAMES.values()}
    absent = sorted(known - {row["engine"].split()[0] for row in rows})
    return "\n".join(
        [
            "# Simulators against exact answers",
            "",
            f"Simulators as they are stop a spinning puck, box or plank {span(bare, 'place')} of its way off, and miss the angle that it turns by",
            f"{span(bare, 'turn')}. With the friction of this library the errors are {span(mended, 'place')} and {span(mended, 'turn')}. The",
            "[problems and their answers](../tests/answers/README.md) depend on no simulator and not on this library:",
            "`python3 tests/answers/compare.py RESULTS.csv` judges yours.",
            "",
            "![Twelve set-ups from the best to the worst; marks show by how much each body misses its place of rest](pictures/engines.svg)",
            "",
            "## Where bodies come to rest",
            "",
            "Distance from the exact place of rest in % of the displacement, mean over five spins. *Angle*: error of the angle turned until rest, in %, mean",
            f"of puck, box and plank over the spins other than 0. **Bold**: more than {BAD} %. \\*: friction of this library. Order: mean of puck, box and plank.",
            "",
            *place_table(rows),
            "",
            "- ¹ The pressure of `tribos.patch` and `tribos-rapier` is uniform and does not lean with the body, which goes straight in place of its curve.",
            "- *balls* (`three_ball`) stand on three points. Coulomb's law at points is right for them, and engines can be right without repair.",
            "",
            "Ring, bar and tripod, the angles of every body: [engines.csv](tables/engines.csv). Every throw: [engines-throws.csv](tables/engines-throws.csv).",
            "",
            "## Other scenes, and the time of a step",
            "",
            "*ball*: error of the speed with which it rolls after sliding. *disk*: error of the angle in which a disk that only spins stops. *capsule*: creep of",
            "one that is held between two pads, which should be 0. *step*: the least of several runs of one sliding puck (Drake's points: of the tripod), each a",
            "mean over its steps, on a machine that did other work as well; with Python packages it contains the call where they have no call for many steps.",
            "",
            *other_table(rows),
            "",
            "MuJoCo loses the contacts of a cylinder that spins exactly upright for tens of milliseconds, in which it drops or is thrown up by 1 to 2 mm: hence",
            "its error for the disk, with the plugin as without. A puck that slides tilts enough to keep all contacts under the plugin.",
            "",
            "## How the engines were set up",
            "",
            *(f"- {engine}" for engine in engines),
            *(f"- {name}: not run" for name in absent),
            "",
            "One body of 1 kg, no restitution, no damping, no sleep, half a second to settle, then the launch. Flat bodies are 2 cm high with their centre of",
            "mass in the plane of contact, as the problems have it. Place and angle are read half a second later than 1.5 times the exact time until rest.",
            "",
            "- `ring` is a full cylinder in engines alone, which most of them carry on points of the rim, and under the two diffs, where its whole face counts:",
            f"  they miss its angle by {span(diffs, 'turn', ['ring'])}.",
            "- Jolt's body on feet has no manifold reduction (`mUseManifoldReduction`), which would make one contact of the three; the diff leaves contacts of",
            "  one point as they are.",
            "- Cylinders are prisms of 16 sides in box3d; such a puck itself goes up to 1 % less far.",
            "- The bar is a box of 2 mm width. Feet are balls of 1 cm radius; `tribos.patch` and `tribos-rapier` have a disk of their own on each.",
            "- Rapier's contacts of an upright cylinder now and then have a normal that is 2° to 9° off for a step, alone as with `tribos-rapier`, which throws",
            "  the body up: `puck` and `ring` alone, `ring` with the patch at 12.5 rad/s, `puck` with the patch at 50.",
            "- Drake: its points serve bodies on feet, hydroelastic contact (1e7 Pa) those with faces, with the default contact approximation.",
            "",
            "## Run it again",
            "",
            "`engines/ranking/rank.py` says in its first lines what to install, runs every simulator that it finds, and writes this page. The friction of this",
            "library is the plugin [`tribos.patch`](mujoco.md) in MuJoCo, [`tribos-rapier`](games.md) in Rapier, and the diffs for box3d and Jolt, which put",
            "[one projection a manifold](inside-an-engine.md) into the engine.",
            "",
            "## Limits",
            "",
            "Each simulator was run with one step and one set of options, said above; smaller steps make some of them better. A time of a step is that of one",
            "body, which says little of a world of a thousand.",
            "",
        ]
    )


def from_tables():
    """The page and the pictures, by file."""
    rows = list(csv.DictReader(MEANS.read_text().splitlines()))
    faces = [f"place_percent_{scene}" for scene in FACES]
    feet = [f"place_percent_{scene}" for scene in FEET]
    marks = [
        (
            f"{row['engine']}, {row['setting']}",
            row["repaired"] == "1",
            [number(row[key]) for key in faces if row[key]],
            [number(row[key]) for key in feet if row[key]],
        )
        for row in rows
    ]
    files = {PAGE: page(rows), PICTURE: drawn(marks, BAD)}
    found = lanes()
    return {**files, STOPS: stops(found, "Rapier alone", "with its patch")} if found else files


def lanes():
    """Spin, exact travel and that of the ways that are shown, of a puck."""
    rows = {}
    for row in csv.DictReader(THROWS.read_text().splitlines()):
        if row["scene"] == "puck":
            way = row["engine"].split()[0], row["setting"]
            rows.setdefault(row["spin_rad_s"], {})[way] = row
    found = []
    for spin, ways in rows.items():
        if all(way in ways for way in SHOWN):
            exact = float(ways["exact", ""]["along_m"])
            travels = (exact * (1 + float(ways[way]["along_percent"]) / 100) for way in SHOWN)
            found.append((spin, exact, *travels))
    return found


def write_page():
    for path, text in from_tables().items():
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        print(path)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    names = (*COMMANDS, *NAMES)
    parser.add_argument("--rows", type=Path)
    parser.add_argument("--engines", nargs="+", choices=names, default=names)
    parser.add_argument("--page", action="store_true", help="from the tables, without an engine")
    args = parser.parse_args()
    if args.page:
        write_page()
        return
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
    for name, reason in missing.items():
        print(f"{name} is left out: {reason}", file=sys.stderr)
    ways = sorted(ways, key=rank)
    found = [means(way) for way in ways]
    written(MEANS, list(means(Way("none, none", "", False))), found)
    thrown = ["scene", "spin_rad_s", "engine", "setting", "along_m", "along_percent", "left_mm"]
    written(THROWS, thrown, throws(ways))
    write_page()


if __name__ == "__main__":
    main()
