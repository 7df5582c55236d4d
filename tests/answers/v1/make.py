#!/usr/bin/env python3
"""Makes answers.csv from problems.csv with 30 digits, independently of the library.

    python3 make.py [SCENE ...]        # prints the rows; all scenes take some minutes
    python3 make.py --write            # all scenes, into answers.csv

Needs Python 3.11 and mpmath; with gmpy2 it is ten times quicker. Each value is computed twice: by integrators
of different order and tolerance (`Extrapolation`), or by Gauss rules with 26 and 20 nodes on graded panels (round
bodies, `tests/tables/generate_motions.py`). Their relative difference is printed.
"""

import argparse
import csv
import sys
from pathlib import Path

try:
    import gmpy2 as mp

    mp.get_context().precision = 100
    real = mp.mpfr
except ImportError:
    import mpmath as mp

    mp.mp.prec = 100
    real = mp.mpf

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "tables"))

MOTION = {"along_m": "m", "left_m": "m", "turn_rad": "rad", "stop_s": "s"}
PI = 2 * mp.asin(real(1))
# Columns of the extrapolation, tolerance of a step.
FINE, COARSE = (10, real("1e-17")), (7, real("1e-15"))
# Fraction of the initial velocities below which the motion is uniformly decelerated.
END = real("1e-17")
# A foot this many tolerances slower than the others rests: its velocity is a difference with that error.
RESTS = 1000


def read_problems():
    problems = {}
    with open(HERE / "problems.csv", newline="") as file:
        for row in csv.DictReader(file):
            problems.setdefault(row["scene"], {})[row["parameter"]] = row["value"]
    return problems


# ---------------------------------------------------------------- bodies with straight outlines and feet


def points(problem, name):
    """Numbered places: corners, ends or feet."""
    found = []
    while f"{name}_{len(found) + 1}_x" in problem:
        key = f"{name}_{len(found) + 1}"
        found.append((real(problem[key + "_x"]), real(problem[key + "_y"])))
    return found


class PolygonFace:
    """Uniform pressure on a polygon whose centroid is the origin; wrench per mu and load.

    With rho the place relative to the centre of rotation, r = |rho| and the pressure p, the force is p times the
    integral of rho/r over the area, turned by a right angle, and the torque about the centre p times that of r: line integrals
    of r along the edges by the divergence theorem.
    """

    def __init__(self, problem):
        corners = points(problem, "corner")
        self.edges = list(zip(corners, corners[1:] + corners[:1]))
        self.area = sum(a[0] * b[1] - a[1] * b[0] for a, b in self.edges) / 2
        polar = sum(
            (a[0] * b[1] - a[1] * b[0])
            * (a[0] ** 2 + a[0] * b[0] + b[0] ** 2 + a[1] ** 2 + a[1] * b[1] + b[1] ** 2)
            for a, b in self.edges
        )
        self.gyration_sq = polar / 12 / self.area

    def wrench(self, vx, vy, spin):
        cx, cy = -vy / spin, vx / spin
        gx = gy = about = real(0)
        for (ax, ay), (bx, by) in self.edges:
            ax, ay, bx, by = ax - cx, ay - cy, bx - cx, by - cy
            length = mp.sqrt((bx - ax) ** 2 + (by - ay) ** 2)
            tx, ty = (bx - ax) / length, (by - ay) / length
            far = ax * ty - ay * tx  # along the outward normal (ty, -tx)
            t0, t1 = ax * tx + ay * ty, bx * tx + by * ty
            r0, r1 = mp.sqrt(ax * ax + ay * ay), mp.sqrt(bx * bx + by * by)
            integral = (t1 * r1 - t0 * r0) / 2
            if far != 0:
                integral += far * far * (mp.asinh(t1 / abs(far)) - mp.asinh(t0 / abs(far))) / 2
            gx, gy, about = gx + ty * integral, gy - tx * integral, about + far * integral / 3
        sense = (1 if spin > 0 else -1) / self.area
        fx, fy = sense * gy, -sense * gx
        return fx, fy, -sense * about + cx * fy - cy * fx

    def scale(self, vx, vy, spin):
        return mp.sqrt(vx * vx + vy * vy + self.gyration_sq * spin * spin)


