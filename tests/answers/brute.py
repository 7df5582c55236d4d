"""The problems by brute force: elements on a grid and small steps, without any of the formulas of the answers."""

import math


def grid(case, n=24):
    """Elements x, y, weight of a face, from the centre of mass."""
    if "end_1_x" in case:
        return [(case["end_1_x"] * (2 * (i + 0.5) / 400 - 1), 0.0, 1.0) for i in range(400)]
    if "corner_1_x" in case:
        x, y = case["corner_1_x"], case["corner_1_y"]
        dx, dy = case.get("offset_x", 0.0), case.get("offset_y", 0.0)
        places = [(x * (2 * (i + 0.5) / n - 1) - dx, y * (2 * (j + 0.5) / n - 1) - dy) for i in range(n) for j in range(n)]
        return balanced(places)
    r = case["radius"]
    if case.get("is_ring"):
        return [(r * math.cos(math.tau * i / 400), r * math.sin(math.tau * i / 400), 1.0) for i in range(400)]
    turns = [(math.tau * i / 40, r * (j + 0.5) / n, j + 0.5) for i in range(40) for j in range(n)]
    return [(s * math.cos(a), s * math.sin(a), w) for a, s, w in turns]


def balanced(places):
    """Weights linear in the place whose mean place is the origin."""
    mx, my = (sum(p[i] for p in places) / len(places) for i in (0, 1))
    xx, yy = (sum((p[i] - m) ** 2 for p in places) / len(places) for i, m in ((0, mx), (1, my)))
    return [(x, y, 1 - mx * (x - mx) / xx - my * (y - my) / yy) for x, y in places]


def wrench(elements, vx, vy, spin, moving=lambda x, y: 0.0):
    fx = fy = torque = total = 0.0
    for x, y, weight in elements:
        ux, uy = vx - spin * y - moving(x, y), vy + spin * x
        speed = math.hypot(ux, uy) or 1.0
        fx, fy = fx - weight * ux / speed, fy - weight * uy / speed
        torque -= weight * (x * uy - y * ux) / speed
        total += weight
    return fx / total, fy / total, torque / total


def rk4(slopes, state, h):
    a = slopes(state)
    b = slopes([s + 0.5 * h * d for s, d in zip(state, a)])
    c = slopes([s + 0.5 * h * d for s, d in zip(state, b)])
    d = slopes([s + h * e for s, e in zip(state, c)])
    return [s + h / 6 * (p + 2 * q + 2 * r + t) for s, p, q, r, t in zip(state, a, b, c, d)]


def thrown(case):
    from friction_answers.items import gyration_sq

    elements, arm2, k = grid(case), gyration_sq(case), case["mu"] * case["g"]

    def slopes(s):
        vx, vy, w, _, _, angle, _ = s
        co, si = math.cos(angle), math.sin(angle)
        fx, fy, torque = wrench(elements, co * vx + si * vy, co * vy - si * vx, w)
        unit = math.sqrt(vx * vx + vy * vy + arm2 * w * w) / k
        return [unit * d for d in (k * (co * fx - si * fy), k * (si * fx + co * fy), k * torque / arm2, vx, vy, w, 1)]

    state = [case["speed"], 0.0, case["spin"], 0.0, 0.0, 0.0, 0.0]
    for _ in range(500):
        state = rk4(slopes, state, 0.02)
    return {"along_m": state[3], "left_m": state[4], "turn_rad": state[5], "stop_s": state[6]}


def leaning(elements, inverse, lever, vx, vy, spin, shift, slip=1e-12):
    """Wrench of elements whose weights are linear in the place of the centre of pressure, which friction shifts; `inverse` gives slopes from places."""
    for _ in range(4):
        a, b = inverse(*shift)
        fx, fy, torque = 0.0, 0.0, 0.0
        for x, y, weight in elements:
            ux, uy = vx - spin * y, vy + spin * x
            force = -weight * (1 + a * x + b * y) / math.hypot(ux, uy, slip)
            fx, fy, torque = fx + force * ux, fy + force * uy, torque + force * (x * uy - y * ux)
        shift = (-lever * fx, -lever * fy)
    return (fx, fy, torque), shift


def moments(elements):
    """Weights that sum to 1, and the inverse of their second moments."""
    total = sum(w for _, _, w in elements)
    elements = [(x, y, w / total) for x, y, w in elements]
    xx, yy, xy = (sum(w * f(x, y) for x, y, w in elements) for f in (lambda x, _: x * x, lambda _, y: y * y, lambda x, y: x * y))
    det = xx * yy - xy * xy
    return elements, lambda sx, sy: ((sx * yy - sy * xy) / det, (sy * xx - sx * xy) / det)


