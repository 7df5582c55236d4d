"""Reference table of dry friction on polygons: polygons.csv, and polygon_shapes.csv.

    python3 generate_polygons.py shapes                  their corners
    python3 generate_polygons.py make [rows a shape]     from line integrals with 150 digits
    python3 generate_polygons.py check [rows]            some of them again, by area integrals
    python3 generate_polygons.py fit [terms]             polynomials of coupling/flat/moving_edge.rs: 12, in f32 6

`make` sums closed line integrals about the centre of rotation with so many digits that their
cancellation at a far centre does not matter. `check` shares nothing with it: the patch is cut into
triangles that have the centre of rotation as a corner, each with its sign, and these are
integrated in polar coordinates (r in closed form, the angle by Gauss).
"""

import random
import sys
from mpmath import mp, mpf, sqrt, asinh, atan2, cos, sin, quad, matrix

mp.dps = 150
HALF = mpf(1) / 2

SHAPES = {
    "square": [[(-1, -1), (1, -1), (1, 1), (-1, 1)]],
    "rectangle": [[(0, 0), (4, 0), (4, 1), (0, 1)]],
    "plank": [[(-5, -0.5), (5, -0.5), (5, 0.5), (-5, 0.5)]],
    "triangle": [[(0, 0), (3, 0.25), (1, 2)]],
    "hexagon": [[(2, 0), (1, 1.75), (-1, 1.75), (-2, 0), (-1, -1.75), (1, -1.75)]],
    "octagon": [[(1, 0.5), (0.5, 1), (-0.5, 1), (-1, 0.5), (-1, -0.5), (-0.5, -1), (0.5, -1), (1, -0.5)]],
    "ell": [[(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]],
    "u": [[(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]],
    "star": [[(3, 0), (0.75, 0.5), (0, 3), (-0.75, 0.5), (-3, 0), (-0.5, -0.75), (0, -3), (0.5, -0.75)]],
    "frame": [[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(-0.5, -0.5), (-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)]],
    "foot": [[(0, 1), (0.25, 0.25), (1, 0), (2, 0.25), (4, 0.125), (5, 0), (6.5, 0.25), (7.5, 1),
              (7.75, 2), (7, 2.75), (5.5, 3), (4, 2.25), (2, 2), (0.75, 2.125)]],
    "sliver": [[(-5, -0.005), (5, -0.005), (5, 0.005), (-5, 0.005)]],
}
# For steep pressure alone: a bar with a stem, on which the pressure grows to eight times the mean.
TEE = {"tee": [[(-1, 0), (1, 0), (1, 0.2), (0.05, 0.2), (0, 1.2), (-0.05, 0.2), (-1, 0.2)]]}


def edges(loops):
    for loop in loops:
        points = [(mpf(x), mpf(y)) for x, y in loop]
        yield from zip(points, points[1:] + points[:1])


def geometry(loops):
    """Area, centroid, and distance of the farthest corner from it."""
    area = x = y = mpf(0)
    for (ax, ay), (bx, by) in edges(loops):
        part = ax * by - ay * bx
        area += part / 2
        x += (ax + bx) * part / 6
        y += (ay + by) * part / 6
    x, y = x / area, y / area
    radius = max(sqrt((a[0] - x) ** 2 + (a[1] - y) ** 2) for a, _ in edges(loops))
    return area, x, y, radius


def by_edges(loops, twist, slope):
    """Force, torque about the origin and Hessian of the power (xx, xy, yy, xn, yn, nn), per muN.

    Pressure per load (1 + slope . (x - centroid))/area."""
    area, mx, my, _ = geometry(loops)
    vx, vy, w = twist
    cx, cy = -vy / w, vx / w
    sense = 1 if w > 0 else -1
    kx, ky = slope
    here = 1 + kx * (cx - mx) + ky * (cy - my)
    pull = [mpf(0), mpf(0)]
    turn = mpf(0)
    K = [[mpf(0)] * 2 for _ in range(2)]
    for (ax, ay), (bx, by) in edges(loops):
        dx, dy = bx - ax, by - ay
        length = sqrt(dx * dx + dy * dy)
        t, n = (dx / length, dy / length), (dy / length, -dx / length)
        h = (ax - cx) * n[0] + (ay - cy) * n[1]
        t0 = (ax - cx) * t[0] + (ay - cy) * t[1]
        t1 = t0 + length
        r0, r1 = sqrt(h * h + t0 * t0), sqrt(h * h + t1 * t1)
        log = asinh(t1 / abs(h)) - asinh(t0 / abs(h)) if h != 0 else mpf(0)
        # Integrals of r, t r, and t^j/r^3 along the edge.
        i0 = (t1 * r1 - t0 * r0 + h * h * log) / 2
        i1 = (r1**3 - r0**3) / 3
        if h != 0:
            m = [(t1 / r1 - t0 / r0) / h**2, 1 / r0 - 1 / r1, log - t1 / r1 + t0 / r0, None]
            m[3] = r1 - r0 + h * h * (1 / r1 - 1 / r0)
            m = [part * h for part in m]
        else:
            m = [mpf(0)] * 4
        kn, kt = kx * n[0] + ky * n[1], kx * t[0] + ky * t[1]
        k = here
        # div(rho f) = (degree + 2) f.
        vec = [k * (n[i] * i0) for i in range(2)]  # int rho/r = sum n I
        pull = [pull[i] + vec[i] for i in range(2)]
        turn += k * h * i0 / 3 + h * (kn * h * i0 + kt * i1) / 4
        # int (k.rho) rho/r: degree 1.
        rr = lambda i: h * ((kn * h) * (h * n[i] * J(h, t0, t1, 0) + t[i] * J(h, t0, t1, 1))
                            + kt * (h * n[i] * J(h, t0, t1, 1) + t[i] * J(h, t0, t1, 2))) / 3
        pull = [pull[i] + rr(i) for i in range(2)]
        # int rho rho/r^3 (degree -1) and int (k.rho) rho rho/r^3 (degree 0).
        for i in range(2):
            for j in range(2):
                second = h * h * n[i] * n[j] * m[0] + h * (n[i] * t[j] + t[i] * n[j]) * m[1] + t[i] * t[j] * m[2]
                third = kn * h * second + kt * (
                    h * h * n[i] * n[j] * m[1] + h * (n[i] * t[j] + t[i] * n[j]) * m[2] + t[i] * t[j] * m[3])
                K[i][j] += k * second + third / 2
    force = [sense * pull[1] / area, -sense * pull[0] / area]
    torque = -sense * turn / area + cx * force[1] - cy * force[0]
    xx, xy, yy = (part / (abs(w) * area) for part in (K[0][0], K[0][1], K[1][1]))
    xn, yn = -(xx * vx + xy * vy) / w, -(xy * vx + yy * vy) / w
    nn = -(xn * vx + yn * vy) / w
    return force + [torque], [xx, xy, yy, xn, yn, nn]


def J(h, t0, t1, power):
    """int t^power/r dt."""
    r0, r1 = sqrt(h * h + t0 * t0), sqrt(h * h + t1 * t1)
    log = asinh(t1 / abs(h)) - asinh(t0 / abs(h)) if h != 0 else mpf(0)
    if power == 0:
        return log
    if power == 1:
        return r1 - r0
    return (t1 * r1 - t0 * r0 - h * h * log) / 2


def by_area(loops, twist, slope):
    """The same by polar coordinates about the centre of rotation, the angle by quadrature."""
    area, mx, my, _ = geometry(loops)
    vx, vy, w = twist
    cx, cy = -vy / w, vx / w
    sense = 1 if w > 0 else -1
    kx, ky = slope
    here = 1 + kx * (cx - mx) + ky * (cy - my)
    total = [mpf(0)] * 6
    for (ax, ay), (bx, by) in edges(loops):
        px, py, qx, qy = ax - cx, ay - cy, bx - cx, by - cy
        cross = px * qy - py * qx
        if cross == 0:
            continue
        start = atan2(py, px)
        sweep = atan2(cross, px * qx + py * qy)
        def along(angle):
            c, s = cos(angle), sin(angle)
            reach = cross / (c * (qy - py) - s * (qx - px))
            k1 = kx * c + ky * s
            one = here * reach**2 / 2 + k1 * reach**3 / 3
            arm = here * reach**3 / 3 + k1 * reach**4 / 4
            rate = here * reach + k1 * reach**2 / 2
            return [c * one, s * one, arm, c * c * rate, c * s * rate, s * s * rate]
        # The foot point of the edge is where the integrand is steepest.
        foot = atan2(-(qx - px), qy - py)
        if cross < 0:
            foot = atan2(qx - px, -(qy - py))
        cuts = [start, start + sweep]
        for turn in range(-2, 3):
            at = foot + turn * 2 * mp.pi
            if min(cuts) < at < max(cuts):
                cuts = [cuts[0], at, cuts[-1]]
        for i in range(6):
            total[i] += quad(lambda angle: along(angle)[i], cuts)
    pull, turn = total[:2], total[2]
    force = [sense * pull[1] / area, -sense * pull[0] / area]
    torque = -sense * turn / area + cx * force[1] - cy * force[0]
    xx, xy, yy = (part / (abs(w) * area) for part in total[3:])
    xn, yn = -(xx * vx + xy * vy) / w, -(xy * vx + yy * vy) / w
    nn = -(xn * vx + yn * vy) / w
    return force + [torque], [xx, xy, yy, xn, yn, nn]


def centres(loops, rng, rows):
    """Centres of rotation: anywhere near, far away, on corners and edges and next to them."""
    _, mx, my, radius = geometry(loops)
    mx, my, radius = float(mx), float(my), float(radius)
    sides = list(edges(loops))
    for row in range(rows):
        kind = row % 8
        (ax, ay), (bx, by) = ((float(p[0]), float(p[1])) for p in sides[rng.randrange(len(sides))])
        angle = rng.uniform(0, 6.283185307179586)
        share = rng.random()
        if kind == 0:
            yield ax, ay
        elif kind == 1:
            yield (ax + bx) / 2, (ay + by) / 2
        elif kind == 2:
            off = 10 ** rng.uniform(-13, -1)
            yield ax + share * (bx - ax) - off * (by - ay), ay + share * (by - ay) + off * (bx - ax)
        elif kind == 3:
            yield 1.5 * bx - 0.5 * ax, 1.5 * by - 0.5 * ay
        else:
            reach = rng.uniform(0, 3.5) if kind < 7 else 10 ** rng.uniform(0.4, 16)
            yield mx + reach * radius * float(cos(angle)), my + reach * radius * float(sin(angle))


def sliding(loops, twist):
    """by_edges for a spin of 0 under uniform pressure: moments of the area."""
    area, mx, my, _ = geometry(loops)
    xx = xy = yy = mpf(0)
    for (ax, ay), (bx, by) in edges(loops):
        ax, ay, bx, by = ax - mx, ay - my, bx - mx, by - my
        cross = (ax * by - ay * bx) / area
        xx += cross * (ax * ax + ax * bx + bx * bx) / 12
        xy += cross * (2 * ax * ay + ax * by + bx * ay + 2 * bx * by) / 24
        yy += cross * (ay * ay + ay * by + by * by) / 12
    vx, vy, _ = twist
    speed = sqrt(vx * vx + vy * vy)
    ex, ey = vx / speed, vy / speed
    across = [part / speed for part in (ey * ey, -ex * ey, ex * ex)]
    along = (ex * ex * xx + 2 * ex * ey * xy + ey * ey * yy) / speed
    # The centroid moves with (-y, x) for each unit of spin about the origin.
    xn, yn = across[1] * mx - across[0] * my, across[2] * mx - across[1] * my
    nn = along + yn * mx - xn * my
    return [-ex, -ey, my * ex - mx * ey], across + [xn, yn, nn]


def beside(loops, rng):
    """Twists about centres next to corners, edges and the centroid and far away; pure spin and pure sliding."""
    _, mx, my, radius = geometry(loops)
    mx, my, radius = float(mx), float(my), float(radius)
    sides = list(edges(loops))
    for kind in range(16):
        (ax, ay), (bx, by) = ((float(p[0]), float(p[1])) for p in sides[rng.randrange(len(sides))])
        angle, share = rng.uniform(0, 6.283185307179586), rng.random()
        x, y = float(cos(angle)), float(sin(angle))
        spin = rng.choice([-1, 1]) * 2.0 ** rng.randrange(-3, 4)
        if kind < 2:
            yield x, y, 0.0
            continue
        if kind < 4:
            yield x, y, spin * 10 ** rng.uniform(-25, -10)
            continue
        if kind < 6:
            at, reach = (mx, my), (kind - 4) * radius * 10 ** rng.uniform(-8, -1)
        elif kind < 9:
            at, reach = (ax, ay), radius * 10 ** rng.uniform(-16, -2)
        elif kind < 13:
            at, reach = (ax + share * (bx - ax), ay + share * (by - ay)), radius * 10 ** rng.uniform(-16, -2)
        else:
            at, reach = (mx, my), radius * 10 ** rng.uniform(1, 10)
        x, y = at[0] + reach * x, at[1] + reach * y
        yield spin * y, -spin * x, spin


def rows(per_shape):
    for name, loops in SHAPES.items():
        rng = random.Random(name)
        for row, (x, y) in enumerate(centres(loops, rng, per_shape)):
            spin = rng.choice([-1, 1]) * 2.0 ** rng.randrange(-3, 4)
            twist = (spin * y, -spin * x, spin)
            slope = (0.0, 0.0)
            if row % 2 == 1:
                _, _, _, radius = geometry(loops)
                angle = rng.uniform(0, 6.283185307179586)
                steep = rng.uniform(0, 0.9) / float(radius)
                slope = (steep * float(cos(angle)), steep * float(sin(angle)))
            yield name, loops, twist, slope
    for name, loops in SHAPES.items():
        for twist in beside(loops, random.Random(name + ", beside")):
            yield name, loops, twist, (0.0, 0.0)
    # Pressure that falls across a strip, to almost nothing at one of the long edges.
    for name in ("plank", "sliver"):
        loops, rng = SHAPES[name], random.Random(name + ", steep")
        _, half = loops[0][2]
        for x, y in centres(loops, rng, 32):
            spin, share = rng.choice([-1, 1]) * 2.0 ** rng.randrange(-3, 4), rng.uniform(0.5, 1)
            across = rng.choice([-1, 1]) * 0.99 * share / half
            yield name, loops, (spin * y, -spin * x, spin), (0.15 * (1 - share), across)
    # The same across the bar of a T, half of the centres on the stem and beyond its end.
    for name, loops in TEE.items():
        rng, (_, _, middle, _) = random.Random(name + ", steep"), geometry(loops)
        beyond = [(rng.uniform(-0.2, 0.2), rng.uniform(0.8, 2.2)) for _ in range(24)]
        for x, y in [*centres(loops, rng, 24), *beyond]:
            spin, share = rng.choice([-1, 1]) * 2.0 ** rng.randrange(-3, 4), rng.uniform(0.9, 1)
            yield name, loops, (spin * y, -spin * x, spin), (0.5 * (1 - share), 0.99 * share / float(middle))


HEADER = "shape,slope_x,slope_y,velocity_x,velocity_y,spin,force_x,force_y,torque,xx,xy,yy,xn,yn,nn"


def make(per_shape):
    print("# Dry friction of polygons per muN, and the second derivatives of its power: generate_polygons.py make")
    print(HEADER)
    for name, loops, twist, slope in rows(per_shape):
        exact, lean = [mpf(t) for t in twist], [mpf(s) for s in slope]
        wrench, hessian = by_edges(loops, exact, lean) if twist[2] else sliding(loops, exact)
        numbers = [repr(x) for x in (*slope, *twist)] + [mp.nstr(x, 25) for x in wrench + hessian]
        print(",".join([name, *numbers]))


def check(most):
    worst = mpf(0)
    done = 0
    for name, loops, twist, slope in rows(16):
        _, mx, my, radius = geometry(loops)
        twist, slope = [mpf(t) for t in twist], [mpf(s) for s in slope]
        if twist[2] == 0:
            continue
        x, y = -twist[1] / twist[2], twist[0] / twist[2]
        if max(abs(x - mx), abs(y - my)) > 20 * radius or done >= most:
            continue
        done += 1
        mp.dps = 150
        first = by_edges(loops, twist, slope)
        mp.dps = 30
        second = by_area(loops, twist, slope)
        for a, b in zip(first[0] + first[1], second[0] + second[1]):
            worst = max(worst, abs(a - b) / max(abs(a), mpf("1e-3")))
        mp.dps = 150
    print(f"{done} rows, largest difference {mp.nstr(worst, 3)}")


def fit(terms):
    """P and Q of z = 1 - y^2 with G = P + Q ln z: least squares with Lawson's weights, Q with one term less."""
    mp.dps = 40

    def bend(z):
        y = sqrt(1 - z)
        if 1 - z < mpf("0.01"):
            return sum((1 - z) ** n / (2 * n + 5) for n in range(25))
        return ((mp.atanh(y) / y - 1) / y**2 - mpf(1) / 3) / y**2

    count = 2 * terms - 1
    places = [((1 - cos(mp.pi * (k + HALF) / (3 * count))) / 2) ** mpf("1.5") for k in range(3 * count)]
    rows = [[z**k for k in range(terms)] + [mp.log(z) * z**k for k in range(terms - 1)] for z in places]
    # Errors count less where the edge's terms are small.
    scales = [(1 - z + mpf("0.03")) * (sqrt(z) + mpf("1e-3")) for z in places]
    weights, best = [mpf(1)] * len(places), None
    for _ in range(10):
        scaled = [sqrt(w) * s for w, s in zip(weights, scales)]
        left = matrix([[s * part for part in row] for s, row in zip(scaled, rows)])
        found, _ = mp.qr_solve(left, matrix([s * bend(z) for s, z in zip(scaled, places)]))
        wrong = [
            abs(mp.fdot(row, found) - bend(z)) * s for row, z, s in zip(rows, places, scales)
        ]
        if best is None or max(wrong) < best[0]:
            best = max(wrong), found
        weights = [w * (e / max(wrong) + mpf("1e-3")) for w, e in zip(weights, wrong)]
        weights = [w * len(places) / sum(weights) for w in weights]
    print("largest error", mp.nstr(best[0], 2))
    for k in range(terms):
        print([mp.nstr(best[1][n], 18) for n in (k, terms + k) if n < count])


def shapes():
    print("# Corners of the polygons of polygons.csv: generate_polygons.py shapes")
    print("shape,loop,x,y")
    for name, loops in (SHAPES | TEE).items():
        for number, loop in enumerate(loops):
            for x, y in loop:
                print(f"{name},{number},{float(x)!r},{float(y)!r}")


if __name__ == "__main__":
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    if sys.argv[1:2] == ["check"]:
        check(count or 60)
    elif sys.argv[1:2] == ["shapes"]:
        shapes()
    elif sys.argv[1:2] == ["fit"]:
        fit(count or 12)
    else:
        make(count or 64)
