#!/usr/bin/env python3
"""High-precision reference tables for the coupled sliding/spinning friction of a
uniform circular patch (radius 1, load 1, coefficient 1, local law |u|^alpha).

    python3 generate.py make [--reference DIR] [--only NAME ...]
    python3 generate.py check [--only NAME ...]

`make` writes the CSV files next to this script.  uniform.csv and fixed_points.csv
are selections from uniform_public.csv and fixed_points_public.csv in DIR and are
skipped without --reference.  `check` re-derives the tables by independent routes
(numerical integrals, other formulas, an ODE solver) and prints the worst deviations.
Needs Python 3.11+, mpmath 1.3; scipy only for `check --only stops`.
"""
import argparse
import csv
import math
import os
from fractions import Fraction
from math import comb, nextafter, inf

import mpmath as mp
from mpmath import mpf

HERE = os.path.dirname(os.path.abspath(__file__))
DIGITS = 25            # significant digits written
DPS_LO, DPS_HI = 60, 90   # every closed form is evaluated at both and compared

# ---------------------------------------------------------------- small helpers


def text(x):
    """25 significant digits of an mpf."""
    return mp.nstr(x, DIGITS)


def write(name, about, columns, rows):
    """One CSV: a comment line, the header, the rows."""
    cmd = f"python3 generate.py make --only {name[:-4]}"
    if name in ("uniform.csv", "fixed_points.csv"):
        cmd += " --reference DIR"
    with open(os.path.join(HERE, name), "w", newline="") as f:
        f.write(f"# {about}; made by: {cmd}\n")
        out = csv.writer(f, lineterminator="\n")
        out.writerow(columns)
        out.writerows(rows)
    print(f"{name}: {len(rows)} rows")


def read(name, folder=HERE):
    """Rows of a CSV as dictionaries, comment lines skipped."""
    with open(os.path.join(folder, name), newline="") as f:
        return list(csv.DictReader(line for line in f if not line.startswith("#")))


def deviation(a, b):
    """Relative difference (absolute where the reference is zero)."""
    return abs(a - b) / abs(b) if b else abs(a)


def confirmed(function, *args):
    """function(*args) at two precisions; they must agree to 40 digits."""
    with mp.workdps(DPS_LO):
        low = function(*args)
    with mp.workdps(DPS_HI):
        high = function(*args)
        for a, b in zip(low, high):
            if deviation(a, b) > mpf(10) ** -40:
                raise ArithmeticError(f"{function.__name__}{args}: {a} {b}")
    return high


# ---------------------------------------------------------------- closed forms


def gauss(a, b, c, x):
    """2F1(a,b;c;x) and its derivative with respect to x."""
    return mp.hyp2f1(a, b, c, x), a * b / c * mp.hyp2f1(a + 1, b + 1, c + 1, x)


def kernel(alpha, v, w):
    """F, T, F_v, F_w, T_w at the exact values of alpha, v >= 0, w >= 0 (not both 0)."""
    a, v, w = mpf(alpha), mpf(v), mpf(w)
    if v <= w:                                  # h = v/w, everything scales with w
        h = v / w
        p, dp = gauss((1 - a) / 2, -(1 + a) / 2, mpf(2), h * h)
        q, dq = gauss((1 - a) / 2, -(3 + a) / 2, mpf(1), h * h)
        k = 2 / (3 + a)
        f, f_h, t, t_h = h * p, p + 2 * h * h * dp, k * q, 2 * k * h * dq
        up, low = w ** a, w ** (a - 1)
        return up * f, up * t, low * f_h, low * t_h, low * (a * t - h * t_h)
    h = w / v                                   # everything scales with v
    p, dp = gauss((1 - a) / 2, -(1 + a) / 2, mpf(2), h * h)
    q, dq = gauss((1 - a) / 2, (1 - a) / 2, mpf(3), h * h)
    k = (1 + a) / 4
    f, f_h, t, t_h = p, 2 * h * dp, k * h * q, k * (q + 2 * h * h * dq)
    up, low = v ** a, v ** (a - 1)
    return up * f, up * t, low * (a * f - h * f_h), low * f_h, low * t_h


# ---------------------------------------------------------------- 1, 2: selections


def make_uniform(folder):
    columns = ["alpha", "eps", "F", "T", "dF", "dT"]
    rows = [[r[c] for c in columns] for r in read("uniform_public.csv", folder)
            if r["pressure"] == "uniform"]
    write("uniform.csv", "uniform disk, w=1, v=eps, dF,dT = d/d eps, dimensionless, 32 digits; "
          "selection of uniform_public.csv (50/85-digit mpmath evaluation of the closed forms)",
          columns, rows)


def make_fixed_points(folder):
    columns = ["alpha", "C", "C_at_0", "C_at_inf", "eps0", "stability"]
    rows = [[r[c] for c in columns] for r in read("fixed_points_public.csv", folder)
            if r["pressure"] == "uniform"]
    write("fixed_points.csv", "ratio eps0 = v/w that stays constant for inertia ratio C = I/(M R^2), "
          "uniform disk, dimensionless, 20 (bounds) and 30 (eps0) digits; uniform rows of "
          "fixed_points_public.csv (50/85-digit mpmath roots)", columns, rows)


# ---------------------------------------------------------------- 3: hard twists

HARD_ALPHAS = [0.0, -0.9, -0.5, 0.5, 1.0, 1.5, 3.0]
HUGE = (mpf(2) ** 1024 - mpf(2) ** 970)   # rounds to infinity from here on
TINY = mpf(2) ** -1075                    # rounds to zero up to here
SUBNORMAL = mpf(2) ** -1022


