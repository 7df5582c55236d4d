//! Targets without vectors whose roots and quotients round as the scalar ones do.

use super::{Numbers, Summed};
use core::array::from_fn;
use core::ops::{Add, Mul};

/// A precision; here without lanes.
pub trait Laned: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// A number of a body that is written once for numbers alone and side by side.
    type Alone: Numbers<Real = Self, Array = [Self; 1], Mask = bool>;
    /// As many of them as go side by side; here one.
    type SideBySide: Numbers<Real = Self>;
    /// As many as are summed side by side; here one.
    type Several: Summed<Real = Self>;

    /// The sum of aₙ uⁿ and that of bₙ uⁿ.
    #[inline]
    fn sums<const TERMS: usize>(pairs: &[[Self; 2]; TERMS], u: Self) -> [Self; 2] {
        side_by_side(pairs, u)
    }

    /// The same of four sums.
    #[inline]
    fn four_sums<const TERMS: usize>(terms: &[[Self; 4]; TERMS], u: Self) -> [Self; 4] {
        side_by_side(terms, u)
    }
}

/// Sums with even and odd powers apart, as vectors compute them. Row by row: by columns a check of bounds stays.
#[inline]
fn side_by_side<R, const SUMS: usize, const TERMS: usize>(
    terms: &[[R; SUMS]; TERMS],
    u: R,
) -> [R; SUMS]
where
    R: Copy + Add<Output = R> + Mul<Output = R>,
{
    let square = u * u;
    let mut sums = [terms[TERMS - 1], terms[TERMS - 2]];
    for n in (1..TERMS - 2).rev() {
        let sum = &mut sums[(TERMS - 1 - n) % 2];
        *sum = from_fn(|column| sum[column] * square + terms[n][column]);
    }
    // The sums end with the first and the second power.
    let [first, second] = if TERMS.is_multiple_of(2) {
        sums
    } else {
        [sums[1], sums[0]]
    };
    from_fn(|column| terms[0][column] + (first[column] * u + second[column] * square))
}

impl Laned for f32 {
    type Alone = f32;
    type SideBySide = f32;
    type Several = f32;
}
impl Laned for f64 {
    type Alone = f64;
    type SideBySide = f64;
    type Several = f64;
}