def standing(case, dt=1e-5, slip=1e-3):
    """The tall cylinder and bodies on feet, whose friction falls linearly below a small slip."""
    arm2, k, lever = case["gyration_sq"], case["mu"] * case["g"], case["mu"] * case["height"]
    if "foot_1_x" in case:
        (ax, ay), (bx, by), (cx, cy) = feet = [(case[f"foot_{i}_x"], case[f"foot_{i}_y"]) for i in (1, 2, 3)]
        own = [bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx]
        elements, inverse = moments([(x, y, w) for (x, y), w in zip(feet, own)])
    else:
        (elements, inverse), dt = moments(grid(case, 12)), 1e-3
    vx, vy, w, x, y, angle, t, shift = case["speed"], 0.0, case["spin"], 0.0, 0.0, 0.0, 0.0, (0.0, 0.0)
    while math.hypot(vx, vy, math.sqrt(arm2) * w) > slip:
        co, si = math.cos(angle + 0.5 * dt * w), math.sin(angle + 0.5 * dt * w)
        (fx, fy, torque), shift = leaning(elements, inverse, lever, co * vx + si * vy, co * vy - si * vx, w, shift, slip)
        ax, ay, turn = k * (co * fx - si * fy), k * (si * fx + co * fy), k * torque / arm2
        x, y, angle = x + dt * (vx + 0.5 * dt * ax), y + dt * (vy + 0.5 * dt * ay), angle + dt * (w + 0.5 * dt * turn)
        vx, vy, w, t = vx + dt * ax, vy + dt * ay, w + dt * turn, t + dt
    return {"along_m": x, "left_m": y, "turn_rad": angle, "stop_s": t}


def belts(case, n=50, steps=400):
    x, y, k = case["half_x"], case["half_y"], case["mu"] * case["g"]
    places = [(x * (2 * (i + 0.5) / n - 1), y * (2 * (j + 0.5) / n - 1)) for i in range(n) for j in range(n)]
    arm2, angle, spin, h = (x * x + y * y) / 3, 0.0, 0.0, case["seconds"] / steps
    for _ in range(steps):
        co, si = math.cos(angle + 0.5 * h * spin), math.sin(angle + 0.5 * h * spin)
        turned = [(co * a - si * b, si * a + co * b, 1.0) for a, b in places]
        torque = wrench(turned, 0.0, 0.0, spin, lambda _, b: math.copysign(case["speed"], b))[2]
        now = spin + h * k * torque / arm2
        angle, spin = angle + 0.5 * h * (spin + now), now
    return {"turn_rad": angle, "drift_m": 0.0}


def points(case, pull, ground=lambda t, x, y: (0.0, 0.0), start=((0.0, 0.0), (0.0, 0.0)), held=None, dt=2e-5, seconds=None):
    """A point under a pull along x whose friction ends its slip within a step if it can."""
    (x, y), (vx, vy) = start
    most = (case["mu"] * case["g"] if held is None else held) * dt
    for i in range(round((seconds or case["seconds"]) / dt)):
        vx += pull(i * dt) * dt
        gx, gy = ground(i * dt, x, y)
        ux, uy = vx - gx, vy - gy
        slip = math.hypot(ux, uy)
        share = min(1.0, most / slip) if slip else 0.0
        vx, vy = vx - share * ux, vy - share * uy
        x, y = x + vx * dt, y + vy * dt
    return x, y


def slope(case, swing=0.0):
    rate = math.tau * case.get("frequency", 0.0)
    down = case["g"] * math.sin(case["angle"])
    held = case["mu"] * case["g"] * math.cos(case["angle"])
    x, _ = points(case, lambda t: down + swing * math.sin(rate * t), held=held)
    return {"along_m": x, "creep_m_s": x / case["seconds"]}


def vibration(case):
    return slope(case, case["swing"])


def turntable(case):
    w, r = case["rate"], case["distance"]
    x, y = points(case, lambda t: 0.0, lambda t, x, y: (-w * y, w * x), ((r, 0.0), (0.0, w * r)))
    return {"distance_m": math.hypot(x, y), "creep_m_s": (math.hypot(x, y) - r) / case["seconds"]}


def stack(case, dt=2e-5):
    k, lower, upper, v, w = case["mu"] * case["g"], 0.0, 0.0, case["speed"], 0.0
    while max(v, w) > 1e-9:
        between = max(-k * dt, min(k * dt, 0.5 * (v - w)))
        v, w = v - between, w + between
        v -= min(2 * k * dt, v)
        lower, upper = lower + v * dt, upper + w * dt
    return {"lower_m": lower, "upper_m": upper}


