"""The problems: what is built, what is launched, what is read, in SI units.

An item has cases (parameters by name). `scene` is what an engine builds, `measure` plays it in a simulator and gives the
quantities of `answers`.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from .scene import FOOT, Body, Scene, Shape

FLAT = 0.01  # m, half the height of flat bodies, whose centre of mass lies in the plane of contact
BLADE = 0.001  # m, half the width of a body that stands on a line
SETTLE = 0.5  # s
STILL = 1e-3  # of the launch: below this speed a body rests


@dataclass(frozen=True)
class Item:
    """A problem."""

    name: str
    mark: str  # holds, releases, travels, turns or rolls
    title: str
    scene: Callable
    measure: Callable


def horizontal(v):
    return math.hypot(v[0], v[1])


def yaw(q):
    w, x, y, z = q
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def settle(sim, dt, seconds=SETTLE):
    for _ in range(math.ceil(seconds / dt)):
        sim.step()


# ---------------------------------------------------------------- bodies thrown on the floor


def thrown_shape(case):
    """Shape, half height and least moments about level axes of a body of the first twelve problems."""
    if "foot_1_x" in case:
        feet = tuple((case[f"foot_{i}_x"], case[f"foot_{i}_y"]) for i in (1, 2, 3))
        return Shape("feet", feet), FOOT
    if "end_1_x" in case:
        return Shape("box", (case["end_1_x"], BLADE, FLAT)), FLAT
    if "corner_1_x" in case:
        return Shape("box", (case["corner_1_x"], case["corner_1_y"], FLAT)), FLAT
    half = case["height"] or FLAT
    return Shape("cylinder", (case["radius"], half), case.get("is_ring", False)), half


def gyration_sq(case):
    if case["gyration_sq"] != "uniform":
        return case["gyration_sq"]
    x, y = (case["end_1_x"], 0.0) if "end_1_x" in case else (case["corner_1_x"], case["corner_1_y"])
    return (x * x + y * y) / 3


def thrown(case):
    shape, half = thrown_shape(case)
    upright = gyration_sq(case)
    level = max(0.5 * upright + case["height"] ** 2 / 3, 0.55 * upright)
    com = (case.get("offset_x", 0.0), case.get("offset_y", 0.0), case["height"] - half)
    place = (-com[0], -com[1], half)
    body = Body("body", shape, place, 1.0, (level, level, upright), com)
    needs = {"feet"} if shape.kind == "feet" else set()
    return Scene((body,), case["mu"], (0.0, 0.0, -case["g"]), needs=frozenset(needs))


def throw(sim, dt, case, seconds):
    """Settles, launches, and reads where the body comes to rest."""
    settle(sim, dt)
    spin, speed = case["spin"], case["speed"]
    sim.set(0, (speed, 0.0, 0.0), (0.0, 0.0, spin))
    (x0, y0, _), q, _, _ = sim.state(0)
    angle, turned, stop = yaw(q), 0.0, math.nan
    arm = math.sqrt(gyration_sq(case))
    unit = speed or arm * abs(spin)
    for i in range(math.ceil((1.5 * seconds + 0.5) / dt)):
        sim.step()
        _, q, v, w = sim.state(0)
        now = yaw(q)
        turned += math.remainder(now - angle, math.tau)
        angle = now
        if math.hypot(horizontal(v), arm * w[2]) >= STILL * unit:
            stop = math.nan
        elif math.isnan(stop):
            stop = (i + 1) * dt
    (x, y, _), _, _, _ = sim.state(0)
    return {"along_m": x - x0, "left_m": y - y0, "turn_rad": turned, "stop_s": stop}


# ---------------------------------------------------------------- a ball


def ball(case):
    r = case["radius"]
    body = Body("ball", Shape("ball", (r,)), (0.0, 0.0, r), 1.0, (0.4 * r * r,) * 3)
    needs = {"torsion"} if case.get("torsion") else set()
    return Scene((body,), case["mu"], (0.0, 0.0, -case["g"]), torsion=case.get("torsion", 0.0), needs=frozenset(needs))


def roll(sim, dt, case, seconds):
    """Launches a ball and reads its speed, and place, after twice the time in which it begins to roll."""
    settle(sim, dt)
    sim.set(0, (case["speed"], 0.0, 0.0), (0.0, case["spin"], 0.0))
    x0 = sim.state(0)[0][0]
    steps = math.ceil(2 * seconds / dt)
    for _ in range(steps):
        sim.step()
    place, _, v, _ = sim.state(0)
    # The rest of the time that does not fit the steps is rolled.
    along = place[0] - x0 + v[0] * (2 * seconds - steps * dt)
    return {"rolling_speed_m_s": v[0], "along_m": along}


def spin_down(sim, dt, case, seconds):
    settle(sim, dt)
    sim.set(0, (0.0, 0.0, 0.0), (0.0, 0.0, case["spin"]))
    turned, stop = 0.0, math.nan
    for i in range(math.ceil((1.5 * seconds + 0.5) / dt)):
        before = sim.state(0)[3][2]
        sim.step()
        w = sim.state(0)[3][2]
        turned += 0.5 * (before + w) * dt
        if abs(w) >= STILL * abs(case["spin"]):
            stop = math.nan
        elif math.isnan(stop):
            stop = (i + 1) * dt
    return {"turn_rad": turned, "stop_s": stop}


# ---------------------------------------------------------------- blocks on a slope, shaken, stacked


def cube(case, half=0.05, mass=1.0, name="body", height=None):
    inertia = (mass * 2 * half * half / 3,) * 3
    return Body(name, Shape("box", (half,) * 3), (0.0, 0.0, height or half), mass, inertia)


def slope(case):
    return Scene((cube(case),), case["mu"], (0.0, 0.0, -case["g"]), needs=frozenset({"gravity"}))


def tilted(case, sideways=0.0):
    return (
        case["g"] * math.sin(case["angle"]) + sideways,
        0.0,
        -case["g"] * math.cos(case["angle"]),
    )


def slide_down(sim, dt, case, seconds):
    """The block feels the slope from one step to the next. It may strain while its contacts are loaded, not creep."""
    settle(sim, dt)
    sim.gravity(tilted(case))
    steps = math.ceil(seconds / dt)
    half = steps // 2
    x0 = sim.state(0)[0][0]
    middle = x0
    for i in range(steps):
        sim.step()
        if i + 1 == half:
            middle = sim.state(0)[0][0]
    x = sim.state(0)[0][0]
    scale = (seconds / (steps * dt)) ** 2
    return {"along_m": (x - x0) * scale, "creep_m_s": (x - middle) / ((steps - half) * dt)}


def shake(sim, dt, case, seconds):
    """The slope swings along itself: in its frame gravity does."""
    settle(sim, dt)
    x0 = sim.state(0)[0][0]
    rate = math.tau * case["frequency"]
    for i in range(round(seconds / dt)):
        swing = case["swing"] * math.sin(rate * (i + 0.5) * dt)
        sim.gravity(tilted(case, swing))
        sim.step()
    return {"along_m": sim.state(0)[0][0] - x0, "creep_m_s": (sim.state(0)[0][0] - x0) / seconds}


def stack(case):
    lower, upper = cube(case, name="lower"), cube(case, name="upper", height=0.15)
    return Scene((lower, upper), case["mu"], (0.0, 0.0, -case["g"]))


def pull_away(sim, dt, case, seconds):
    """The lower of two blocks is launched, the upper one is carried along late."""
    settle(sim, dt)
    sim.set(0, (case["speed"], 0.0, 0.0), (0.0, 0.0, 0.0))
    start = [sim.state(i)[0][0] for i in (0, 1)]
    settle(sim, dt, 1.5 * seconds + 0.5)
    lower, upper = (sim.state(i)[0][0] - start[i] for i in (0, 1))
    return {"lower_m": lower, "upper_m": upper}


def tower(case):
    ratio = case["ratio"]
    lower, upper = cube(case, name="lower"), cube(case, 0.05, ratio, "upper", 0.15)
    return Scene((lower, upper), case["mu"], (0.0, 0.0, -case["g"]), needs=frozenset({"gravity"}))


def bear(sim, dt, case, seconds):
    """A light block bears a heavy one on a slope."""
    settle(sim, dt)
    sim.gravity(tilted(case))
    settle(sim, dt, seconds / 2)
    before = sim.state(1)[0]
    settle(sim, dt, seconds / 2)
    after = sim.state(1)[0]
    return {"sink_m": 0.15 - after[2], "creep_m_s": (after[0] - before[0]) / (seconds / 2)}


# ---------------------------------------------------------------- driven ground


def box_on(case, height):
    x, y = case["half_x"], case["half_y"]
    upright = (x * x + y * y) / 3
    return Body("box", Shape("box", (x, y, FLAT)), (0.0, 0.0, height + FLAT), 1.0, (0.55 * upright,) * 2 + (upright,), (0.0, 0.0, -FLAT))


def belts(case):
    """Two long plates side by side along x, with a box across the line between them."""
    plates = tuple(
        Body(f"belt_{i}", Shape("box", (4.0, 1.0, 0.05)), (0.0, side * 1.0, -0.05), 1e3, (334.0, 5334.0, 5667.0), is_driven=True)
        for i, side in enumerate((1.0, -1.0), 1)
    )
    return Scene((box_on(case, 0.0), *plates), case["mu"], (0.0, 0.0, -case["g"]), has_floor=False, needs=frozenset({"driven"}))


def convey(sim, dt, case, seconds):
    still = (0.0, 0.0, 0.0)
    for body in (1, 2):
        sim.set(body, still, still)
    settle(sim, dt)
    sim.set(1, (case["speed"], 0.0, 0.0), still)
    sim.set(2, (-case["speed"], 0.0, 0.0), still)
    angle, turned = yaw(sim.state(0)[1]), 0.0
    (x0, y0, _) = sim.state(0)[0]
    steps = math.ceil(seconds / dt)
    for _ in range(steps):
        sim.step()
        now = yaw(sim.state(0)[1])
        turned += math.remainder(now - angle, math.tau)
        angle = now
    place, _, _, w = sim.state(0)
    turned += w[2] * (seconds - steps * dt)
    return {"turn_rad": turned, "drift_m": math.hypot(place[0] - x0, place[1] - y0)}


def turntable(case):
    plate = Body("plate", Shape("cylinder", (2.0, 0.05)), (0.0, 0.0, -0.05), 1e3, (1e3, 1e3, 2e3), is_driven=True)
    r = case["radius"]
    upright = 0.5 * r * r
    puck = Body("puck", Shape("cylinder", (r, FLAT)), (case["distance"], 0.0, FLAT), 1.0, (0.55 * upright,) * 2 + (upright,), (0.0, 0.0, -FLAT))
    return Scene((puck, plate), case["mu"], (0.0, 0.0, -case["g"]), has_floor=False, needs=frozenset({"driven"}))


def ride(sim, dt, case, seconds):
    """The puck moves with the table from the first moment; where it ends says whether the table holds it."""
    still = (0.0, 0.0, 0.0)
    sim.set(1, still, still)
    settle(sim, dt)
    rate = case["rate"]
    place = sim.state(0)[0]
    sim.set(1, still, (0.0, 0.0, rate))
    sim.set(0, (-rate * place[1], rate * place[0], 0.0), (0.0, 0.0, rate))
    steps = math.ceil(seconds / dt)
    for _ in range(steps):
        sim.step()
    place, _, v, _ = sim.state(0)
    left = seconds - steps * dt
    end = math.hypot(place[0] + v[0] * left, place[1] + v[1] * left)
    return {"distance_m": end, "creep_m_s": (end - case["distance"]) / seconds}


# ---------------------------------------------------------------- others


def collide(case):
    r = case["radius"]
    inertia = (0.4 * r * r,) * 3
    away = 2.5 * r
    sin, cos = math.sin(case["angle"]), math.cos(case["angle"])
    # The line of centres leans by the angle from the direction of the first ball's motion when they touch.
    first = Body("first", Shape("ball", (r,)), (-2 * r * cos - away, -2 * r * sin, 1.0), 1.0, inertia)
    second = Body("second", Shape("ball", (r,)), (0.0, 0.0, 1.0), 1.0, inertia)
    return Scene((first, second), case["mu"], (0.0, 0.0, 0.0), has_floor=False)


def meet(sim, dt, case, _):
    sim.set(0, (case["speed"], 0.0, 0.0), (0.0, 0.0, case["spin"]))
    settle(sim, dt, 5 * case["radius"] / case["speed"] + 0.2)
    _, _, v, w = sim.state(0)
    _, _, other, turn = sim.state(1)
    return {"along_m_s": v[0], "left_m_s": v[1], "spin_rad_s": w[2], "other_along_m_s": other[0], "other_left_m_s": other[1], "other_spin_rad_s": turn[2]}


def wheel(case):
    """A cylinder on its side: its axis is along y at the start."""
    r, half = case["radius"], case["half_width"]
    about, axial = (3 * r * r + 4 * half * half) / 12, 0.5 * r * r
    half_turn = math.sqrt(0.5)
    body = Body("wheel", Shape("cylinder", (r, half)), (0.0, 0.0, r), 1.0, (about, about, axial), pose=(half_turn, half_turn, 0.0, 0.0))
    return Scene((body,), case["mu"], (0.0, 0.0, -case["g"]))


def skate(case):
    upright = 2 * 0.05**2 / 3
    body = Body("box", Shape("box", (0.05, 0.05, FLAT)), (0.0, 0.0, FLAT), 1.0, (0.55 * upright,) * 2 + (upright,), (0.0, 0.0, -FLAT))
    return Scene((body,), case["mu"], (0.0, 0.0, -case["g"]), mu_across=case["mu_across"], needs=frozenset({"anisotropic"}))


def oblique(case):
    return replace(skate({**case, "mu_across": None}), needs=frozenset())


def glide(sim, dt, case, seconds):
    settle(sim, dt)
    direction = case["direction"]
    sim.set(0, (case["speed"] * math.cos(direction), case["speed"] * math.sin(direction), 0.0), (0.0, 0.0, 0.0))
    x0, y0, _ = sim.state(0)[0]
    settle(sim, dt, 1.5 * seconds + 0.5)
    x, y, _ = sim.state(0)[0]
    return {"along_m": x - x0, "left_m": y - y0}


def pinched(case):
    """A capsule along x between two heavy pads that are pressed together along y, far from any floor."""
    r, half = 0.01, 0.5 * case["length"]
    m = case["mass"]
    about = m * (0.25 * r * r + (2 * half) ** 2 / 12)
    rod = Body("capsule", Shape("capsule", (r, half)), (0.0, 0.0, 1.0), m, (0.5 * m * r * r, about, about))
    pads = tuple(
        Body(f"pad_{i}", Shape("box", (half, 0.02, 0.02)), (0.0, side * (r + 0.02), 1.0), 1e3 * m, (1e4 * m,) * 3) for i, side in enumerate((1.0, -1.0), 1)
    )
    return Scene((rod, *pads), case["mu"], (0.0, 0.0, 0.0), has_floor=False, needs=frozenset({"capsule", "force"}))


def hang(sim, dt, case, seconds):
    """Its weight pulls the capsule, by a force, since the pads have none."""
    weight = case["mass"] * case["g"]
    steps = math.ceil((SETTLE + seconds) / dt)
    middle, first = 0.0, round(SETTLE / dt)
    for i in range(steps):
        sim.force(1, (0.0, -case["grip"], 0.0))
        sim.force(2, (0.0, case["grip"], 0.0))
        sim.force(0, (0.0, 0.0, -weight if i >= first // 2 else 0.0))
        sim.step()
        drop = 0.5 * (sim.state(1)[0][2] + sim.state(2)[0][2]) - sim.state(0)[0][2]
        if i + 1 == first:
            middle = drop
    return {"creep_m_s": (drop - middle) / ((steps - first) * dt)}


THROWN = ("puck", "ring", "box", "plank", "bar", "tripod", "three_ball", "three_ball_low", "tall")
ITEMS = {
    item.name: item
    for item in (
        Item("incline_holds", "holds", "block below the angle of friction", slope, slide_down),
        Item("vibration_holds", "holds", "block on a slope that swings", slope, shake),
        Item("turntable_holds", "holds", "puck on a turntable", turntable, ride),
        Item("capsule", "holds", "capsule between two pads", pinched, hang),
        Item("tower", "holds", "light block under a heavy one", tower, bear),
        Item("incline_slides", "releases", "block above the angle of friction", slope, slide_down),
        Item("vibration_slips", "releases", "block that walks down a slope that swings", slope, shake),
        Item("turntable_slips", "releases", "puck that leaves a turntable", turntable, ride),
        *(Item(name, "travels", f"{name} that slides and spins", thrown, throw) for name in THROWN),
        Item("eccentric", "travels", "box with its mass off its middle", thrown, throw),
        Item("stack", "travels", "block launched from under another", stack, pull_away),
        Item("oblique", "travels", "box launched across its sides", oblique, glide),
        Item("skate", "travels", "box with two coefficients", skate, glide),
        Item("collide", "travels", "two balls that collide with spin", collide, meet),
        Item("spin_down", "turns", "disk that spins down", thrown, spin_down),
        Item("top", "turns", "body that spins on a narrow foot", thrown, spin_down),
        Item("wheel", "turns", "wheel that turns in place", wheel, spin_down),
        Item("torsion", "turns", "ball under torsion", ball, spin_down),
        Item("belts", "turns", "box across two belts", belts, convey),
        Item("ball", "rolls", "ball that begins to roll", ball, roll),
        Item("back_spin", "rolls", "ball that rolls back", ball, roll),
    )
}
