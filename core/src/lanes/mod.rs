//! Numbers side by side: one function body for one of them, and for four or eight at once.
//!
//! It knows no physics and no other room: the scalar of the kernel, [`crate::real`], stands on it.

mod numbers;
#[cfg_attr(
    not(any(
        target_feature = "sse2",
        all(target_arch = "aarch64", target_feature = "neon"),
        target_feature = "simd128"
    )),
    path = "alone.rs"
)]
mod vectors;

pub(crate) use numbers::{FOUR, Numbers, Summed};
#[cfg(any(
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
))]
pub(crate) use vectors::Eight;
pub(crate) use vectors::Laned;

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Numbers in a group.
pub(crate) const GROUP: usize = 8;

/// One value for each number of a group.
pub(crate) type Group<T> = [T; GROUP];

/// Σ term(n) uⁿ, even and odd powers apart.
#[inline(always)]
pub(crate) fn even_and_odd<V: Copy + Add<Output = V> + Mul<Output = V>, const TERMS: usize>(
    term: impl Fn(usize) -> V,
    u: V,
) -> V {
    let square = u * u;
    let mut sums = [term(TERMS - 1), term(TERMS - 2)];
    for n in (1..TERMS - 2).rev() {
        let sum = &mut sums[(TERMS - 1 - n) % 2];
        *sum = *sum * square + term(n);
    }
    let [first, second] = if TERMS.is_multiple_of(2) {
        sums
    } else {
        [sums[1], sums[0]]
    };
    term(0) + (first * u + second * square)
}

/// A number, or several numbers side by side that are computed independently.
///
/// `f32` and `f64` are one lane; `wide::f32x4` and `wide::f64x4` are four, `wide::f32x8` and `wide::f64x8` eight, where
/// the target has vectors. An engine with vectors of its own implements it for them: its results have
/// the bits of the scalar ones if its operations round to nearest and are not contracted.
///
/// Comparisons with NaN are false.
pub trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One truth value a lane.
    type Mask: Copy;

    /// The same number in every lane.
    fn splat(value: f32) -> Self;
    /// Square root, rounded to nearest.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// `self` < `other`.
    fn below(self, other: Self) -> Self::Mask;
    /// `self` ≤ `other`.
    fn at_most(self, other: Self) -> Self::Mask;
    /// `yes` where the mask is true, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// True if the mask is true in every lane.
    fn all(mask: Self::Mask) -> bool;

    /// The smaller number; `self` if either is NaN.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self::select(other.below(self), other, self)
    }

    /// The larger number; `self` if either is NaN.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::select(self.below(other), other, self)
    }

    /// This magnitude with the sign of `other`, which counts as positive if it is zero.
    #[inline(always)]
    fn signed_as(self, other: Self) -> Self {
        Self::select(other.below(Self::splat(0.0)), -self, self)
    }
}

macro_rules! one_lane {
    ($real:ty, $sqrt:path, $abs:path) => {
        impl Lanes for $real {
            type Mask = bool;

            #[inline(always)]
            fn splat(value: f32) -> Self {
                <$real>::from(value)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $abs(self)
            }
            #[inline(always)]
            fn below(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn at_most(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline(always)]
            fn all(mask: bool) -> bool {
                mask
            }
        }
    };
}
one_lane!(f32, tribos_sqrt::sqrtf, libm::fabsf);
one_lane!(f64, tribos_sqrt::sqrt, libm::fabs);
