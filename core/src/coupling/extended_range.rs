//! Products in the number range whose factors are not.

use crate::real::Real;

/// mantissa · 2^exponent with 1 ≤ |mantissa| < 2; zero, infinity and NaN are their own mantissa.
///
/// Every operation rounds once, as it would in a type without ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct ExtendedRange<R> {
    mantissa: R,
    exponent: i32,
}

/// Raises subnormal numbers of either type to normal ones.
const LIFT: i32 = 64;
/// Exponent bias of an f64.
const BIAS_F64: i32 = 1023;
/// Stored mantissa bits of an f64.
const MANTISSA_F64: u32 = f64::MANTISSA_DIGITS - 1;

/// 2^`exponent`. *Domain*: the normal exponents of the type.
#[inline]
fn power_of_two<R: Real>(exponent: i32) -> R {
    R::from_f64(f64::from_bits(
        ((BIAS_F64 + exponent) as u64) << MANTISSA_F64,
    ))
}

/// The exponent of the largest numbers of the type; that of the smallest normal one is 1 less this.
#[inline]
fn bias<R: Real>() -> i32 {
    (R::HALF_OCTAVE_OF_ONE / 2) as i32
}

impl<R: Real> ExtendedRange<R> {
    pub fn new(x: R) -> Self {
        Self {
            mantissa: x,
            exponent: 0,
        }
        .normalized()
    }

    /// `base`^`exponent`. *Accuracy*: 1 ulp where the power is a normal number, 4 ulp beyond.
    pub fn power(base: R, exponent: R) -> Self {
        let whole = base.pow(exponent);
        if is_in_normal_range(whole) {
            return Self::new(whole);
        }
        // Dry friction's rates: one division.
        if exponent == -R::ONE {
            return Self::new(R::ONE).over(Self::new(base));
        }
        let half = base.pow(R::HALF * exponent);
        if is_in_normal_range(half) {
            return Self::new(half).times(Self::new(half));
        }
        // Where a quarter leaves the range too, no product with two speeds comes back.
        let quarter = Self::new(base.pow(R::HALF * R::HALF * exponent));
        let half = quarter.times(quarter);
        half.times(half)
    }

    fn normalized(self) -> Self {
        let Self {
            mut mantissa,
            mut exponent,
        } = self;
        if !self.is_number() {
            return self;
        }
        if mantissa.abs() < R::MIN_POSITIVE {
            mantissa *= power_of_two(LIFT);
            exponent -= LIFT;
        }
        let own = (mantissa.abs().half_octave() / 2) as i32 - bias::<R>();
        // In two parts, since 2^-own may be subnormal.
        let part = own / 2;
        Self {
            mantissa: mantissa * power_of_two(-part) * power_of_two(part - own),
            exponent: exponent + own,
        }
    }

    /// True unless zero, infinite or NaN.
    pub fn is_number(&self) -> bool {
        self.mantissa != R::ZERO && self.mantissa.is_finite()
    }

    pub fn times(self, other: Self) -> Self {
        Self {
            mantissa: self.mantissa * other.mantissa,
            exponent: self.exponent + other.exponent,
        }
        .normalized()
    }

    pub fn over(self, other: Self) -> Self {
        Self {
            mantissa: self.mantissa / other.mantissa,
            exponent: self.exponent - other.exponent,
        }
        .normalized()
    }

    pub fn plus(self, other: Self) -> Self {
        let (large, small) = if self.exponent >= other.exponent {
            (self, other)
        } else {
            (other, self)
        };
        if !(self.is_number() && other.is_number()) {
            // A zero adds nothing, whatever its exponent is; infinities and NaN absorb.
            return match [self.mantissa == R::ZERO, other.mantissa == R::ZERO] {
                [true, _] => other,
                [_, true] => self,
                _ => Self::new(self.mantissa + other.mantissa),
            };
        }
        let apart = large.exponent - small.exponent;
        if apart > LIFT {
            return large;
        }
        Self {
            mantissa: large.mantissa + small.mantissa * power_of_two(-apart),
            exponent: large.exponent,
        }
        .normalized()
    }

