#!/usr/bin/env python3
"""Makes v2/answers.csv: the answers of version 2 with 30 digits, each beside a second route.

    python3 make.py [ITEM ...]     # prints the rows
    python3 make.py --write        # all of them, into v2/answers.csv, and v2/problems.json

Needs mpmath and scipy. The second route shares no formula with the first where there is a choice: other integrators (scipy's), quadrature in polar
coordinates for faces, event times by root finding on integrated speeds, motions integrated where the first is a closed form. The column
`second` is its difference relative to the scale of the quantity. Items of version 1 keep their own answers, which
the tests find again in doubles.
"""

import argparse
import csv
import json
import math
import sys
from pathlib import Path

import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from friction_answers import numbers  # noqa: E402
from friction_answers.answers import ANSWERS, face_of  # noqa: E402
from friction_answers.cases import standard  # noqa: E402
from friction_answers.items import ITEMS  # noqa: E402
from friction_answers.units import UNITS  # noqa: E402

# Digits beyond those of the tolerance are for what cancels.
FINE, DIGITS = (10, "1e-17"), 60
EXACT = {"rtol": 3e-14, "atol": 1e-16, "method": "DOP853"}
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


# ---------------------------------------------------------------- second routes


def polar_wrench(corners, slope, mean, v, spin):
    """Wrench about the origin of a polygon with pressure (1 + slope . (r - mean))/area, by quadrature over its edges as seen from the centre of rotation."""
    c = np.array([-v[1] / spin, v[0] / spin])
    at_centre = 1 + slope @ (c - mean)
    force, torque, area = np.zeros(2), 0.0, 0.0
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        area += 0.5 * (a[0] * b[1] - a[1] * b[0])
        a, b = a - c, b - c
        tangent = (b - a) / math.hypot(*(b - a))
        normal = np.array([tangent[1], -tangent[0]])
        far = a @ normal
        if abs(far) < 1e-300:
            continue
        # t = |far| sinh s makes the integrand analytic.
        ends = [math.asinh(t / abs(far)) for t in (a @ tangent, b @ tangent)]
        panels = max(4, math.ceil(abs(ends[1] - ends[0])))
        cuts = np.linspace(*ends, panels + 1)
        s = (0.5 * (cuts[1:] + cuts[:-1])[:, None] + 0.5 * (cuts[1:] - cuts[:-1])[:, None] * NODES).ravel()
        w = (0.5 * (cuts[1:] - cuts[:-1])[:, None] * WEIGHTS).ravel()
        t, r = abs(far) * np.sinh(s), abs(far) * np.cosh(s)
        rho = far * normal + t[:, None] * tangent
        along = rho @ slope
        weight = w * r * far  # dt = r ds, and the angle is far dt/r^2
        force += (weight / r * (at_centre / 2 + along / 3)) @ np.stack([-rho[:, 1], rho[:, 0]], axis=1)
        torque += np.sum(weight * r * (at_centre / 3 + along / 4))
    sense = -math.copysign(1.0, spin) / area
    force = sense * force
    return force[0], force[1], sense * torque + c[0] * force[1] - c[1] * force[0]


def second_thrown(case):
    face = face_of(case)
    corners = np.array([a for a, _ in face.edges]) + np.array(face.middle)
    slope, mean, arm2, k = np.array(face.slope), np.array(face.middle), face.gyration_sq, case["mu"] * case["g"]

    def slopes(_, y):
        vx, vy, w, _, _, angle, _ = y
        co, si = math.cos(angle), math.sin(angle)
        fx, fy, torque = polar_wrench(corners, slope, mean, np.array([co * vx + si * vy, co * vy - si * vx]), w)
        unit = math.sqrt(vx * vx + vy * vy + arm2 * w * w) / k
        return [unit * d for d in (k * (co * fx - si * fy), k * (si * fx + co * fy), k * torque / arm2, vx, vy, w, 1)]

    # Speeds fall like exp(-time): after 34 of it they are 1e-15 of the first.
    y = solve_ivp(slopes, (0, 34), [case["speed"], 0, case["spin"], 0, 0, 0, 0], **EXACT | {"atol": 1e-18}).y[:, -1]
    return {"along_m": y[3], "left_m": y[4], "turn_rad": y[5], "stop_s": y[6]}