def skate(case, dt=2e-5):
    m1, m2, g = case["mu"], case["mu_across"], case["g"]
    vx, vy = case["speed"] * math.cos(case["direction"]), case["speed"] * math.sin(case["direction"])
    x = y = 0.0
    while vx > 2 * m1 * g * dt:
        size = math.hypot(m1 * vx, m2 * vy)
        # Implicit across, where friction is stiff at the end.
        vx, vy = vx - g * dt * m1 * m1 * vx / size, vy / (1 + g * dt * m2 * m2 / size)
        x, y = x + vx * dt, y + vy * dt
    return {"along_m": x, "left_m": y}


def oblique(case):
    vx, vy = case["speed"] * math.cos(case["direction"]), case["speed"] * math.sin(case["direction"])
    x, y = points(case, lambda t: 0.0, start=((0.0, 0.0), (vx, vy)), seconds=1.1 * case["speed"] / (case["mu"] * case["g"]))
    return {"along_m": x, "left_m": y}


def rolls(case, dt=2e-5):
    k, r, v, w, x, t, end = case["mu"] * case["g"], case["radius"], case["speed"], case["spin"], 0.0, 0.0, None
    while end is None or t < end:
        slip = v - w * r
        change = math.copysign(min(k * dt, 2 * abs(slip) / 7), slip)
        v, w, x, t = v - change, w + change / (0.4 * r), x + v * dt, t + dt
        if end is None and abs(v - w * r) < 1e-12:
            end = 2 * t
    return {"rolling_speed_m_s": v, "along_m": x, "slide_s": end / 2}


def spins(case, torque, arm2, dt=2e-5):
    """A constant torque per mass."""
    w, turn, t, way = abs(case["spin"]), 0.0, 0.0, math.copysign(1.0, case["spin"])
    while w > 0:
        w, turn, t = w - torque / arm2 * dt, turn + w * dt, t + dt
    return {"turn_rad": way * turn, "stop_s": t}


def disk(case):
    elements = grid(case)
    torque = sum(w * math.hypot(x, y) for x, y, w in elements) / sum(w for _, _, w in elements)
    return spins(case, case["mu"] * case["g"] * torque, case["gyration_sq"])


def wheel(case, n=200):
    half, r = case["half_width"], case["radius"]
    lever = sum(abs(half * (2 * (i + 0.5) / n - 1)) for i in range(n)) / n
    places = [(half * (2 * (i + 0.5) / n - 1), (j + 0.5) / n * r) for i in range(n) for j in range(n)]
    # Slices of rings across the axis: x^2 + s^2/2, weighted by the radius s.
    arm2 = sum((x * x + 0.5 * s * s) * s for x, s in places) / sum(s for _, s in places)
    return spins(case, case["mu"] * case["g"] * lever, arm2)


def torsion(case):
    return spins(case, case["torsion"] * case["g"], 0.4 * case["radius"] ** 2)


def collide(case, n=20000):
    """The impulse in small parts, each with friction against the slip of the moment."""
    r, (co, si) = case["radius"], (math.cos(case["angle"]), math.sin(case["angle"]))
    a, b, spin, turn = [case["speed"], 0.0], [0.0, 0.0], case["spin"], 0.0
    part = case["speed"] * co / 2 / n
    for _ in range(n):
        slip = -si * (a[0] - b[0]) + co * (a[1] - b[1]) + r * (spin + turn)
        along = -math.copysign(min(case["mu"] * part, abs(slip) / 7), slip)
        px, py = -part * co - along * si, -part * si + along * co
        a, b = [a[0] + px, a[1] + py], [b[0] - px, b[1] - py]
        spin, turn = spin + along / (0.4 * r), turn + along / (0.4 * r)
    return {"along_m_s": a[0], "left_m_s": a[1], "spin_rad_s": spin, "other_along_m_s": b[0], "other_left_m_s": b[1], "other_spin_rad_s": turn}


def nothing(case):
    return {"sink_m": 0.0, "creep_m_s": 0.0}


BRUTE = {
    **dict.fromkeys(("puck", "ring", "box", "plank", "bar", "eccentric"), thrown),
    **dict.fromkeys(("tripod", "three_ball", "three_ball_low", "tall"), standing),
    **dict.fromkeys(("spin_down", "top"), disk),
    **dict.fromkeys(("ball", "back_spin"), rolls),
    **dict.fromkeys(("incline_holds", "incline_slides"), slope),
    **dict.fromkeys(("vibration_holds", "vibration_slips"), vibration),
    **dict.fromkeys(("turntable_holds", "turntable_slips"), turntable),
    **dict.fromkeys(("tower", "capsule"), nothing),
    "wheel": wheel, "torsion": torsion, "belts": belts, "stack": stack, "skate": skate, "oblique": oblique, "collide": collide,
}  # fmt: skip
