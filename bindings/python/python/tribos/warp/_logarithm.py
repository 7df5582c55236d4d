"""The kernel's own logarithm, of + − × ÷ and bits alone: the same digits on every device."""

from __future__ import annotations

import math

import warp as wp

# 2 (atanh(f)/f − 1)/f² for f² ≤ 0.0402, to 2.5e-7: the kernel's ATANH_SINGLE.
ATANH = wp.constant(wp.vec3(0.6666671, 0.39978802, 0.2996279))
LN_2 = wp.constant(math.log(2.0))
# Stored digits of a float32, half a step of the exponent, its bias, and the least normal number.
DIGITS = wp.constant(wp.uint32(23))
HALF_STEP = wp.constant(wp.uint32(1 << 22))
BIAS = wp.constant(127.0)
LEAST = wp.constant(2.0**-126)


@wp.func
def power_of_two_next_to(z: float) -> float:
    """2ᵏ next to a positive normal number, by a factor of 1.5 at most."""
    raised = (wp.cast(z, wp.uint32) + HALF_STEP) >> DIGITS
    return wp.cast(raised << DIGITS, wp.float32)


@wp.func
def log_part(z: float) -> float:
    """ln z of a positive normal number, to 4 ulp of the larger of it and 1 − z."""
    raised = (wp.cast(z, wp.uint32) + HALF_STEP) >> DIGITS
    octaves = float(raised) - BIAS
    nearest = wp.cast(raised << DIGITS, wp.float32)
    # ln(z/2ᵏ) = 2 atanh f; the difference is exact.
    f = (z - nearest) / (z + nearest)
    square = f * f
    bend = (ATANH[0] + ATANH[1] * square) + ATANH[2] * (square * square)
    return octaves * LN_2 + f * (2.0 + square * bend)
