#!/usr/bin/env python3
"""Force and torque of a uniform disk under laws with several regimes: regimes.csv.

    python3 generate_regimes.py

Seen from the instantaneous centre of rotation, at the distance d = v/w (in radii) from the centre of the disk,
the speed of an element at the distance s is w s, and friction is along the circle of radius s, of which the arc
of the angle A(s) lies on the disk:

    A = 2 pi for s <= 1 - d,  2 acos((s^2 + d^2 - 1)/(2 s d)) between |1 - d| and 1 + d
    F = 1/pi int s g(w s) 2 sin(A/2) ds,   T = 1/pi int s^2 g(w s) A ds - d F

integrated with 30 digits.  Needs mpmath.
"""
from pathlib import Path

import mpmath as mp

mp.mp.dps = 30
HERE = Path(__file__).resolve().parent


def stribeck(mu_s, mu_d, vs, delta, k):
    return lambda v: mu_d + (mu_s - mu_d) * mp.exp(-((v / vs) ** delta)) + k * v


def lugre(fc, fs, vs, s2):
    return lambda v: fc + (fs - fc) * mp.exp(-((v / vs) ** 2)) + s2 * v


LAWS = [("stribeck", stribeck, p) for p in [
    ("0.15", "0.1", "0.2", "2", "0"), ("0.15", "0.1", "1", "2", "0"), ("0.3", "0.01", "0.2", "2", "0"),
    ("0.15", "0.1", "0.2", "1", "0.05"), ("0.15", "0.1", "0.2", "0.5", "0")]]
LAWS += [("lugre", lugre, ("0.1", "0.2", "0.2", "0"))]
TWISTS = [("1", "0.5"), ("0.95", "0.5"), ("1.3", "0.5"), ("0.6", "0.5"), ("0.501", "0.5"), ("0.5", "0.5"),
          ("0.499", "0.5"), ("0.3", "0.5"), ("0.1", "1"), ("0.01", "0.5"), ("0.05", "0.04"), ("0", "0.7")]


def wrench(g, v, w):
    d = v / w
    inner, outer = abs(1 - d), 1 + d
    # s = middle - half cos t takes the roots at both ends of the arcs.
    middle, half = (inner + outer) / 2, (outer - inner) / 2

    def over(f):
        cuts = [mp.pi * k / 16 for k in range(17)]
        return mp.quad(lambda t: f(middle - half * mp.cos(t)) * half * mp.sin(t), cuts) if half else mp.mpf(0)

    def arc(s):
        return mp.pi / 2 if s == 0 else mp.acos(max(-1, min(1, (s * s + d * d - 1) / (2 * s * d))))
    force = over(lambda s: s * g(w * s) * 2 * mp.sin(arc(s))) / mp.pi
    about = over(lambda s: s * s * g(w * s) * 2 * arc(s)) / mp.pi
    if d < 1:
        about += mp.quad(lambda s: 2 * s * s * g(w * s), [inner * mp.mpf(k) / 8 for k in range(9)])
    return force, about - d * force


def main():
    lines = ["# Uniform disk under Stribeck's and LuGre's steady laws: F and T per load, w = omega R, R = 1.",
             "# a to e: stribeck mu_s, mu_d, vs, delta, k; lugre fc, fs, vs, s2. Made by generate_regimes.py.",
             "law,a,b,c,d,e,v,w,force,torque"]
    for name, law, given in LAWS:
        g = law(*map(mp.mpf, given))
        for v, w in TWISTS:
            numbers = [mp.nstr(x, 20) for x in wrench(g, mp.mpf(v), mp.mpf(w))]
            lines.append(",".join([name, *given, *[""] * (5 - len(given)), v, w, *numbers]))
    (HERE / "regimes.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
