//! Targets without vectors whose roots and quotients round as the scalar ones do.

use super::Numbers;
use core::ops::{Add, Mul};

/// A precision; here without lanes.
pub trait Laned: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// Its numbers one by one.
    type Several: Numbers<Real = Self>;

    /// The sum of aₙ uⁿ and that of bₙ uⁿ, even and odd powers apart, on pairs.
    #[inline]
    fn sums<const TERMS: usize>(pairs: &[[Self; 2]; TERMS], u: Self) -> [Self; 2] {
        let square = u * u;
        let mut sums = [pairs[TERMS - 1], pairs[TERMS - 2]];
        for n in (1..TERMS - 2).rev() {
            let sum = &mut sums[(TERMS - 1 - n) % 2];
            sum[0] = sum[0] * square + pairs[n][0];
            sum[1] = sum[1] * square + pairs[n][1];
        }
        // The sums end with the first and the second power.
        let [first, second] = if TERMS.is_multiple_of(2) {
            sums
        } else {
            [sums[1], sums[0]]
        };
        let [a, b] = pairs[0];
        [
            a + (first[0] * u + second[0] * square),
            b + (first[1] * u + second[1] * square),
        ]
    }
}

impl Laned for f32 {
    type Several = Self;
}
impl Laned for f64 {
    type Several = Self;
}
