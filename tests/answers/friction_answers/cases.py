"""Cases of the problems: the standard ones, and random ones by seed. Parameters in SI units, angles in rad."""

import csv
import math
import random
from pathlib import Path

G = 9.81  # m/s^2
HERE = Path(__file__).resolve().parent
# Beside the package in the sources, in it once it is installed.
DATA = next(path for path in (HERE / "v1", HERE.parent / "v1") if path.exists()).parent


def first_problems():
    """Parameters of the twelve problems of version 1 by name, with a list of spins."""
    found = {}
    with open(DATA / "v1" / "problems.csv", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["scene"], {})[row["parameter"]] = row["value"]
    for texts in found.values():
        spins = [float(spin) for spin in texts.pop("spins").split()]
        texts.update({key: text if text == "uniform" else float(text) for key, text in texts.items()})
        texts["spins"] = spins
    return found


def angle(mu, share):
    """A share of the angle of friction."""
    return share * math.atan(mu)


def standard():
    """Item -> its cases by name."""
    cases = {}
    for name, problem in first_problems().items():
        problem = dict(problem)
        spins = problem.pop("spins")
        cases[name] = {f"{spin:g}": {**problem, "spin": spin} for spin in spins}
    box = dict(first_problems()["box"], speed=1.0, offset_x=0.008, offset_y=0.005)
    del box["spins"]
    block = {"mu": 0.5, "g": G, "seconds": 1.0}
    swing = dict(block, frequency=10.0, seconds=1.0, angle=angle(0.5, 0.5))
    down = {"mu": 0.3, "g": G, "height": 0.0, "speed": 0.0}
    roll = {"mu": 0.2, "g": G, "radius": 0.03, "speed": 1.0}
    table = {"mu": 0.3, "g": G, "radius": 0.04, "distance": 0.3}
    hit = {"mu": 0.2, "radius": 0.05, "speed": 1.0, "angle": math.pi / 6}
    for case in cases["ring"].values():
        case["is_ring"] = True
    return cases | {
        "incline_holds": {f"{share:g}": dict(block, angle=angle(0.5, share)) for share in (0.9, 0.99)},
        "incline_slides": {f"{share:g}": dict(block, angle=angle(0.5, share)) for share in (1.01, 1.1)},
        # Largest pull along the slope, in what friction holds.
        "vibration_holds": {f"{share:g}": dict(swing, swing=held_swing(swing, share)) for share in (0.95,)},
        "vibration_slips": {f"{share:g}": dict(swing, swing=held_swing(swing, share)) for share in (1.3, 2.0)},
        "turntable_holds": {f"{share:g}": dict(table, rate=math.sqrt(share * 0.3 * G / 0.3), seconds=1.0) for share in (0.9,)},
        "turntable_slips": {f"{share:g}": dict(table, rate=math.sqrt(share * 0.3 * G / 0.3), seconds=0.6) for share in (1.2, 2.0)},
        # The load stays in the middle third of the lower block.
        "tower": {f"{ratio:g}": dict(mu=0.5, g=G, ratio=ratio, angle=angle(0.5, 0.2), seconds=1.0) for ratio in (1e2, 1e4, 1e6)},
        "eccentric": {f"{spin:g}": dict(box, spin=spin) for spin in (12.5, 25.0, 50.0)},
        "stack": {f"{speed:g}": dict(mu=0.3, g=G, speed=speed) for speed in (0.5, 0.8)},
        "oblique": {f"{degrees:g}": dict(mu=0.3, g=G, speed=1.0, direction=math.radians(degrees)) for degrees in (22.5, 45.0)},
        "skate": {f"{degrees:g}": dict(mu=0.1, mu_across=0.4, g=G, speed=1.0, direction=math.radians(degrees)) for degrees in (30.0, 60.0)},
        "collide": {f"{spin:g}": dict(hit, spin=spin) for spin in (-20.0, 5.0, 40.0)},
        "top": {"20": dict(down, radius=0.01, gyration_sq=0.0008, spin=20.0)},
        "wheel": {"10": dict(mu=0.3, g=G, radius=0.05, half_width=0.02, spin=10.0)},
        "torsion": {"20": dict(roll, torsion=0.001, spin=20.0)},
        "belts": {f"{speed:g}": dict(mu=0.3, g=G, half_x=0.08, half_y=0.05, speed=speed, seconds=0.4) for speed in (0.1, 0.3)},
        "back_spin": {"-60": dict(roll, spin=-60.0), "-200": dict(roll, spin=-200.0)},
    }


def held_swing(case, share):
    """Amplitude of the swing with which the pull along the slope is a share of what friction holds."""
    held = case["mu"] * case["g"] * math.cos(case["angle"])
    return share * held - case["g"] * math.sin(case["angle"])


def drawn(item, seed):
    """A random case: each number of a standard one, drawn anew, changed by up to a fifth, and its spin by up to a half."""
    cases = list(standard()[item].values())
    cases = [case for case in cases if case.get("spin") != 0.0] or cases
    draw = random.Random(f"{item} {seed}")
    case = dict(cases[draw.randrange(len(cases))])
    fixed = ("g", "gyration_sq", "seconds", "is_ring")
    for key, value in case.items():
        if key not in fixed and isinstance(value, float) and not key.startswith(("corner", "end", "foot")):
            case[key] = value * (1.0 + (0.5 if key == "spin" else 0.2) * (2.0 * draw.random() - 1.0))
    if "corner_1_x" in case:
        x, y = case["corner_1_x"], case["corner_1_y"] * (1.0 + 0.4 * (draw.random() - 0.5))
        for i, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1)), 1):
            case[f"corner_{i}_x"], case[f"corner_{i}_y"] = sx * x, sy * y
    return kept(item, case)


def kept(item, case):
    """The same on the item's side of its threshold, and well away from it."""
    low, high = (0.5, 0.99) if item.endswith("holds") else (1.05, 2.5)

    def within(value, limit):
        return min(max(value, low * limit), high * limit)

    if item.startswith("incline"):
        case["angle"] = within(case["angle"], math.atan(case["mu"]))
    elif item.startswith("vibration"):
        # The pull stays below friction uphill, where the block would slip both ways.
        up = case["g"] * (case["mu"] * math.cos(case["angle"]) + math.sin(case["angle"]))
        case["angle"] = min(case["angle"], angle(case["mu"], 0.6))
        least, most = held_swing(case, low), held_swing(case, high)
        case["swing"] = min(max(case["swing"], least), most, 0.99 * up)
    elif item.startswith("turntable"):
        case["rate"] = math.sqrt(within(case["rate"] ** 2 * case["distance"], case["mu"] * case["g"]) / case["distance"])
    elif item == "tall":
        # The pressure stays positive at the rim.
        case["mu"] = min(case["mu"], 0.95 * case["radius"] / (4 * case["height"]))
    elif item == "tower":
        case["angle"] = min(case["angle"], 0.1)
    elif item == "stack":
        # The upper block neither falls nor tips.
        case["speed"] = min(case["speed"], math.sqrt(8 * case["mu"] * case["g"] * 0.03))
    elif item == "eccentric":
        # The pressure stays positive at every corner.
        for key, half in (("offset_x", "corner_1_x"), ("offset_y", "corner_1_y")):
            case[key] = min(case[key], case[half] / 7)
    return case
