//! The scalar of the kernel, with all elementary functions that the kernel uses.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

pub(crate) use sealed::{InEach, STEPS, Sealed};

mod sealed {
    /// Cells of m, each about a multiple of 1/32; one begins a 64th below 1.
    pub const STEPS: usize = 32;
    /// Binary digits of the number of a cell.
    pub const STEP_BITS: u32 = STEPS.trailing_zeros();

    /// A number 2^e m as a table of powers needs it.
    #[derive(Clone, Copy, Debug)]
    pub struct Split<R> {
        /// e; negative ones wrap.
        pub exponent: usize,
        /// Cell of m.
        pub cell: usize,
        /// The upper digits of m, which is at most a 64th below 1.
        pub head: R,
        /// The lower digits of m.
        pub tail: R,
    }

    /// What is done alike in `f32` and in `f64`, with data that differ in more than their precision.
    pub trait InEach {
        type Input<R: super::Real>;
        type Output<R: super::Real>;
        fn single(given: Self::Input<f32>) -> Self::Output<f32>;
        fn double(given: Self::Input<f64>) -> Self::Output<f64>;
    }

    /// What only the kernel needs of a precision.
    pub trait Sealed: Sized + 'static + crate::lanes::Laned {
        /// The one of both that is done in this precision.
        fn in_own<E: InEach>(given: E::Input<Self>) -> E::Output<Self>
        where
            Self: super::Real;

        /// True for `f32`: what it does not need is left out of a program.
        const IS_SINGLE: bool;

        /// The one of two tables that is in this precision, without a conversion: processors with
        /// single precision alone convert in software.
        fn pick<const COLUMNS: usize, const ROWS: usize>(
            single: &'static [[f32; COLUMNS]; ROWS],
            double: &'static [[f64; COLUMNS]; ROWS],
        ) -> &'static [[Self; COLUMNS]; ROWS];

        /// The whole number k for which `self` 2⁻ᵏ is nearest to `other`, by a factor of 1.51 at most.
        ///
        /// *Domain*: positive normal numbers; k ends at ±[`Sealed::MOST_OCTAVES`].
        fn octaves_above(self, other: Self) -> i32;

        /// 2ᵏ, exact. *Domain*: |k| ≤ [`Sealed::MOST_OCTAVES`].
        fn power_of_two(k: i32) -> Self;

        /// Octaves on both sides of 1 that are safely in range.
        const MOST_OCTAVES: i32;

        /// Speeds between this one and its reciprocal are ordinary: their squares, quotients and
        /// reciprocals are normal numbers.
        const LEAST_SPEED: Self;

        /// Exponent and mantissa for a table of powers; an exponent beyond all tables for numbers
        /// that are not positive and normal.
        fn split(self) -> Split<Self>;

        /// True from the smallest normal number up to the largest one: one comparison of bits.
        fn normal_and_positive(self) -> bool;

        /// The least number with this count of half octaves, see [`super::Real::half_octave`].
        fn of_half_octave(count: usize) -> Self;
    }

    /// The two functions of a binary format's exponent.
    macro_rules! octaves {
        ($real:ty, $bits:ty, $signed:ty, $mantissa:expr, $most:expr, $least_speed:expr) => {
            const MOST_OCTAVES: i32 = $most;
            const LEAST_SPEED: Self = $least_speed;
            #[inline]
            fn octaves_above(self, other: Self) -> i32 {
                // The bits of a positive number are its logarithm, but for 0.09 octaves.
                let apart = (self.to_bits() as $signed).wrapping_sub(other.to_bits() as $signed);
                let octaves = apart.wrapping_add(1 << ($mantissa - 1)) >> $mantissa;
                if octaves > $most {
                    $most
                } else if octaves < -$most {
                    -$most
                } else {
                    octaves as i32
                }
            }
            #[inline]
            fn power_of_two(k: i32) -> Self {
                const BIAS: i32 = <$real>::MAX_EXP - 1;
                Self::from_bits(((BIAS.wrapping_add(k)) as $bits) << $mantissa)
            }
            #[inline]
            fn normal_and_positive(self) -> bool {
                const LEAST: $bits = <$real>::MIN_POSITIVE.to_bits();
                self.to_bits().wrapping_sub(LEAST) < <$real>::INFINITY.to_bits() - LEAST
            }
            #[inline]
            fn of_half_octave(count: usize) -> Self {
                Self::from_bits((count as $bits) << ($mantissa - 1))
            }
            #[inline]
            fn split(self) -> Split<Self> {
                const BIAS: $bits = (<$real>::MAX_EXP - 1) as $bits;
                const HALF_CELL: $bits = 1 << ($mantissa - STEP_BITS - 1);
                /// The upper half of the digits.
                const FRONT: $bits = <$bits>::MAX << (($mantissa + 2) / 2);
                let bits = self.to_bits();
                let raised = bits.wrapping_add(HALF_CELL);
                let exponent = (raised >> $mantissa).wrapping_sub(BIAS);
                let mantissa = bits.wrapping_sub(exponent << $mantissa);
                let head = Self::from_bits(mantissa & FRONT);
                Split {
                    exponent: exponent as $signed as usize,
                    cell: (raised >> ($mantissa - STEP_BITS)) as usize % STEPS,
                    head,
                    tail: Self::from_bits(mantissa) - head,
                }
            }
        };
    }

    impl Sealed for f32 {
        octaves!(f32, u32, i32, super::MANTISSA_F32, 120, 1e-15);
        const IS_SINGLE: bool = true;
        #[inline(always)]
        fn in_own<E: InEach>(given: E::Input<f32>) -> E::Output<f32> {
            E::single(given)
        }
        #[inline]
        fn pick<const COLUMNS: usize, const ROWS: usize>(
            single: &'static [[f32; COLUMNS]; ROWS],
            _: &'static [[f64; COLUMNS]; ROWS],
        ) -> &'static [[f32; COLUMNS]; ROWS] {
            single
        }
    }
    impl Sealed for f64 {
        octaves!(f64, u64, i64, super::MANTISSA_F64, 1000, 1e-140);
        const IS_SINGLE: bool = false;
        #[inline(always)]
        fn in_own<E: InEach>(given: E::Input<f64>) -> E::Output<f64> {
            E::double(given)
        }
        #[inline]
        fn pick<const COLUMNS: usize, const ROWS: usize>(
            _: &'static [[f32; COLUMNS]; ROWS],
            double: &'static [[f64; COLUMNS]; ROWS],
        ) -> &'static [[f64; COLUMNS]; ROWS] {
            double
        }
    }
}