def hard_twists():
    """(name, v, w), all exact binary64."""
    out = []
    for at in (1.0, 0.3, 1e-300, 1e300):
        tag = repr(at).replace("+", "").replace(".0", "")
        out += [(f"equal-at-{tag}", at, at),
                (f"neighbours-above-at-{tag}", nextafter(at, inf), at),
                (f"neighbours-below-at-{tag}", nextafter(at, 0.0), at),
                (f"no-sliding-at-{tag}", 0.0, at),
                (f"no-spinning-at-{tag}", at, 0.0)]
    for k in (10, 20, 30, 40, 50):
        out += [(f"ratio-1-plus-2^-{k}", 1 + 2.0 ** -k, 1.0),
                (f"ratio-1-minus-2^-{k}", 1 - 2.0 ** -k, 1.0)]
    out += [("ratio-1e-300", 1e-300, 1.0), ("ratio-1e300", 1e300, 1.0),
            ("ratio-1e-160", 1e-160, 1.0), ("ratio-1e160", 1e160, 1.0),
            ("ratio-1e300-small-spin", 1.0, 1e-300), ("ratio-1e-300-large-spin", 1.0, 1e300),
            ("ratio-1e160-small-spin", 1.0, 1e-160),
            ("subnormal-equal-5e-324", 5e-324, 5e-324),
            ("subnormal-1e-310-3e-310", 1e-310, 3e-310),
            ("subnormal-3e-310-1e-310", 3e-310, 1e-310),
            ("huge-equal-1e308", 1e308, 1e308),
            ("huge-1.7e308-1e300", 1.7e308, 1e300),
            ("huge-1e300-1.7e308", 1e300, 1.7e308)]
    return out


def range_of(x):
    """How binary64 would hold the positive value x."""
    if x >= HUGE:
        return "overflow"
    if 0 < x <= TINY:
        return "underflow"
    return "subnormal" if 0 < x < SUBNORMAL else ""


def cell(x, overflow):
    """Table text of x, with what to write for an overflow; 0 for an underflow."""
    kind = range_of(abs(x))
    return overflow if kind == "overflow" else "0" if kind == "underflow" else text(x)


def hard_row(name, alpha, v, w):
    """One row, or None where neither F nor T (nonzero ones) is representable."""
    values = confirmed(kernel, alpha, v, w)
    kinds = [range_of(x) for x in values[:2]]
    lost = ("overflow", "underflow")
    if all(k in lost or x == 0 for k, x in zip(kinds, values)):
        return None
    name += "".join(f"--{q}-{k}" for q, k in zip("FT", kinds) if k)
    return [name, repr(alpha), repr(v), repr(w)] + [cell(x, "inf") for x in values[:2]] \
        + [cell(x, "") for x in values[2:]]


def make_hard_twists(_):
    rows = [hard_row(n, a, v, w) for n, v, w in hard_twists() for a in HARD_ALPHAS]
    write("hard_twists.csv", "uniform disk F,T and partial derivatives F_v, F_w (= T_v), T_w at exact "
          "binary64 (alpha,v,w), dimensionless, 25 digits (60/90 internally); inf/0 and a --F- or --T- "
          "mark in the name where binary64 over/underflows, --X-subnormal where X is subnormal; "
          "blank derivative = overflow, 0 = zero or underflow",
          ["name", "alpha", "v", "w", "F", "T", "F_v", "F_w", "T_w"], [r for r in rows if r])


# ---------------------------------------------------------------- 4: exponents

EXPONENTS = [-0.99, -0.95, -0.6, -0.3, -0.05, 0.05, 0.3, 0.6, 1.0000001, 1.2, 1.999, 2.2, 3.5,
             6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 30.0, 50.0, 100.0]
EPS = [0.0, 1e-8, 1e-3, 0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95, 0.99, 0.9999,
       1.0, 1.0001, 1.01, 1.05, 1.3, 1.8, 3.0, 10.0, 1e3, 1e8]


def make_exponents(_):
    rows = []
    for alpha in EXPONENTS:
        for eps in EPS:
            values = confirmed(kernel, alpha, eps, 1.0)[:4]       # F, T, F_v, F_w = T_v
            rows.append([repr(alpha), repr(eps)] + [text(x) for x in values])
    write("exponents.csv", "uniform disk, w=1, v=eps, dF,dT = d/d eps, dimensionless, 25 digits "
          "(60/90 internally), also beyond the binary64 range (alpha 50 and 100 at eps=1e8)",
          ["alpha", "eps", "F", "T", "dF", "dT"], rows)


# ---------------------------------------------------------------- 5: elliptic

COMPLEMENTS = [1e-300, 1e-20, 1e-10, 1e-3, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.999, 1.0]


def elliptic(mc):
    """m, K, E, B, D, C from the complement, all by one arithmetic-geometric mean."""
    mc = mpf(mc)
    m = 1 - mc
    if m == 0:
        return m, mp.pi / 2, mp.pi / 2, mp.pi / 4, mp.pi / 4, mp.pi / 16
    a, g, weight, total = mpf(1), mp.sqrt(mc), mpf(1) / 2, m / 2   # total = sum 2^(n-1) c_n^2
    while abs(a - g) > mp.eps * a * 4:
        c = (a - g) / 2
        a, g = (a + g) / 2, mp.sqrt(a * g)
        weight *= 2
        total += weight * c * c
    k = mp.pi / (2 * a)
    e = k * (1 - total)
    b, d = (e - mc * k) / m, (k - e) / m
    return m, k, e, b, d, (d - b) / m


def make_elliptic(_):
    rows = []
    for mc in COMPLEMENTS:
        with mp.workdps(400):                    # 1 - 1e-300 must be held exactly enough
            rows.append([repr(mc)] + [text(x) for x in elliptic(mc)])
    rows = [[r[1], r[2], r[3], r[4], r[5], r[6], r[0]] for r in rows]
    write("elliptic.csv", "complete elliptic integrals of the PARAMETER m = 1-mc, mc exact binary64: "
          "K, E Legendre, B=(E-mc K)/m, D=(K-E)/m, C=(D-B)/m, dimensionless, 25 digits (400 internally)",
          ["m", "K", "E", "B", "D", "C", "mc"], rows)


