//! Logarithm of a number up to 1, of one number or of several side by side.

use super::log_quotient::twice_atanh;
use crate::real::Real;
use core::ops::{Add, Div, Mul, Sub};

/// ln z for z next to 2ᵏ, from z, k and 2ᵏ; `repeat` makes a constant of each lane.
///
/// *Domain*: positive normal numbers. *Accuracy*: 4 ulp of the larger of it and 1 − z.
#[inline(always)]
pub(crate) fn log_part<R: Real, V>(z: V, [octaves, nearest]: [V; 2], repeat: impl Fn(R) -> V) -> V
where
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<Output = V> + Div<Output = V>,
{
    // ln(z/2ᵏ) = 2 atanh f; the difference is exact.
    let f = (z - nearest) / (z + nearest);
    octaves * repeat(R::from_f64(core::f64::consts::LN_2)) + f * twice_atanh(f * f, repeat)
}