/// A table rounded to single precision.
pub(crate) const fn to_single<const COLUMNS: usize, const ROWS: usize>(
    table: &[[f64; COLUMNS]; ROWS],
) -> [[f32; COLUMNS]; ROWS] {
    let mut single = [[0.0; COLUMNS]; ROWS];
    let mut row = 0;
    while row < ROWS {
        let mut column = 0;
        while column < COLUMNS {
            single[row][column] = table[row][column] as f32;
            column += 1;
        }
        row += 1;
    }
    single
}

/// A binary floating-point number: `f32` or `f64`.
///
/// Elementary functions always come from the `libm` crate, so that a result has the same
/// bits on every supported platform, whatever features other crates of the build switch on.
/// Only square roots are instructions where the processor has one (`libm`'s feature `arch`,
/// `tribos-sqrt`): these round correctly, as the code in software does.
/// The kernel never contracts a product and a sum into one rounding.
///
/// ```
/// use tribos_core::Real;
/// /// Distance in m in which dry friction stops a body.
/// fn stopping_distance<R: Real>(speed: R, mu: R) -> R {
///     let gravity = R::from_f64(10.0); // m/s^2, roughly
///     speed * speed * R::HALF / (mu * gravity)
/// }
/// assert_eq!(stopping_distance(2.0_f32, 0.25), 0.8);
/// assert_eq!(stopping_distance(2.0_f64, 0.25), 0.8);
/// assert_eq!(Real::hypot(3e300_f64, 4e300), 5e300); // whose square is no number
/// ```
pub trait Real:
    Copy
    + PartialOrd
    + Debug
    + Default
    + nalgebra::Scalar
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + Send
    + Sync
    + sealed::Sealed
{
    /// 0
    const ZERO: Self;
    /// 1/2
    const HALF: Self;
    /// 1
    const ONE: Self;
    /// 2
    const TWO: Self;
    /// π, rounded to the type.
    const PI: Self;
    /// Gap between 1 and the next larger number.
    const EPSILON: Self;
    /// Smallest normal number.
    const MIN_POSITIVE: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// Not a number.
    const NAN: Self;
    /// Exponent and first mantissa bit of 1, as [`Real::half_octave`] counts them.
    const HALF_OCTAVE_OF_ONE: usize;

    /// The number of this type nearest to `value`.
    fn from_f64(value: f64) -> Self;
    /// This number as `f64`, exact.
    fn to_f64(self) -> f64;
    /// Absolute value; NaN stays NaN.
    fn abs(self) -> Self;
    /// Magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// Square root, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self;
    /// `self` to the power `exponent`, within one unit in the last place.
    fn pow(self, exponent: Self) -> Self;
    /// e to the power `self`, within one unit in the last place.
    fn exp(self) -> Self;
    /// e to the power `self`, minus one, within one unit in the last place also near zero.
    fn exp_m1(self) -> Self;
    /// Natural logarithm, within one unit in the last place; NaN below zero.
    fn ln(self) -> Self;
    /// Natural logarithm of 1 + `self`, within one unit in the last place also near zero.
    fn ln_1p(self) -> Self;
    /// Sine of an angle in radians, within one unit in the last place.
    fn sin(self) -> Self;
    /// Cosine of an angle in radians, within one unit in the last place.
    fn cos(self) -> Self;
    /// Arc sine in radians, within one unit in the last place; NaN beyond ±1.
    fn asin(self) -> Self;
    /// Arc tangent in radians, within one unit in the last place.
    fn atan(self) -> Self;
    /// Inverse hyperbolic sine, within two units in the last place.
    fn asinh(self) -> Self;
    /// True unless infinite or NaN.
    fn is_finite(self) -> bool;
    /// True for NaN.
    fn is_nan(self) -> bool;
    /// Number of half octaves from the smallest number up to `self` ≥ 0: each interval
    /// [2ᵏ, 1.5·2ᵏ) and [1.5·2ᵏ, 2ᵏ⁺¹) has its own count. No logarithm is taken.
    fn half_octave(self) -> usize;

    /// Length of the vector (`self`, `other`) without overflow or underflow on the way.
    ///
    /// *Accuracy*: 2 ulp. *Special values*: NaN if either is NaN; infinite if either is infinite
    /// and none is NaN.
    #[inline]
    fn hypot(self, other: Self) -> Self {
        let (a, b) = (self.abs(), other.abs());
        let (large, small) = if a > b { (a, b) } else { (b, a) };
        if large == Self::ZERO || large == Self::INFINITY {
            // `+ small` keeps a NaN.
            return large + small;
        }
        let ratio = small / large;
        large * (Self::ONE + ratio * ratio).sqrt()
    }
}

