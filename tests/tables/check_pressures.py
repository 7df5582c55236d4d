#!/usr/bin/env python3
"""Independent checks of the tables of generate_pressures.py.

    python3 check_pressures.py [--only NAME ...]

Direct integrals of the friction over the patch, no hypergeometric function:
  * in double precision for every row: rings of pressure, panels graded towards the rotation centre and the rim;
  * at 40 digits for some rows: along rays from the rotation centre (eps < 1) or from the middle (eps > 1);
  * at 40 digits for eps = 1, where the integral along a ray is a product of Gamma functions.
dF and dT by numerical differentiation of F and T.  Needs mpmath 1.3, numpy, scipy.
"""
import argparse

import mpmath as mp
import numpy as np
from mpmath import mpf
from scipy.special import roots_jacobi

from generate import Worst, read
from generate_pressures import NAMES, SELECTED, annulus, family, polynomial

# ---------------------------------------------------------------- rings of pressure, double precision

NODES, WEIGHTS = np.polynomial.legendre.leggauss(14)
LEVELS = 52


def graded(length, jacobi=None):
    """Nodes and weights on [0, length], panels halved towards 0; with `jacobi` = q the innermost weight is x^q."""
    edges = length * 2.0 ** -np.arange(LEVELS + 1)
    half, mid = (edges[:-1] - edges[1:]) / 2, (edges[:-1] + edges[1:]) / 2
    x, w = mid[:, None] + half[:, None] * NODES, half[:, None] * WEIGHTS
    if jacobi is None:
        return np.append(x.ravel(), edges[-1] / 2), np.append(w.ravel(), edges[-1])
    z, v = roots_jacobi(20, 0.0, jacobi)
    inner = edges[-1] * (1 + z) / 2
    return np.append(x.ravel(), inner), np.append((w * x ** jacobi).ravel(), v * (edges[-1] / 2) ** (1 + jacobi))


ANGLE, ANGLE_WEIGHT = graded(np.pi)


def ring_forces(alpha, eps, r, beyond):
    """<F, T, G> on rings of radius r, one ring a row; beyond = r - eps without cancellation."""
    r, beyond = r[:, None], beyond[:, None]
    drop = 2 * np.sin(ANGLE / 2) ** 2                     # 1 - sin(phi), phi = pi/2 - angle
    d2 = beyond ** 2 + 2 * eps * r * drop
    with np.errstate(divide="ignore", invalid="ignore"):
        power = np.where(d2 > 0, d2 ** ((alpha - 1) / 2), 0.0)
    parts = (r * drop - beyond, r * (beyond + eps * drop), (r * np.sin(ANGLE)) ** 2)
    return [power * p @ ANGLE_WEIGHT / np.pi for p in parts]


def radial_rule(inner, eps, q):
    """r, r - eps, weights of int_inner^1 (..) (1-r)^q dr: graded towards eps and towards the rim."""
    out = []

    def piece(anchor, direction, length):
        rim = anchor == 1.0
        x, w = graded(length, q if rim else None)
        r, beyond = anchor + direction * x, (anchor - eps) + direction * x
        out.append((r, beyond, w if rim else w * (1 - r if anchor != eps else (1 - eps) - direction * x) ** q))

    if inner < eps < 1:
        piece(eps, -1, eps - inner)
        piece(eps, 1, (1 - eps) / 2)
        piece(1.0, -1, (1 - eps) / 2)
    else:                                                 # the centre of rotation is on no ring
        if eps <= inner:
            piece(inner, 1, (1 - inner) / 2)
            piece(1.0, -1, (1 - inner) / 2)
        else:
            piece(1.0, -1, 1.0 - inner)
    return [np.concatenate(x) for x in zip(*out)]


def by_rings(alpha, eps, density, inner=0.0, q=0.0):
    """F, T, G for the pressure density(r) (1-r)^q / pi on inner < r < 1."""
    r, beyond, w = radial_rule(inner, eps, q)
    return [2 * np.sum(w * density(r) * r * x) for x in ring_forces(alpha, eps, r, beyond)]


def family_by_rings(q, alpha, eps):
    """The three of p_q in double precision."""
    if q == -1:
        return [x[0] for x in ring_forces(alpha, eps, np.array([1.0]), np.array([1.0 - eps]))]
    return by_rings(alpha, eps, lambda r: (q + 1) * (1 + r) ** q, q=q)


def row_by_rings(row):
    """The three for a row of any of the tables."""
    alpha, eps = float(row["alpha"]), float(row["eps"])
    if "k" in row:
        k = float(row["k"])
        return by_rings(alpha, eps, lambda r: 1 / (1 - k * k) + 0 * r, inner=k)
    if "a0" in row:
        a = [float(row[x]) for x in ("a0", "a1", "a2")]
        load = a[0] + a[1] / 2 + a[2] / 3
        return by_rings(alpha, eps, lambda r: (a[0] + a[1] * r ** 2 + a[2] * r ** 4) / load)
    return family_by_rings(float(row.get("q", 0.0)), alpha, eps)