# ---------------------------------------------------------------- 6: gauss

GAUSS_ALPHAS = [-0.9, -0.5, 0.0, 1e-9, 0.5, 0.999999, 1.0, 2.0, 2.5, 3.0, 9.0]
GAUSS_MC = [1.0, 0.9, 0.7, 0.5, 0.3, 0.1, 1e-2, 1e-4, 1e-8, 1e-12, 2.0 ** -52, 0.0]


def phi(alpha, mc):
    """x, Phi, dPhi/dx with x = 1 - mc."""
    a, x = mpf(alpha), 1 - mpf(mc)
    return (x,) + gauss((1 - a) / 2, -(1 + a) / 2, mpf(2), x)


def make_gauss(_):
    rows = []
    for alpha in GAUSS_ALPHAS:
        for mc in GAUSS_MC:
            x, p, dp = confirmed(phi, alpha, mc)
            rows.append([repr(alpha), text(x), repr(mc), text(p), text(dp)])
    write("gauss.csv", "Phi(x) = 2F1((1-alpha)/2, -(1+alpha)/2; 2; x) and its x-derivative at x = 1-mc, "
          "alpha and mc exact binary64 (x rounded to 25 digits), dimensionless, 25 digits (60/90 internally)",
          ["alpha", "x", "mc", "Phi", "dPhi"], rows)


# ---------------------------------------------------------------- 7: stops
# dv/dt = -F, dw/dt = -T/C.  Polar form v = s cos a, w = s sin a, dtau = s^(alpha-1) dt:
#   d(ln s)/dtau = -f(a), da/dtau = g(a), f = F cos a + T sin a / C, g = F sin a - T cos a / C.
# a runs monotonically to a zero a0 of g, so t, x and angle are integrals over a of
# s^p c(a)/g(a) with ln s itself an integral of -f/g.

STOPS = [(0.5, 0.0, v, w) for v, w in
         [(1.0, 0.0), (1.0, 0.4), (1.0, 1.0), (1.0, 1.5), (1.0, 4.0), (0.01, 1.0), (1.0, 0.001)]]
STOPS += [(c, 0.0, 1.0, 1.0) for c in (0.3, 0.6, 1.0, 0.2)]
STOPS += [(0.5, -0.5, 1.0, 1.0), (0.5, -0.5, 1.0, 0.2)]
STOPS += [(0.5, 0.5, 1.0, 1.0), (0.5, 0.5, 1.0, 0.2), (0.5, 0.5, 0.2, 1.0)]
STOP_DPS = 55


def force_torque(alpha, v, w):
    """F and T, v and w of any sign (F odd in v, T odd in w)."""
    a, x, y = mpf(alpha), abs(v), abs(w)
    if x <= y:
        h = x / y
        f = y ** a * h * mp.hyp2f1((1 - a) / 2, -(1 + a) / 2, 2, h * h)
        t = y ** a * 2 / (3 + a) * mp.hyp2f1((1 - a) / 2, -(3 + a) / 2, 1, h * h)
    else:
        h = y / x
        f = x ** a * mp.hyp2f1((1 - a) / 2, -(1 + a) / 2, 2, h * h)
        t = x ** a * (1 + a) / 4 * h * mp.hyp2f1((1 - a) / 2, (1 - a) / 2, 3, h * h)
    return (f if v >= 0 else -f), (t if w >= 0 else -t)


def rates(alpha, c, a):
    """f and g of the polar form."""
    co, si = mp.cos(a), mp.sin(a)
    f, t = force_torque(alpha, co, si)
    return f * co + t * si / c, f * si - t * co / c


def settled_angle(alpha, c):
    """The stable zero a0 of g for alpha < 1."""
    a = mpf(alpha)
    if c >= 2 / (3 + a):
        return mp.pi / 2                         # ends spinning
    if c <= (1 + a) / 4:
        return mpf(0)                            # ends sliding
    return mp.findroot(lambda y: rates(alpha, c, y)[1], (mpf("0.05"), mp.pi / 2 - mpf("0.05")),
                       solver="anderson", tol=mpf(10) ** (-2 * mp.mp.dps + 10))


def panels(start, end, singular):
    """Split [start, end] (either direction) until every panel is no longer than its distance
    to the singular points; a panel that touches one is accepted when negligibly short."""
    gap = min(0 if (start - p) * (end - p) <= 0 else min(abs(start - p), abs(end - p)) for p in singular)
    length = abs(end - start)
    if length <= gap or length < mpf(2) ** -40:
        return [(start, end)]
    middle = (start + end) / 2
    return panels(start, middle, singular) + panels(middle, end, singular)


def monomials(nodes):
    """Inverse Vandermonde matrix: values at the nodes -> monomial coefficients."""
    return mp.matrix([[x ** j for j in range(len(nodes))] for x in nodes]) ** -1


class Rule:
    """Gauss-Legendre nodes on [-1,1] with weights and a running-integral matrix."""

    def __init__(self, n):
        with mp.workdps(STOP_DPS + n):
            self.nodes = sorted(mp.polyroots([mp.mpf(x) for x in legendre(n)], maxsteps=500,
                                             extraprec=400), key=mp.re)
            self.nodes = [mp.re(x) for x in self.nodes]
            inverse = monomials(self.nodes)
            self.running = [[self.piece(inverse, j, x) for j in range(n)] for x in self.nodes]
            self.weights = [self.piece(inverse, j, mpf(1)) for j in range(n)]

    @staticmethod
    def piece(inverse, j, x):
        """Integral from -1 to x of the j-th Lagrange polynomial."""
        return mp.fsum(inverse[k, j] * (x ** (k + 1) - mpf(-1) ** (k + 1)) / (k + 1)
                       for k in range(inverse.rows))


