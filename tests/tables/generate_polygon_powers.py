"""Reference table of friction |v|^alpha on polygons: polygon_powers.csv.

    python3 generate_polygon_powers.py make [rows a shape]   from line integrals with 130 digits
    python3 generate_polygon_powers.py check [rows]          some of them again, by area integrals

`make` sums line integrals about the centre of rotation, Gauss' hypergeometric function, with so many digits
that their cancellation at a far centre does not matter. `check` shares nothing with it: the patch is cut
into triangles that have the centre of rotation as a corner, each with its sign, and these are
integrated in polar coordinates (r in closed form, the angle by Gauss).
"""

import random
import sys
from mpmath import mp, mpf, sqrt, atan2, cos, sin, quad, hyp2f1, nstr

from generate_polygons import SHAPES, centres, edges, geometry

mp.dps = 130
HALF = mpf(1) / 2
ALPHAS = [-0.5, 0.5, 1.0, 2.3, 3.0, 0.0625, 2.0, -0.875, 10.0]


def arc(h, t, power):
    """int_0^t (h^2 + t^2)^(power/2) dt."""
    if h == 0:
        return mp.sign(t) * abs(t) ** (power + 1) / (power + 1) if t else mpf(0)
    return abs(h) ** power * t * hyp2f1(-power / 2, HALF, 3 * HALF, -((t / h) ** 2))


def by_edges(loops, twist, slope, alpha):
    """Force, torque about the origin, and minus their derivatives (xx, xy, yy, xn, yn, nn), per load.

    Pressure per load (1 + slope . (x - centroid))/area."""
    area, mx, my, _ = geometry(loops)
    vx, vy, w = twist
    cx, cy = -vy / w, vx / w
    beta = 1 + alpha
    kx, ky = slope
    here = 1 + kx * (cx - mx) + ky * (cy - my)
    zero = mpf(0)
    pull, moment = [zero, zero], [zero, zero]
    turn = zero
    M, B, S = ([[zero] * 2 for _ in range(2)] for _ in range(3))
    for (ax, ay), (bx, by) in edges(loops):
        dx, dy = bx - ax, by - ay
        length = sqrt(dx * dx + dy * dy)
        t, n = (dx / length, dy / length), (dy / length, -dx / length)
        h = (ax - cx) * n[0] + (ay - cy) * n[1]
        t0 = (ax - cx) * t[0] + (ay - cy) * t[1]
        t1 = t0 + length
        r0, r1 = sqrt(h * h + t0 * t0), sqrt(h * h + t1 * t1)
        whole = arc(h, t1, beta) - arc(h, t0, beta)
        bent = h * (arc(h, t1, beta - 2) - arc(h, t0, beta - 2)) if h != 0 else zero
        rise = (r1**beta - r0**beta) / beta
        first = (r1 ** (beta + 2) - r0 ** (beta + 2)) / (beta + 2)
        square = whole - h * bent  # int t^2 r^(beta-2)
        kn, kt = kx * n[0] + ky * n[1], kx * t[0] + ky * t[1]
        turn += h * whole
        for i in range(2):
            pull[i] += n[i] * whole
            b = h * n[i] * whole + t[i] * first
            moment[i] += h * b
            m = n[i] * bent + t[i] * rise
            both = n[i] * (kn * h * bent + kt * h * rise) + t[i] * (kn * h * rise + kt * square)
            for j in range(2):
                M[i][j] += m * n[j]
                B[i][j] += both * n[j]
                S[i][j] += b * n[j]
    turn /= beta + 2
    pull = [part / beta for part in pull]
    for i in range(2):
        for j in range(2):
            S[i][j] = (S[i][j] - (turn if i == j else 0)) / beta
    k = [kx, ky]
    total = [here * pull[i] + S[i][0] * kx + S[i][1] * ky for i in range(2)]
    torque = here * turn + (kx * moment[0] + ky * moment[1]) / (beta + 3)
    even = beta * (kx * pull[0] + ky * pull[1])
    trace = M[0][0] + M[1][1]
    K = [[here * ((trace if i == j else 0) - M[i][j]) + (even if i == j else 0) - B[i][j] + pull[i] * k[j]
          for j in range(2)] for i in range(2)]
    return finished(twist, alpha, total, torque, (K[0][0], (K[0][1] + K[1][0]) / 2, K[1][1]), area)


def finished(twist, alpha, pull, turn, K, area):
    """Wrench about the origin and derivatives from the integrals about the centre of rotation."""
    vx, vy, w = twist
    cx, cy = -vy / w, vx / w
    speed = abs(w) ** alpha
    sense = 1 if w > 0 else -1
    force = [sense * speed * pull[1] / area, -sense * speed * pull[0] / area]
    torque = -sense * speed * turn / area + cx * force[1] - cy * force[0]
    xx, xy, yy = (part * speed / (abs(w) * area) for part in K)
    # Euler: the derivatives times the twist are alpha times the wrench.
    xn = (-alpha * force[0] - xx * vx - xy * vy) / w
    yn = (-alpha * force[1] - xy * vx - yy * vy) / w
    nn = (-alpha * torque - xn * vx - yn * vy) / w
    return force + [torque], [xx, xy, yy, xn, yn, nn]


