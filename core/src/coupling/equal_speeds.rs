//! The uniform disk next to equal speeds, below the cells of its table: z → 0.
//!
//! The connection formula (DLMF 15.8.4, for integer α its limit 15.8.10) gives Φ the form
//!
//! ```text
//! Φ = Φ₀ + Φ₁z + z²(Q + KΛ(1 + kz)) + O(z³),      Λ = (z^α − 1)/α,      k = (5+α)/4
//! K = 2^−(1+α) Γ(1 − α/2) / (√π (2+α) Γ((1−α)/2))
//! ```
//!
//! Λ = ln z for α = 0, and there K = 1/(4π) and Q = K(19/6 − 4 ln 2). Written with Λ nothing has a pole
//! between α = −1 and 1: Q, which has no short form, comes from the slope where the cells
//! end. From α = 1 on the singular part is below rounding, and K counts as 0.
//!
//! For α ≥ 0 values do not show the singular part either: the cell of z = 0 holds polynomials, with a tangent in
//! place of Λ, which serve Jacobians too where the cells come near enough to z = 0.

use super::half_octave_table::Pair;
use crate::power::halved;
use crate::real::Real;
use crate::special::{Gauss, log_quotient};
use core::f64::consts::PI;

/// True if the polynomials of the cell of z = 0 are not enough for values.
#[inline(always)]
pub(super) fn bends_values<R: Real>(alpha: R) -> bool {
    alpha < R::ZERO
}

/// True if they are not enough for slopes.
#[inline(always)]
pub(super) fn bends_slopes<R: Real>(alpha: R) -> bool {
    // In f32 the cells come near enough to z = 0; in f64 K is 0 from α = 1 on.
    alpha < if R::IS_SINGLE { R::ZERO } else { R::ONE }
}

/// Below this many roots of rounding α counts as 0 in Λ, whose difference loses digits like 1/α.
const NEARLY_ZERO: f64 = 1.0 / 4.0;

/// zΛ for 0 < z < 2⁻¹⁰. *Accuracy*: 2e-14 in f64, 3e-6 in f32, absolute.
#[inline]
fn times_log<R: Real>(alpha: R, z: R) -> R {
    if alpha.abs() < R::from_f64(NEARLY_ZERO) * R::EPSILON.sqrt() {
        -z * log_quotient(R::ONE - z, z)
    } else {
        // One power, which is finite for any z.
        (z.pow(R::ONE + alpha) - z) / alpha
    }
}

/// The expansion of Φ.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct EqualSpeedExpansion<R> {
    /// Φ₀, Φ₁ and Q.
    terms: [R; 3],
    /// K
    hook: R,
}

impl EqualSpeedExpansion<f64> {
    /// From Φ₀ and Φ₁, and the slope that the equation has at z = 2^−`octaves`.
    pub const fn fitted(disk: &Pair, [value, slope]: [f64; 2], octaves: u32) -> Self {
        let alpha = disk.alpha;
        let z = 1.0 / (1u64 << octaves) as f64;
        let near = disk.gauss.at(1.0 - z, z);
        let hook = hook(alpha);
        let [_, log] = halved(alpha, octaves);
        let further = 0.25 * (5.0 + alpha) * z;
        let growth = (1.0 + further) * (1.0 + (2.0 + alpha) * log) + further * log;
        Self {
            terms: [
                value,
                slope,
                0.5 * ((-near.slope - slope) / z - hook * growth),
            ],
            hook,
        }
    }

    /// Terms of z² and z³ for values, Φ and Θ, with the tangent at z = 2^−`octaves` in place of Λ.
    pub const fn tangents(&self, disk: &Pair, octaves: u32) -> [[f64; 2]; 2] {
        let Pair {
            alpha, inv_moment, ..
        } = *disk;
        let Self {
            terms: [_, _, bend],
            hook,
        } = *self;
        let [power, log] = halved(alpha, octaves);
        let tangent = [log - power, power * (1u64 << octaves) as f64];
        // nΘ = (1+α)/2 Φ − z dΦ/dz, where z d/dz of z²(Q + KΛ) is z²(2Q + K + (2+α)KΛ).
        let half = 0.5 * (1.0 + alpha);
        let theta_bend = (half - 2.0) * bend - hook;
        let theta_hook = (half - 2.0 - alpha) * hook;
        [
            [
                bend + hook * tangent[0],
                inv_moment * (theta_bend + theta_hook * tangent[0]),
            ],
            [hook * tangent[1], inv_moment * theta_hook * tangent[1]],
        ]
    }

