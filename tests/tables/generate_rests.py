#!/usr/bin/env python3
"""Random launches of flat round bodies, followed to rest: rests.csv.

    python3 generate_rests.py make                  # writes the table
    python3 generate_rests.py check                 # repeats some of its launches with 30 digits
    python3 generate_rests.py make --exponents 16 --launches 50 --out FILE      # 4,000 launches

With the pressure ~ (1-r^2)^q and the local law |u|^alpha, the force and torque of the bodies are Gauss functions
(v the speed, w = omega R, m the larger, h the smaller over the larger, x = h^2, s = alpha + 1):

    F = m^(alpha-1) v Phi,  T = m^(alpha-1) w Chi,   A = Gamma(q+2) Gamma(s/2+1)/Gamma(s/2+q+2)
    v <= w:  Phi = A (s/2+1+q) 2F1(1-s/2, -s/2-q; 2; x),   Chi = A 2F1(1-s/2, -s/2-1-q; 1; x)
    v >= w:  Phi = 2F1(1-s/2, -s/2; q+2; x),               Chi = s/(2(q+2)) 2F1(1-s/2, 1-s/2; q+3; x)

each continued by its differential equation from x = 0 towards 1 in 30 digits.  The motion is integrated over
y = ln(v/w), dy/ds = Chi/C - Phi, by composite Gauss-Legendre rules on panels halved towards y = 0 and towards the
fixed point, with ln v and ln w as running integrals: every sum is one of positive terms.
"""
import argparse
import math
import random
from pathlib import Path

import mpmath as mp

HERE = Path(__file__).resolve().parent
POINTS = 12                             # of the Gauss-Legendre rule
TERMS, KEPT = 44, 24                    # of a Taylor series while it is continued, and kept in double precision
CELLS = 112                             # half octaves of z = 1 - x: 2^-56
PRESSURES = [0.0, -1.0, -0.5, 0.5, 1.0]     # uniform, ring, punch, Hertz, paraboloid
DPS = 30


class Gauss:
    """2F1(a, b; c; 1 - z) on half octaves of z."""

    def __init__(self, a, b, c, factor, number):
        a, b, c = mp.mpf(a), mp.mpf(b), mp.mpf(c)
        self.cells = []
        series = [mp.mpf(1)]
        for n in range(4 * TERMS):
            series.append(series[-1] * (a + n) * (b + n) / ((c + n) * (n + 1)))
        z = (1 + mp.sqrt(mp.mpf(0.5))) / 2
        x = 1 - z
        g = [sum(t * x ** n for n, t in enumerate(series)),
             sum(n * t * x ** (n - 1) for n, t in enumerate(series) if n)]
        for _ in range(CELLS):
            g = g[:2]
            p = x * z
            for n in range(TERMS):
                g.append((((a + n) * (b + n)) * g[n] - ((z - x) * n + c - (a + b + 1) * x) * (n + 1) * g[n + 1])
                         / (p * (n + 1) * (n + 2)))
            kept = g if number is mp.mpf else g[:KEPT]
            self.cells.append((number(z), [number(factor * t * z ** n) for n, t in enumerate(kept)][::-1]))
            after = z / mp.sqrt(2)
            t = z - after
            value = slope = mp.mpf(0)
            for k in range(len(g) - 1, -1, -1):
                slope = slope * t + value
                value = value * t + g[k]
            g, z, x = [value, slope], after, 1 - after
        self.end = number(factor * mp.hyp2f1(a, b, c, 1))

    def at(self, z):
        k = int(-2 * math.log2(z)) if z > 1e-16 else CELLS
        if k >= CELLS:
            return self.end
        center, coefficients = self.cells[max(k, 0)]
        t = (center - z) / center
        value = 0
        for c in coefficients:
            value = value * t + c
        return value


class Law:
    """Phi and Chi of one pressure and exponent; kinks are where they are not smooth in y."""

    kinks = [0]

    def __init__(self, q, alpha, number):
        q, s = mp.mpf(q), mp.mpf(alpha) + 1
        self.alpha = alpha
        size = mp.gamma(q + 2) * mp.gamma(s / 2 + 1) / mp.gamma(s / 2 + q + 2)
        self.spinning = [Gauss(1 - s / 2, -s / 2 - q, 2, size * (s / 2 + 1 + q), number),
                         Gauss(1 - s / 2, -s / 2 - 1 - q, 1, size, number)]
        self.sliding = [Gauss(1 - s / 2, -s / 2, q + 2, mp.mpf(1), number),
                        Gauss(1 - s / 2, 1 - s / 2, q + 3, s / (2 * (q + 2)), number)]

    def factors(self, y, expm1):
        z = -expm1(-2 * abs(y))
        return [g.at(z) for g in (self.sliding if y > 0 else self.spinning)]


