#!/usr/bin/env python3
"""Rings and punches next to equal speeds, in mpmath: python3 generate_equal_speeds.py > equal_speeds.csv

Derivatives at w = 1, v = 1 +- 2^-k, where those of a ring grow without bound; forms as in generate_ranges.py.
"""
from generate_ranges import results
from mpmath import mp, nstr

mp.dps = 50
print("# q, alpha, v at w = 1; F/v and derivatives next to equal speeds")
print("q,alpha,v,drag,F_v,F_w,T_w")
for q in [-1.0, -0.5]:
    for alpha in [-0.5, 0.0, 0.5, 2.0]:
        for k in [1, 5, 10, 20, 26, 30, 40, 46, 52]:
            for v in [1 - 2.0**-k, 1 + 2.0**-k]:
                _, _, _, *found = results(q, alpha, v, 1.0)
                print(",".join([repr(q), repr(alpha), repr(v)] + [nstr(y, 20) for y in found[:4]]))
