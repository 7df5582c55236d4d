//! Three terms of the power series about ε = 0 and about ε = ∞, joined at ε = 1.
//!
//! *Source*: R. I. Leine and Ch. Glocker, Eur. J. Mech. A 22 (2003) 193, with one term more.

use super::{PURE_SPIN_TORQUE, ordered};

/// `[F, T]`; worst at equal speeds.
#[inline]
pub fn wrench(slide: f64, rim: f64) -> [f64; 2] {
    let (h, sliding_leads) = ordered(slide, rim);
    let x = h * h;
    // ₂F₁(½, −½; 2; x), ₂F₁(½, ½; 3; x), ₂F₁(½, −3/2; 1; x).
    let phi = 1.0 - x * (1.0 / 8.0 + x / 64.0);
    if sliding_leads {
        [phi, 0.25 * h * (1.0 + x * (1.0 / 12.0 + x * 3.0 / 128.0))]
    } else {
        let torque = 1.0 - x * (3.0 / 4.0 - x * 9.0 / 64.0);
        [h * phi, PURE_SPIN_TORQUE * torque]
    }
}
