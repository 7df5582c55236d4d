"""Writes ../../core/src/coupling/coulomb/terms.rs: Coulomb friction of round patches in jointly fitted forms.

With x the square of the smaller over the larger speed, z = 1 - x and q the order of the pressure, F/v of a dry patch at
larger speed 1, its torque over the rim's speed T/w and the slope d(F/v)/dx are

    P(u) + z^(q+2) ln z Q(u) for F/v and T/w, P(u) + z^(q+1) ln z Q(u) for the slope, u = z - 1/2      for whole q
                                          u = z for the ring's F/v and slope, as ln z grows without bound
    P(u^2) + u Q(u^2) for all, u = sqrt(z) - 1/2                                                       for half q

Both parts are fitted together, so that their sum counts and not each
alone: least squares of the relative error with Lawson's weights, which lead towards the least largest error.
python3 -m pip install mpmath; takes a few minutes.
"""

import struct
import sys

import mpmath as mp

mp.mp.dps = 40
HALF = mp.mpf(1) / 2
ROUNDS = 8
PRESSURES = {"RING": -1, "PUNCH": -HALF, "DISK": 0, "HERTZ": HALF, "PARABOLOID": 1}
# Terms of force and torque for whole and for half q, and of force and slope.
SIZES = {"F32": ("f32", 6, 6, 6), "F64": ("f64", 11, 12, 12)}
# For the first step of a search along the disk's curve.
ROUGH = {"ROUGH": ("f64", 0, 0, 6)}
POWERS = 6


def spinning(q):
    """F/v, T/w and the slope of the first where spinning leads, as functions of x."""
    torque = mp.gamma(q + 2) * mp.gamma(3 * HALF) / mp.gamma(q + 5 * HALF)
    force = torque * (q + 3 * HALF)
    return (
        lambda x: force * mp.hyp2f1(HALF, -HALF - q, 2, x),
        lambda x: torque * mp.hyp2f1(HALF, -3 * HALF - q, 1, x),
        lambda x: -force * (HALF + q) / 4 * mp.hyp2f1(3 * HALF, HALF - q, 3, x),
    )


def sliding(q):
    """The same where sliding leads."""
    return (
        lambda x: mp.hyp2f1(HALF, -HALF, q + 2, x),
        lambda x: mp.hyp2f1(HALF, HALF, q + 3, x) / (2 * (q + 2)),
        lambda x: -mp.hyp2f1(3 * HALF, HALF, q + 3, x) / (4 * (q + 2)),
    )


def basis(q, power, terms, centre, t):
    """z and the values of all terms at t in (0, 1)."""
    if q == int(q):
        z = t ** (3 * HALF)
        singular = z**power * mp.log(z)
        powers = [(z - centre) ** k for k in range(terms)]
        return z, powers + [singular * entry for entry in powers]
    u = t - HALF
    return t * t, [u ** (2 * k) for k in range(terms)] + [u ** (2 * k + 1) for k in range(terms)]


def fitted(f, q, power, terms, centre):
    """Largest relative error and the terms of both parts."""
    unknowns = 2 * terms
    points = 3 * unknowns
    rows = []
    for i in range(points):
        z, row = basis(q, power, terms, centre, (1 - mp.cos(mp.pi * (i + HALF) / points)) / 2)
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


def interpolated(f, terms):
    """The same of a polynomial in z = (u + 1/2)^2 of degree 2 at most."""
    low, middle, high = f(mp.mpf(1)), f(HALF), f(mp.mpf(0))
    a, b, c = low, 4 * middle - high - 3 * low, 2 * (high + low - 2 * middle)
    regular = [a + b / 4 + c / 16, b + 3 * c / 2, c]
    singular = [b + c / 2, 2 * c]
    return 0, regular + [0] * (terms - 3), singular + [0] * (terms - 2)


def two(functions, q, powers, terms, centre, elementary):
    """The largest errors of two functions, and rows of their regular and their singular parts."""
    fits = [interpolated(f, terms) if elementary else fitted(f, q, power, terms, centre) for f, power in zip(functions, powers)]
    errors, regular, singular = zip(*fits)
    return errors, list(zip(*regular, *singular))


def powers():
    """Polynomials in x with the values of the disk's functions at the points of Chebyshev: right to 1e-5."""
    force, torque, _ = sliding(0)
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
    out.write("//! Terms of the fitted forms, made by `tests/tables/fit_coulomb.py`.\n\nuse crate::real::to_single;\n")
    for name, q in PRESSURES.items():
        sides = {"SPINNING": spinning, "SLIDING": sliding}
        if q == 0:
            sides = {"": sliding}
        sizes = SIZES | (ROUGH if q == 0 else {})
        for side, functions in sides.items():
            force, torque, slope = functions(q if q != -1 else q + mp.mpf("1e-36"))
            elementary = q in (-HALF, HALF) and side == "SPINNING"
            for size, (precision, whole, half, many) in sizes.items():
                tables = (
                    ("TORQUE", whole if q == int(q) else half, (force, torque), (q + 2, q + 2), HALF),
                    ("SLOPE", many, (force, slope), (q + 2, q + 1), 0 if q == -1 else HALF),
                )
                for second, terms, pair, powers_of_z, centre in tables:
                    # A ring's sides change places, and the disk's rough slope has the digits of f32.
                    if terms == 0 or (q, side, second) == (-1, "SLIDING", "TORQUE") or (q, second, size) == (0, "SLOPE", "F32"):
                        continue
                    errors, rows = two(pair, q, powers_of_z, terms, centre, elementary)
                    label = "_".join(part for part in (name, side, second, size) if part)
                    shown = ", ".join(mp.nstr(error, 2) for error in errors)
                    out.write(f"\n/// Largest relative errors of force and {second.lower()}: {shown}.\n")
                    out.write(f"pub(super) static {label}: [[{precision}; 4]; {terms}] = [\n")
                    for row in rows:
                        out.write(f"    [{', '.join(written(term, precision == 'f32') for term in row)}],\n")
                    out.write("];\n")
                    print(label, shown, *(mp.nstr(sum(abs(r[i]) / 2**k for k, r in enumerate(rows)), 3) for i in range(4)), file=sys.stderr)
        if q == 0:
            out.write(f"\n/// The same in f32.\npub(super) static {name}_SLOPE_F32: [[f32; 4]; 6] = to_single(&{name}_SLOPE_ROUGH);\n")
            out.write("\n/// Torque/h where sliding leads and force/h where spinning does, by powers of x.\n")
            out.write(f"pub(super) static {name}_POWERS: [[f64; {POWERS}]; 2] = [\n")
            for row in powers():
                out.write(f"    [{', '.join(written(term, False) for term in row)}],\n")
            out.write("];\n")


if __name__ == "__main__":
    with open("../../core/src/coupling/coulomb/terms.rs", "w") as terms:
        main(terms)