class BarFace:
    """Uniform pressure on a line along x about the origin; wrench per mu and load."""

    def __init__(self, problem):
        (end, _), _ = points(problem, "end")
        self.half = end
        self.gyration_sq = end * end / 3

    def wrench(self, vx, vy, spin):
        u0, u1 = vy - spin * self.half, vy + spin * self.half
        q0, q1 = mp.sqrt(vx * vx + u0 * u0), mp.sqrt(vx * vx + u1 * u1)
        angle = mp.asinh(u1 / abs(vx)) - mp.asinh(u0 / abs(vx)) if vx != 0 else real(0)
        length = 2 * self.half * spin
        across = (q1 - q0) / length
        moment = ((u1 * q1 - u0 * q0) - vx * vx * angle) / 2 / length
        return -vx * angle / length, -across, -(moment - vy * across) / spin

    scale = PolygonFace.scale


class RimFace:
    """A thin ring about the origin; wrench per mu and load by complete elliptic integrals.

    Its force at the ratio v/w is its torque at w/v (w the rim speed): m is the square of the smaller ratio.
    """

    def __init__(self, problem):
        self.radius = real(problem["radius"])
        self.gyration_sq = real(problem["gyration_sq"])

    def wrench(self, vx, vy, spin):
        speed, rim = mp.sqrt(vx * vx + vy * vy), abs(spin) * self.radius
        lesser, greater = min(speed, rim), max(speed, rim)
        m = (lesser / greater) ** 2
        if m == 1:
            less = more = 2 / PI
        else:
            k, e = elliptic(m)
            b, d = (e - (1 - m) * k) / m, (k - e) / m
            less, more = 2 / PI * lesser / greater * b, 2 / PI * (b + (1 - m) * d)
        force, torque = (less, more) if speed < rim else (more, less)
        sense = 1 if spin > 0 else -1
        return -force * vx / speed, -force * vy / speed, -sense * self.radius * torque

    scale = PolygonFace.scale


def elliptic(m):
    """K and E of the parameter m by the arithmetic-geometric mean."""
    a, b, c_sq, power, total = real(1), mp.sqrt(1 - m), m, real(1) / 2, real(0)
    while c_sq > real("1e-60"):
        total += power * c_sq
        a, b, c_sq, power = (a + b) / 2, mp.sqrt(a * b), ((a - b) / 2) ** 2, 2 * power
    k = PI / 2 / a
    return k, k * (1 - total)


class Feet:
    """Three points that carry a rigid body: the loads follow from statics with the friction itself.

    With the loads N, places r and the height h of the centre of mass, sum N = m g and sum N r = -h F.
    """

    def __init__(self, problem):
        self.feet = points(problem, "foot")
        self.mu, self.height = real(problem["mu"]), real(problem["height"])
        (ax, ay), (bx, by), (cx, cy) = self.feet
        twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        # Share of each foot: that without friction, and its gradient in the place of the resultant.
        self.shares = []
        for (px, py), (qx, qy) in (
            (self.feet[1], self.feet[2]),
            (self.feet[2], self.feet[0]),
            (self.feet[0], self.feet[1]),
        ):
            self.shares.append(((px * qy - py * qx) / twice, (py - qy) / twice, (qx - px) / twice))

    def wrench(self, vx, vy, spin):
        # f = -sum (s - h g.f) mu u is linear in the friction f per load.
        units = []
        a11 = a22 = real(1)
        a12 = a21 = b1 = b2 = real(0)
        for (x, y), (share, gx, gy) in zip(self.feet, self.shares):
            ux, uy = vx - spin * y, vy + spin * x
            size = mp.sqrt(ux * ux + uy * uy)
            ux, uy = ux / size, uy / size
            units.append((ux, uy))
            k = self.mu * self.height
            b1, b2 = b1 - self.mu * share * ux, b2 - self.mu * share * uy
            a11, a12 = a11 - k * gx * ux, a12 - k * gy * ux
            a21, a22 = a21 - k * gx * uy, a22 - k * gy * uy
        det = a11 * a22 - a12 * a21
        fx, fy = (b1 * a22 - b2 * a12) / det, (a11 * b2 - a21 * b1) / det
        torque = real(0)
        for (x, y), (share, gx, gy), (ux, uy) in zip(self.feet, self.shares, units):
            load = share - self.height * (gx * fx + gy * fy)
            if load < 0:
                raise ValueError("a foot lifts off")
            torque -= load * (x * uy - y * ux)
        return fx / self.mu, fy / self.mu, torque

    def scale(self, vx, vy, spin):
        """Small where a foot nearly rests: its friction turns quickly there."""
        inverse = real(0)
        for x, y in self.feet:
            ux, uy = vx - spin * y, vy + spin * x
            inverse += 1 / mp.sqrt(ux * ux + uy * uy)
        return 1 / inverse

    def resting(self, vx, vy, spin):
        """The foot that moves least, and its speed over that of the others."""
        sizes = [mp.sqrt((vx - spin * y) ** 2 + (vy + spin * x) ** 2) for x, y in self.feet]
        least = min(range(3), key=sizes.__getitem__)
        return least, sizes[least] / max(sizes)