def check_rings(name):
    """Every row, relative to the largest of F, T, G (F cancels for small eps and T for large).

    In pressures.csv the row eps = 1 is left to `at_the_rim`: there (1-r)^q and the rotation centre meet.
    """
    worst, near = (Worst(f"{name} vs rings of pressure, double precision{x}") for x in ("", ", |eps-1| < 1e-8"))
    for row in read(f"{name}.csv"):
        gap = abs(float(row["eps"]) - 1)
        if name == "pressures" and gap == 0:
            continue
        got = row_by_rings(row)
        known = {c: float(row[c]) for c in "FTG" if c in row}
        scale = max(known.values())
        for c, x in zip("FTG", got):
            if c in known:
                measure = near if name == "pressures" and gap < 1e-8 else worst
                measure.add(1 + (mpf(x) - mpf(row[c])) / scale, mpf(1), (*list(row.values())[:4], c))
    worst.show()
    if near.count:
        near.show()


# ---------------------------------------------------------------- rays, 40 digits


def gauss_jacobi(n, right, left):
    """Nodes and weights for the weight (1-t)^right t^left on [0, 1] (Golub and Welsch)."""
    a, b = mpf(right), mpf(left)
    matrix = mp.zeros(n)
    for k in range(n):
        c = 2 * k + a + b
        matrix[k, k] = (b - a) / (a + b + 2) if k == 0 else (b * b - a * a) / (c * (c + 2))
        if k:
            first = 4 * (1 + a) * (1 + b) / ((2 + a + b) ** 2 * (3 + a + b))
            square = first if k == 1 else 4 * k * (k + a) * (k + b) * (k + a + b) / (c ** 2 * (c + 1) * (c - 1))
            matrix[k, k - 1] = matrix[k - 1, k] = mp.sqrt(square)
    values, vectors = mp.eigsy(matrix)
    total = mp.beta(a + 1, b + 1)
    return [((1 + values[k]) / 2, total * vectors[0, k] ** 2) for k in range(n)]


def mean_over_turn(function, n):
    """Mean of (F, T, G) values over n equal angles."""
    sums = [mpf(0)] * 3
    for k in range(n):
        co, si = mp.cos_sin(2 * mp.pi * (k + mpf(1) / 2) / n)
        sums = [x + y for x, y in zip(sums, function(co, si))]
    return [x / n for x in sums]


def from_rotation_centre(q, alpha, eps, rule, n=96):
    """eps < 1, q > -1: along each ray d^(alpha+1) (reach - d)^q (d + back)^q is a Jacobi weight times a smooth rest."""
    def ray(co, si):
        root = mp.sqrt(1 - (eps * co) ** 2)
        reach, back = root - eps * si, root + eps * si
        zero = one = mpf(0)
        for t, w in rule:
            rest = w * (reach * t + back) ** q
            zero, one = zero + rest, one + rest * t
        zero *= reach ** (alpha + 2 + q)
        one *= reach ** (alpha + 3 + q)
        return -si * zero, one + eps * si * zero, co * co * one

    return [2 * (q + 1) * x for x in mean_over_turn(ray, n)]


def ring_turn(alpha, eps, r, n):
    """<F, T, G> on one ring, eps away from r."""
    def point(co, si):
        power = (eps * eps + r * r - 2 * eps * r * si) ** ((alpha - 1) / 2)
        return power * (eps - r * si), power * (r * r - eps * r * si), power * (r * co) ** 2

    return mean_over_turn(point, n)


def from_the_middle(q, alpha, eps, rule, n):
    """eps > 1, q > -1: ring means are smooth in t = r^2, the weight is (1-t)^q."""
    sums = [mpf(0)] * 3
    for t, w in rule:
        sums = [x + w * y for x, y in zip(sums, ring_turn(alpha, eps, mp.sqrt(t), n))]
    return [(q + 1) * x for x in sums]


def at_the_rim(q, alpha):
    """eps = 1: along a ray at angle theta below the tangent d^(alpha+1+q) (2 sin theta - d)^q."""
    def along(n):
        a = alpha + 2 + n + q                             # (q+1) B(a, q+1), also for the ring
        return mp.gamma(a) * mp.gamma(q + 2) / mp.gamma(a + q + 1) * mpf(2) ** (a + q)

    def sines(p):
        return mp.beta((p + 1) / 2, mpf(1) / 2) / mp.pi   # (1/pi) int_0^pi sin^p

    p0, p1 = alpha + 2 + 2 * q, alpha + 3 + 2 * q         # powers of sin in the two integrals
    f = along(0) * sines(p0 + 1)
    one = along(1)
    return f, one * sines(p1) - f, one * (sines(p1) - sines(p1 + 2))