    /// The nearest number of the type; infinite or zero beyond its ends.
    pub fn value(self) -> R {
        let Self { mantissa, exponent } = self;
        let (lowest, highest) = (1 - bias::<R>(), bias::<R>());
        if !self.is_number() {
            mantissa
        } else if exponent > highest {
            R::INFINITY.copysign(mantissa)
        } else if exponent >= lowest {
            mantissa * power_of_two(exponent)
        } else if exponent >= lowest - LIFT {
            mantissa * R::MIN_POSITIVE * power_of_two(exponent - lowest)
        } else {
            R::ZERO.copysign(mantissa)
        }
    }
}

/// True if a product with `scale` can be formed at once.
#[inline]
pub(super) fn is_in_normal_range<R: Real>(scale: R) -> bool {
    scale.normal_and_positive()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn there_and_back<R: Real>(x: R) {
        let same = ExtendedRange::new(x).value();
        assert!(same == x || same.is_nan() && x.is_nan(), "{x:?} {same:?}");
    }

    #[test]
    fn every_number_survives() {
        for x in [
            0.0,
            5e-324,
            1e-310,
            2.5e-308,
            0.3,
            1.0,
            f64::MAX,
            f64::INFINITY,
            f64::NAN,
        ] {
            [x, -x].into_iter().for_each(there_and_back);
        }
        for x in [
            0.0,
            1e-45,
            1e-39,
            2e-38,
            0.3,
            1.0,
            f32::MAX,
            f32::INFINITY,
            f32::NAN,
        ] {
            [x, -x].into_iter().for_each(there_and_back);
        }
    }

    #[test]
    fn products_come_back_from_beyond_the_range() {
        let [tiny, huge] = [3e-300_f64, 7e300].map(ExtendedRange::new);
        assert_eq!(
            tiny.times(tiny).times(huge).over(tiny).value(),
            3e-300 * 7e300
        );
        assert_eq!(tiny.times(tiny).value(), 0.0);
        assert_eq!(huge.times(huge).value(), f64::INFINITY);
        // The quotient of the ends, and half of the smallest number, which rounds to even.
        let ends = ExtendedRange::new(5e-324).over(ExtendedRange::new(f64::MAX));
        assert_eq!(ends.times(ExtendedRange::new(f64::MAX)).value(), 5e-324);
        assert_eq!(
            ExtendedRange::new(5e-324)
                .times(ExtendedRange::new(0.5))
                .value(),
            0.0
        );
        assert_eq!(
            ExtendedRange::new(5e-324)
                .times(ExtendedRange::new(0.75))
                .value(),
            5e-324
        );
    }

    #[test]
    fn sums_keep_what_counts() {
        let sum = |a: f64, b: f64| ExtendedRange::new(a).plus(ExtendedRange::new(b)).value();
        for (a, b) in [
            (1e300, 3e-300),
            (0.1, 0.2),
            (0.0, 1e-320),
            (-1e10, 1e10),
            (3.0, -2.9),
        ] {
            assert_eq!(sum(a, b), a + b);
            assert_eq!(sum(b, a), a + b);
        }
        assert_eq!(sum(f64::INFINITY, -1e300), f64::INFINITY);
        assert!(sum(f64::NAN, 1.0).is_nan() && sum(f64::INFINITY, f64::NEG_INFINITY).is_nan());
    }

    #[test]
    fn powers_go_beyond_the_range() {
        let power = |base: f64, exponent: f64| ExtendedRange::power(base, exponent);
        let one = power(2.0, 3000.0).times(power(2.0, -3000.0));
        assert_eq!(one.value(), 1.0);
        // The fourth root 2^-749.875 is rounded, and its fourth power carries that four times.
        let root = power(2.0, 3000.0).times(power(2.0, -2999.5)).value();
        assert!((root / 2.0_f64.sqrt() - 1.0).abs() <= 4.0 * f64::EPSILON);
        assert_eq!(power(4.0, 0.5).value(), 2.0);
        // A reciprocal is rounded once, beyond the normal numbers too.
        for base in [f64::MAX, 5e-324, 3e-310] {
            let reciprocal = ExtendedRange::new(1.0).over(ExtendedRange::new(base));
            assert_eq!(power(base, -1.0).mantissa, reciprocal.mantissa);
            assert_eq!(power(base, -1.0).exponent, reciprocal.exponent);
        }
        assert_eq!(power(0.0, 2.0).value(), 0.0);
    }
}
