//! Reference values with more digits than an `f64`, and errors relative to them.

/// A number of a table, kept as an unevaluated sum `high + low` of two `f64` (about 32 digits).
///
/// In the subnormal range `low` is zero, and errors there are inaccurate by up to half a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// The nearest `f64`.
    pub high: f64,
    /// Remainder that `high` leaves out.
    pub low: f64,
}

/// Significant digits of the integers that a decimal string and an `f64` are compared as: 32
/// digits of the longest table and room for one carry, below the 38 digits of an `i128`.
const DIGITS: usize = 36;

impl Reference {
    /// Reads a decimal; `None` unless it is a number, infinities included.
    pub fn parse(text: &str) -> Option<Self> {
        let high: f64 = text.trim().parse().ok()?;
        if high == 0.0 || !high.is_finite() {
            return Some(Self { high, low: 0.0 });
        }
        let (wanted, wanted_exponent) = integer(text.trim())?;
        // Rust prints as many correct digits of a binary number as requested.
        let (rounded, rounded_exponent) = integer(&format!("{high:.*e}", DIGITS - 1))?;
        let exponent = wanted_exponent.min(rounded_exponent);
        let aligned = |n: i128, e: i32| n * 10_i128.pow((e - exponent) as u32);
        let rest = aligned(wanted, wanted_exponent) - aligned(rounded, rounded_exponent);
        let low = format!("{rest}e{exponent}").parse().ok()?;
        Some(Self { high, low })
    }

    /// A reference that is an exact `f64`.
    pub fn exact(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// |got − reference|; zero for equal infinities, infinite for NaN.
    pub fn distance(&self, got: f64) -> f64 {
        if got == self.high && !got.is_finite() {
            return 0.0;
        }
        let difference = ((got - self.high) - self.low).abs();
        if difference.is_nan() {
            f64::INFINITY
        } else {
            difference
        }
    }

    /// Error over |reference|; for a reference of zero only zero error is accepted.
    pub fn relative(&self, got: f64) -> f64 {
        self.over(got, self.high.abs())
    }

    /// Error in units of the last place of the `f64` reference.
    pub fn ulps(&self, got: f64) -> f64 {
        self.over(got, ulp_f64(self.high))
    }

    /// Error of an `f32` in units of its last place.
    pub fn ulps_f32(&self, got: f32) -> f64 {
        self.over(f64::from(got), ulp_f32(self.high as f32))
    }

    /// Error over `scale` > 0; zero error is zero on any scale.
    pub fn over(&self, got: f64, scale: f64) -> f64 {
        let distance = self.distance(got);
        if distance == 0.0 || distance == f64::INFINITY {
            distance
        } else {
            distance / scale
        }
    }
}

/// The gap above |x|, for finite x.
pub fn ulp_f64(x: f64) -> f64 {
    let x = x.abs();
    if x == f64::MAX {
        return x - x.next_down();
    }
    x.next_up() - x
}

/// The gap above |x| among `f32`, for finite x.
pub fn ulp_f32(x: f32) -> f64 {
    let x = x.abs();
    f64::from(x.next_up()) - f64::from(x)
}

/// A decimal as integer × 10^exponent with exactly [`DIGITS`] digits.
fn integer(text: &str) -> Option<(i128, i32)> {
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, mantissa.trim_start_matches('+')),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0');
    if digits.is_empty() || digits.len() > DIGITS {
        return None;
    }
    let missing = DIGITS - digits.len();
    let value: i128 = digits.parse().ok()?;
    let value = sign * value * 10_i128.pow(missing as u32);
    Some((value, exponent - fraction.len() as i32 - missing as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reference_resolves_far_below_one_unit() {
        let third = Reference::parse("0.33333333333333333333333333333333").unwrap();
        // 1/3 lies 1/3 of a unit above its neighbour below.
        assert!((third.ulps(1.0 / 3.0) - 1.0 / 3.0).abs() < 1e-14);
        assert!((third.ulps((1.0_f64 / 3.0).next_up()) - 2.0 / 3.0).abs() < 1e-14);
        let near_one = Reference::parse("0.99999999999999999999").unwrap();
        assert_eq!((near_one.high, near_one.low), (1.0, -1e-20));
        let tiny = Reference::parse("-1.2345678901234567890123456e-280").unwrap();
        assert_eq!(tiny.high, -1.234_567_890_123_456_8e-280);
        assert!(tiny.low != 0.0 && tiny.low.abs() < 1e-296);
    }

    #[test]
    fn nothing_but_the_right_special_value_passes() {
        let zero = Reference::parse("0.0").unwrap();
        assert_eq!(zero.relative(-0.0), 0.0);
        assert_eq!(zero.relative(5e-324), f64::INFINITY);
        let infinite = Reference::parse("inf").unwrap();
        assert_eq!(infinite.relative(f64::INFINITY), 0.0);
        assert_eq!(infinite.relative(f64::MAX), f64::INFINITY);
        assert_eq!(infinite.relative(f64::NAN), f64::INFINITY);
        assert_eq!(Reference::exact(1.0).ulps(f64::NAN), f64::INFINITY);
        assert!(Reference::parse("").is_none() && Reference::parse("none").is_none());
    }
}
