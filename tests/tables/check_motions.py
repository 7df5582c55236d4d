#!/usr/bin/env python3
"""Independent checks of the tables of generate_motions.py.

    python3 check_motions.py

  * tilted pressure: force, lateral force and torque by two-dimensional integration, against the formulas used;
  * tilted_cylinder, ring_stops: DOP853 in double precision at two tolerances;
  * modes_pressure: C F = eps T, with F and T as integrals over rings of pressure.
Needs mpmath 1.3, numpy, scipy.
"""
import math

import mpmath as mp
import numpy as np
from mpmath import mpf
from scipy.integrate import solve_ivp
from scipy.special import ellipe, ellipk, gamma, hyp2f1, roots_jacobi

from check_pressures import family_by_rings
from generate import Worst, read
from generate_pressures import family

# ---------------------------------------------------------------- the tilted pressure


def tilted_by_area(q, alpha, eps, lx, ly, turns=1200):
    """Resistance along the motion, to the left, and its torque, for the pressure p_q (1 + lx x + ly y)."""
    theta = 2 * np.pi * (np.arange(turns) + 0.5) / turns
    co, si = np.cos(theta)[:, None], np.sin(theta)[:, None]
    if eps < 1:                                          # polar coordinates about the rotation centre
        root = np.sqrt(1 - (eps * co) ** 2)
        reach, back = root - eps * si, root + eps * si
        t, w = roots_jacobi(80, q, alpha + 1)
        d = reach * (1 + t) / 2
        x, y, ux, uy = d * co, eps + d * si, -si + 0 * d, co + 0 * d
        w = w / 2 ** (alpha + 2 + q) * (d + back) ** q * reach ** (alpha + 2 + q)
    else:                                                # about the middle
        t, w = roots_jacobi(80, q, 0.0)
        r = np.sqrt((1 + t) / 2)
        x, y = r * co, r * si
        ux, uy = eps - y, x
        w = w / 2 ** (2 + q) * np.hypot(ux, uy) ** (alpha - 1)
    w = 2 * (q + 1) / turns * w * (1 + lx * x + ly * y)
    return np.sum(w * ux), np.sum(w * uy), np.sum(w * (x * uy - y * ux))


def check_tilted_pressure():
    worst = Worst("tilted pressure: F - ly (G + eps G'), lx G, T + ly eps (eps G' - alpha G) vs area integrals")
    lx, ly = 0.37, 0.29
    for q in (-0.5, 0.0, 0.5, 1.0):
        for alpha in (-0.5, 0.0, 0.5, 3.0):
            for eps in (0.2, 0.65, 0.85, 1.2, 2.5):
                f, t, g = (float(x) for x in family(q, alpha, eps)[:3])
                eg = eps * float(mp.diff(lambda z: family(q, alpha, z)[2], mpf(eps)))
                want = f - ly * (g + eg), lx * g, t + ly * eps * (eg - alpha * g)
                for x, y, c in zip(tilted_by_area(q, alpha, eps, lx, ly), want, "FPT"):
                    worst.add(mpf(x), mpf(y), (q, alpha, eps, c))
    worst.show()


# ---------------------------------------------------------------- motions by DOP853


def disk_numbers(eps):
    """F, T, G, eps G' at alpha = 0 in double precision, by 2F1."""
    if eps <= 1:
        x = eps * eps
        g, dg = hyp2f1(0.5, -1.5, 2, x) / 3, -0.75 / 2 * hyp2f1(1.5, -0.5, 3, x) / 3
        return eps * hyp2f1(0.5, -0.5, 2, x), hyp2f1(0.5, -1.5, 1, x) * 2 / 3, g, 2 * x * dg
    y = 1 / (eps * eps)
    g, dg = hyp2f1(-0.5, 0.5, 3, y) / (4 * eps), -0.25 / 3 * hyp2f1(0.5, 1.5, 4, y) / (4 * eps)
    return hyp2f1(0.5, -0.5, 2, y), hyp2f1(0.5, 0.5, 3, y) / (4 * eps), g, -g - 2 * y * dg