def slow_torque(corners, speed, spin):
    """Of a polygon whose centre of rotation is far: Gauss rules over triangles about its first corner."""
    torque, area = 0.0, 0.0
    s, t = 0.5 * (NODES[:, None] + 1), 0.5 * (NODES[None, :] + 1)
    weight = 0.25 * WEIGHTS[:, None] * WEIGHTS[None, :] * s
    for b, c in zip(corners[1:-1], corners[2:]):
        a = corners[0]
        size = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        px, py = (a[i] + s * ((b[i] - a[i]) + t * (c[i] - b[i])) for i in (0, 1))
        ux, uy = speed - spin * py, spin * px
        torque -= size * np.sum(weight * (px * uy - py * ux) / np.hypot(ux, uy))
        area += 0.5 * size
    return torque / area


def second_belts(case):
    x, y, speed = case["half_x"], case["half_y"], case["speed"]
    box = np.array([(x, y), (-x, y), (-x, -y), (x, -y)])
    k, arm2 = case["mu"] * case["g"], (x * x + y * y) / 3

    def slopes(_, state):
        angle, w = state
        co, si = math.cos(angle), math.sin(angle)
        turned = box @ np.array([[co, si], [-si, co]])
        upper = []
        for a, b in zip(turned, np.roll(turned, -1, axis=0)):
            if a[1] > 0:
                upper.append(a)
            if (a[1] > 0) != (b[1] > 0):
                upper.append(a + (b - a) * a[1] / (a[1] - b[1]))
        if abs(w) * math.hypot(x, y) < 0.3 * speed:
            return [w, k / arm2 * slow_torque(np.array(upper), -speed, w)]
        return [w, k / arm2 * polar_wrench(np.array(upper), np.zeros(2), np.zeros(2), np.array([-speed, 0.0]), w)[2]]

    def crosses(_, state):
        return state[0] + math.atan2(y, x)

    crosses.terminal = True
    run = solve_ivp(slopes, (0, case["seconds"]), [0, 0], events=crosses, **EXACT)
    if run.t[-1] < case["seconds"]:
        run = solve_ivp(slopes, (run.t[-1], case["seconds"]), run.y[:, -1] - [1e-15, 0], **EXACT)
    return {"turn_rad": run.y[0, -1], "drift_m": 0.0}


def second_turntable(case):
    """In the frame of the table, in polar coordinates of the slip."""
    k, w = case["mu"] * case["g"], case["rate"]
    out = w * w * case["distance"] - k
    if out <= 0:
        return {"distance_m": case["distance"], "creep_m_s": 0.0}

    def slopes(_, s):
        x, y, speed, way = s
        co, si = math.cos(way), math.sin(way)
        # Along the slip: centrifugal force less friction; across it: centrifugal and Coriolis force turn it.
        return [speed * co, speed * si, w * w * (x * co + y * si) - k, w * w * (y * co - x * si) / speed - 2 * w]

    t = 1e-7 / w
    way = -2 * w * t / (2 + k / out)
    end = solve_ivp(slopes, (t, case["seconds"]), [case["distance"] + out * t * t / 2, 0, out * t, way], **EXACT).y[:, -1]
    return {"distance_m": math.hypot(end[0], end[1])}


def second_vibration(case):
    """Speeds integrated numerically between events that roots of the pull and of the speed give."""
    g, a, w, end = case["g"], case["swing"], math.tau * case["frequency"], case["seconds"]
    held, steady = case["mu"] * g * math.cos(case["angle"]), g * math.sin(case["angle"])

    def pull(t):
        return steady + a * math.sin(w * t)

    if steady + abs(a) <= held:
        return {"creep_m_s": 0.0}
    place, now, step = 0.0, 0.0, 1 / case["frequency"] / 400
    while now < end:
        while now < end and abs(pull(now)) <= held:
            now += step
        if now >= end:
            break
        way = math.copysign(1.0, pull(now))
        begin = brentq(lambda t: way * pull(t) - held, now - step, now, xtol=1e-16, rtol=1e-15) if now > 0 else now

        def speed(t):
            return quad(lambda s: pull(s) - way * held, begin, t, epsabs=1e-16, epsrel=1e-14)[0]

        stop = now
        while way * speed(stop) > 0 or stop == now:
            stop += step
        stop = min(brentq(speed, stop - step, stop, xtol=1e-16, rtol=1e-15), end) if stop < end + step else end
        place += quad(lambda t: (min(stop, end) - t) * (pull(t) - way * held), begin, min(stop, end), epsabs=1e-17, epsrel=1e-14)[0]
        now = stop + 1e-12
    return {"along_m": place}


