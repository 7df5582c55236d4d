#!/usr/bin/env python3
"""High-precision reference tables for the friction of patches whose pressure is not uniform:
the family p_q = (q+1)/pi (1-r^2)^q (thin ring q -> -1, flat punch -1/2, disk 0, Hertz 1/2, paraboloid 1),
annuli and polynomials in r^2.  Radius, load, coefficient and omega R are 1, v = eps.

    python3 generate_pressures.py make [--reference DIR] [--only NAME ...]

writes the CSV files next to this script; ring, hertz, punch, paraboloid and uniform_lateral are
selections of the *_public.csv files in DIR and are skipped without --reference.
check_pressures.py compares the tables with direct integrals.  Needs Python 3.11+, mpmath 1.3.
"""
import argparse
import csv
import math
import os
from fractions import Fraction

import mpmath as mp
from mpmath import mpf

from generate import HERE, confirmed, read, text

# ---------------------------------------------------------------- closed forms
# With s = alpha + 1, d = distance to the rotation centre (0, eps), <.> = mean weighted by the pressure:
#   F = <d^(alpha-1) (eps - r sin)>, T = <d^(alpha-1) (r^2 - eps r sin)>, G = <d^(alpha-1) (r cos)^2>.
# G is half the lateral force of a unit front-back pressure slope: F_perp = slope * G.


def family(q, alpha, eps):
    """F, T, G, dF, dT of p_q at exact q >= -1 (-1 is the ring), alpha > -1, eps >= 0."""
    q, a, e = mpf(q), mpf(alpha), mpf(eps)
    h, f21 = (a + 1) / 2, mp.hyp2f1                      # h = s/2
    singular = e == 1 and a + q <= -1 and a != 1         # the slopes are infinite at the rim
    if e <= 1:
        x = e * e
        big_a = mp.gamma(q + 2) * mp.gamma(h + 1) / mp.gamma(h + q + 2)
        slope = big_a * (h + 1 + q)
        f = slope * e * f21(1 - h, -h - q, 2, x)
        t = big_a * f21(1 - h, -h - 1 - q, 1, x)
        g = big_a / 2 * f21(1 - h, -1 - q - h, 2, x)
        if singular:
            return f, t, g, mp.inf, -mp.inf
        dt = -(1 - a) * slope * e * f21((3 - a) / 2, -h - q, 2, x)
        if e == 0:
            return f, t, g, slope, dt
        return f, t, g, (a * f - dt) / e, dt
    y, k = 1 / (e * e), q + 2
    f = e ** a * f21(1 - h, -h, k, y)
    t = h / k * e ** (a - 1) * f21(1 - h, 1 - h, k + 1, y)
    g = e ** (a - 1) / (2 * k) * f21(-h, 1 - h, k + 1, y)
    dt = -(1 - a) * h / k * e ** (a - 2) * f21((3 - a) / 2, (1 - a) / 2, k + 1, y)
    return f, t, g, (a * f - dt) / e, dt


def annulus(k, alpha, eps):
    """The five of a uniform annulus, inner radius k, outer radius 1."""
    k, a = mpf(k), mpf(alpha)
    outer, inner = family(0, a, eps), family(0, a, mpf(eps) / k)
    powers = (2 + a, 3 + a, 3 + a, 1 + a, 2 + a)
    return tuple((o - k ** p * i) / (1 - k * k) for o, i, p in zip(outer, inner, powers))


def in_powers_of_depth(coefficients):
    """Weights of the members q = j for p ~ sum a_i r^(2i), exact: r^2 = 1 - (1 - r^2)."""
    a = [Fraction(x) for x in coefficients]
    b = [sum(a[i] * math.comb(i, j) * (-1) ** j for i in range(j, len(a))) for j in range(len(a))]
    load = sum(x / (j + 1) for j, x in enumerate(b))
    return [x / (j + 1) / load for j, x in enumerate(b)]


def polynomial(coefficients, alpha, eps):
    """The five of the pressure ~ sum a_i r^(2i), scaled to unit load."""
    total = [mpf(0)] * 5
    for j, w in enumerate(in_powers_of_depth(coefficients)):
        if w:
            part = family(j, alpha, eps)
            total = [x + mpf(w.numerator) / w.denominator * y for x, y in zip(total, part)]
    return tuple(total)


def values(function, *args):
    """Table texts of function(*args), computed twice; exact zeros and infinities are kept."""
    return [x if isinstance(x, str) else "inf" if x == mp.inf else "-inf" if x == -mp.inf else text(x)
            for x in confirmed_finite(function, *args)]


def confirmed_finite(function, *args):
    """`confirmed` for results that may hold infinities."""
    finite = confirmed(lambda *a: tuple(x for x in function(*a) if mp.isfinite(x)), *args)
    with mp.workdps(15):
        shape = function(*args)
    rest = iter(finite)
    return [next(rest) if mp.isfinite(x) else x for x in shape]


def write(name, about, columns, rows, needs_reference=False, script="generate_pressures.py"):
    """One CSV: a comment line, the header, the rows."""
    cmd = f"python3 {script} make --only {name[:-4]}" + " --reference DIR" * needs_reference
    with open(os.path.join(HERE, name), "w", newline="") as f:
        f.write(f"# {about}; made by: {cmd}\n")
        out = csv.writer(f, lineterminator="\n")
        out.writerow(columns)
        out.writerows(rows)
    print(f"{name}: {len(rows)} rows, {os.path.getsize(os.path.join(HERE, name)) / 1000:.0f} kB", flush=True)


