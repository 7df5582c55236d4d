//! Numbers of one precision, alone or side by side, for a body that is written once for both.

use super::{Laned, Lanes};

/// Sums that are formed side by side.
pub(crate) const FOUR: usize = 4;

/// One number or several of them, with what a search asks of them.
///
/// Every operation rounds as that of a number alone does, so that a lane's bits do not depend on the others.
pub trait Numbers: Lanes {
    /// A lane.
    type Real: Copy;
    /// One number for each lane.
    type Array: Copy + AsRef<[Self::Real]> + AsMut<[Self::Real]>;

    fn new(numbers: Self::Array) -> Self;
    fn to_array(self) -> Self::Array;
    /// The same number in every lane.
    fn repeat(number: Self::Real) -> Self;
    /// A constant, rounded to the precision.
    fn constant(number: f64) -> Self;
    /// This size ≥ 0 with the sign of `other`.
    fn with_sign(self, other: Self) -> Self;
    /// k and 2ᵏ next to a normal number, by a factor of 1.5 at most.
    fn octaves(self) -> [Self; 2];

    fn both(one: Self::Mask, other: Self::Mask) -> Self::Mask;
    fn either(one: Self::Mask, other: Self::Mask) -> Self::Mask;
    fn not(mask: Self::Mask) -> Self::Mask;
    /// True if the mask is true in a lane.
    fn any(mask: Self::Mask) -> bool;

    /// True where the number lies between two others or is one of them.
    #[inline(always)]
    fn is_within(self, low: Self, high: Self) -> Self::Mask {
        Self::both(low.at_most(self), self.at_most(high))
    }
}

/// One number, or four, for sums that have the same bits either way.
pub trait Summed: Numbers {
    /// Lanes.
    const COUNT: usize;
    /// Four sums side by side.
    type Sums: Copy;

    /// The number `at(k)` in lane k.
    fn of(at: impl FnMut(usize) -> Self::Real) -> Self;
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
}

/// Stored digits, bias of the exponent, and the number whose last digit counts 1.
macro_rules! format {
    (f32) => {
        (f32::MANTISSA_DIGITS - 1, 127, 8_388_608.0_f32)
    };
    (f64) => {
        (f64::MANTISSA_DIGITS - 1, 1023, 4_503_599_627_370_496.0_f64)
    };
}

macro_rules! alone {
    ($real:ident, $bits:ty, $copysign:path, |$single:ident, $double:ident| $own:expr) => {
        impl Summed for $real {
            const COUNT: usize = 1;
            type Sums = [$real; FOUR];

            #[inline(always)]
            fn of(mut at: impl FnMut(usize) -> $real) -> Self {
                at(0)
            }
            #[inline(always)]
            fn none() -> [$real; FOUR] {
                [0.0; FOUR]
            }
            #[inline(always)]
            fn add_to(self, sums: &mut [$real; FOUR], first: usize) {
                if let Some(sum) = sums.get_mut(first) {
                    *sum += self;
                }
            }
            #[inline(always)]
            fn total([a, b, c, d]: &[$real; FOUR]) -> $real {
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
        }

        impl Numbers for $real {
            type Real = $real;
            type Array = [$real; 1];

            #[inline(always)]
            fn new([number]: [$real; 1]) -> Self {
                number
            }
            #[inline(always)]
            fn to_array(self) -> [$real; 1] {
                [self]
            }
            #[inline(always)]
            fn repeat(number: $real) -> Self {
                number
            }
            #[inline(always)]
            fn constant(number: f64) -> Self {
                number as $real
            }
            #[inline(always)]
            fn with_sign(self, other: Self) -> Self {
                $copysign(self, other)
            }
            #[inline(always)]
            fn octaves(self) -> [Self; 2] {
                const DIGITS: u32 = format!($real).0;
                let raised = self.to_bits().wrapping_add(1 << (DIGITS - 1)) >> DIGITS;
                let (_, bias, unit) = format!($real);
                let count = <$real>::from_bits(unit.to_bits() | raised) - (unit + bias as $real);
                [count, <$real>::from_bits(raised << DIGITS)]
            }
            #[inline(always)]
            fn both(one: bool, other: bool) -> bool {
                one & other
            }
            #[inline(always)]
            fn either(one: bool, other: bool) -> bool {
                one | other
            }
            #[inline(always)]
            fn not(mask: bool) -> bool {
                !mask
            }
            #[inline(always)]
            fn any(mask: bool) -> bool {
                mask
            }
        }
    };
}
alone!(f32, u32, libm::copysignf, |single, _double| single);
alone!(f64, u64, libm::copysign, |_single, double| double);

#[cfg(any(
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
))]
mod side_by_side {
    use super::{FOUR, Numbers, Summed};
    use crate::lanes::even_and_odd;
    use core::ops::{Add, Mul};
    use wide::{bytemuck, f32x4, f32x8, f64x4, f64x8, u32x4, u32x8, u64x4, u64x8};

