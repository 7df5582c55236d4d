"""Reference table of supports whose pressure is known by its centre alone: any_pressure.csv.

    python3 generate_any_pressure.py make > any_pressure.csv       a minute; needs mpmath, numpy and scipy
    python3 generate_any_pressure.py check                         some minutes: the same by linear programmes

The yaw limit with a force is max over the shares of the load of min over the centre of rotation of

    sum share_i |x_i - r| - g . r,        g the force over muN, turned by a right angle.

`make` maximises over the shares: a concave problem in n - 3 unknowns. For each share the minimum over
r is found by Newton with 40 digits (Weiszfeld's problem with a bias). Three corners have one set of shares; for four
the shares move along a line, where a bracket of the derivative is halved. More corners are only in `check`, whose
answer is a linear programme with the friction circles cut into 4096-gons: its error is below
4e-7, next to the largest force below 3e-6.
The gauge of a wrench is 1 on the surface: the limit itself tests it.
"""

import math
import random
import sys
from mpmath import mp, mpf, sqrt

mp.dps = 40

SHAPES = {
    "triangle": [(0, 0), (3, 0.25), (1, 2)],
    "square": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
    "sole": [(-0.0625, -0.0390625), (0.1875, -0.046875), (0.1875, 0.046875), (-0.0625, 0.0390625)],
    "kite": [(3, 0), (0, 1), (-1, 0), (0, -1)],
}


def newton(corners, shares, gx, gy):
    """Least sum of shares times distances minus g . r, and the distances there; one corner may be r."""
    def parts(x, y):
        f, dx, dy, xx, xy, yy = -gx * x - gy * y, -gx, -gy, mpf(0), mpf(0), mpf(0)
        for (a, b), w in zip(corners, shares):
            if w == 0:
                continue
            u, v = x - a, y - b
            r = sqrt(u * u + v * v)
            f += w * r
            if r == 0:
                continue
            dx += w * u / r
            dy += w * v / r
            xx += w * v * v / r**3
            xy -= w * u * v / r**3
            yy += w * u * u / r**3
        return f, dx, dy, xx, xy, yy

    # A corner is the minimum if the others and the bias pull less than its share.
    for (a, b), w in zip(corners, shares):
        f, dx, dy, *_ = parts(a, b)
        if w > 0 and sqrt(dx * dx + dy * dy) <= w:
            return f, (a, b)
    # From a few starts: next to a corner Newton's steps get short.
    x0 = sum(w * a for (a, _), w in zip(corners, shares))
    y0 = sum(w * b for (_, b), w in zip(corners, shares))
    for far in (1, 3, -1, 10, 0.3, 30):
        x, y = x0 + mpf(1) / 97 + far * gx, y0 + mpf(1) / 89 + far * gy
        for _ in range(200):
            f, dx, dy, xx, xy, yy = parts(x, y)
            size = sqrt(dx * dx + dy * dy)
            if size < mpf(10) ** -30:
                return f, (x, y)
            det = xx * yy - xy * xy
            if det <= 0:
                break
            sx, sy = (yy * dx - xy * dy) / det, (xx * dy - xy * dx) / det
            t = mpf(1)
            # Next to the minimum its value no longer tells.
            while size > mpf(10) ** -12 and parts(x - t * sx, y - t * sy)[0] > f - t * (dx * sx + dy * sy) / 10**4:
                t /= 2
                if t < mpf(10) ** -12:
                    break
            x, y = x - t * sx, y - t * sy
    raise SystemExit(f"no minimum: {corners} {shares} {gx} {gy}")


def barycentric(corners, at):
    (ax, ay), (bx, by), (cx, cy) = corners
    x, y = at
    twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    a = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / twice
    b = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / twice
    return [a, b, 1 - a - b]


def yaw(corners, centre, force):
    """Highest torque about the centre over muN."""
    corners = [(mpf(x) - mpf(centre[0]), mpf(y) - mpf(centre[1])) for x, y in corners]
    # v = -z x r, and f . v = g . r.
    gx, gy = -mpf(force[1]), mpf(force[0])
    if len(corners) == 3:
        return newton(corners, barycentric(corners, (0, 0)), gx, gy)[0]
    # Shares of four corners: a line with the direction of their affine dependence.
    base = barycentric(corners[:3], (0, 0)) + [mpf(0)]
    last = barycentric(corners[:3], corners[3])
    way = [-x for x in last] + [mpf(1)]
    low, high = mpf(-10) ** 9, mpf(10) ** 9
    for b, w in zip(base, way):
        if w > 0:
            low = max(low, -b / w)
        elif w < 0:
            high = min(high, -b / w)

    def at(t):
        shares = [max(b + t * w, mpf(0)) for b, w in zip(base, way)]
        value, (x, y) = newton(corners, shares, gx, gy)
        slope = sum(w * sqrt((x - a) ** 2 + (y - b) ** 2) for w, (a, b) in zip(way, corners))
        return value, slope

    (f, df), (h, dh) = at(low), at(high)
    if df <= 0:
        return f
    if dh >= 0:
        return h
    for _ in range(110):
        middle = (low + high) / 2
        value, slope = at(middle)
        if slope > 0:
            low = middle
        else:
            high = middle
    return value