def close_inside(q, alpha, eps):
    """eps just below 1, q > -1: as `from_rotation_centre`, each ray a 2F1 of its own ratio, angles graded."""
    def ray(theta):
        co, si = mp.cos_sin(theta)
        gap = 1 - eps * eps
        root = mp.sqrt(gap + (eps * si) ** 2)
        long = root + eps * abs(si)
        reach, back = (long, gap / long) if si < 0 else (gap / long, long)
        zero, one = (mp.beta(alpha + 2 + n, q + 1) * reach ** (alpha + 2 + q + n) * back ** q
                     * mp.hyp2f1(-q, alpha + 2 + n, alpha + q + 3 + n, -reach / back) for n in (0, 1))
        return -si * zero, one + eps * si * zero, co * co * one

    steps = [mpf(2) ** -k for k in range(46, 0, -4)]
    cuts = [-mp.pi / 2] + [-x for x in reversed(steps)] + [0] + steps + [mp.pi / 2]
    return [2 * (q + 1) / mp.pi * mp.quad(lambda t, i=i: ray(t)[i], cuts, method="gauss-legendre", maxdegree=5)
            for i in range(3)]


def check_close():
    """Rows with eps = 1 - 2^-40."""
    worst = Worst("pressures, eps = 1 - 2^-40, vs rays with a 2F1 each, 30 digits")
    with mp.workdps(30):
        for row in read("pressures.csv"):
            q, alpha, eps = (mpf(float(row[c])) for c in ("q", "alpha", "eps"))
            if float(q) in (-0.9, -0.25, 2.0) and float(alpha) in (-0.9, -0.3, 0.0, 3.0) and 0 < 1 - eps < 1e-9:
                for c, x in zip("FTG", close_inside(q, alpha, eps)):
                    worst.add(x, mpf(row[c]), (row["q"], row["alpha"], c))
    worst.show()


RAY_ALPHA = [-0.9, -0.75, -0.3, 0.0, 0.5, 2.0, 5.0]


def check_rays():
    """Some rows of pressures.csv at 40 digits, and all with eps = 1."""
    ray, rim = Worst("pressures vs rays, 40 digits"), Worst("pressures, eps = 1, vs Gamma functions")
    with mp.workdps(40):
        rules = {}
        for row in read("pressures.csv"):
            q, alpha, eps = (mpf(float(row[c])) for c in ("q", "alpha", "eps"))
            if eps == 1:
                got, worst = at_the_rim(q, alpha), rim
            elif float(alpha) in RAY_ALPHA and float(eps) in (1e-9, 0.3, 1.4, 1e4):
                worst = ray
                turn = 300 if eps == 1.4 else 96
                left = alpha + 1 if eps < 1 else mpf(0)
                if q > -1 and (q, left) not in rules:
                    rules[q, left] = gauss_jacobi(30, q, left)
                if q == -1:
                    got = ring_turn(alpha, eps, mpf(1), turn)
                elif eps < 1:
                    got = from_rotation_centre(q, alpha, eps, rules[q, left])
                else:
                    got = from_the_middle(q, alpha, eps, rules[q, left], turn)
            else:
                continue
            for c, x in zip("FTG", got):
                worst.add(x, mpf(row[c]), (row["q"], row["alpha"], row["eps"], c))
    ray.show()
    rim.show()


# ---------------------------------------------------------------- slopes


def check_slopes(name):
    """dF and dT against central differences of F and T, every third row but eps = 0, 1 and k."""
    def at(row, e):
        alpha = mpf(float(row["alpha"]))
        if "k" in row:
            return annulus(float(row["k"]), alpha, e)[:2]
        if "a0" in row:
            return polynomial([float(row[x]) for x in ("a0", "a1", "a2")], alpha, e)[:2]
        return family(float(row["q"]), alpha, e)[:2]

    worst = Worst(f"{name}: dF, dT vs central differences")
    with mp.workdps(90):
        for row in read(f"{name}.csv")[::3]:
            eps = mpf(float(row["eps"]))
            inner = mpf(float(row["k"])) if "k" in row else mpf(1)
            h = mpf(10) ** -14 * min(eps, abs(eps - 1), abs(eps - inner))
            if h == 0:
                continue
            up, down = at(row, eps + h), at(row, eps - h)
            for c, x, y in zip(("dF", "dT"), up, down):
                if float(row[c]):
                    worst.add((x - y) / (2 * h), mpf(row[c]), (*list(row.values())[:4], c))
    worst.show()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", choices=NAMES, default=NAMES)
    for name in parser.parse_args().only:
        check_rings(name)
        if name == "pressures":
            check_rays()
            check_close()
        if name not in (*SELECTED, "uniform_lateral"):
            check_slopes(name)


if __name__ == "__main__":
    main()
