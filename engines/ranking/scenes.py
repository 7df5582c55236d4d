#!/usr/bin/env python3
"""The scenes of the reference answers as simulators need them, and how a throw is measured.

As a program it prints them for simulators without Python, one launch a line: name, shape, six sizes, mu, gravity, height of
the shape's middle, of the centre of mass above that, moments of inertia about a level and the upright axis, speed, spin and
duration, in SI units for 1 kg.
"""

import csv
import importlib.util
import math
import sys
from dataclasses import dataclass
from pathlib import Path

ANSWERS = Path(__file__).resolve().parent.parent.parent / "tests" / "answers"
sys.path.insert(0, str(ANSWERS))

import compare  # noqa: E402

VERSION = "v1"
CREEP = ANSWERS.parent.parent / "bindings" / "python" / "benches" / "hold.py"
# Half the height of a flat body, whose centre of mass lies in the plane of contact; radius of a foot;
# half width of the bar.
HALF_HEIGHT, FOOT, BLADE = 0.01, 0.01, 0.001  # m
MASS = 1.0  # kg
# Below these speeds, as fractions of the launch, a body rests.
STILL = 1e-3
SETTLE = 0.5  # s


@dataclass(frozen=True)
class Scene:
    """A body thrown on a plane."""

    name: str
    numbers: dict
    spins: tuple
    feet: tuple

    @property
    def mu(self):
        return self.numbers["mu"]

    @property
    def gravity(self):
        return self.numbers["g"]

    @property
    def speed(self):
        return self.numbers["speed"]

    @property
    def height(self):
        """Centre of mass above the ground."""
        return self.numbers.get("height", 0.0)

    @property
    def radius(self):
        return self.numbers.get("radius")

    @property
    def half_height(self):
        """Of the shape."""
        if self.feet:
            return FOOT
        return self.height if self.name == "tall" else HALF_HEIGHT

    @property
    def half_sides(self):
        if "corner_1_x" in self.numbers:
            return self.numbers["corner_1_x"], self.numbers["corner_1_y"]
        return (self.numbers["end_1_x"], BLADE) if self.name == "bar" else None

    @property
    def gyration_sq(self):
        given = self.numbers["gyration_sq"]
        if given != "uniform":
            return given
        x, y = self.half_sides
        return x * x / 3 if self.name == "bar" else (x * x + y * y) / 3

    @property
    def inertia(self):
        """Principal moments about the centre of mass; those of level axes matter where the body tilts."""
        upright = MASS * self.gyration_sq
        level = 0.5 * upright + MASS * self.height**2 / 3
        return max(level, 0.55 * upright), max(level, 0.55 * upright), upright

    def exact(self, spin, quantity):
        return EXACT[self.name, spin, quantity]


def read():
    found = {}
    with open(ANSWERS / VERSION / "problems.csv", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["scene"], {})[row["parameter"]] = row["value"]
    scenes = {}
    for name, texts in found.items():
        spins = tuple(float(spin) for spin in texts.pop("spins").split())
        numbers = {key: text if text == "uniform" else float(text) for key, text in texts.items()}
        feet = tuple(
            (numbers[f"foot_{i}_x"], numbers[f"foot_{i}_y"])
            for i in (1, 2, 3)
            if f"foot_{i}_x" in numbers
        )
        scenes[name] = Scene(name, numbers, spins, feet)
    return scenes


EXACT = compare.answers(VERSION)
SCENES = read()
THROWN = [name for name in SCENES if name not in ("ball", "capsule")]


def follow(scene, spin, simulator):
    """Throws the body and yields its rows.

    The simulator has dt, launch(speed, spin), step(), pose(), which gives x, y, yaw, and motion(): speed, spin.
    """
    simulator.launch(scene.speed, spin)
    x0, y0, yaw = simulator.pose()
    turned, stop = 0.0, math.nan
    longest = 1.5 * scene.exact(spin, "stop_s") + 0.5
    unit = scene.speed or math.sqrt(scene.gyration_sq) * abs(spin)
    for i in range(math.ceil(longest / simulator.dt)):
        simulator.step()
        now = simulator.pose()[2]
        turned += math.remainder(now - yaw, math.tau)
        yaw = now
        speed, rate = simulator.motion()
        is_still = math.hypot(speed, math.sqrt(scene.gyration_sq) * rate) < STILL * unit
        if not is_still:
            stop = math.nan
        elif math.isnan(stop):
            stop = (i + 1) * simulator.dt
    x, y, _ = simulator.pose()
    if getattr(simulator, "has_failed", bool)():
        x = y = turned = stop = math.nan
    values = {"along_m": x - x0, "left_m": y - y0, "turn_rad": turned, "stop_s": stop}
    for quantity, value in values.items():
        yield [scene.name, f"{spin:g}", quantity, f"{value:.9g}"]


def roll(scene, spin, simulator):
    """The speed of a thrown ball after twice the time in which it should roll."""
    simulator.launch(scene.speed, spin)
    for _ in range(math.ceil(2 * scene.exact(spin, "slide_s") / simulator.dt)):
        simulator.step()
    yield [scene.name, f"{spin:g}", "rolling_speed_m_s", f"{simulator.motion()[0]:.9g}"]


def creep(simulate):
    """Of the pinched capsule, by the bench that publishes it, which needs MuJoCo.

    `simulate` takes the bench and the grip and gives the displacement.
    """
    spec = importlib.util.spec_from_file_location("hold", CREEP)
    hold = importlib.util.module_from_spec(spec)
    sys.modules["hold"] = hold
    try:
        spec.loader.exec_module(hold)
    except ImportError as error:
        print(f"no creep: {error}", file=sys.stderr)
        return
    speed = simulate(hold, SCENES["capsule"].numbers["grip"]) / hold.SECONDS
    yield ["capsule", "0", "creep_m_s", f"{speed:.6g}"]


def shape_of(scene):
    """Name of a shape and its sizes: half sides, radius, or places of feet."""
    if scene.feet:
        return "feet", [size for foot in scene.feet for size in foot]
    if scene.half_sides:
        return "box", scene.half_sides
    return ("ball" if scene.name == "ball" else "cylinder"), [scene.radius]


def launch_lines():
    for scene in SCENES.values():
        if scene.name == "capsule":
            continue
        is_ball = scene.name == "ball"
        middle = scene.radius if is_ball else scene.half_height
        low = 0.0 if is_ball else scene.height - middle
        level, _, upright = [0.4 * MASS * scene.radius**2] * 3 if is_ball else scene.inertia
        shape, sizes = shape_of(scene)
        sizes = [*sizes, *[0.0] * (6 - len(sizes))]
        about = [*sizes, scene.mu, scene.gravity, middle, low, level, upright, scene.speed]
        for spin in scene.spins:
            seconds = (
                2 * scene.exact(spin, "slide_s")
                if is_ball
                else 1.5 * scene.exact(spin, "stop_s") + 0.5
            )
            yield " ".join([scene.name, shape, *(f"{x:.9g}" for x in (*about, spin, seconds))])


def print_results(engine, results):
    """A line that names the engine, its version, licence and step, then CSV; results are (way, repaired, rows)."""
    print(f"# {engine}")
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["way", "repaired", "scene", "spin_rad_s", "quantity", "value"])
    for way, repaired, rows in results:
        for row in rows:
            writer.writerow([way, int(repaired), *row])
        sys.stdout.flush()


if __name__ == "__main__":
    print("\n".join(launch_lines()))
