"""Reference table of dry friction on meshes of triangles: meshes.csv, and mesh_triangles.csv.

    python3 generate_meshes.py triangles                 their corners and pressures
    python3 generate_meshes.py make [rows a mesh]        from line integrals with 150 digits
    python3 generate_meshes.py check [rows]              some of them again, by area integrals

Each triangle is a polygon of `generate_polygons` under linear pressure, with its share of the load.
`make` sums its closed line integrals about the centre of rotation with so many digits that their
cancellation does not matter, however small the triangle is and however far away; `check` cuts each
triangle into three with the centre of rotation as a corner and integrates these in polar
coordinates.
"""

import random
import sys
from mpmath import mp, mpf, sqrt, cos, sin
from generate_polygons import by_area, by_edges, centres

mp.dps = 150
HEADER = "mesh,velocity_x,velocity_y,spin,force_x,force_y,torque,xx,xy,yy,xn,yn,nn"


def grid(rng, count, pressure):
    """A jittered grid of squares, each cut in two; `pressure` at each vertex."""
    step = 1 / count
    at = {}
    for i in range(count + 1):
        for j in range(count + 1):
            inner = 0 < i < count and 0 < j < count
            jitter = [rng.uniform(-0.3, 0.3) * step if inner else 0.0 for _ in range(2)]
            x, y = i * step + jitter[0], j * step + jitter[1]
            at[i, j] = (x, y, pressure(rng, x, y))
    for i in range(count):
        for j in range(count):
            a, b, c, d = at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]
            yield (a, b, c)
            yield (c, a, d) if (i + j) % 3 else (c, d, a)


def dome(rings, sectors):
    """A round face with the pressure sqrt(1 - r^2) at its vertices, none at the rim."""
    def vertex(ring, sector):
        r = ring / rings
        angle = 6.283185307179586 * sector / sectors
        return (r * float(cos(angle)), r * float(sin(angle)), float(sqrt(1 - mpf(r) ** 2)))
    for ring in range(rings):
        for sector in range(sectors):
            a, b = vertex(ring, sector), vertex(ring + 1, sector)
            c, d = vertex(ring + 1, sector + 1), vertex(ring, sector + 1)
            yield (a, b, c)
            if ring:
                yield (a, c, d)