def tilted_double(variant, kappa):
    def force(co, si):
        f, t, g, eg = disk_numbers(co / si)
        if variant == "front-back":
            return f, kappa * f * g, t
        f = f / (1 + kappa ** 2 * g * (g + eg))
        return f, kappa * g * f, t + kappa ** 2 * g * f * eg * co / si
    return force


def straight_double(q, alpha):
    h = (alpha + 1) / 2
    a = gamma(q + 2) * gamma(h + 1) / gamma(h + q + 2)

    def force(co, si):
        if co <= si:
            x = (co / si) ** 2
            return (si ** alpha * a * (h + 1 + q) * co / si * hyp2f1(1 - h, -h - q, 2, x), 0.0,
                    si ** alpha * a * hyp2f1(1 - h, -h - 1 - q, 1, x))
        y = (si / co) ** 2
        return (co ** alpha * hyp2f1(1 - h, -h, q + 2, y), 0.0,
                co ** alpha * h / (q + 2) * si / co * hyp2f1(1 - h, 1 - h, q + 3, y))
    return force


def by_ode(force, c, alpha, v0, w0, rtol):
    """Time, x, y, angle from the equations in tau, until the speed is negligible."""
    p = 1 - alpha

    def slope(_, y):
        co, si = math.cos(y[1]), math.sin(y[1])
        f, right, t = force(co, si)
        s = math.exp(y[0])
        dt = s ** p
        turn = right / co if right else 0.0
        return [-(f * co + t * si / c), f * si - t * co / c, -turn, dt, dt * s * co * math.cos(y[2]),
                dt * s * co * math.sin(y[2]), dt * s * si]

    y, speed = [math.log(math.hypot(v0, w0)), math.atan2(w0, v0), 0.0, 0.0, 0.0, 0.0, 0.0], 1.0
    while p * y[0] > -34:
        y = list(solve_ivp(slope, (0, 4), y, method="DOP853", rtol=rtol, atol=1e-16).y[:, -1])
    y[3] += math.exp(p * y[0]) / (p * -slope(0, y)[0])
    return y[3], y[4], y[5], y[6]


def check_motions():
    for rtol in (1e-10, 3e-14):
        tilted, stops = (Worst(f"{n} vs DOP853, rtol {rtol}") for n in ("tilted_cylinder", "ring_stops"))
        for r in read("tilted_cylinder.csv"):
            mu, g, radius, height, v0, spin0 = (float(r[c]) for c in ("mu", "g", "R", "H_over_R", "v0", "spin0"))
            got = by_ode(tilted_double(r["variant"], 2 * mu * height), 0.5, 0.0, v0, spin0 * radius, rtol)
            units = (1 / (mu * g), 1 / (mu * g), 1 / (mu * g), 1 / (mu * g * radius))
            for c, x, u in zip(("t_stop", "x", "y", "angle"), got, units):
                tilted.add(mpf(x * u), mpf(r[c]), (*list(r.values())[:7], c))
        for r in read("ring_stops.csv"):
            q, alpha, c, v0, w0 = (float(r[x]) for x in ("q", "alpha", "inertia_ratio", "v0", "w0"))
            t, x, _, angle = by_ode(straight_double(q, alpha), c, alpha, v0, w0, rtol)
            for n, value in (("stop_time", t), ("distance", x), ("angle", angle)):
                stops.add(mpf(value), mpf(r[n]), (q, alpha, c, v0, w0, n))
        tilted.show()
        stops.show()


def check_modes():
    worst = Worst("modes_pressure: C F(eps0) = eps0 T(eps0) by rings of pressure, 0.01 < eps0 < 100")
    for r in read("modes_pressure.csv"):
        if r["eps0"] and 0.01 < float(r["eps0"]) < 100:
            e = float(r["eps0"])
            f, t, _ = family_by_rings(float(r["q"]), float(r["alpha"]), e)
            worst.add(mpf(float(r["C"]) * f), mpf(e * t), (r["q"], r["alpha"], r["C"]))
    worst.show()


if __name__ == "__main__":
    check_tilted_pressure()
    check_modes()
    check_motions()