def second_oblique(case):
    """Both components of the velocity, integrated until the speed is 1e-13 of the first."""
    k, v, direction = case["mu"] * case["g"], case["speed"], case["direction"]

    def slopes(_, s):
        speed = math.hypot(s[0], s[1])
        return [-s[0], -s[1], s[0] * speed / k, s[1] * speed / k]

    y = solve_ivp(slopes, (0, 30), [v * math.cos(direction), v * math.sin(direction), 0, 0], **EXACT).y[:, -1]
    return {"along_m": y[2], "left_m": y[3]}


def second_skate(case):
    """Over the direction of the motion, in place of its speed."""
    m1, m2, g, direction = case["mu"], case["mu_across"], case["g"], case["direction"]
    k = (m2 / m1) ** 2

    def slopes(_, s):
        p, _, _ = s  # log of v1 over its start
        v1 = case["speed"] * math.cos(direction) * math.exp(p)
        v2 = case["speed"] * math.sin(direction) * math.exp(k * p)
        lasts = math.hypot(m1 * v1, m2 * v2) / (g * m1 * m1)
        return [-1.0, v1 * lasts, v2 * lasts]

    y = solve_ivp(slopes, (0, 18), [0, 0, 0], **EXACT).y[:, -1]
    return {"along_m": y[1], "left_m": y[2]}


def steady(case, slowing, spin):
    """A spin that a constant torque slows, by its equation of motion."""
    run = solve_ivp(lambda _, s: [-slowing * np.sign(spin), s[0]], (0, abs(spin) / slowing), [spin, 0.0], **EXACT)
    return {"turn_rad": run.y[1, -1], "stop_s": run.t[-1]}


def second_top(case):
    """The torque by quadrature of the elements of a disk."""
    torque = quad(lambda r: 2 * r * r, 0, case["radius"])[0] / case["radius"] ** 2
    return steady(case, case["mu"] * case["g"] * torque / case["gyration_sq"], case["spin"])


def second_wheel(case):
    half, r = case["half_width"], case["radius"]
    torque = quad(lambda x: x / half, 0, half)[0]
    # Of a cylinder across its axis, by quadrature of disks.
    arm2 = quad(lambda x: (r * r / 4 + x * x) / half, 0, half)[0]
    return steady(case, case["mu"] * case["g"] * torque / arm2, case["spin"])


def second_torsion(case):
    r = case["radius"]
    arm2 = quad(lambda z: 0.5 * (r * r - z * z) ** 2, -r, r)[0] / quad(lambda z: r * r - z * z, -r, r)[0]
    return steady(case, case["torsion"] * case["g"] / arm2, case["spin"])


def second_rolls(case):
    """The motion of a ball with its friction, integrated until it rolls."""
    k, r = case["mu"] * case["g"], case["radius"]

    def slopes(_, s):
        way = np.sign(s[1] - s[2] * r)
        return [s[1], -way * k, way * k * r / (0.4 * r * r)]

    def rolls(_, s):
        return s[1] - s[2] * r

    rolls.terminal = True
    run = solve_ivp(slopes, (0, 100), [0, case["speed"], case["spin"]], events=rolls, max_step=0.01, **EXACT)
    place, speed, _ = run.y[:, -1]
    return {"rolling_speed_m_s": speed, "along_m": place + speed * run.t[-1], "slide_s": run.t[-1]}