class Rule:
    """Gauss-Legendre nodes on [0, 1], weights, and weights of the running integrals."""

    def __init__(self, number):
        n = POINTS
        roots = sorted(mp.re(r) for r in mp.polyroots(mp.taylor(lambda x: mp.legendre(n, x), 0, n)[::-1],
                                                      maxsteps=400, extraprec=300))
        self.nodes = [number((1 + r) / 2) for r in roots]
        weights = [1 / ((1 - r * r) * mp.diff(lambda x: mp.legendre(n, x), r) ** 2) for r in roots]
        self.weights = [number(w) for w in weights]
        self.running = []
        for i in range(n):
            row = []
            for j in range(n):
                total = (roots[i] + 1) / 2
                for k in range(1, n):
                    total += mp.legendre(k, roots[j]) * (mp.legendre(k + 1, roots[i])
                                                         - mp.legendre(k - 1, roots[i])) / 2
                row.append(number(weights[j] * total))
            self.running.append(row)


def fixed_point(law, c, expm1):
    """y with Chi/C = Phi, or none."""
    def drive(y):
        phi, chi = law.factors(y, expm1)
        return chi / c - phi
    for lo, hi in ((-40.0, -1e-300), (1e-300, 40.0)):
        ends = drive(lo), drive(hi)
        if ends[0] * ends[1] < 0:
            for _ in range(200):
                mid = (lo + hi) / 2
                if mid in (lo, hi):
                    break
                if drive(mid) * ends[0] > 0:
                    lo = mid
                else:
                    hi = mid
            return (lo + hi) / 2
    return None


def panels(start, end, specials):
    """From start towards end, halved towards the special places, none longer than 1/2 where y matters."""
    sign = 1 if end > start else -1
    at = start
    while (end - at) * sign > 0:
        gap = min((abs(at - p) for p in specials if abs(at - p) > 0), default=math.inf)
        ahead = min((abs(p - at) for p in specials if (p - at) * sign > 0), default=math.inf)
        length = 2.0 if abs(at) > 22 else 0.5
        length = min(length, ahead / 2 if ahead > 1e-15 else ahead, abs(end - at))
        behind = [abs(at - p) for p in specials if (p - at) * sign <= 0]
        if behind:
            length = min(length, max(min(behind), 1e-15))
        if gap < 1e-17:
            length = min(length, 1e-15)
        yield at, at + sign * length
        if at + sign * length == at:
            return
        at = at + sign * length


def follow(law, rule, c, v0, w0, functions):
    """Stop time, distance, angle (none for alpha >= 1) and the states at the ends of all panels."""
    exp, log, expm1, number = functions
    beta = 1 - law.alpha
    y = log(v0) - log(w0)
    offsets = [log(v0) - log(max(v0, w0)), log(w0) - log(max(v0, w0))]
    fixed = fixed_point(law, c, expm1)

    def rates(y):
        phi, chi = law.factors(y, expm1)
        return phi, chi / c

    a, b = rates(y)
    up = b > a
    end = 22.0 if up else -22.0
    if fixed is not None and (fixed > y) == up:
        end = fixed
    ends = [rates(p) for p in (-60.0, 60.0, y, 1e-9)]
    slowest = [min(r[i] for r in ends) / 2 for i in (0, 1)]
    specials = [number(p) for p in law.kinks] + ([fixed] if fixed is not None else [])
    faded, sums, trace = [number(0)] * 2, [number(0)] * 3, []
    is_dead = False
    todo = list(panels(y, end, specials))[::-1]
    while todo and not is_dead:
        lo, hi = todo.pop()
        lead = 0 if lo + hi > 0 else 1
        nodes = [lo + (hi - lo) * t for t in rule.nodes]
        all_rates = [rates(p) for p in nodes]
        steps = [abs((hi - lo) / (r[1] - r[0])) if r[1] != r[0] else None for r in all_rates]
        if None in steps:
            break
        growth = max(st * (abs(beta) * r[lead] + max(r)) for st, r in zip(steps, all_rates))
        if growth > 3 and abs(hi - lo) > 1e-13 * abs(lo):
            live = [exp(beta * (offsets[lead] - faded[lead]) - f) for f in faded]
            if growth * abs(beta) > 3 or max(live) > 1e-25 * max(1e-300, min(sums[1:])):
                mid = lo + (hi - lo) / 2
                if mid not in (lo, hi):
                    todo += [(mid, hi), (lo, mid)]
                    continue
        for i in range(POINTS):
            at = [faded[k] + sum(m * st * r[k] for m, st, r in zip(rule.running[i], steps, all_rates)) for k in (0, 1)]
            pace = rule.weights[i] * steps[i] * exp(beta * (offsets[lead] - at[lead]))
            sums[0] += pace
            sums[1] += pace * exp(-at[0])
            sums[2] += pace * exp(-at[1])
        for k in (0, 1):
            faded[k] += sum(w * st * r[k] for w, st, r in zip(rule.weights, steps, all_rates))
        trace.append((list(sums), list(faded)))
        if beta > 0:
            pace = exp(beta * (offsets[lead] - faded[lead]))
            either = beta * min(slowest)
            left = [pace / either, pace * exp(-faded[0]) / (slowest[0] + either), pace * exp(-faded[1]) / (slowest[1] + either)]
            is_dead = all(x <= 1e-19 * total for x, total in zip(left, sums))
        elif max(faded) > 12:
            break
        if fixed is not None and end == fixed and abs(hi - fixed) < 3e-14:
            break
        y = hi
    if beta <= 0:
        return None, trace
    if not is_dead:
        final = fixed if fixed is not None and end == fixed else math.copysign(60.0, end)
        lead = 0 if final > 0 else 1
        phi, spin = rates(final)
        pace = exp(beta * (offsets[lead] - faded[lead]))
        fall = beta * (phi, spin)[lead]
        sums = [sums[0] + pace / fall, sums[1] + pace * exp(-faded[0]) / (phi + fall),
                sums[2] + pace * exp(-faded[1]) / (spin + fall)]
    return sums, trace


