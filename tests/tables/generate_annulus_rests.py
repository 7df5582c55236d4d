#!/usr/bin/env python3
"""Random launches of annuli, followed to rest: annulus_rests.csv.

    python3 generate_annulus_rests.py make          # writes the table, some minutes
    python3 generate_annulus_rests.py check         # repeats some of its launches with 30 digits

An annulus from k to 1 radii under uniform pressure is the disk without its inside,

    F = (F1(v, w) - k^2 F1(v, k w))/(1-k^2),   T = (T1(v, w) - k^3 T1(v, k w))/(1-k^2),

with F1, T1 of the uniform disk as Gauss functions (generate_rests.py, whose integration to rest this uses).  They
are not smooth at v = w and, for the inner edge, at v = k w.
"""
import argparse
import math
import random
from pathlib import Path

import mpmath as mp

from generate_rests import COLUMNS, DPS, Law, Rule, follow, in_units, launch, row

HERE = Path(__file__).resolve().parent
INNER = [0.1, 0.5, 0.9, 0.99]           # over the outer radius
HEAD = ("# Random launches of an annulus from k to 1 radii, uniform pressure, to rest; other columns as in rests.csv.\n"
        "# Relative accuracy 1e-13. Made by generate_annulus_rests.py.\n")


class AnnulusLaw:
    """Phi and Chi of an annulus."""

    def __init__(self, k, alpha, number, log):
        self.alpha, self.k = alpha, k
        self.disk = Law(0, alpha, number)
        self.step = log(k)
        self.kinks = [0, self.step]

    def factors(self, y, expm1):
        k, alpha = self.k, self.alpha
        outer = self.disk.factors(y, expm1)
        # Ratio v/(k w) of the inner disk.
        inside = y - self.step
        inner = self.disk.factors(inside, expm1)
        exp = mp.exp if isinstance(y, mp.mpf) else math.exp
        # Its larger speed, over that of the outer one, to the power alpha - 1.
        size = exp((alpha - 1) * (max(y, self.step) - max(y, 0)))
        whole = 1 - k * k
        return [(outer[0] - k ** 2 * size * inner[0]) / whole, (outer[1] - k ** 4 * size * inner[1]) / whole]


def make(exponents, launches, out, seed):
    rng = random.Random(seed)
    functions = (math.exp, math.log, math.expm1, float)
    lines = []
    with mp.workdps(DPS):
        rule = Rule(float)
        for _ in range(exponents):
            alpha = round(rng.uniform(-0.9, 0.99), 3)
            for k in INNER:
                law = AnnulusLaw(k, alpha, float, math.log)
                for _ in range(launches):
                    c, v0, w0 = launch(rng)
                    cells = [repr(x) for x in (k, alpha, c, v0, w0)]
                    lines.append(",".join(cells + row(law, rule, c, v0, w0, functions, rng)) + "\n")
            print("alpha", alpha, flush=True)
    out.write_text(HEAD + ",".join(["k"] + COLUMNS[1:]) + "\n" + "".join(lines))


def check(count):
    """Some launches again with mpmath numbers throughout."""
    lines = [line.split(",") for line in (HERE / "annulus_rests.csv").read_text().splitlines()
             if not line.startswith("#")][1:]
    with mp.workdps(DPS):
        rule = Rule(mp.mpf)
        worst = 0
        for cells in lines[:: max(1, len(lines) // count)]:
            k, alpha, c, v0, w0 = map(mp.mpf, map(float, cells[:5]))
            law = AnnulusLaw(k, alpha, mp.mpf, mp.log)
            stop, _ = follow(law, rule, c, v0, w0, (mp.exp, mp.log, mp.expm1, mp.mpf))
            exact = in_units(stop, v0, w0, 1 - alpha)
            errors = [abs(mp.mpf(a) / b - 1) for a, b in zip(map(float, cells[5:8]), exact)]
            worst = max(worst, *errors)
            print(cells[:5], [mp.nstr(e, 2) for e in errors], flush=True)
        print("worst", mp.nstr(worst, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("make", "check"))
    parser.add_argument("--exponents", type=int, default=12)
    parser.add_argument("--launches", type=int, default=12)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--seed", type=int, default=5)
    parser.add_argument("--out", type=Path, default=HERE / "annulus_rests.csv")
    args = parser.parse_args()
    if args.action == "make":
        make(args.exponents, args.launches, args.out, args.seed)
    else:
        check(args.count)


if __name__ == "__main__":
    main()
