"""Writes ../../core/src/coupling/coulomb/terms.rs: Coulomb friction of round patches in jointly fitted forms.

With x the square of the smaller over the larger speed, z = 1 - x and q the order of the pressure, F/v of a dry patch
at larger speed 1 and its slope F' = d(F/v)/dx are

    P(z) + z^(q+2) ln z Q(z) and R(z) + z^(q+1) ln z S(z)          for whole q
    P(u^2) + u Q(u^2)        and R(u^2) + u S(u^2), u = sqrt(z) - 1/2      for half q

Both parts are fitted together, so that their sum counts and not each alone: least squares of the relative error with
Lawson's weights, which lead towards the least largest error. python3 -m pip install mpmath; takes a minute.
"""

import struct
import sys

import mpmath as mp

mp.mp.dps = 40
HALF = mp.mpf(1) / 2
ROUNDS = 8
PRESSURES = {"RING": -1, "PUNCH": -HALF, "DISK": 0, "HERTZ": HALF, "PARABOLOID": 1}
SIZES = {"F32": ("f32", 6), "F64": ("f64", 12)}
# For the first step of a search along the disk's curve.
ROUGH = {"ROUGH": ("f64", 6)}
POWERS = 6


def spinning(q):
    """F/v and its slope where spinning leads, as functions of x."""
    scale = mp.gamma(q + 2) * mp.gamma(3 * HALF) / mp.gamma(q + 5 * HALF) * (q + 3 * HALF)
    slope = -scale * (HALF + q) / 4
    return (
        lambda x: scale * mp.hyp2f1(HALF, -HALF - q, 2, x),
        lambda x: slope * mp.hyp2f1(3 * HALF, HALF - q, 3, x),
    )


def sliding(q):
    """The same where sliding leads."""
    return (
        lambda x: mp.hyp2f1(HALF, -HALF, q + 2, x),
        lambda x: -mp.hyp2f1(3 * HALF, HALF, q + 3, x) / (4 * (q + 2)),
    )


def basis(q, power, terms, t):
    """z and the values of all terms at t in (0, 1)."""
    if q == int(q):
        z = t ** (3 * HALF)
        singular = z**power * mp.log(z)
        return z, [z**k for k in range(terms)] + [singular * z**k for k in range(terms)]
    u = t - HALF
    return t * t, [u ** (2 * k) for k in range(terms)] + [u ** (2 * k + 1) for k in range(terms)]


def fitted(f, q, power, terms):
    """Largest relative error and the terms of both parts."""
    unknowns = 2 * terms
    points = 3 * unknowns
    rows = []
    for i in range(points):
        z, row = basis(q, power, terms, (1 - mp.cos(mp.pi * (i + HALF) / points)) / 2)
        value = f(1 - z)
        rows.append([entry / value for entry in row])
    weights = [mp.mpf(1)] * points
    best = None
    for _ in range(ROUNDS):
        roots = [mp.sqrt(weight) for weight in weights]
        matrix = mp.matrix([[root * entry for entry in row] for root, row in zip(roots, rows)])
        found, _ = mp.qr_solve(matrix, mp.matrix(roots))
        errors = [abs(sum(a * b for a, b in zip(row, found)) - 1) for row in rows]
        worst = max(errors)
        if best is None or worst < best[0]:
            best = worst, list(found)
        weights = [weight * (error / worst + mp.mpf("1e-3")) for weight, error in zip(weights, errors)]
        total = sum(weights) / points
        weights = [weight / total for weight in weights]
    worst, found = best
    return worst, found[:terms], found[terms:]


def both(functions, q, terms):
    """The largest error and rows of P, Q, R and S."""
    near = q if q != -1 else q + mp.mpf("1e-36")
    errors, columns = [], []
    for power, f in zip((q + 2, q + 1), functions(near)):
        error, regular, singular = fitted(f, q, power, terms)
        errors.append(error)
        columns += [regular, singular]
    return errors, list(zip(*columns))


def elementary(q, terms):
    """Rows where spinning leads and the force is a polynomial in z = u^2 + u + 1/4, of degree 0 or 1."""
    at_end, _ = spinning(q)
    constant, linear = at_end(mp.mpf(1)), at_end(mp.mpf(0)) - at_end(mp.mpf(1))
    rows = [[constant + linear / 4, linear, -linear, 0], [linear, 0, 0, 0]]
    return [0, 0], rows + [[0] * 4] * (terms - 2)


def powers():
    """Polynomials in x with the values of the disk's functions at the points of Chebyshev: right to 1e-5."""
    force, _ = sliding(0)
    torque = lambda x: mp.hyp2f1(HALF, HALF, 3, x) / 4
    points = [(1 - mp.cos(mp.pi * (k + HALF) / POWERS)) / 2 for k in range(POWERS)]
    matrix = mp.matrix([[x**k for k in range(POWERS)] for x in points])
    return [list(mp.lu_solve(matrix, mp.matrix([f(x) for x in points]))) for f in (torque, force)]


def written(number, single):
    """The shortest text of the nearest number of the precision."""
    number = float(number)
    if single:
        round_to = lambda x: struct.unpack("f", struct.pack("f", x))[0]
        number = round_to(number)
        texts = (f"{number:.{digits}g}" for digits in range(1, 12))
        number = float(next(text for text in texts if round_to(float(text)) == number))
    text = repr(number).replace("e-0", "e-")
    mantissa, mark, exponent = text.partition("e")
    whole, _, digits = mantissa.partition(".")
    groups = [digits[i : i + 3] for i in range(0, len(digits), 3)] or ["0"]
    return f"{whole}.{'_'.join(groups)}{mark}{exponent}"


def main(out):
    out.write("//! Terms of the fitted forms, made by `tests/tables/fit_coulomb.py`.\n")
    for name, q in PRESSURES.items():
        sides = {"SPINNING": spinning, "SLIDING": sliding}
        if q == 0:
            sides = {"": sliding}
        sizes = SIZES | (ROUGH if q == 0 else {})
        for side, functions in sides.items():
            for size, (precision, terms) in sizes.items():
                if q in (-HALF, HALF) and side == "SPINNING":
                    errors, rows = elementary(q, terms)
                else:
                    errors, rows = both(functions, q, terms)
                label = "_".join(part for part in (name, side, size) if part)
                out.write(f"\n/// Largest relative errors of force and slope: {', '.join(mp.nstr(e, 2) for e in errors)}.\n")
                out.write(f"pub(super) static {label}: [[{precision}; 4]; {terms}] = [\n")
                for row in rows:
                    out.write(f"    [{', '.join(written(term, precision == 'f32') for term in row)}],\n")
                out.write("];\n")
                print(label, *(mp.nstr(e, 3) for e in errors), file=sys.stderr)
        if q == 0:
            out.write("\n/// Torque/h where sliding leads and force/h where spinning does, by powers of x.\n")
            out.write(f"pub(super) static {name}_POWERS: [[f64; {POWERS}]; 2] = [\n")
            for row in powers():
                out.write(f"    [{', '.join(written(term, False) for term in row)}],\n")
            out.write("];\n")


if __name__ == "__main__":
    with open("../../core/src/coupling/coulomb/terms.rs", "w") as terms:
        main(terms)
