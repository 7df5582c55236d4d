//! Force and torque for α = 0 in double-double arithmetic: the reference for every method.
//!
//! It shares no code with the kernel. For h² ≤ ½ the hypergeometric series are summed; beyond, E
//! and K come from an arithmetic–geometric mean and enter eqs. 3.11 and 3.13 themselves, which lose
//! two digits of thirty there. Its own test compares it with the 32-digit table.

use core::ops::{Add, Div, Mul, Sub};

/// An unevaluated sum of two f64, about 31 digits (Dekker, Numer. Math. 18 (1971) 224).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    /// The value rounded to f64.
    pub high: f64,
    /// Remainder of that rounding.
    pub low: f64,
}

impl Wide {
    /// An f64, exact.
    pub const fn new(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }

    /// Moves what `low` has of `high`'s size; |high| ≥ |low|.
    fn settled(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }

    /// The square root: one Newton step from the f64 root.
    pub fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let root = Self::new(self.high.sqrt());
        let rest = self - root * root;
        root + Self::new(0.5 * rest.high / root.high)
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = self.high + other.high;
        let moved = sum - self.high;
        let error = (self.high - (sum - moved)) + (other.high - moved);
        Self::settled(sum, error + self.low + other.low)
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + Self {
            high: -other.high,
            low: -other.low,
        }
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let error = self.high.mul_add(other.high, -product);
        Self::settled(
            product,
            error + self.high * other.low + self.low * other.high,
        )
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self - other * Self::new(quotient);
        Self::settled(quotient, rest.high / other.high)
    }
}

/// π with 32 digits.
const PI: Wide = Wide {
    high: core::f64::consts::PI,
    low: 1.224_646_799_147_353_2e-16,
};
/// The series at h² = ½ gains a bit a term.
const SERIES_TERMS: u32 = 110;
/// Rounds of the mean that reach 2⁻¹⁰⁶ from any f64 ratio.
const ROUNDS: usize = 10;

/// F and T of the uniform disk at f64 speeds, to about 30 digits.
///
/// *Domain*: `slide` ≥ 0, `rim` ≥ 0, not both zero.
pub fn wrench(slide: f64, rim: f64) -> [Wide; 2] {
    let sliding_leads = slide > rim;
    let (major, minor) = if sliding_leads {
        (slide, rim)
    } else {
        (rim, slide)
    };
    let h = Wide::new(minor) / Wide::new(major);
    let m = h * h;
    if m.high <= 0.5 {
        away_from_equal(h, m, sliding_leads)
    } else {
        let complement = (Wide::new(major) - Wide::new(minor)) / Wide::new(major);
        near_equal(h, m, complement * (Wide::new(1.0) + h), sliding_leads)
    }
}

/// F and T by the power series about ε = 0 or ε = ∞.
fn away_from_equal(h: Wide, m: Wide, sliding_leads: bool) -> [Wide; 2] {
    let phi = series(0.5, -0.5, 2.0, m);
    if sliding_leads {
        [phi, Wide::new(0.25) * h * series(0.5, 0.5, 3.0, m)]
    } else {
        let two_thirds = Wide::new(2.0) / Wide::new(3.0);
        [h * phi, two_thirds * series(0.5, -1.5, 1.0, m)]
    }
}

/// F and T by eqs. 3.11 and 3.13, with 1 − m given to full precision.
fn near_equal(h: Wide, m: Wide, complement: Wide, sliding_leads: bool) -> [Wide; 2] {
    let [one, two, three] = [1.0, 2.0, 3.0].map(Wide::new);
    let four_over_pi = Wide::new(4.0) / PI;
    let (third, ninth) = (four_over_pi / three, four_over_pi / Wide::new(9.0));
    let [k, e] = integrals(m, complement);
    let rest = complement * k;
    if sliding_leads {
        let force = ((one + m) * e - rest) / m;
        // 4 − 2ε² = (4m − 2)/m and 2ε² − 5 + 3/ε² = (1 − m)(2 − 3m)/m.
        let torque = ((two + two) * m - two) * e + (two - three * m) * rest;
        [third * force, ninth * torque / (h * m)]
    } else {
        let force = ((one + m) * e - rest) / h;
        let torque = (two + two - two * m) * e - rest;
        [third * force, ninth * torque]
    }
}

/// ₂F₁(a, b; c; x) for 0 ≤ x ≤ ½ and parameters that are small binary fractions.
fn series(a: f64, b: f64, c: f64, x: Wide) -> Wide {
    let mut term = Wide::new(1.0);
    let mut sum = term;
    for n in 0..SERIES_TERMS {
        let k = f64::from(n);
        let ratio = Wide::new((a + k) * (b + k)) / Wide::new((c + k) * (k + 1.0));
        term = term * ratio * x;
        sum = sum + term;
    }
    sum
}

/// K and E of the parameter m; for m = 1 K is left 0, its factor 1 − m being 0 too.
fn integrals(m: Wide, complement: Wide) -> [Wide; 2] {
    let half = Wide::new(0.5);
    if complement.high == 0.0 {
        return [Wide::new(0.0), Wide::new(1.0)];
    }
    let (mut arithmetic, mut geometric) = (Wide::new(1.0), complement.sqrt());
    let mut sum = half * m;
    let mut weight = half;
    for _ in 0..ROUNDS {
        let difference = half * (arithmetic - geometric);
        let next = half * (arithmetic + geometric);
        geometric = (arithmetic * geometric).sqrt();
        arithmetic = next;
        weight = weight + weight;
        sum = sum + weight * difference * difference;
    }
    let k = half * PI / arithmetic;
    [k, k * (Wide::new(1.0) - sum)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `a.bcde-f` as a sum of two f64: the digits beyond the first f64 are parsed apart.
    fn parsed(text: &str) -> Wide {
        let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let exponent: i32 = exponent.parse().unwrap();
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let ten = Wide::new(10.0);
        let all = whole.chars().chain(fraction.chars());
        let mut value = all.fold(Wide::new(0.0), |sum, digit| {
            sum * ten + Wide::new(f64::from(digit.to_digit(10).unwrap()))
        });
        for _ in 0..(fraction.len() as i32 - exponent) {
            value = value / ten;
        }
        value
    }

    #[test]
    fn agrees_with_the_high_precision_table() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/tables/uniform.csv");
        let table = std::fs::read_to_string(path).unwrap();
        let rows: Vec<_> = table
            .lines()
            .filter(|line| line.starts_with("0.0,"))
            .collect();
        assert!(rows.len() > 30);
        for row in rows {
            let cells: Vec<&str> = row.split(',').collect();
            let found = wrench(cells[1].parse().unwrap(), 1.0);
            for (value, text) in found.iter().zip(&cells[2..4]) {
                let exact = parsed(text);
                let difference = (*value - exact).high.abs();
                assert!(difference <= 1e-28 * exact.high.abs(), "{row}: {value:?}");
            }
        }
    }
}
