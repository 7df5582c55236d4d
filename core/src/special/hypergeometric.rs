//! Gauss' function ₂F₁(a, b; c; x) on [0, 1] for c − a − b > 0.
//!
//! Two regimes. For x ≤ 1/2 the power series converges at least like 2⁻ⁿ (and for large c − a − b
//! it serves all of [0, 1]). Beyond, with z = 1 − x,
//! the differential equation is continued by Taylor expansions whose centres halve z: every
//! expansion then converges like 2⁻ⁿ, whatever the exponents at x = 1 are. There is no connection
//! formula, hence no Γ function and no special case when c − a − b is close to an integer.
//!
//! Everything here is `const`, so that tables made from it can be built by the compiler.

/// ₂F₁(a, b; c; ·) with fixed parameters.
///
/// *Domain*: c > 0 and c − a − b > 0 (finite at x = 1); |a|, |b| up to about 500.
/// *Source*: the recurrence is the hypergeometric equation (DLMF 15.10.1) expanded about 1 − z.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gauss {
    a: f64,
    b: f64,
    c: f64,
}

/// Value and x-derivative of a function.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Jet {
    /// f(x)
    pub value: f64,
    /// f'(x)
    pub slope: f64,
}

/// Terms of the power series at x = 1/2 and of one Taylor expansion at ratio 1/2. 2⁻⁵³ needs
/// about 50 for moderate parameters; large parameters shift the largest term up.
const MAX_TERMS: usize = 1200;
/// Below this z the function is taken at its end x = 1 (no f64 ratio below one comes closer).
const Z_END: f64 = 1.0 / (1u64 << 60) as f64;
/// Border of the two regimes.
const HALF: f64 = 0.5;
/// From this c − a − b on the power series converges fast enough at x = 1 too, like n⁻⁹, and the
/// continuation, whose equation has growing solutions there, is not needed.
const SERIES_EXCESS: f64 = 8.0;

impl Gauss {
    /// Fixes the parameters.
    pub const fn new(a: f64, b: f64, c: f64) -> Self {
        Self { a, b, c }
    }

    /// Value and slope at x = 1 − z, given both x and z so that neither is rounded near its zero.
    ///
    /// *Domain*: 0 ≤ x ≤ 1; z below 2⁻⁶⁰ counts as 0. *Special values*: at z = 0 the slope is the
    /// one-sided limit if c − a − b > 1, otherwise infinite with the sign of ab. NaN in gives NaN out.
    /// *Accuracy*: 4e-15 relative for the parameters of the friction disk with α ≥ −0.9
    /// (the tests compare with 25-digit values). *Cost*: at most 60 expansions.
    pub const fn at(&self, x: f64, z: f64) -> Jet {
        if z >= HALF || z.is_nan() || self.c - self.a - self.b > SERIES_EXCESS {
            return self.series(x);
        }
        let mut state = self.series(HALF);
        let mut low = Jet {
            value: 0.0,
            slope: 0.0,
        };
        let mut center = HALF;
        let end = if z > Z_END { z } else { Z_END };
        while 0.5 * center > end {
            (state, low) = self.continued(center, state, low, -0.5);
            center *= 0.5;
        }
        (state, low) = self.continued(center, state, low, end / center - 1.0);
        state = Jet {
            value: state.value + low.value,
            slope: state.slope + low.slope,
        };
        if z > Z_END { state } else { self.at_end(state) }
    }

    /// f(1) and f'(1) from the state at z = 2⁻⁶⁰. With e = c − a − b > 1 f is linear there and the
    /// equation itself ties the slope to the value; below, f leaves its end like zᵉ.
    const fn at_end(&self, near: Jet) -> Jet {
        let excess = self.c - self.a - self.b;
        let bend = self.a * self.b;
        if excess > 1.0 {
            return Jet {
                value: near.value,
                slope: bend * near.value / (excess - 1.0),
            };
        }
        Jet {
            value: near.value + Z_END * near.slope / excess,
            slope: if bend > 0.0 {
                f64::INFINITY
            } else if bend < 0.0 {
                f64::NEG_INFINITY
            } else {
                0.0
            },
        }
    }

