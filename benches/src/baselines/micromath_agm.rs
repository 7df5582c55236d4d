//! The AGM in f32 with micromath's square root: what a coarse root costs in accuracy.
//!
//! Its root is a shift of the bits, good to 6 %; the mean of two numbers that should meet then
//! keeps that error for any number of rounds.
//!
//! *Source*: T. Arcieri, micromath 2.1, `F32Ext::sqrt`.

use core::f32::consts::{FRAC_PI_2, PI};
use micromath::F32Ext;

/// Rounds that a correct root needs in f32 for all but the closest speeds.
const ROUNDS: usize = 4;

/// `[F, T]` in f32. *Accuracy*: a tenth.
#[inline]
pub fn wrench(slide: f32, rim: f32) -> [f32; 2] {
    let sliding_leads = slide > rim;
    let h = if sliding_leads {
        rim / slide
    } else {
        slide / rim
    };
    let m = h * h;
    let complement = (1.0 - h) * (1.0 + h);
    let (force, torque) = (4.0 / (3.0 * PI), 4.0 / (9.0 * PI));
    if complement == 0.0 {
        return [2.0 * force, 2.0 * torque];
    }

    // K, B and D; q = Σ 2ⁿ⁻¹ cₙ²/m² by cₙ₊₁ = cₙ²/(4aₙ₊₁), which needs no division by m.
    let root = F32Ext::sqrt(complement);
    let mut arithmetic = 0.5 * (1.0 + root);
    let mut geometric = F32Ext::sqrt(root);
    let mut per_m = 0.25 / arithmetic;
    let mut q = per_m * per_m;
    let mut weight = 1.0;
    for _ in 0..ROUNDS {
        let next = 0.5 * (arithmetic + geometric);
        per_m *= m * per_m / (4.0 * next);
        geometric = F32Ext::sqrt(arithmetic * geometric);
        arithmetic = next;
        weight += weight;
        q += weight * per_m * per_m;
    }
    let k = FRAC_PI_2 / arithmetic;
    let (b, d) = (k * (0.5 - m * q), k * (0.5 + m * q));

    // The same closed forms as the f64 baseline.
    let phi = force * (2.0 * b + complement * d);
    if sliding_leads {
        [phi, torque * h * k * (1.0 + (2.0 - 4.0 * m) * q)]
    } else {
        let spinning = (3.0 - m) * b + complement * (3.0 - 2.0 * m) * d;
        [h * phi, torque * spinning]
    }
}