def legendre(n):
    """Coefficients of the n-th Legendre polynomial, highest power first, exact."""
    c = [Fraction(0)] * (n + 1)
    for k in range(n // 2 + 1):
        c[n - 2 * k] = Fraction((-1) ** k * comb(n, k) * comb(2 * n - 2 * k, n), 2 ** n)
    return [mpf(x.numerator) / x.denominator for x in reversed(c)]


def factors(alpha, a):
    """(p, c(a)) of the three integrals t, x, angle."""
    a1 = mpf(alpha)
    return [(1 - a1, mpf(1)), (2 - a1, mp.cos(a)), (2 - a1, mp.sin(a))]


def regular_panel(rule, alpha, c, lo, hi, ln_s):
    """The three integrals over one panel and ln s at its end."""
    half, mid = (hi - lo) / 2, (hi + lo) / 2
    at = [mid + half * x for x in rule.nodes]
    fg = [rates(alpha, c, a) for a in at]
    slope = [-f / g for f, g in fg]
    sums = [mpf(0)] * 3
    for i, a in enumerate(at):
        here = ln_s + half * mp.fdot(rule.running[i], slope)
        for k, (p, w) in enumerate(factors(alpha, a)):
            sums[k] += rule.weights[i] * half * mp.exp(p * here) * w / fg[i][1]
    return sums, ln_s + half * mp.fdot(rule.weights, slope)


def settling_panel(alpha, c, lo, a0, ln_s, n):
    """The three integrals from lo to a0, where ln s -> -infinity: with y = (a-a0)/(lo-a0),
    s = s_lo y^kappa exp(R(y)), R a polynomial, and the rest is smooth in y."""
    half = lo - a0
    ys = [mp.cos((2 * i + 1) * mp.pi / (2 * n)) for i in range(n)]      # both sides of a0
    inverse = monomials(ys)
    fg = [rates(alpha, c, a0 + half * y) for y in ys]
    big_g = [g / (half * y) for (_, g), y in zip(fg, ys)]
    ratio = inverse * mp.matrix([-f / g for (f, _), g in zip(fg, big_g)])
    kappa = ratio[0]                                                    # d ln s / d ln y at a0
    rest = [ratio[k] / k for k in range(1, n)]                          # R(y) = sum rest_k y^k - R(1)
    r_at = lambda y: mp.fsum(q * (y ** (k + 1) - 1) for k, q in enumerate(rest))
    sums = []
    for which in range(3):
        values = []
        for y, g in zip(ys, big_g):
            p, w = factors(alpha, a0 + half * y)[which]
            values.append(-mp.exp(p * r_at(y)) * w / g)
        coeff = inverse * mp.matrix(values)
        sums.append(mp.exp(p * ln_s) * mp.fsum(coeff[k] / (kappa * p + k) for k in range(n)))
    return sums


def stop(c, alpha, v0, w0, n=28, n_last=44, rules={}):
    """stop time, distance, angle, final ratio v/w."""
    v0, w0, a1 = mpf(v0), mpf(w0), mpf(alpha)
    if w0 == 0:                                  # w stays zero: dv/dt = -v^alpha
        return v0 ** (1 - a1) / (1 - a1), v0 ** (2 - a1) / (2 - a1), mpf(0), mp.inf
    c, start = mpf(c), mp.atan2(w0, v0)
    a0 = settled_angle(alpha, c)
    singular = [mpf(0), mp.pi / 4, mp.pi / 2, a0]
    reach = min(abs(a0 - p) for p in singular if abs(a0 - p) > mpf(10) ** -10) * mpf("0.15")
    reach = min(reach, abs(start - a0))
    last = a0 + reach * mp.sign(start - a0)
    rule = rules.setdefault(n, None) or rules.__setitem__(n, Rule(n)) or rules[n]
    total, ln_s = [mpf(0)] * 3, mp.log(mp.hypot(v0, w0))
    cuts = [start] + ([mp.pi / 4] if (start - mp.pi / 4) * (last - mp.pi / 4) < 0 else []) + [last]
    for lo, hi in zip(cuts, cuts[1:]):
        for piece in (panels(lo, hi, singular) if lo != hi else []):
            sums, ln_s = regular_panel(rule, alpha, c, *piece, ln_s)
            total = [a + b for a, b in zip(total, sums)]
    tail = settling_panel(alpha, c, last, a0, ln_s, n_last)
    total = [a + b for a, b in zip(total, tail)]
    ratio = mp.inf if a0 == 0 else mpf(0) if a0 == mp.pi / 2 else mp.cot(a0)
    return (*total, ratio)


def make_stops(_):
    rows = []
    with mp.workdps(STOP_DPS):
        for case in STOPS:
            fine, coarse = stop(*case), stop(*case, n=22, n_last=36)
            worst = max(deviation(a, b) for a, b in zip(coarse[:3], fine[:3]))
            print("  stop", case, [mp.nstr(x, 18) for x in fine], "coarser rule differs by", mp.nstr(worst, 2),
                  flush=True)
            rows.append([repr(x) for x in case] + [mp.nstr(x, 20) if mp.isfinite(x) else "inf" for x in fine])
    write("stops.csv", "slider dv/dt=-F(v,w), dw/dt=-T(v,w)/C with C = inertia_ratio = I/(M R^2), w = omega R: "
          "stop time, distance = int v dt, angle = int w dt, final v/w, dimensionless (R = mu g = 1), "
          "20 digits written (quadrature at 55 digits; see README for the accuracy)",
          ["inertia_ratio", "alpha", "v0", "w0", "stop_time", "distance", "angle", "final_ratio"], rows)


# ---------------------------------------------------------------- 8: odd exponents

ODD = [1, 3, 5, 7, 9]


def disk_mean(p, q):
    """Mean of r^p sin(phi)^q over the unit disk."""
    return Fraction(0) if q % 2 else Fraction(2, p + 2) * Fraction(comb(q, q // 2), 2 ** q)


def times(a, b):
    """Product of polynomials {(power of eps, of r, of sin): coefficient}."""
    out = {}
    for (i, j, k), x in a.items():
        for (l, m, n), y in b.items():
            key = (i + l, j + m, k + n)
            out[key] = out.get(key, 0) + x * y
    return out


def odd_polynomials(alpha):
    """Exact coefficients by power of eps of F and T at w = 1, v = eps."""
    one = Fraction(1)
    speed2 = {(2, 0, 0): one, (0, 2, 0): one, (1, 1, 1): -2 * one}    # |u|^2
    along = {(1, 0, 0): one, (0, 1, 1): -one}                        # u . e_v
    around = {(0, 2, 0): one, (1, 1, 1): -one}                       # u . r e_phi
    power = {(0, 0, 0): one}
    for _ in range((alpha - 1) // 2):
        power = times(power, speed2)
    result = {}
    for name, component in (("F", along), ("T", around)):
        total = {}
        for (i, j, k), x in times(power, component).items():
            total[i] = total.get(i, 0) + x * disk_mean(j, k)
        result[name] = {i: x for i, x in sorted(total.items()) if x}
    return result


def make_odd_exponents(_):
    rows = [[repr(float(a)), name, i, x.numerator, x.denominator]
            for a in ODD for name, poly in odd_polynomials(a).items() for i, x in poly.items()]
    write("odd_exponents.csv", "exact polynomials F(eps), T(eps) at w=1, v=eps for odd alpha (valid for every "
          "eps >= 0): coefficient of eps^power = numerator/denominator, dimensionless, exact",
          ["alpha", "quantity", "power", "numerator", "denominator"], rows)


# ---------------------------------------------------------------- independent checks


def rim_integrals(alpha, v, w):
    """F, T, F_v, F_w, T_w from one-dimensional averages over the rim (divergence theorem),
    v > 0, w > 0, no hypergeometric function.  d^2 = v^2 + w^2 - 2 v w sin."""
    a, v, w = mpf(alpha), mpf(v), mpf(w)
    scale = max(v, w)
    v, w, s = v / scale, w / scale, a + 1
    cuts = [mp.pi] + [mp.pi * mpf(2) ** -k for k in range(1, 75)] + [mpf(0)]

    def mean(g):      # phi = pi/2 - y, even in y; (sin, 1 - sin) given separately
        def h(y):
            drop = 2 * mp.sin(y / 2) ** 2
            return g(1 - drop, (v - w) ** 2 + 2 * v * w * drop, v - w + w * drop, w - v + v * drop)
        return mp.quad(h, cuts[::-1], method="gauss-legendre", maxdegree=6) / mp.pi

    f = -2 / (s * w) * mean(lambda si, d2, p, q: si * d2 ** (s / 2))
    m = 2 / ((s + 2) * w) * mean(lambda si, d2, p, q: q * d2 ** (s / 2))
    f_v = -2 / w * mean(lambda si, d2, p, q: si * d2 ** (s / 2 - 1) * p)
    t = (m - v * f) / w
    f_w = (a * f - v * f_v) / w
    t_w = (a * t - v * f_w) / w
    up, low = scale ** a, scale ** (a - 1)
    return up * f, up * t, low * f_v, low * f_w, low * t_w


def area_integrals(alpha, v, w, rays=160):
    """The same five by direct two-dimensional integration over the disk in polar coordinates:
    about the rotation centre for v < w (where |u| = 0 lies inside), about the disk centre for v > w."""
    a, v, w = mpf(alpha), mpf(v), mpf(w)
    inside = v < w

    def local(d, co, si):                       # integrands at one point, times d (area element)
        x, y = (d * co, v / w + d * si) if inside else (d * co, d * si)
        ux, uy = (-w * d * si, w * x) if inside else (v - w * y, w * x)   # no cancellation near |u| = 0
        u2 = ux * ux + uy * uy
        along, around, k = ux, ux * -y + uy * x, (a - 1) / u2
        wt = u2 ** ((a - 1) / 2) * d
        return [wt * along, wt * around, wt * (1 + k * along ** 2),
                wt * (-y + k * along * around), wt * (x * x + y * y + k * around ** 2)]

    total = [mpf(0)] * 5
    for i in range(rays):                       # trapezoid in the angle: periodic and analytic
        psi = 2 * mp.pi * (i + mpf(1) / 2) / rays
        co, si = mp.cos(psi), mp.sin(psi)
        e = v / w * si if inside else mpf(0)
        length = -e + mp.sqrt(e * e + 1 - (v / w) ** 2) if inside else mpf(1)
        k = 24 / (1 + a) if inside else 1       # d = length z^k smooths d^(1+alpha), d^alpha
        for z, wt in gauss_nodes(40):
            d, jac = length * z ** k, length * k * z ** (k - 1)
            for j, val in enumerate(local(d, co, si)):
                total[j] += wt * jac * val
    return [2 * x / rays for x in total]        # (1/pi) * (2 pi / rays)


def gauss_nodes(n, store={}):
    """Gauss-Legendre on [0,1]."""
    if n not in store:
        r = Rule(n)
        store[n] = [((1 + x) / 2, w / 2) for x, w in zip(r.nodes, r.weights)]
    return store[n]


class Worst:
    """Keeps the largest deviation."""

    def __init__(self, title):
        self.title, self.dev, self.at, self.count = title, mpf(0), None, 0

    def add(self, got, want, at):
        self.count += 1
        d = deviation(got, want)
        if d > self.dev:
            self.dev, self.at = d, at

    def show(self):
        print(f"{self.title}: {self.count} values, worst relative deviation {mp.nstr(self.dev, 3)} at {self.at}",
              flush=True)


JAC = ["F", "T", "F_v", "F_w", "T_w"]


def check_hard_twists():
    """Every row with v, w > 0 of ratio within 1e+-9 by rim integrals; far ratios by leading terms."""
    rim, far = Worst("hard_twists vs rim integrals"), Worst("hard_twists, far ratios, vs leading terms")
    with mp.workdps(40):
        for r in read("hard_twists.csv"):
            a, v, w = (mpf(float(r[c])) for c in ("alpha", "v", "w"))
            near = v > 0 and w > 0 and mpf(10) ** -9 < v / w < mpf(10) ** 9
            want = rim_integrals(a, v, w) if near else leading(a, v, w)
            for q, x in zip(JAC, want):
                if r[q] not in ("", "inf", "0", "0.0"):
                    (rim if near else far).add(mpf(r[q]), x, (r["name"], r["alpha"], q))
    rim.show()
    far.show()
    check_area("hard_twists vs area integrals", [(a, v, w) for a in (0.0, -0.5, 0.5) for v, w in
                                                  ((1e-310, 3e-310), (3e-310, 1e-310))], hard_lookup)


def leading(a, v, w):
    """Leading terms for w/v -> 0 or v/w -> 0 (next terms relatively (ratio)^2)."""
    if v < w:
        k = 2 / (3 + a)
        cross = -(1 - a) * (3 + a) * k / 2 * v * w ** (a - 2)
        return w ** (a - 1) * v, k * w ** a, w ** (a - 1), cross, a * k * w ** (a - 1)
    k = (1 + a) / 4
    return v ** a, k * w * v ** (a - 1), a * v ** (a - 1), -(1 - a) * k * w * v ** (a - 2), k * v ** (a - 1)


def hard_lookup(a, v, w):
    for r in read("hard_twists.csv"):
        if (float(r["alpha"]), float(r["v"]), float(r["w"])) == (a, v, w):
            return [mpf(r[q]) if r[q] not in ("", "inf", "0") else None for q in JAC]


def exponent_lookup(a, v, w):
    for r in read("exponents.csv"):
        if (float(r["alpha"]), float(r["eps"])) == (a, v) and w == 1:
            return [mpf(r[q]) for q in ("F", "T", "dF", "dT")]


def gauss_lookup(a, v, w):
    """Phi and dPhi at x = v^2 as F = v Phi, F_v = Phi + 2 v^2 dPhi (w = 1)."""
    for r in read("gauss.csv"):
        if float(r["alpha"]) == a and abs(1 - mpf(float(r["mc"])) - v * v) < mpf(10) ** -25:
            p, dp = mpf(r["Phi"]), mpf(r["dPhi"])
            return [v * p, None, p + 2 * v * v * dp]


def check_area(title, points, lookup):
    worst = Worst(title)
    with mp.workdps(32):
        for a, v, w in points:
            want = area_integrals(a, v, w)
            for q, got, x in zip(JAC, lookup(a, v, w), want):
                if got is not None:
                    worst.add(got, x, (a, mp.nstr(mpf(v), 6), mp.nstr(mpf(w), 6), q))
    worst.show()


def check_exponents():
    rim = Worst("exponents vs rim integrals, every row with 1e-3 <= eps <= 1e3")
    with mp.workdps(40):
        for r in read("exponents.csv"):
            a, eps = float(r["alpha"]), float(r["eps"])
            if 1e-3 <= eps <= 1e3:
                for q, x in zip(("F", "T", "dF", "dT"), rim_integrals(a, eps, 1.0)):
                    rim.add(mpf(r[q]), x, (a, eps, q))
    rim.show()
    check_area("exponents vs area integrals", [(a, e, 1.0) for a in (-0.6, 0.3, 2.2, 12.0)
                                                for e in (0.25, 0.55, 1.8, 3.0)], exponent_lookup)


def check_gauss():
    rim = Worst("gauss vs rim integrals, every row with x > 0")
    with mp.workdps(40):
        for r in read("gauss.csv"):
            a, x = float(r["alpha"]), 1 - mpf(float(r["mc"]))
            if x > 0:
                h = mp.sqrt(x)
                f, _, f_v, _, _ = rim_integrals(a, h, 1.0)
                rim.add(mpf(r["Phi"]), f / h, (a, r["mc"], "Phi"))
                if a != 1:                       # Phi is constant for alpha = 1
                    rim.add(mpf(r["dPhi"]), (f_v - f / h) / (2 * x), (a, r["mc"], "dPhi"))
    rim.show()
    with mp.workdps(40):
        points = [(a, mp.sqrt(1 - mpf(mc)), mpf(1)) for a in (-0.5, 0.5, 2.5) for mc in (0.9, 0.7, 0.5)]
    check_area("gauss vs area integrals", points, gauss_lookup)


def check_elliptic():
    """The defining integrals, by quadrature; and mpmath's own ellipk, ellipe at 400 digits."""
    worst, own = Worst("elliptic vs integrals"), Worst("elliptic K,E vs mpmath ellipk, ellipe")
    with mp.workdps(40):
        for r in read("elliptic.csv"):
            mc = mpf(float(r["mc"]))
            # t = cot(theta) = e^z: flat in z even for mc = 1e-300, Delta^2 = sin^2 (t^2 + mc)
            low = min(mp.log(mc), 0) / 2 - 60
            cuts = mp.linspace(low, mpf(60), 240)

            def integral(n_sin, n_cos, n_delta):
                def g(z):
                    t = mp.exp(z)
                    si, delta2 = 1 / mp.sqrt(1 + t * t), (t * t + mc) / (1 + t * t)
                    return si ** n_sin * (t * si) ** n_cos * delta2 ** (-mpf(n_delta) / 2) * t * si * si
                return mp.quad(g, cuts, method="gauss-legendre", maxdegree=4)
            for q, n in (("K", (0, 0, 1)), ("E", (0, 0, -1)), ("B", (0, 2, 1)), ("D", (2, 0, 1)), ("C", (2, 2, 3))):
                worst.add(mpf(r[q]), integral(*n), (r["mc"], q))
    with mp.workdps(400):
        for r in read("elliptic.csv"):
            m = 1 - mpf(float(r["mc"]))
            own.add(mpf(r["K"]), mp.ellipk(m), (r["mc"], "K"))
            own.add(mpf(r["E"]), mp.ellipe(m), (r["mc"], "E"))
    worst.show()
    own.show()


def check_uniform():
    """Every row re-evaluated from this script's closed forms; rows near eps = 1 by rim integrals."""
    again, rim = Worst("uniform vs closed forms of this script"), Worst("uniform vs rim integrals")
    with mp.workdps(40):
        for r in read("uniform.csv"):
            a, eps = float(r["alpha"]), float(r["eps"])
            for q, x in zip(("F", "T", "dF", "dT"), kernel(a, eps, 1.0)):
                again.add(mpf(r[q]), x, (a, eps, q))
            if 0.9 < eps < 1.1:
                for q, x in zip(("F", "T", "dF", "dT"), rim_integrals(a, eps, 1.0)):
                    if not (a == 1 and q == "dT"):
                        rim.add(mpf(r[q]), x, (a, eps, q))
    again.show()
    rim.show()


def check_fixed_points():
    """C F = eps T at eps0, relatively."""
    worst = Worst("fixed_points: C F(eps0) vs eps0 T(eps0)")
    with mp.workdps(40):
        for r in read("fixed_points.csv"):
            if r["eps0"] not in ("", "0", "0.0", "inf", "none", "nan"):
                e = mpf(r["eps0"])
                f, t = kernel(float(r["alpha"]), e, mpf(1))[:2]
                worst.add(mpf(float(r["C"])) * f, e * t, (r["alpha"], r["C"]))
    worst.show()


def check_odd_exponents():
    polys = {}
    for r in read("odd_exponents.csv"):
        key = (float(r["alpha"]), r["quantity"])
        polys.setdefault(key, []).append((int(r["power"]), Fraction(int(r["numerator"]), int(r["denominator"]))))
    worst = Worst("odd_exponents polynomials vs uniform.csv, every eps")
    with mp.workdps(40):
        for r in read("uniform.csv"):
            for q in "FT":
                poly = polys.get((float(r["alpha"]), q))
                if poly:
                    e = mpf(float(r["eps"]))
                    got = mp.fsum(mpf(c.numerator) / c.denominator * e ** p for p, c in poly)
                    worst.add(got, mpf(r[q]), (r["alpha"], r["eps"], q))
    worst.show()


# ---- the slider by ODE solvers


def double_force(alpha, v, w):
    """F, T in double precision with scipy's 2F1."""
    from scipy.special import hyp2f1
    a = alpha
    if v <= w:
        x = (v / w) ** 2
        return (w ** a * (v / w) * hyp2f1((1 - a) / 2, -(1 + a) / 2, 2, x),
                w ** a * 2 / (3 + a) * hyp2f1((1 - a) / 2, -(3 + a) / 2, 1, x))
    x = (w / v) ** 2
    return (v ** a * hyp2f1((1 - a) / 2, -(1 + a) / 2, 2, x),
            v ** a * (1 + a) / 4 * (w / v) * hyp2f1((1 - a) / 2, (1 - a) / 2, 3, x))


def ode_stop(c, alpha, v0, w0):
    """Same four numbers by DOP853: in a up to the kink a = pi/4, then in tau, linear tail."""
    from scipy.integrate import solve_ivp

    def parts(a):
        co, si = math.cos(a), math.sin(a)
        f, t = double_force(alpha, co, si)
        return f * co + t * si / c, f * si - t * co / c, co, si

    def in_tau(_, y):
        f, g, co, si = parts(y[1])
        p = math.exp((1 - alpha) * y[0])
        q = p * math.exp(y[0])
        return [-f, g, p, q * co, q * si]

    def in_a(a, y):
        d = in_tau(0, [y[0], a, 0, 0, 0])
        return [d[0] / d[1], d[2] / d[1], d[3] / d[1], d[4] / d[1]]

    options = dict(method="DOP853", rtol=3e-14, atol=1e-17)
    a, kink = math.atan2(w0, v0), math.pi / 4
    y = [math.log(math.hypot(v0, w0)), a, 0.0, 0.0, 0.0]
    a0 = float(settled_angle(alpha, mpf(c)))
    if (a - kink) * (a0 - kink) < 0:
        r = solve_ivp(in_a, (a, kink), [y[0], 0, 0, 0], **options).y[:, -1]
        y = [r[0], kink, r[1], r[2], r[3]]
    elif v0 == w0:
        y[1] = kink
    for _ in range(40):                          # stretches of tau until s^(1-alpha) is negligible
        y = list(solve_ivp(in_tau, (0, 5), y, **options).y[:, -1])
        if (1 - alpha) * y[0] < -38:
            break
    f = parts(y[1])[0]
    y[2] += math.exp((1 - alpha) * y[0]) / ((1 - alpha) * f)
    return y[2], y[3], y[4], 1 / math.tan(y[1])


def midpoint_step(rhs, x, y, step, columns=11):
    """One Gragg-Bulirsch-Stoer step of order 2*columns."""
    table, counts = [], [2 * (k + 1) for k in range(columns)]
    start = rhs(x, y)
    for k, n in enumerate(counts):
        h = step / n
        z0, z1 = y, [p + h * q for p, q in zip(y, start)]
        for i in range(1, n):
            z0, z1 = z1, [p + 2 * h * q for p, q in zip(z0, rhs(x + i * h, z1))]
        row = [[(p + q + h * r) / 2 for p, q, r in zip(z0, z1, rhs(x + step, z1))]]
        for j in range(k):
            f = mpf(counts[k - j - 1] ** 2) / (n ** 2 - counts[k - j - 1] ** 2)
            row.append([p + (p - q) * f for p, q in zip(row[j], table[j])])
        table = row
    return table[-1]


def elliptic_force(v, w):
    """F, T at alpha = 0 from complete elliptic integrals (no 2F1)."""
    h = min(v, w) / max(v, w)
    m = h * h
    if m == 1:
        return 8 / (3 * mp.pi), 8 / (9 * mp.pi)
    k, e = mp.ellipk(m), mp.ellipe(m)
    b, d = (e - (1 - m) * k) / m, (k - e) / m
    f = 4 / (3 * mp.pi) * (2 * b + (1 - m) * d)
    if v <= w:
        return h * f, 4 / (9 * mp.pi) * ((3 - m) * b + (1 - m) * (3 - 2 * m) * d)
    return f, 4 / (9 * mp.pi * h) * ((3 * m - 1) * b + (1 - m) * d)


def precise_ode_stop(c, alpha, v0, w0):
    """The four numbers by a high-order ODE solver at the working precision."""
    alpha, c, kink = mpf(alpha), mpf(c), mp.pi / 4

    def in_tau(_, y):
        co, si = mp.cos(y[1]), mp.sin(y[1])
        f, t = elliptic_force(co, si) if alpha == 0 else force_torque(alpha, co, si)
        p = mp.exp((1 - alpha) * y[0])
        q = p * mp.exp(y[0])
        return [-(f * co + t * si / c), f * si - t * co / c, p, q * co, q * si]

    def in_a(a, y):
        d = in_tau(0, [y[0], a, 0, 0, 0])
        return [d[0] / d[1], d[2] / d[1], d[3] / d[1], d[4] / d[1]]

    a, y = mp.atan2(w0, v0), [mp.log(mp.hypot(v0, w0))] + [mpf(0)] * 3
    if a < kink:                                 # steps shrinking towards the kink
        gap = kink - a
        while gap > mpf(10) ** -11:
            y = midpoint_step(in_a, kink - gap, y, gap / 8)
            gap -= gap / 8
        y = midpoint_step(in_a, kink - gap, y, gap)
    y = [y[0], kink] + y[1:]
    step = mpf(10) ** -11
    while (1 - alpha) * y[0] > -46:              # and growing away from it
        y = midpoint_step(in_tau, 0, y, step)
        step = min(step * mpf("1.3"), mpf("0.15"))
    y[2] += mp.exp((1 - alpha) * y[0]) / ((1 - alpha) * -in_tau(0, y)[0])
    return y[2], y[3], y[4], mp.cot(y[1])


def check_stops():
    ode, known = Worst("stops vs DOP853 in double precision"), Worst("stops vs the known dimensional values")
    ratio, fine = Worst("final ratio vs DOP853 at its last step"), Worst("stops vs extrapolated midpoint ODE, 30 digits")
    table = {tuple(float(r[c]) for c in ("inertia_ratio", "alpha", "v0", "w0")): r for r in read("stops.csv")}
    columns = ("stop_time", "distance", "angle", "final_ratio")
    for key, r in table.items():
        if key[3] == 0:
            continue
        for q, x in zip(columns, ode_stop(*key)):
            if r[q] != "inf" and float(r[q]) != 0:
                (ratio if q == "final_ratio" else ode).add(mpf(x), mpf(r[q]), (key, q))
    ode.show()
    ratio.show()
    with mp.workdps(30):
        for key in ((0.5, 0.0, 1.0, 0.4), (0.6, 0.0, 1.0, 1.0), (0.5, -0.5, 1.0, 0.2)):
            for q, x in zip(columns[:3], precise_ode_stop(*key)):
                fine.add(x, mpf(table[key][q]), (key, q))
    fine.show()
    with mp.workdps(30):                         # mu g = 0.3*9.81, R = 0.08, v0 = 1 m/s
        mug = mpf("0.3") * mpf("9.81")
        for w0, t, x in ((0.0, ".339789330615024", ".169894665307512"), (0.4, ".369017132104558", ".176861185300839")):
            r = table[(0.5, 0.0, 1.0, w0)]       # omega = 5 rad/s: omega R = 0.4 m/s
            known.add(mpf(r["stop_time"]) / mug, mpf(t), (w0, "t"))
            known.add(mpf(r["distance"]) / mug, mpf(x), (w0, "x"))
        known.add(mpf(table[(0.5, 0.0, 1.0, 0.4)]["final_ratio"]), mpf(".6530017892056"), "ratio")
        print("  omega0 = 0 and 5 rad/s, t and x here:", [mp.nstr(mpf(table[(0.5, 0.0, 1.0, w)][q]) / mug, 18)
                                                       for w in (0.0, 0.4) for q in columns[:2]])
    known.show()


# ---------------------------------------------------------------- command line

NAMES = ["uniform", "fixed_points", "hard_twists", "exponents", "elliptic", "gauss", "stops", "odd_exponents"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("make", "check"))
    parser.add_argument("--reference", help="folder with uniform_public.csv and fixed_points_public.csv")
    parser.add_argument("--only", nargs="+", choices=NAMES, default=NAMES)
    args = parser.parse_args()
    for name in args.only:
        if args.action == "check":
            globals()[f"check_{name}"]()
        elif name in ("uniform", "fixed_points") and not args.reference:
            print(f"{name}: skipped, needs --reference")
        else:
            globals()[f"make_{name}"](args.reference)


if __name__ == "__main__":
    main()
