//! Bulirsch's general complete elliptic integral, called twice.
//!
//! cel(k', 1, x, y) = x B + y D, so that force and torque take one call each.
//!
//! *Source*: R. Bulirsch, Numer. Math. 13 (1969) 305, with the characteristic p fixed to 1.

use super::agm::{gauss, horner};
use super::{FORCE_FACTOR, TORQUE_FACTOR, ordered};
use core::f64::consts::FRAC_PI_2;

/// Relative difference at which Bulirsch's means have met: the square root of the precision.
const MET: f64 = 1e-8;
/// Below this m the torque of leading sliding would cancel and its power series takes over.
const SERIES_BELOW: f64 = 0.2;
/// Terms of that series: 0.2²¹ is 2e-15, times a coefficient below 1e-3.
const TORQUE_SLIDING: [f64; 21] = gauss(0.5, 0.5, 3.0);

/// `[F, T]`. *Accuracy*: 2e-15.
#[inline]
pub fn wrench(slide: f64, rim: f64) -> [f64; 2] {
    let (h, sliding_leads) = ordered(slide, rim);
    let m = h * h;
    let complement = (1.0 - h) * (1.0 + h);
    if complement == 0.0 {
        return [2.0 * FORCE_FACTOR, 2.0 * TORQUE_FACTOR];
    }
    let root = complement.sqrt();
    let phi = FORCE_FACTOR * cel(root, 2.0, complement);
    if !sliding_leads {
        let torque = cel(root, 3.0 - m, complement * (3.0 - 2.0 * m));
        [h * phi, TORQUE_FACTOR * torque]
    } else if m < SERIES_BELOW {
        [phi, 0.25 * h * horner(m, &TORQUE_SLIDING)]
    } else {
        let torque = cel(root, 3.0 * m - 1.0, complement);
        [phi, TORQUE_FACTOR * h / m * torque]
    }
}

/// ∫ (a cos²φ + b sin²φ)/√(cos²φ + k'² sin²φ) dφ over [0, π/2].
#[inline]
fn cel(complementary_modulus: f64, a: f64, b: f64) -> f64 {
    let (mut a, mut b, mut p) = (a, b, 1.0);
    let (mut geometric, mut arithmetic) = (complementary_modulus, 1.0);
    let mut product = complementary_modulus;
    loop {
        let before = a;
        a += b / p;
        let g = product / p;
        b += before * g;
        b += b;
        p += g;
        let last = arithmetic;
        arithmetic += geometric;
        // NaN leaves too.
        let apart = (last - geometric).abs() > last * MET;
        if !apart {
            return FRAC_PI_2 * (b + a * arithmetic) / (arithmetic * (arithmetic + p));
        }
        geometric = 2.0 * product.sqrt();
        product = geometric * arithmetic;
    }
}