    /// Power series about x = 0, with compensated sums. *Domain*: 0 ≤ x ≤ 1/2, or up to 1 for
    /// c − a − b > 8.
    pub const fn series(&self, x: f64) -> Jet {
        let (mut value, mut value_low) = (1.0, 0.0);
        let (mut slope, mut slope_low) = (0.0, 0.0);
        // power = coefficient · xⁿ, and n · coefficient · xⁿ⁻¹ for the slope.
        let mut coefficient_times_power = 1.0;
        let mut n = 0;
        while n < MAX_TERMS {
            let k = n as f64;
            let ratio = (self.a + k) * (self.b + k) / ((self.c + k) * (k + 1.0));
            let slope_term = coefficient_times_power * ratio * (k + 1.0);
            coefficient_times_power *= ratio * x;
            (value, value_low) = add(value, value_low, coefficient_times_power);
            (slope, slope_low) = add(slope, slope_low, slope_term);
            let small = slope_term.abs() <= TINY * slope.abs();
            if ratio == 0.0 || small && ratio.abs() * x < 1.0 {
                break;
            }
            n += 1;
        }
        Jet {
            value: value + value_low,
            slope: slope + slope_low,
        }
    }

    /// Coefficients of the power series about x = 0.
    pub const fn series_coefficients<const N: usize>(&self) -> [f64; N] {
        let mut out = [0.0; N];
        let mut coefficient = 1.0;
        let mut n = 0;
        while n < N {
            out[n] = coefficient;
            let k = n as f64;
            coefficient *= (self.a + k) * (self.b + k) / ((self.c + k) * (k + 1.0));
            n += 1;
        }
        out
    }

    /// Coefficients cₙ of f(1 − z(1 + t)) = Σ cₙ tⁿ, from value and slope at z.
    ///
    /// *Domain*: 0 < z ≤ 1/2, where the expansion converges for |t| < 1.
    pub const fn taylor<const N: usize>(&self, z: f64, at: Jet) -> [f64; N] {
        let mut out = [0.0; N];
        out[0] = at.value;
        out[1] = -z * at.slope;
        let mut n = 0;
        while n + 2 < N {
            out[n + 2] = self.next_coefficient(z, n as f64, out[n], out[n + 1]);
            n += 1;
        }
        out
    }

    /// The recurrence of the Taylor coefficients about z in t = (z' − z)/z.
    const fn next_coefficient(&self, z: f64, n: f64, c0: f64, c1: f64) -> f64 {
        // In x the equation reads x z f'' + (c − (a+b+1) x) f' − a b f = 0; dx = −z dt.
        let x = 1.0 - z;
        let s = self.a + self.b + 1.0;
        let q0 = (self.c - s * x) - n * (2.0 * x - 1.0);
        let first = q0 * (n + 1.0) * c1;
        let second = (n * (n - 1.0) + s * n + self.a * self.b) * z * c0;
        (first + second) / (x * (n + 2.0) * (n + 1.0))
    }

    /// Moves the state from z to z (1 + t); `low` carries what rounding would lose.
    pub(crate) const fn continued(&self, z: f64, at: Jet, low: Jet, t: f64) -> (Jet, Jet) {
        let (mut c0, mut c1) = (at.value, -z * at.slope);
        let (mut value, mut value_low) = add(at.value, low.value, c1 * t);
        // Sum of the slope in t without its first term, which is carried exactly.
        let mut slope_gain = 0.0;
        let mut power = t;
        let mut n = 0;
        while n < MAX_TERMS {
            let k = n as f64;
            let c2 = self.next_coefficient(z, k, c0, c1);
            let slope_term = (k + 2.0) * c2 * power;
            slope_gain += slope_term;
            power *= t;
            (value, value_low) = add(value, value_low, c2 * power);
            if c2 == 0.0 && c1 == 0.0
                || slope_term.abs() <= TINY * (c1.abs() + slope_gain.abs()) && k > 8.0
            {
                break;
            }
            (c0, c1) = (c1, c2);
            n += 1;
        }
        let (slope, slope_low) = add(at.slope, low.slope, -slope_gain / z);
        (
            Jet { value, slope },
            Jet {
                value: value_low,
                slope: slope_low,
            },
        )
    }
}

/// A term this much smaller than its sum no longer matters.
const TINY: f64 = 1.0 / (1u64 << 58) as f64;

/// Adds `term` to the unevaluated sum `high + low` (Knuth's two-sum).
const fn add(high: f64, low: f64, term: f64) -> (f64, f64) {
    let sum = high + term;
    let shifted = sum - high;
    let error = (high - (sum - shifted)) + (term - shifted);
    (sum, low + error)
}