class Pivot:
    """A body that turns about one of its feet, which friction holds, until it rests."""

    def __init__(self, motion, foot):
        self.face, self.foot = motion.face, foot
        self.gyration_sq, self.g = motion.gyration_sq, motion.strength / motion.face.mu
        px, py = self.face.feet[foot]
        self.arm = (-px, -py)  # from the foot to the centre of mass

    def turning(self, spin):
        """Angular acceleration and whether the foot is held: torque about the foot, linear in the acceleration."""
        face, (dx, dy) = self.face, self.arm
        px, py = face.feet[self.foot]
        sense = 1 if spin > 0 else -1
        constant, slope, friction = real(0), real(0), []
        for j, ((x, y), (share, gx, gy)) in enumerate(zip(face.feet, face.shares)):
            # Load per weight: fixed + rate * acceleration.
            fixed = share + face.height / self.g * spin * spin * (gx * dx + gy * dy)
            rate = -face.height / self.g * (gy * dx - gx * dy)
            if j == self.foot:
                own = (fixed, rate)
                continue
            length = mp.sqrt((x - px) ** 2 + (y - py) ** 2)
            strength = -sense * face.mu * self.g
            constant, slope = constant + strength * length * fixed, slope + strength * length * rate
            friction.append(
                (-(y - py) / length * strength, (x - px) / length * strength, fixed, rate)
            )
        rate = constant / (self.gyration_sq + dx * dx + dy * dy - slope)
        fx, fy = -rate * dy - spin * spin * dx, rate * dx - spin * spin * dy
        for ux, uy, fixed, load in friction:
            fx, fy = fx - ux * (fixed + load * rate), fy - uy * (fixed + load * rate)
        limit = face.mu * self.g * (own[0] + own[1] * rate)
        return rate, fx * fx + fy * fy <= limit * limit

    def is_held(self, spin):
        """The force on the foot is a quadratic in the spin and its limit is one: both ends decide."""
        tiny = spin * real("1e-20")
        return self.turning(spin)[1] and self.turning(tiny)[1]

    def to_rest(self, state, columns, tolerance):
        """Over the spin, from now to nothing."""
        _, _, spin, x, y, angle, time = state

        def slope(here):
            rate = self.turning(here[0] if here[0] * spin > 0 else spin * real("1e-30"))[0]
            return [-spin, -spin * here[0] / rate, -spin / rate]

        solver = Extrapolation(slope, columns, tolerance)
        here = [spin, real(0), real(0)]
        rate = abs(self.turning(spin)[0])
        units = [abs(spin), spin * spin / rate, abs(spin) / rate]
        left = real(1)
        while left > END:
            here, _ = solver.step(here, left, units)
            left -= solver.taken
        dx, dy = self.arm
        for sign, a in ((-1, angle), (1, angle + here[1])):
            co, si = mp.cos(a), mp.sin(a)
            x, y = x + sign * (co * dx - si * dy), y + sign * (si * dx + co * dy)
        return [x, y, angle + here[1], time + here[2]]