# ---------------------------------------------------------------- 1: selections

COLUMNS = ["q", "alpha", "eps", "F", "T", "G", "dF", "dT"]
SELECTED = {"ring": "ring", "hertz": "hertz", "punch": "punch", "paraboloid": "parabolic"}
EVERY = 2           # thinning of the lateral table: one row in two, alternating between the exponents


def make_selected(name, folder):
    source = f"{SELECTED[name]}_public.csv"
    rows = [[r["Fperp" if c == "G" else c] for c in COLUMNS] for r in read(source, folder)]
    write(f"{name}.csv", f"pressure ~ (1-r^2)^q: F, T, G and d/d eps of F, T at w=1, v=eps, dimensionless, "
          f"32 digits; the rows of {source} (50/85-digit mpmath evaluation of the closed forms), "
          "G there is Fperp", COLUMNS, rows, True)


def make_uniform_lateral(folder):
    rows = [[r["alpha"], r["eps"], r["Fperp"]] for r in read("uniform_public.csv", folder)]
    exponents = sorted({float(r[0]) for r in rows})
    kept = []
    for k, alpha in enumerate(exponents):
        kept += [r for r in rows if float(r[0]) == alpha][k % EVERY::EVERY]
    write("uniform_lateral.csv", "uniform disk, lateral function G at w=1, v=eps, dimensionless, 32 digits; "
          "every other row of uniform_public.csv (50/85-digit mpmath evaluation), G there is Fperp",
          ["alpha", "eps", "G"], kept, True)


# ---------------------------------------------------------------- 2: the family

PRESSURE_Q = [-1.0, -0.9, -0.5, -0.25, 0.5, 1.0, 2.0, 3.5, 6.0]
PRESSURE_ALPHA = [-0.9, -0.75, -0.3, 0.0, 1e-3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0]
PRESSURE_EPS = [1e-9, 1e-3, 0.3, 0.77, 0.99, 1 - 2.0 ** -40, 1.0, 1 + 2.0 ** -30, 1.01, 1.4, 7.0, 1e4]


def make_pressures(_):
    rows = [[repr(q), repr(a), repr(e)] + values(family, q, a, e)
            for q in PRESSURE_Q for a in PRESSURE_ALPHA for e in PRESSURE_EPS]
    write("pressures.csv", "pressure ~ (1-r^2)^q (q = -1: thin ring): F, T, G and d/d eps of F, T at w=1, v=eps, "
          "dimensionless, 25 digits (60/90 internally); +-inf where a slope is infinite at the rim",
          COLUMNS, rows)


# ---------------------------------------------------------------- 3: annulus

ANNULUS_K = [0.1, 0.5, 0.9, 0.923, 0.99, 0.999, 0.999999]
PATCH_ALPHA = [-0.5, 0.0, 0.5, 3.0]
ANNULUS_EPS = [1e-3, 0.3, 0.5, 0.9, 0.95, 1.0, 1.1, 5.0, 1e3]


def annulus_eps(k):
    """Ratios for one annulus: the common ones and some about its inner rim."""
    return sorted({*ANNULUS_EPS, 0.98 * k, k, math.nextafter(k, 1), k + (1 - k) / 4, (1 + k) / 2})


def make_annulus(_):
    rows = [[repr(k), repr(a), repr(e)] + values(annulus, k, a, e)
            for k in ANNULUS_K for a in PATCH_ALPHA for e in annulus_eps(k)]
    write("annulus.csv", "uniform annulus, inner radius k, outer radius 1, load 1: F, T, G and d/d eps of F, T at "
          "w=1, v=eps (w = omega * outer radius), dimensionless, 25 digits (60/90 internally)",
          ["k"] + COLUMNS[1:], rows)


# ---------------------------------------------------------------- 4: polynomials in r^2

POLYNOMIALS = [(1.0, 0.5, 0.0), (1.0, -1.0, 0.0), (0.2, 1.0, 0.0), (1.0, -2.0, 1.5), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
POLYNOMIAL_EPS = [0.0, 1e-6, 1e-2, 0.4, 0.75, 0.98, 1.0, 1 + 2.0 ** -20, 1.2, 3.0, 1e3]


def make_polynomial(_):
    rows = [[repr(x) for x in (*p, a, e)] + values(polynomial, p, a, e)
            for p in POLYNOMIALS for a in PATCH_ALPHA for e in POLYNOMIAL_EPS]
    write("polynomial.csv", "pressure ~ a0 + a1 r^2 + a2 r^4 scaled to unit load (divide by pi (a0 + a1/2 + a2/3)): "
          "F, T, G and d/d eps of F, T at w=1, v=eps, dimensionless, 25 digits (60/90 internally)",
          ["a0", "a1", "a2"] + COLUMNS[1:], rows)


# ---------------------------------------------------------------- command line

NAMES = [*SELECTED, "uniform_lateral", "pressures", "annulus", "polynomial"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("make",))
    parser.add_argument("--reference", help="folder with the *_public.csv files")
    parser.add_argument("--only", nargs="+", choices=NAMES, default=NAMES)
    args = parser.parse_args()
    for name in args.only:
        if name in (*SELECTED, "uniform_lateral") and not args.reference:
            print(f"{name}: skipped, needs --reference")
        elif name in SELECTED:
            make_selected(name, args.reference)
        else:
            globals()[f"make_{name}"](args.reference)


if __name__ == "__main__":
    main()