    macro_rules! side_by_side {
        ($lanes:ty, $real:ident, $count:literal, $integers:ty) => {
            impl Numbers for $lanes {
                type Real = $real;
                type Array = [$real; $count];

                #[inline(always)]
                fn new(numbers: [$real; $count]) -> Self {
                    <$lanes>::new(numbers)
                }
                #[inline(always)]
                fn to_array(self) -> [$real; $count] {
                    self.to_array()
                }
                #[inline(always)]
                fn repeat(number: $real) -> Self {
                    <$lanes>::splat(number)
                }
                #[inline(always)]
                fn constant(number: f64) -> Self {
                    <$lanes>::splat(number as $real)
                }
                #[inline(always)]
                fn with_sign(self, other: Self) -> Self {
                    self | (other & <$lanes>::splat(-0.0))
                }
                #[inline(always)]
                fn octaves(self) -> [Self; 2] {
                    const DIGITS: u32 = format!($real).0;
                    let bits: $integers = bytemuck::cast(self);
                    let raised = (bits + <$integers>::splat(1 << (DIGITS - 1))) >> DIGITS;
                    let (_, bias, unit) = format!($real);
                    let counted = raised | <$integers>::splat(unit.to_bits());
                    let counted: $lanes = bytemuck::cast(counted);
                    let count = counted - <$lanes>::splat(unit + bias as $real);
                    [count, bytemuck::cast(raised << DIGITS)]
                }
                #[inline(always)]
                fn both(one: Self, other: Self) -> Self {
                    one & other
                }
                #[inline(always)]
                fn either(one: Self, other: Self) -> Self {
                    one | other
                }
                #[inline(always)]
                fn not(mask: Self) -> Self {
                    !mask
                }
                #[inline(always)]
                fn any(mask: Self) -> bool {
                    mask.any()
                }
            }
        };
    }
    side_by_side!(f64x4, f64, 4, u64x4);
    side_by_side!(f64x8, f64, 8, u64x8);
    side_by_side!(f32x4, f32, 4, u32x4);
    side_by_side!(f32x8, f32, 8, u32x8);

    macro_rules! four {
        ($lanes:ty, $real:ty, |$single:ident, $double:ident| $own:expr) => {
            impl Summed for $lanes {
                const COUNT: usize = FOUR;
                type Sums = Self;

                #[inline(always)]
                fn of(mut at: impl FnMut(usize) -> $real) -> Self {
                    <$lanes>::new([at(0), at(1), at(2), at(3)])
                }
                #[inline(always)]
                fn none() -> Self {
                    Self::splat(0.0)
                }
                #[inline(always)]
                fn add_to(self, sums: &mut Self, _: usize) {
                    *sums += self;
                }
                #[inline(always)]
                fn total(sums: &Self) -> $real {
                    <$real>::total(&sums.to_array())
                }
                #[inline(always)]
                fn sums<const SINGLE: usize, const DOUBLE: usize>(
                    $single: &[[f32; 2]; SINGLE],
                    $double: &[[f64; 2]; DOUBLE],
                    u: Self,
                ) -> [Self; 2] {
                    of_each($own, Self::splat, u)
                }
            }
        };
    }
    four!(f64x4, f64, |_single, double| double);
    four!(f32x4, f32, |single, _double| single);

    /// The sums of both functions of the pairs.
    #[inline(always)]
    fn of_each<R: Copy, V, const TERMS: usize>(
        pairs: &[[R; 2]; TERMS],
        splat: impl Fn(R) -> V,
        u: V,
    ) -> [V; 2]
    where
        V: Copy + Add<Output = V> + Mul<Output = V>,
    {
        [
            even_and_odd::<_, TERMS>(|n| splat(pairs[n][0]), u),
            even_and_odd::<_, TERMS>(|n| splat(pairs[n][1]), u),
        ]
    }
}
