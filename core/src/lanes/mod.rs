//! Numbers side by side: one function body for one of them, and for four or eight at once.
//!
//! It knows no physics and no other room: the scalar of the kernel, [`crate::real`], stands on it.

#[cfg_attr(
    not(any(
        target_feature = "sse2",
        all(target_arch = "aarch64", target_feature = "neon"),
        target_feature = "simd128"
    )),
    path = "alone.rs"
)]
mod vectors;

pub(crate) use vectors::Laned;
#[cfg(any(
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
))]
pub(crate) use vectors::{Eight, even_and_odd};

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Numbers in a group.
pub(crate) const GROUP: usize = 8;

/// One value for each number of a group.
pub(crate) type Group<T> = [T; GROUP];

/// A number, or several numbers side by side that are computed independently.
///
/// `f32` and `f64` are one lane; `wide::f32x4` and `wide::f32x8` are four and eight where the target
/// has vectors. An engine with vectors of its own implements it for them: its results have
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

/// Sums that are formed side by side.
pub(crate) const FOUR: usize = 4;

/// One number of a precision, or four side by side of which each has the bits of the one.
pub trait Numbers: Lanes {
    /// A lane.
    type Real: Copy;
    /// Lanes.
    const COUNT: usize;
    /// Four sums side by side.
    type Sums: Copy;

    /// The number `at(k)` in lane k.
    fn of(at: impl FnMut(usize) -> Self::Real) -> Self;
    /// The same number in every lane.
    fn repeat(number: Self::Real) -> Self;
    /// Sums of nothing.
    fn none() -> Self::Sums;
    /// Adds to the sums, from the `first` one on.
    fn add_to(self, sums: &mut Self::Sums, first: usize);
    /// The sum of the sums.
    fn total(sums: &Self::Sums) -> Self::Real;
    /// The sum of aₙ uⁿ and that of bₙ uⁿ, of the pairs (aₙ, bₙ) that are in its precision.
    fn sums<const SINGLE: usize, const DOUBLE: usize>(
        single: &[[f32; 2]; SINGLE],
        double: &[[f64; 2]; DOUBLE],
        u: Self,
    ) -> [Self; 2];
    /// m from √½ to √2, and k, with 2ᵏ m = `self`. *Domain*: positive normal numbers.
    fn octaves(self) -> [Self; 2];
}

/// The bits of a binary format that take a number apart.
pub(crate) mod f64_bits {
    pub(crate) const DIGITS: u32 = f64::MANTISSA_DIGITS - 1;
    pub(crate) const HALF_ROOT: u64 = core::f64::consts::FRAC_1_SQRT_2.to_bits();
    pub(crate) const SIGN: u64 = (-0.0_f64).to_bits();
    /// The number whose last digit counts 1, and what an exponent of 0 adds to it.
    pub(crate) const WHOLE: f64 = (1_u64 << DIGITS) as f64;
    pub(crate) const ZERO: f64 = WHOLE + (SIGN >> DIGITS) as f64;
}

/// [`f64_bits`] of single precision.
pub(crate) mod f32_bits {
    pub(crate) const DIGITS: u32 = f32::MANTISSA_DIGITS - 1;
    pub(crate) const HALF_ROOT: u32 = core::f32::consts::FRAC_1_SQRT_2.to_bits();
    pub(crate) const SIGN: u32 = (-0.0_f32).to_bits();
    pub(crate) const WHOLE: f32 = (1_u32 << DIGITS) as f32;
    pub(crate) const ZERO: f32 = WHOLE + (SIGN >> DIGITS) as f32;
}

macro_rules! one_number {
    ($real:ident, $bits:ident, |$single:ident, $double:ident| $own:expr) => {
        impl Numbers for $real {
            type Real = Self;
            const COUNT: usize = 1;
            type Sums = [Self; FOUR];

            #[inline(always)]
            fn of(mut at: impl FnMut(usize) -> Self) -> Self {
                at(0)
            }
            #[inline(always)]
            fn repeat(number: Self) -> Self {
                number
            }
            #[inline(always)]
            fn none() -> [Self; FOUR] {
                [0.0; FOUR]
            }
            #[inline(always)]
            fn add_to(self, sums: &mut [Self; FOUR], first: usize) {
                if let Some(sum) = sums.get_mut(first) {
                    *sum += self;
                }
            }
            #[inline(always)]
            fn total([a, b, c, d]: &[Self; FOUR]) -> Self {
                (a + b) + (c + d)
            }
            #[inline(always)]
            fn sums<const SINGLE: usize, const DOUBLE: usize>(
                $single: &[[f32; 2]; SINGLE],
                $double: &[[f64; 2]; DOUBLE],
                u: Self,
            ) -> [Self; 2] {
                Laned::sums($own, u)
            }
            #[inline(always)]
            fn octaves(self) -> [Self; 2] {
                use $bits::{DIGITS, HALF_ROOT, SIGN, WHOLE, ZERO};
                let bits = self.to_bits();
                // Exponents from the middle of the range on are no negative numbers.
                let octaves = bits.wrapping_add(SIGN.wrapping_sub(HALF_ROOT)) >> DIGITS;
                let mantissa = bits.wrapping_sub(octaves << DIGITS).wrapping_add(SIGN);
                let count = Self::from_bits(octaves | WHOLE.to_bits()) - ZERO;
                [Self::from_bits(mantissa), count]
            }
        }
    };
}
one_number!(f32, f32_bits, |single, _double| single);
one_number!(f64, f64_bits, |_single, double| double);

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
one_lane!(f64, libm::sqrt, libm::fabs);