    pub const fn rounded(&self) -> EqualSpeedExpansion<f32> {
        let Self {
            terms: [value, slope, bend],
            hook,
        } = *self;
        EqualSpeedExpansion {
            terms: [value as f32, slope as f32, bend as f32],
            hook: hook as f32,
        }
    }
}

/// K. Gauss' sum ₂F₁(1/2, −α/2; 1−α/2; 1) is √π times the quotient of its two Γ functions.
const fn hook(alpha: f64) -> f64 {
    if alpha >= 1.0 {
        return 0.0;
    }
    let quotient = Gauss::new(0.5, -0.5 * alpha, 1.0 - 0.5 * alpha).at(1.0, 0.0);
    0.5 * halved(alpha, 1)[0] * quotient.value / (PI * (2.0 + alpha))
}

impl<R: Real> EqualSpeedExpansion<R> {
    /// Φ and Φ' = −dΦ/dz at z; NaN for NaN.
    pub fn value_and_slope(&self, alpha: R, z: R) -> [R; 2] {
        let Self {
            terms: [value, slope, bend],
            hook,
        } = *self;
        let log = if z == R::ZERO { z } else { times_log(alpha, z) };
        let further = R::from_f64(0.25) * (R::from_f64(5.0) + alpha) * z;
        let nearly_one = R::ONE + further;
        // ψ = z²(Q + KΛ(1 + kz)): ψ/z, and dψ/dz less twice that.
        let curve = z * bend + hook * log * nearly_one;
        let growth = nearly_one * (z + alpha * log) + further * log;
        [
            value + z * (slope + curve),
            -(slope + (R::TWO * curve + hook * growth)),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupling::table::DiskTable64;

    #[test]
    fn dry_friction_bends_as_the_connection_formula_says() {
        let EqualSpeedExpansion {
            terms: [value, slope, bend],
            hook,
        } = DiskTable64::new(0.0).unwrap().disk.tip;
        let far = |got: f64, wanted: f64| (got / wanted - 1.0).abs();
        assert!(far(value, 8.0 / (3.0 * PI)) < 1e-15 && far(slope, 2.0 / (3.0 * PI)) < 1e-15);
        let known = 1.0 / (4.0 * PI);
        assert!(far(hook, known) < 1e-15, "{hook}");
        let known = known * (19.0 / 6.0 - 4.0 * core::f64::consts::LN_2);
        assert!(far(bend, known) < 1e-6, "{bend}");
    }

    #[test]
    fn singular_parts_have_their_known_factors() {
        // mpmath: mp.dps = 40; 2**(-1-a)*gamma(1-a/2)/(sqrt(pi)*(2+a)*gamma((1-a)/2))
        for (alpha, known) in [
            (-0.99, 0.49011931),
            (-0.5, 0.19672344),
            (0.3, 0.043527972),
            (0.95, 0.0021207467),
        ] {
            assert!((hook(alpha) / known - 1.0).abs() < 1e-7, "{alpha}");
        }
        assert_eq!(hook(1.0), 0.0);
    }

    #[test]
    fn logarithms_are_limits_of_powers() {
        for alpha in [1e-4_f64, -1e-4, 1e-8, -1e-9, 1e-10, -1e-300, 0.0] {
            for z in [5e-324, 1e-300, 1e-20, 1e-9, 3e-8] {
                let apart = times_log(alpha, z) - times_log(0.0, z);
                // α z ln²z/2, and rounding.
                assert!(apart.abs() <= 6e-6 * alpha.abs() + 2e-14, "{alpha} {z}");
            }
        }
        // The smallest number to a power next to −1, times itself.
        assert!(times_log(-0.99, 5e-324_f64).is_finite());
        assert!(times_log(0.0, f64::NAN).is_nan() && times_log(0.5, f64::NAN).is_nan());
    }
}
