//! Numbers of one precision, alone or side by side, for a body that is written once for both.

use super::Lanes;

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
    fn each(number: Self::Real) -> Self;
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
    ($real:ident, $bits:ty, $copysign:path) => {
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
            fn each(number: $real) -> Self {
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
alone!(f32, u32, libm::copysignf);
alone!(f64, u64, libm::copysign);

#[cfg(any(
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
))]
mod side_by_side {
    use super::Numbers;
    use wide::{bytemuck, f32x8, f64x4, u32x8, u64x4};

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
                fn each(number: $real) -> Self {
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
    side_by_side!(f32x8, f32, 8, u32x8);
}
