//! The arithmetic–geometric mean, as a competent engineer would implement it.
//!
//! One AGM gives the complete elliptic integrals B and D of the parameter m = h²; the closed forms
//! of the disk in B and D do not cancel. Two shortcuts that pay: for small m four to six terms of
//! the power series replace the roots, and the mean stops one round early, because its next
//! correction is known to be the fourth power of the last.
//!
//! *Source*: Abramowitz & Stegun 17.6; Fukushima, J. Comput. Appl. Math. 235 (2011) 4140.

use super::{FORCE_FACTOR, PURE_SPIN_TORQUE, TORQUE_FACTOR, ordered};
use core::f64::consts::FRAC_PI_2;

/// Below this m the power series takes over: 0.01⁷ × the next coefficient is 1e-17.
const SERIES_BELOW: f64 = 0.01;
/// The rest after a difference c is c⁴ ≈ 1e-18.
const LAST_DIFFERENCE: f64 = 3e-5;
/// No f64 ratio needs more rounds.
const MAX_ROUNDS: usize = 8;

/// `[F, T]` with the hardware's square root. *Accuracy*: 1e-14.
#[inline]
pub fn wrench(slide: f64, rim: f64) -> [f64; 2] {
    wrench_with(slide, rim, f64::sqrt)
}

/// `[F, T]` with the square root of `libm`. *Accuracy*: 1e-14.
#[inline]
pub fn wrench_libm(slide: f64, rim: f64) -> [f64; 2] {
    wrench_with(slide, rim, libm::sqrt)
}

#[inline]
fn wrench_with(slide: f64, rim: f64, sqrt: impl Fn(f64) -> f64) -> [f64; 2] {
    let (h, sliding_leads) = ordered(slide, rim);
    let m = h * h;
    if m < SERIES_BELOW {
        return small(h, m, sliding_leads);
    }
    let complement = (1.0 - h) * (1.0 + h);
    if complement == 0.0 {
        return [2.0 * FORCE_FACTOR, 2.0 * TORQUE_FACTOR];
    }

    // K, B and D, and the closed forms.
    let [k, q] = mean(m, complement, sqrt);
    let (b, d) = (k * (0.5 - m * q), k * (0.5 + m * q));
    let phi = FORCE_FACTOR * (2.0 * b + complement * d);
    if sliding_leads {
        // (3m − 1) B + (1 − m) D = m K (1 + (2 − 4m) q), divided by m here.
        [phi, TORQUE_FACTOR * h * k * (1.0 + (2.0 - 4.0 * m) * q)]
    } else {
        let torque = (3.0 - m) * b + complement * (3.0 - 2.0 * m) * d;
        [h * phi, TORQUE_FACTOR * torque]
    }
}

/// K(m) and q = Σ 2ⁿ⁻¹ cₙ²/m² over n ≥ 1, from the mean of 1 and √(1−m).
#[inline]
fn mean(m: f64, complement: f64, sqrt: impl Fn(f64) -> f64) -> [f64; 2] {
    let root = sqrt(complement);
    let mut arithmetic = 0.5 * (1.0 + root);
    let mut geometric = sqrt(root);
    let mut difference = 0.25 * m / arithmetic;
    let mut sum = difference * difference;
    let mut weight = 1.0;
    for _ in 0..MAX_ROUNDS {
        if difference < LAST_DIFFERENCE {
            break;
        }
        // One round: mean, root, difference.
        difference = 0.5 * (arithmetic - geometric);
        let next = 0.5 * (arithmetic + geometric);
        geometric = sqrt(arithmetic * geometric);
        arithmetic = next;
        weight += weight;
        sum += weight * difference * difference;
    }
    let limit = 0.5 * (arithmetic + geometric);
    [FRAC_PI_2 / limit, sum / (m * m)]
}

/// The power series of ₂F₁(½, −½; 2; m), ₂F₁(½, ½; 3; m) and ₂F₁(½, −3/2; 1; m).
#[inline]
fn small(h: f64, m: f64, sliding_leads: bool) -> [f64; 2] {
    let phi = horner(m, &PHI);
    if sliding_leads {
        [phi, 0.25 * h * horner(m, &TORQUE_SLIDING)]
    } else {
        [h * phi, PURE_SPIN_TORQUE * horner(m, &TORQUE_SPINNING)]
    }
}

/// Coefficients are exact binary fractions or quotients of integers.
const PHI: [f64; 7] = gauss(0.5, -0.5, 2.0);
const TORQUE_SLIDING: [f64; 7] = gauss(0.5, 0.5, 3.0);
const TORQUE_SPINNING: [f64; 7] = gauss(0.5, -1.5, 1.0);

/// The first coefficients of ₂F₁(a, b; c; ·).
pub(super) const fn gauss<const N: usize>(a: f64, b: f64, c: f64) -> [f64; N] {
    let mut out = [1.0; N];
    let mut n = 1;
    while n < N {
        let k = (n - 1) as f64;
        out[n] = out[n - 1] * (a + k) * (b + k) / ((c + k) * (k + 1.0));
        n += 1;
    }
    out
}

#[inline]
pub(super) fn horner(x: f64, coefficients: &[f64]) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}