def second_slope(case):
    pull = case["g"] * math.sin(case["angle"]) - case["mu"] * case["g"] * math.cos(case["angle"])
    if pull <= 0:
        return {"creep_m_s": 0.0}
    return {"along_m": solve_ivp(lambda _, s: [s[1], pull], (0, case["seconds"]), [0, 0], **EXACT).y[0, -1]}


def second_stack(case):
    """Both blocks, integrated until they go together, and then until rest."""
    k = case["mu"] * case["g"]

    def together(_, s):
        return s[1] - s[3]

    together.terminal = True
    run = solve_ivp(lambda _, s: [s[1], -3 * k, s[3], k], (0, 100), [0, case["speed"], 0, 0], events=together, max_step=0.01, **EXACT)
    lower, v, upper, _ = run.y[:, -1]
    rest = quad(lambda t: v - k * t, 0, v / k, epsabs=1e-17)[0]
    return {"lower_m": lower + rest, "upper_m": upper + rest}


def second_collide(case):
    """Routh's way: the impulse grows little by little, friction against the slip of the moment, which it may end."""
    r, mu, v, w = case["radius"], case["mu"], case["speed"], case["spin"]
    n = np.array([math.cos(case["angle"]), math.sin(case["angle"])])
    t = np.array([-n[1], n[0]])
    first, second = np.array([v, 0.0]), np.zeros(2)
    spins, arm2 = np.array([w, 0.0]), 0.4 * r * r

    def slip():
        return (first - second) @ t + r * spins.sum()

    left = (first - second) @ n / 2
    # The slip is linear in the impulse: one stretch with it, one without.
    per_unit = mu * (2 + 2 * r * r / arm2)
    stretch = min(left, abs(slip()) / per_unit)
    friction = -mu * np.sign(slip()) * stretch
    first, second = first - left * n + friction * t, second + left * n - friction * t
    spins = spins + friction * r / arm2
    return {
        "along_m_s": first[0], "left_m_s": first[1], "spin_rad_s": spins[0],
        "other_along_m_s": second[0], "other_left_m_s": second[1], "other_spin_rad_s": spins[1],
    }  # fmt: skip


def none(quantity):
    return lambda case: {quantity: 0.0}


SECOND = {
    "eccentric": second_thrown, "belts": second_belts, "turntable_holds": second_turntable, "turntable_slips": second_turntable,
    "vibration_holds": second_vibration, "vibration_slips": second_vibration, "oblique": second_oblique, "skate": second_skate, "top": second_top,
    "wheel": second_wheel, "torsion": second_torsion, "back_spin": second_rolls, "incline_holds": second_slope,
    "incline_slides": second_slope, "stack": second_stack, "collide": second_collide,
    "tower": lambda case: {"sink_m": 0.0, "creep_m_s": 0.0},
}  # fmt: skip


# ---------------------------------------------------------------- the table


def rows(item):
    for name, case in standard()[item].items():
        numbers.use_digits(DIGITS)
        exact = ANSWERS[item](case, FINE)
        texts = {key: "0" if value == 0 else numbers.text(value, 15) for key, value in exact.items()}
        exact = {key: float(value) for key, value in exact.items()}
        numbers.use_digits(None)
        second = SECOND[item](case)
        lengths = max((abs(exact[key]) for key in exact if UNITS[key] == "m"), default=0.0)
        for key, value in exact.items():
            scale = lengths if UNITS[key] == "m" else abs(value)
            off = abs(second[key] - value) / (scale or 1.0)
            yield [item, name, key, UNITS[key], texts[key], f"{off:.0e}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("items", nargs="*", choices=[[], *SECOND])
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    made = []
    for item in args.items or (name for name in ITEMS if name in SECOND):
        for row in rows(item):
            print(*row, sep=",", flush=True)
            made.append(row)
    if args.write:
        (HERE / "v2").mkdir(exist_ok=True)
        problems = {item: standard()[item] for item in ITEMS if item in SECOND}
        (HERE / "v2" / "problems.json").write_text(json.dumps(problems, indent=1) + "\n")
        with open(HERE / "v2" / "answers.csv", "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["item", "case", "quantity", "unit", "value", "second"])
            writer.writerows(made)


if __name__ == "__main__":
    main()