class Motion:
    """Equations of motion over the time s with dt = scale ds, in which friction changes slowly up to rest."""

    def __init__(self, problem):
        kinds = {"corner_1_x": PolygonFace, "end_1_x": BarFace, "foot_1_x": Feet, "radius": RimFace}
        self.face = next(kind(problem) for key, kind in kinds.items() if key in problem)
        given = problem["gyration_sq"]
        self.gyration_sq = self.face.gyration_sq if given == "uniform" else real(given)
        self.strength = real(problem["mu"]) * real(problem["g"])

    def acceleration(self, vx, vy, spin, angle):
        co, si = mp.cos(angle), mp.sin(angle)
        fx, fy, torque = self.face.wrench(co * vx + si * vy, co * vy - si * vx, spin)
        k = self.strength
        return k * (co * fx - si * fy), k * (si * fx + co * fy), k * torque / self.gyration_sq

    def slope(self, state):
        vx, vy, spin, _, _, angle, _ = state
        co, si = mp.cos(angle), mp.sin(angle)
        scale = self.face.scale(co * vx + si * vy, co * vy - si * vx, spin)
        return [scale * d for d in (*self.acceleration(vx, vy, spin, angle), vx, vy, spin, 1)]

    def size(self, state):
        vx, vy, spin = state[:3]
        return mp.sqrt(vx * vx + vy * vy + self.gyration_sq * spin * spin)

    def pivot(self, state, tolerance):
        """If a foot has come to rest and stays: friction brings its velocity to nothing in a finite time."""
        if not isinstance(self.face, Feet):
            return None
        vx, vy, spin, _, _, angle, _ = state
        co, si = mp.cos(angle), mp.sin(angle)
        foot, ratio = self.face.resting(co * vx + si * vy, co * vy - si * vx, spin)
        pivot = Pivot(self, foot)
        return pivot if ratio < RESTS * tolerance and pivot.is_held(spin) else None

    def to_rest(self, speed, spin, columns, tolerance):
        state = [speed, real(0), spin, real(0), real(0), real(0), real(0)]
        start = self.size(state)
        time = start / self.strength
        units = [time * start, time * start, time * start / mp.sqrt(self.gyration_sq), time]
        solver = Extrapolation(self.slope, columns, tolerance)
        h, steps = real("0.01") / self.strength, 0
        while self.size(state) > END * start:
            size = self.size(state)
            weights = [size, size, size / mp.sqrt(self.gyration_sq), *units]
            state, h = solver.step(state, h, weights)
            steps += 1
            pivot = self.pivot(state, tolerance)
            if pivot:
                return pivot.to_rest(state, columns, tolerance), steps
        ax, ay, turn = self.acceleration(*state[:3], state[5])
        slowing = -(state[0] * ax + state[1] * ay + self.gyration_sq * state[2] * turn) / self.size(
            state
        )
        return [*state[3:6], state[6] + self.size(state) / slowing], steps


class Extrapolation:
    """Gragg's midpoint rule with 2, 4, 6, ... sub-steps, extrapolated to none (Gragg, Bulirsch & Stoer)."""

    def __init__(self, slope, columns, tolerance):
        self.slope, self.columns, self.tolerance = slope, columns, tolerance

    def midpoint(self, state, first, h, n):
        sub = h / n
        before, here = state, [y + sub * d for y, d in zip(state, first)]
        for _ in range(n - 1):
            before, here = here, [y + 2 * sub * d for y, d in zip(before, self.slope(here))]
        return [(b + y + sub * d) / 2 for b, y, d in zip(before, here, self.slope(here))]

    def step(self, state, h, weights):
        first = self.slope(state)
        while True:
            table = []
            for k in range(self.columns):
                row = [self.midpoint(state, first, h, 2 * (k + 1))]
                for j in range(k):
                    ratio = (real(k + 1) / (k - j)) ** 2 - 1
                    row.append([a + (a - b) / ratio for a, b in zip(row[j], table[-1][j])])
                table.append(row)
            error = max(abs(a - b) / w for a, b, w in zip(table[-1][-1], table[-1][-2], weights))
            factor = (self.tolerance / (error + real("1e-40"))) ** (
                real(1) / (2 * self.columns - 1)
            )
            factor = min(max(real("0.9") * factor, real("0.1")), real(3))
            if error <= self.tolerance:
                self.taken = h
                return table[-1][-1], h * factor
            h *= factor


def straight(problem, spin):
    """Bodies with straight outlines and feet."""
    motion, speed = Motion(problem), real(problem["speed"])
    if spin == 0:
        # Friction against the motion has no torque: the resultant of the loads lies ahead of the centre of mass.
        rate = real(problem["mu"]) * real(problem["g"])
        exact = [speed**2 / (2 * rate), real(0), real(0), speed / rate]
        return exact, exact, "closed form"
    (fine, steps), (coarse, fewer) = (motion.to_rest(speed, spin, *way) for way in (FINE, COARSE))
    return fine, coarse, f"{steps} and {fewer} steps"


# ---------------------------------------------------------------- round bodies