def by_area(loops, twist, slope, alpha):
    """The same by polar coordinates about the centre of rotation, the angle by quadrature."""
    area, mx, my, _ = geometry(loops)
    vx, vy, w = twist
    cx, cy = -vy / w, vx / w
    kx, ky = slope
    here = 1 + kx * (cx - mx) + ky * (cy - my)
    total = [mpf(0)] * 6
    for (ax, ay), (bx, by) in edges(loops):
        px, py, qx, qy = ax - cx, ay - cy, bx - cx, by - cy
        cross = px * qy - py * qx
        if abs(cross) < mpf(10) ** -30:
            continue
        start = atan2(py, px)
        sweep = atan2(cross, px * qx + py * qy)

        def along(angle):
            c, s = cos(angle), sin(angle)
            reach = cross / (c * (qy - py) - s * (qx - px))
            slant = kx * c + ky * s
            over = lambda n: here * reach ** (alpha + n) / (alpha + n) + slant * reach ** (alpha + n + 1) / (alpha + n + 1)
            one, arm, rate = over(2), over(3), over(1)
            # r^(alpha-1) (alpha - (alpha-1) rho rho/r^2)
            return [c * one, s * one, arm, (alpha - (alpha - 1) * c * c) * rate,
                    -(alpha - 1) * c * s * rate, (alpha - (alpha - 1) * s * s) * rate]

        # The foot point of the edge is where the integrand is steepest.
        side = 1 if cross > 0 else -1
        foot = atan2(-side * (qx - px), side * (qy - py))
        cuts = [start + sweep * mpf(i) / 4 for i in range(5)]
        for whole in range(-2, 3):
            at = foot + whole * 2 * mp.pi
            if min(cuts) < at < max(cuts):
                cuts = sorted(cuts + [at], reverse=sweep < 0)
        for i in range(6):
            total[i] += quad(lambda angle: along(angle)[i], cuts)
    return finished(twist, alpha, total[:2], total[2], total[3:], area)


def rows(per_shape):
    for name, loops in SHAPES.items():
        if name == "sliver":
            continue
        rng = random.Random(name + " powers")
        for row, (x, y) in enumerate(centres(loops, rng, per_shape)):
            alpha = ALPHAS[row // 8 % len(ALPHAS)]
            spin = rng.choice([-1, 1]) * 2.0 ** rng.randrange(-3, 4)
            twist = (spin * y, -spin * x, spin)
            slope = (0.0, 0.0)
            if (row + row // 8) % 2 == 1:
                _, _, _, radius = geometry(loops)
                angle = rng.uniform(0, 6.283185307179586)
                steep = rng.uniform(0, 0.9) / float(radius)
                slope = (steep * float(cos(angle)), steep * float(sin(angle)))
            yield name, loops, twist, slope, alpha


HEADER = "shape,alpha,slope_x,slope_y,velocity_x,velocity_y,spin,force_x,force_y,torque,xx,xy,yy,xn,yn,nn"


def make(per_shape):
    print("# Friction |v|^alpha of polygons per load, and minus its derivatives: generate_polygon_powers.py make")
    print(HEADER)
    for name, loops, twist, slope, alpha in rows(per_shape):
        given = [mpf(t) for t in twist], [mpf(s) for s in slope], mpf(alpha)
        wrench, hessian = by_edges(loops, *given)
        numbers = [repr(x) for x in (alpha, *slope, *twist)] + [nstr(x, 21) for x in wrench + hessian]
        print(",".join([name, *numbers]))


def check(most):
    worst, where = mpf(0), None
    done = 0
    for number, (name, loops, twist, slope, alpha) in enumerate(rows(8 * len(ALPHAS))):
        _, mx, my, radius = geometry(loops)
        given = [mpf(t) for t in twist], [mpf(s) for s in slope], mpf(alpha)
        x, y = -given[0][1] / given[0][2], given[0][0] / given[0][2]
        if number % 5 != 0 or max(abs(x - mx), abs(y - my)) > 20 * radius or done >= most:
            continue
        done += 1
        mp.dps = 130
        first = by_edges(loops, *given)
        mp.dps = 30
        second = by_area(loops, *given)
        mp.dps = 130
        for a, b in zip(first, second):
            size = max(abs(part) for part in a)
            error = max(abs(p - q) for p, q in zip(a, b)) / size
            if error > worst:
                worst, where = error, (name, twist, slope, alpha)
    print(f"{done} rows, largest difference {nstr(worst, 3)} of the largest entry, at {where}")


if __name__ == "__main__":
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    if sys.argv[1:2] == ["check"]:
        check(count or 40)
    else:
        make(count or 8 * len(ALPHAS))