macro_rules! impl_real {
    ($real:ty, $mantissa:expr, $($name:ident($($argument:ident),*) = $function:path;)*) => {
        impl Real for $real {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const PI: Self = core::f64::consts::PI as $real;
            const EPSILON: Self = <$real>::EPSILON;
            const MIN_POSITIVE: Self = <$real>::MIN_POSITIVE;
            const INFINITY: Self = <$real>::INFINITY;
            const NAN: Self = <$real>::NAN;
            const HALF_OCTAVE_OF_ONE: usize =
                ((1.0 as $real).to_bits() >> ($mantissa - 1)) as usize;

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $real
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
            $(
                #[inline]
                fn $name(self $(, $argument: Self)*) -> Self {
                    $function(self $(, $argument)*)
                }
            )*
            #[inline]
            fn is_nan(self) -> bool {
                <$real>::is_nan(self)
            }
            #[inline]
            fn is_finite(self) -> bool {
                <$real>::is_finite(self)
            }
            #[inline]
            fn half_octave(self) -> usize {
                (self.to_bits() >> ($mantissa - 1)) as usize
            }
        }
    };
}

/// Stored mantissa bits of the two types.
const MANTISSA_F32: u32 = f32::MANTISSA_DIGITS - 1;
const MANTISSA_F64: u32 = f64::MANTISSA_DIGITS - 1;

impl_real! {
    f32, MANTISSA_F32,
    abs() = libm::fabsf;
    copysign(sign) = libm::copysignf;
    sqrt() = tribos_sqrt::sqrtf;
    pow(exponent) = libm::powf;
    exp() = libm::expf;
    exp_m1() = libm::expm1f;
    ln() = libm::logf;
    ln_1p() = libm::log1pf;
    sin() = libm::sinf;
    cos() = libm::cosf;
    asin() = libm::asinf;
    atan() = libm::atanf;
    asinh() = libm::asinhf;
}
impl_real! {
    f64, MANTISSA_F64,
    abs() = libm::fabs;
    copysign(sign) = libm::copysign;
    sqrt() = tribos_sqrt::sqrt;
    pow(exponent) = libm::pow;
    exp() = libm::exp;
    exp_m1() = libm::expm1;
    ln() = libm::log;
    ln_1p() = libm::log1p;
    sin() = libm::sin;
    cos() = libm::cos;
    asin() = libm::asin;
    atan() = libm::atan;
    asinh() = libm::asinh;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hypot_survives_the_ends_of_the_range() {
        let hypot = <f64 as Real>::hypot;
        assert_eq!(hypot(3e300, 4e300), 5e300);
        assert_eq!(hypot(-3e-320, 4e-320), 5e-320);
        assert_eq!(hypot(0.0, 0.0), 0.0);
        assert_eq!(hypot(f64::INFINITY, 1.0), f64::INFINITY);
        assert!(hypot(f64::NAN, f64::INFINITY).is_nan());
        assert!(<f32 as Real>::hypot(0.0, f32::NAN).is_nan());
    }

    #[test]
    fn half_octaves_count_without_gaps() {
        assert_eq!(1.0_f64.half_octave(), f64::HALF_OCTAVE_OF_ONE);
        assert_eq!(0.99_f64.half_octave() + 1, f64::HALF_OCTAVE_OF_ONE);
        assert_eq!(0.74_f32.half_octave() + 2, f32::HALF_OCTAVE_OF_ONE);
        assert_eq!(0.0_f32.half_octave(), 0);
    }
}