def round_body(problem, spin):
    """Puck and tall cylinder: integrals over the angle atan(rim speed/speed)."""
    import generate_motions as gm
    import mpmath

    with mpmath.workdps(40):
        number = {k: mpmath.mpf(v) for k, v in problem.items() if k != "spins"}
        rate, radius = number["mu"] * number["g"], number["radius"]
        c = number["gyration_sq"] / radius**2
        tilt = 4 * number["mu"] * number["height"] / radius
        force = gm.tilted_force("full", tilt)
        # Inertia ratios beyond which a body ends spinning or sliding alone.
        bounds = gm.bounds(0, 0)
        results = []
        for nodes in gm.NODES:
            end = gm.to_rest(force, c, 0, number["speed"], spin * radius, bounds, nodes)[0]
            results.append(
                [
                    end.position.real / rate,
                    end.position.imag / rate,
                    end.angle / rate / radius,
                    end.time / rate,
                ]
            )
    return (*results, "26 and 20 nodes")


def spin_down(problem, spin):
    """Torque 2/3 mu m g R."""
    slowing = 2 * real(problem["mu"]) * real(problem["g"]) * real(problem["radius"]) / 3
    slowing /= real(problem["gyration_sq"])
    exact = [real(0), real(0), spin * spin / (2 * slowing), spin / slowing]
    return exact, exact, "closed form"


def ball(problem, spin):
    """Speed at which it rolls, time and distance until then."""
    speed, rate = real(problem["speed"]), real(problem["mu"]) * real(problem["g"])
    slip = speed - spin * real(problem["radius"])
    time = 2 * abs(slip) / (7 * rate)
    slowing = rate if slip > 0 else -rate
    exact = [speed - slowing * time, time, speed * time - slowing * time**2 / 2]
    return exact, exact, "closed form"


def capsule(problem, _):
    """No creep; the factors by which the weight may grow at the middle of the pads and off it; torque that twists it loose.

    A line of length L under uniform pressure that turns about a point of itself at s L/2 from its middle has the force
    s mu N and the torque (1 - s^2) mu N L/4.
    """
    limit = 2 * real(problem["mu"]) * real(problem["grip"])
    weight = real(problem["mass"]) * real(problem["g"])
    length = real(problem["length"])
    lever = 2 * real(problem["offset"]) / length
    off = mp.sqrt(lever * lever + 1) - lever
    exact = [real(0), limit / weight, off * limit / weight, limit * length / 4]
    return exact, exact, "closed form"


UNITS = {
    "ball": {"rolling_speed_m_s": "m/s", "slide_s": "s", "slide_m": "m"},
    "capsule": {
        "creep_m_s": "m/s",
        "margin": "",
        "margin_off_middle": "",
        "torque_limit_N_m": "N m",
    },
}


def answers(scene, problem):
    """Rows of the table."""
    own = {"spin_down": spin_down, "ball": ball, "capsule": capsule}
    for text in problem["spins"].split():
        if scene in ("puck", "tall") and text != "0":
            import mpmath

            fine, coarse, how = round_body(problem, mpmath.mpf(text))
        else:
            fine, coarse, how = own.get(scene, straight)(problem, real(text))
        quantities = UNITS.get(scene, MOTION)
        # Displacements err relative to the whole one.
        size = [abs(x) for x in fine]
        if quantities is MOTION:
            size[0] = size[1] = max(size[0], size[1])
        worst = max(abs(a - b) / s if s else abs(a - b) for a, b, s in zip(fine, coarse, size))
        print(
            f"{scene} at {text}: {how}, which differ by {float(worst):.1e}",
            file=sys.stderr,
            flush=True,
        )
        for (quantity, unit), value, s in zip(quantities.items(), fine, size):
            # Of the size of rounding errors: symmetry makes it nothing.
            is_zero = abs(value) <= real("1e-20") * (s or 1)
            yield [scene, text, quantity, unit, "0" if is_zero else f"{digits(value)}"]


def digits(value):
    """15 significant digits."""
    import mpmath

    with mpmath.workdps(30):
        return mpmath.nstr(mpmath.mpf(str(value)), 15, min_fixed=0, max_fixed=0, strip_zeros=False)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    problems = read_problems()
    unknown = [scene for scene in args.scenes if scene not in problems]
    if unknown:
        parser.error(f"no scene {unknown[0]}; there are {', '.join(problems)}")
    if args.write and args.scenes:
        parser.error("--write makes all scenes")
    rows = [row for scene in args.scenes or problems for row in answers(scene, problems[scene])]
    out = open(HERE / "answers.csv", "w", newline="") if args.write else sys.stdout
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["scene", "spin_rad_s", "quantity", "unit", "value"])
    writer.writerows(rows)


if __name__ == "__main__":
    main()