def in_units(sums, v0, w0, beta):
    unit = max(v0, w0) ** beta
    return [sums[0] * unit, sums[1] * unit * v0, sums[2] * unit * w0]


COLUMNS = ["q", "alpha", "inertia_ratio", "v0", "w0", "stop_time", "distance", "angle",
           "time", "speed", "spin", "distance_then", "angle_then"]


HEAD = ("# Random launches of a flat round body to rest: pressure ~ (1-r^2)^q (q = -1: thin ring), dv/dt=-F(v,w),\n"
        "# dw/dt=-T(v,w)/C, C = inertia_ratio = I/(M R^2), w = omega R, dimensionless (R = kappa = 1); the last five\n"
        "# columns are a state on the way. Blank stops: alpha >= 1 never rests. Relative accuracy 5e-14.\n"
        "# Made by generate_rests.py.\n")


def launch(rng):
    """C, v0, w0: the rim speed 1 or the speed 1."""
    c = 10 ** rng.uniform(-4, 4)
    ratio = 10 ** rng.uniform(-15, 15)
    c, ratio = float(f"{c:.4g}"), float(f"{ratio:.4g}")
    return (c, ratio, 1.0) if ratio < 1 else (c, 1.0, float(f"{1 / ratio:.4g}"))


def make(exponents, launches, out, seed):
    rng = random.Random(seed)
    functions = (math.exp, math.log, math.expm1, float)
    with mp.workdps(DPS):
        rule = Rule(float)
        for k in range(exponents):
            top = 3.0 if k % 4 == 3 else 0.99
            alpha = round(rng.uniform(-0.9, top), 3)
            rows = []
            for q in PRESSURES:
                law = Law(q, alpha, float)
                for _ in range(launches):
                    c, v0, w0 = launch(rng)
                    rows.append([repr(x) for x in (q, alpha, c, v0, w0)]
                                + row(law, rule, c, v0, w0, functions, rng))
            with out.open("a" if k else "w") as file:
                if not k:
                    file.write(HEAD + ",".join(COLUMNS) + "\n")
                file.writelines(",".join(r) + "\n" for r in rows)
            print("alpha", alpha, flush=True)


def row(law, rule, c, v0, w0, functions, rng):
    beta = 1 - law.alpha
    stop, trace = follow(law, rule, c, v0, w0, functions)
    usable = [t for t in trace if (stop is None or t[0][0] < 0.9 * stop[0]) and max(t[1]) < 600
              and in_units(t[0], v0, w0, beta)[0] > 1e-12]
    cells = ["", "", ""] if stop is None else [repr(x) for x in in_units(stop, v0, w0, beta)]
    if not usable:
        return cells + [""] * 5
    sums, faded = rng.choice(usable)
    time, distance, angle = in_units(sums, v0, w0, beta)
    return cells + [repr(x) for x in (time, v0 * math.exp(-faded[0]), w0 * math.exp(-faded[1]), distance, angle)]


def check(count):
    """The first launches of every pressure again with mpmath numbers throughout."""
    lines = [line.split(",") for line in (HERE / "rests.csv").read_text().splitlines()
             if not line.startswith("#")][1:]
    lines = [line for line in lines if line[5]]
    with mp.workdps(DPS):
        rule = Rule(mp.mpf)
        worst = 0
        for cells in lines[:: max(1, len(lines) // count)]:
            q, alpha, c, v0, w0 = map(mp.mpf, map(float, cells[:5]))
            law = Law(q, alpha, mp.mpf)
            stop, _ = follow(law, rule, c, v0, w0, (mp.exp, mp.log, mp.expm1, mp.mpf))
            exact = in_units(stop, v0, w0, 1 - alpha)
            errors = [abs(mp.mpf(a) / b - 1) for a, b in zip(map(float, cells[5:8]), exact)]
            worst = max(worst, *errors)
            print(cells[:5], [mp.nstr(e, 2) for e in errors], flush=True)
        print("worst", mp.nstr(worst, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("make", "check"))
    parser.add_argument("--exponents", type=int, default=16)
    parser.add_argument("--launches", type=int, default=4)
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--seed", type=int, default=20)
    parser.add_argument("--out", type=Path, default=HERE / "rests.csv")
    args = parser.parse_args()
    if args.action == "make":
        make(args.exponents, args.launches, args.out, args.seed)
    else:
        check(args.count)


if __name__ == "__main__":
    main()
