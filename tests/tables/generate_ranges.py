#!/usr/bin/env python3
"""Speeds from the whole range of both binary types, in mpmath: python3 generate_ranges.py > ranges.csv

F, T, G and all derivatives of the round pressures (q+1)/pi (1-r^2)^q under |u|^alpha at unit load, from their
hypergeometric forms, each function by its own (T is not made from F). Speeds are random mantissas times powers of two
that cover the type, subnormal numbers included; a row is kept if F, T or G is a number of the type. Results keep their
true decimal exponents, also beyond binary64.
"""
import random
import struct

from mpmath import gamma, hyp2f1, mp, mpf, nstr

mp.dps = 40
ORDERS = [-1.0, -0.5, 0.0, 0.5, 1.0]
EXPONENTS = [-0.9, -0.5, 0.0, 0.25, 1.0, 2.0, 5.0, 10.0]
TYPES = {"f64": (-1074, 1023, 7), "f32": (-149, 127, 4)}


def rounded(x, kind):
    """The number of the type nearest to x."""
    return struct.unpack("<f", struct.pack("<f", x))[0] if kind == "f32" else x


def functions(q, alpha, v, w):
    """Phi, Phi', Chi, Chi', Gamma, Gamma' (of G = m^alpha b Gamma) in x = h^2, and x."""
    s = alpha + 1
    x = (min(v, w) / max(v, w)) ** 2

    def pair(scale, a, b, c):
        value = scale * hyp2f1(a, b, c, x)
        return value, scale * a * b / c * hyp2f1(a + 1, b + 1, c + 1, x)

    if v > w:
        return (pair(mpf(1), 1 - s / 2, -s / 2, q + 2), pair(s / (2 * (q + 2)), 1 - s / 2, 1 - s / 2, q + 3),
                pair(1 / (2 * (q + 2)), -s / 2, 1 - s / 2, q + 3), x)
    A = gamma(q + 2) * gamma(s / 2 + 1) / gamma(s / 2 + q + 2)
    return (pair(A * (s / 2 + 1 + q), 1 - s / 2, -s / 2 - q, mpf(2)), pair(A, 1 - s / 2, -s / 2 - 1 - q, mpf(1)),
            pair(A / 2, 1 - s / 2, -1 - q - s / 2, mpf(2)), x)


def results(q, alpha, v, w):
    """F, T, G, F/v, F_v, F_w, T_w, (vG)_v, (vG)_w."""
    q, alpha, v, w = (mpf(y) for y in (q, alpha, v, w))
    m = max(v, w)
    (phi, dphi), (chi, dchi), (lat, dlat), x = functions(q, alpha, v, w)
    n = m ** (alpha - 1)
    F, T = n * v * phi, n * w * chi
    if v > w:
        # x = w^2/v^2; G = v^(alpha-1) w Gamma
        G = n * w * lat
        F_v, F_w = n * (alpha * phi - 2 * x * dphi), n * 2 * (w / v) * dphi
        T_w = n * (chi + 2 * x * dchi)
        vG_v, vG_w = n * w * (alpha * lat - 2 * x * dlat), n * v * (lat + 2 * x * dlat)
    else:
        # x = v^2/w^2; G = w^alpha Gamma
        G = n * w * lat
        F_v, F_w = n * (phi + 2 * x * dphi), n * (v / w) * ((alpha - 1) * phi - 2 * x * dphi)
        T_w = n * (alpha * chi - 2 * x * dchi)
        vG_v, vG_w = n * w * (lat + 2 * x * dlat), n * v * (alpha * lat - 2 * x * dlat)
    return [F, T, G, n * phi, F_v, F_w, T_w, vG_v, vG_w]


def speed(rng, low, high, kind):
    exponent = rng.randint(low, high)
    mantissa = 1 + rng.getrandbits(52) / 2**52
    if exponent > high - 1:
        mantissa = 1.0
    return rounded(float(mpf(mantissa) * mpf(2) ** exponent), kind)


def main():
    rng = random.Random(20)
    print("# type, order, alpha, v, w; F, T, G, F/v and derivatives at speeds of the whole range of the type")
    print("type,q,alpha,v,w,F,T,G,drag,F_v,F_w,T_w,vG_v,vG_w")
    for kind, (low, high, count) in TYPES.items():
        smallest, largest = mpf(2) ** low, mpf(2) ** high
        for q in ORDERS:
            for alpha in EXPONENTS:
                alpha = rounded(alpha, kind)
                kept = 0
                while kept < count:
                    v, w = (speed(rng, low, high, kind) for _ in range(2))
                    if v == w:
                        continue
                    found = results(q, alpha, v, w)
                    if not any(smallest < y < largest for y in found[:3]):
                        continue
                    texts = ["0.0" if y == 0 else nstr(y, 20, min_fixed=1, max_fixed=0) for y in found]
                    print(",".join([kind, repr(q), repr(alpha), repr(v), repr(w)] + texts))
                    kept += 1


if __name__ == "__main__":
    main()