def soup(rng, count):
    """Triangles that do not touch, with pressures that share nothing."""
    done = 0
    while done < count:
        x, y = 2.5 * (done % 4), 2.5 * (done // 4)
        a, b, c = ((x + rng.uniform(0, 2), y + rng.uniform(0, 2), 10 ** rng.uniform(-3, 0)) for _ in range(3))
        twice = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        longest = max((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 for p, q in ((a, b), (b, c), (c, a)))
        # At most 5 times as long as wide.
        if twice > 0.2 * longest:
            yield (a, b, c)
            done += 1


def graded(levels):
    """Squares that shrink by 4 towards a corner, each under 16 times the pressure before."""
    for level in range(levels):
        side, pressure = 4.0**-level, 16.0**level
        a, b = (side, 0.0, pressure), (side, side, 2 * pressure)
        c, d = (0.25 * side, 0.25 * side, 4 * pressure), (0.25 * side, 0.0, 8 * pressure)
        yield (a, b, c)
        yield (d, a, c)


def needles(rng):
    for n in range(10):
        y = 0.3 * n
        yield ((0.0, y, rng.random()), (4.0, y + 0.05, rng.random()), (rng.uniform(0, 4), y + 0.2, rng.random()))


def meshes():
    """Name and triangles of each mesh."""
    rng = random.Random("meshes")
    yield "one", [((0.0, 0.0, 1.0), (3.0, 0.25, 0.0), (1.0, 2.0, 0.5))]
    yield "patchwork", list(grid(rng, 4, lambda rng, x, y: rng.random()))
    yield "slope", list(grid(rng, 6, lambda rng, x, y: 3.0 + 2.0 * x - y))
    yield "fine", list(grid(rng, 16, lambda rng, x, y: 1.0 + x * y + 0.1 * rng.random()))
    yield "dome", list(dome(6, 12))
    yield "soup", list(soup(rng, 12))
    yield "graded", list(graded(8))
    yield "needles", list(needles(rng))
    yield "spike", [((0.0, 0.0, 1.0), (8.0, 0.0, 1.0), (0.0, 6.0, 1.0)),
                    ((7.0, 5.0, 1e9), (7.0001, 5.0, 0.0), (7.0, 5.0002, 0.0))]


def polygon_of(triangle):
    """The triangle as loops, its load, and the slope of its pressure over its mean."""
    (ax, ay, p), (bx, by, q), (cx, cy, r) = ([mpf(part) for part in corner] for corner in triangle)
    twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if twice < 0:
        bx, by, q, cx, cy, r = cx, cy, r, bx, by, q
        twice = -twice
    mean = (p + q + r) / 3
    slope = (((q - p) * (cy - ay) - (r - p) * (by - ay)) / twice,
             ((r - p) * (bx - ax) - (q - p) * (cx - ax)) / twice)
    loops = [[(ax, ay), (bx, by), (cx, cy)]]
    return loops, twice / 2 * mean, (slope[0] / mean, slope[1] / mean)


def summed(triangles, twist, one):
    """Wrench and Hessian of a mesh per muN, each triangle by `one`."""
    total, load = [mpf(0)] * 9, mpf(0)
    for triangle in triangles:
        loops, share, slope = polygon_of(triangle)
        wrench, hessian = one(loops, twist, slope)
        total = [sum_ + share * part for sum_, part in zip(total, wrench + hessian)]
        load += share
    return [part / load for part in total]


def rows(per_mesh):
    for name, triangles in meshes():
        rng = random.Random(name)
        box = [[(min(c[0] for t in triangles for c in t), min(c[1] for t in triangles for c in t)),
                (max(c[0] for t in triangles for c in t), min(c[1] for t in triangles for c in t)),
                (max(c[0] for t in triangles for c in t), max(c[1] for t in triangles for c in t)),
                (min(c[0] for t in triangles for c in t), max(c[1] for t in triangles for c in t))]]
        around = centres(box, rng, per_mesh)
        for row in range(per_mesh):
            # On corners and edges of triangles and next to them, inside of them, and anywhere.
            triangle = rng.choice(triangles)
            one = [[(c[0], c[1]) for c in polygon_of(triangle)[0][0]]]
            x, y = next(centres(one, rng, 1)) if row % 2 == 0 else next(around)
            if row % 8 == 2:
                x, y = (float(sum(c[i] for c in triangle) / 3) for i in range(2))
            if row % 8 == 4:
                side = one[0]
                off = 10 ** rng.uniform(-13, -1)
                (ax, ay), (bx, by) = ((float(p[0]), float(p[1])) for p in side[:2])
                share = rng.random()
                x = ax + share * (bx - ax) - off * (by - ay)
                y = ay + share * (by - ay) + off * (bx - ax)
            spin = rng.choice([-1, 1]) * 2.0 ** rng.randrange(-3, 4)
            yield name, triangles, (spin * y, -spin * x, spin)


def make(per_mesh):
    print("# Dry friction of meshes per muN, and the second derivatives of its power: generate_meshes.py make")
    print(HEADER)
    for name, triangles, twist in rows(per_mesh):
        numbers = summed(triangles, [mpf(t) for t in twist], by_edges)
        cells = [repr(x) for x in twist] + [mp.nstr(x, 25) for x in numbers]
        print(",".join([name, *cells]), flush=True)


def check(most):
    worst, done = mpf(0), 0
    for name, triangles, twist in rows(6):
        if len(triangles) > 40 or name in ("graded", "spike") or done >= most:
            continue
        twist = [mpf(t) for t in twist]
        mp.dps = 150
        first = summed(triangles, twist, by_edges)
        size = max(abs(part) for part in first)
        if max(abs(t) for t in twist[:2]) > 100 * abs(twist[2]):
            continue
        done += 1
        mp.dps = 30
        second = summed(triangles, twist, by_area)
        for a, b in zip(first, second):
            worst = max(worst, abs(a - b) / max(abs(a), size * mpf("1e-3")))
        mp.dps = 150
    print(f"{done} rows, largest difference {mp.nstr(worst, 3)}")


def triangles():
    print("# Triangles of the meshes of meshes.csv: generate_meshes.py triangles")
    print("mesh,x1,y1,p1,x2,y2,p2,x3,y3,p3")
    for name, all_ in meshes():
        for triangle in all_:
            print(",".join([name, *(repr(float(part)) for corner in triangle for part in corner)]))


if __name__ == "__main__":
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    if sys.argv[1:2] == ["check"]:
        check(count or 20)
    elif sys.argv[1:2] == ["triangles"]:
        triangles()
    else:
        make(count or 40)
