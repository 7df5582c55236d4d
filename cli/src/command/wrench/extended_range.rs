//! Products of numbers that need not be numbers of the type on the way.

use tribos_core::Real;

/// mantissa · 2^exponent with 1 ≤ |mantissa| < 2; zero, infinity and NaN are their own mantissa.
#[derive(Clone, Copy, Debug)]
pub struct ExtendedRange {
    mantissa: f64,
    exponent: i64,
}

/// Stored mantissa bits and the exponent bias of an f64.
const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
const BIAS: i64 = 1023;
/// Raises subnormal numbers to normal ones.
const LIFT: i64 = 64;

/// 2^`exponent`, in two factors where it is no normal number itself.
fn scaled(x: f64, exponent: i64) -> f64 {
    let power = |exponent: i64| f64::from_bits(((BIAS + exponent) as u64) << MANTISSA);
    match exponent {
        ..-1100 => 0.0 * x,
        // The first factor leaves a normal number, so that only the second product rounds.
        -1100..-1022 => x * power(-1000) * power(exponent + 1000),
        -1022..=1023 => x * power(exponent),
        _ => f64::INFINITY.copysign(x),
    }
}

impl ExtendedRange {
    pub const ONE: Self = Self {
        mantissa: 1.0,
        exponent: 0,
    };

    pub fn new(x: f64) -> Self {
        if x == 0.0 || !x.is_finite() {
            return Self {
                mantissa: x,
                exponent: 0,
            };
        }
        let (x, lifted) = if x.abs() < f64::MIN_POSITIVE {
            (scaled(x, LIFT), LIFT)
        } else {
            (x, 0)
        };
        let own = ((x.abs().to_bits() >> MANTISSA) as i64) - BIAS;
        Self {
            // In two factors, since 2^-1023 is subnormal.
            mantissa: scaled(scaled(x, -(own / 2)), own / 2 - own),
            exponent: own - lifted,
        }
    }

    /// 2^(`times` `exponent`), to a few ulp however large the product is.
    pub fn power_of_two(times: i64, exponent: f64) -> Self {
        // The product with 24 digits of the exponent is exact.
        let coarse = f64::from(exponent as f32);
        let product = times as f64 * coarse;
        let whole = product.floor();
        let rest = (product - whole) + times as f64 * (exponent - coarse);
        let fraction = Self::new(Real::pow(2.0, rest));
        fraction.shifted(whole as i64)
    }

    /// Times 2^`by`.
    pub fn shifted(self, by: i64) -> Self {
        Self {
            exponent: self.exponent + by,
            ..self
        }
    }

    pub fn times(self, other: Self) -> Self {
        Self::new(self.mantissa * other.mantissa).shifted(self.exponent + other.exponent)
    }

    pub fn is_zero(self) -> bool {
        self.mantissa == 0.0
    }

    /// The binary exponent of what is not zero.
    pub fn exponent(self) -> i64 {
        self.exponent
    }

    /// True if |self| > |other|.
    pub fn exceeds(self, other: Self) -> bool {
        if self.is_zero() || other.is_zero() {
            return !self.is_zero();
        }
        let key = |x: Self| (x.exponent, x.mantissa.abs());
        key(self) > key(other)
    }

    /// The nearest f64; infinite or zero beyond its ends.
    pub fn value(self) -> f64 {
        if self.is_zero() || !self.mantissa.is_finite() {
            return self.mantissa;
        }
        scaled(self.mantissa, self.exponent)
    }

    /// The nearest number of the type, and whether that is a normal one, or was zero or no number
    /// before.
    pub fn narrowed<R: Real>(self) -> (R, bool) {
        let narrow = R::from_f64(self.value());
        let was_none = self.is_zero() || !self.mantissa.is_finite();
        let is_normal = narrow.is_finite() && narrow.abs() >= R::MIN_POSITIVE;
        (narrow, was_none || is_normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_survives() {
        for x in [
            0.0,
            5e-324,
            1e-310,
            2.3e-308,
            0.3,
            1.0,
            1.5e308,
            f64::INFINITY,
        ] {
            assert_eq!(ExtendedRange::new(x).value(), x);
            assert_eq!(ExtendedRange::new(-x).value(), -x);
        }
    }

    #[test]
    fn products_come_back_from_beyond_the_range() {
        let product = |list: &[f64]| {
            let factors = list.iter().map(|&x| ExtendedRange::new(x));
            factors.fold(ExtendedRange::ONE, ExtendedRange::times)
        };
        let [small, large] = [-650, 650].map(|exponent| 2.0_f64.powi(exponent));
        assert_eq!(product(&[small, small, 3.0, large, large]).value(), 3.0);
        assert_eq!(product(&[1e200, 1e200]).value(), f64::INFINITY);
        assert_eq!(product(&[1e-200, 1e-200]).value(), 0.0);
        assert!(!product(&[1e-200, 1e-200]).narrowed::<f64>().1);
        assert!(product(&[1e-200, 1e-200, 0.0]).narrowed::<f64>().1);
        let power = ExtendedRange::power_of_two(1500, 1.0 / 3.0)
            .times(ExtendedRange::power_of_two(-1500, 0.3));
        assert!((power.value() / 2.0_f64.powi(50) - 1.0).abs() < 1e-14);
    }
}