def support(corners, centre, twist):
    """Greatest mean of the speeds by all triangles, in mpmath."""
    vx, vy, w = map(mpf, twist)
    speed = [sqrt((vx - w * mpf(y)) ** 2 + (vy + w * mpf(x)) ** 2) for x, y in corners]
    best = None
    n = len(corners)
    for i in range(n):
        for j in range(i):
            for k in range(j):
                three = [tuple(map(mpf, corners[m])) for m in (i, j, k)]
                parts = barycentric(three, tuple(map(mpf, centre)))
                if min(parts) >= 0:
                    value = sum(p * speed[m] for p, m in zip(parts, (i, j, k)))
                    best = value if best is None or value > best else best
    return best


def cases():
    chance = random.Random(7)
    for name, corners in SHAPES.items():
        # The eighth kite has its minimum so near to a corner that Newton's steps do not end.
        for number in range(7 if name == "kite" else 8):
            weights = [chance.random() + 0.01 for _ in corners]
            total = sum(weights)
            centre = [sum(w * c[a] for w, c in zip(weights, corners)) / total for a in (0, 1)]
            if name == "square" and number == 0:
                centre = [0.0, 0.0]
            size, angle = chance.choice([0.0, 0.3, 0.7, 0.95, 0.999]), chance.uniform(-3, 3)
            force = [round(size * math.cos(angle), 6), round(size * math.sin(angle), 6)]
            twist = [round(chance.uniform(-2, 2), 6) for _ in range(3)]
            yield name, corners, [float(c) for c in centre], force, twist


def make():
    print("# Yaw limits and supports per muN of corners under any pressure with this centre: "
          "generate_any_pressure.py make")
    print("shape,x,y,centre_x,centre_y,force_x,force_y,velocity_x,velocity_y,spin,highest,lowest,support")
    for name, corners, centre, force, twist in cases():
        highest = yaw(corners, centre, force)
        lowest = -yaw(corners, centre, [-f for f in force])
        offset = mpf(centre[0]) * mpf(force[1]) - mpf(centre[1]) * mpf(force[0])
        xs = " ".join(repr(float(c[0])) for c in corners)
        ys = " ".join(repr(float(c[1])) for c in corners)
        row = [mp.nstr(x, 22) for x in (highest + offset, lowest + offset, support(corners, centre, twist))]
        numbers = [repr(x) for x in (*centre, *force, *twist)]
        print(",".join([name, xs, ys, *numbers, *row]))


def check():
    import numpy
    from scipy.optimize import linprog
    sides = 4096
    angles = 2 * numpy.pi * (numpy.arange(sides) + 0.5) / sides
    worst = 0.0
    for name, corners, centre, force, _ in list(cases())[::3]:
        n = len(corners)
        places = numpy.array(corners) - numpy.array(centre)
        # Unknowns: forces x, forces y, shares. No force leaves the polygon around its circle.
        a = numpy.zeros((n * sides, 3 * n))
        for i in range(n):
            rows = slice(i * sides, (i + 1) * sides)
            a[rows, i], a[rows, n + i] = numpy.cos(angles), numpy.sin(angles)
            a[rows, 2 * n + i] = -numpy.cos(numpy.pi / sides)
        equal = numpy.zeros((5, 3 * n))
        equal[0, :n] = equal[1, n:2 * n] = equal[2, 2 * n:] = 1
        equal[3, 2 * n:], equal[4, 2 * n:] = places[:, 0], places[:, 1]
        cost = numpy.concatenate([places[:, 1], -places[:, 0], numpy.zeros(n)])
        bounds = [(None, None)] * (2 * n) + [(0, None)] * n
        answer = linprog(cost, a, numpy.zeros(n * sides), equal, [*force, 1, 0, 0], bounds)
        scale = max(numpy.hypot(places[:, 0], places[:, 1]))
        error = (-answer.fun - float(yaw(corners, centre, force))) / scale
        worst = max(worst, abs(error))
        print(name, force, f"{error:.2e}")
    print(f"worst {worst:.2e} of muN times the radius")


if __name__ == "__main__":
    {"make": make, "check": check}[sys.argv[1]]()
