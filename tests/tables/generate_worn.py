"""Reference table of Coulomb friction of worn annuli, p ~ 1/r: worn.csv.

    python3 generate_worn.py make          bars from the inner to the outer edge, closed forms, mean over their angle
    python3 generate_worn.py check [rows]  some of them again, from elliptic integrals of rings

Along a radius the load is even, so that the annulus is the mean over all angles of radial bars: their integrals are
elementary. That shares nothing with a mean over rings.
"""

import sys
from mpmath import mp, mpf, sqrt, log, pi, sin, cos, quad, ellipk, ellipe

mp.dps = 70
INNER = [0.0, 0.125, 0.5, 0.9, 0.9375, 0.99, 0.9999]
# Sliding and rim speed; some put the centre of rotation on an edge, next to it, and into the middle of the band.
SPEEDS = [(1.0, 0.0), (1.0, 1e-9), (1.0, 0.01), (1.0, 0.3), (1.0, 0.7), (1.0, 0.999), (1.0, 1.0),
          (0.999, 1.0), (0.95, 1.0), (0.9375, 1.0), (0.9, 1.0), (0.7, 1.0), (0.5, 1.0), (0.4999, 1.0), (0.125, 1.0),
          (0.05, 1.0), (0.004, 1.0), (1e-3, 1.0), (1e-9, 1.0), (0.0, 1.0), (3.0, 4.0)]


def along_radius(v, w, k, angle):
    """Integrals of the unit velocity along v, times (1, r), and of the drag's slope, over r from k to 1.

    The velocity at a radius is (v - w r sin, w r cos).
    """
    s, c = sin(angle), cos(angle)
    # |q|^2 = w^2 (r - r0)^2 + v^2 c^2, with r0 = v s/w.
    def at(r):
        q = sqrt((w * r - v * s) ** 2 + (v * c) ** 2)
        u = w * r - v * s
        big = u + q if u > 0 else (v * c) ** 2 / (q - u)
        return q, u, log(big) if big > 0 else mpf(0)
    q1, u1, l1 = at(mpf(1))
    q0, u0, l0 = at(k)
    # With u = w r - v s: int dr/q = [log(u + q)]/w; int u/q du = [q]; int q du = (u q + v^2 c^2 log)/2.
    i0 = (l1 - l0) / w
    iu = (q1 - q0) / w
    iuu = ((u1 * q1 - u0 * q0) - (v * c) ** 2 * (l1 - l0)) / (2 * w)
    # Force along v: v - w r s = v c^2 - s u. Torque: r (w r - v s) = r u = (u + v s) u/w.
    force = v * c * c * i0 - s * iu
    torque = (iuu + v * s * iu) / w
    # Second derivatives: (cross of unit velocity)^2/q; d F/d v = w^2 r^2 c^2/q^3.
    return force, torque


def wrench(v, w, k):
    v, w, k = mpf(v), mpf(w), mpf(k)
    if w == 0:
        return [mpf(1), mpf(0)]
    if v == 0:
        return [mpf(0), (1 + k) / 2]
    places = {-pi / 2, pi / 2, mpf(0)}
    for r in (mpf(1), k):
        for k_ in range(70):
            places.add(pi / 2 - mpf(2) ** -k_)
    edges = sorted(places)
    total = [mpf(0), mpf(0)]
    for low, high in zip(edges, edges[1:]):
        for node, weight in gauss():
            found = along_radius(v, w, k, (low + high) / 2 + (high - low) / 2 * node)
            total = [t + (high - low) / 2 * weight * x for t, x in zip(total, found)]
    return [t / pi / (1 - k) for t in total]


RULE = []


def gauss(count=30):
    """Nodes and weights on [-1, 1]: Newton's method on the recurrence."""
    for k in range(0 if RULE else count):
        x = cos(pi * (k + mpf(3) / 4) / (count + mpf(1) / 2))
        for _ in range(8):
            before, here = mpf(1), x
            for n in range(1, count):
                before, here = here, ((2 * n + 1) * x * here - n * before) / (n + 1)
            slope = count * (x * here - before) / (x * x - 1)
            x -= here / slope
        RULE.append((x, 2 / ((1 - x * x) * slope ** 2)))
    return RULE


def ring(v, u):
    """Force and torque over the radius of a ring: derivatives of 2/pi (v + u) E(4 v u/(v + u)^2)."""
    m = 4 * v * u / (v + u) ** 2
    e, k = ellipe(m), ellipk(m) if m != 1 else mpf(0)
    if u == 0:
        return mpf(1), mpf(0)
    if v == u:
        return 2 / pi, 2 / pi
    return ((v + u) * e + (v - u) * k) / (pi * v), ((v + u) * e - (v - u) * k) / (pi * u)


def by_rings(v, w, k):
    v, w, k = mpf(v), mpf(w), mpf(k)
    points = [k, mpf(1)]
    if w and k < v / w < 1:
        points.insert(1, v / w)
    return [quad(lambda r: ring(v, r * w)[0], points) / (1 - k), quad(lambda r: r * ring(v, r * w)[1], points) / (1 - k)]


def jacobian(v, w, k, force, torque):
    """F/v, dF/dv, dF/dw, dT/dw from the rings at the edges: F w (1 - k) is the integral of F(v, u) over u."""
    v, w, k = mpf(v), mpf(w), mpf(k)
    if v == 0:
        damping = log(1 / k) / 2 / w / (1 - k) if k else mp.inf
        return [damping, damping, mpf(0), mpf(0)]
    if w == 0:
        return [1 / v, mpf(0), mpf(0), (1 + k + k * k) / 6 / v]
    outer, inner = ring(v, w), ring(v, k * w)
    mixed = (outer[0] - k * inner[0]) / (1 - k) / w - force / w
    return [force / v, -w / v * mixed, mixed, -v / w * mixed]


def make():
    with open("worn.csv", "w") as out:
        out.write("# Coulomb friction of worn annuli: generate_worn.py make\n")
        out.write("inner,slide,rim,force,torque,force_per_slide,force_slide,mixed,torque_rim\n")
        for k in INNER:
            for v, w in SPEEDS:
                force, torque = wrench(v, w, k)
                found = [force, torque] + jacobian(v, w, k, force, torque)
                out.write(",".join([repr(x) for x in (k, v, w)] + [mp.nstr(x, 22) for x in found]) + "\n")


def check(count):
    rows = [(v, w, k) for k in INNER for v, w in SPEEDS if v and w][::5][:count]
    for row in rows:
        print(*row, mp.nstr(max(abs(x - y) for x, y in zip(wrench(*row), by_rings(*row))), 3), flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["make"]:
        make()
    elif sys.argv[1:2] == ["check"]:
        check(int(sys.argv[2]) if len(sys.argv) > 2 else 12)
    else:
        sys.exit(__doc__)
