//! The tier without tables: a few KiB of code, tens of ulp.

use super::octave::force_function;
use super::profile::{self, Profile};
use super::{Coupling, DryCoupling, ReducedJacobian, ReducedWrench};
use crate::law::{LawError, PowerLaw, validated_exponent};
use crate::real::Real;
use crate::special::CompleteElliptic;
use crate::special::hypergeometric::Gauss;

/// Coulomb friction, α = 0, from complete elliptic integrals by the arithmetic–geometric mean.
///
/// Φ = 4/(3π) (2B + (1−m) D) and Φ' = 2/(3π) (C − D) with m = h².
/// *Accuracy*: at most 1e-14 relative in f64 (5e-6 in f32).
/// *Source*: eqs. 3.11 and 3.13 in the integrals B, C, D, which do not cancel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coulomb;

impl<R: Real> Profile<R> for Coulomb {
    #[inline]
    fn exponent(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn force_and_torque_factors(&self, ratio: R) -> [R; 2] {
        let z = (R::ONE - ratio) * (R::ONE + ratio);
        let [phi, slope] = self.force_factor_and_slope(z);
        // Θ at α = 0; at z = 0 the slope is finite, so that z Φ' vanishes.
        [phi, R::TWO / R::from_f64(3.0) * (R::HALF * phi + z * slope)]
    }
    #[inline]
    fn force_factor_and_slope(&self, complement: R) -> [R; 2] {
        let third_of_pi = R::from_f64(4.0 / (3.0 * core::f64::consts::PI));
        if complement == R::ZERO {
            return [R::TWO * third_of_pi, -R::HALF * third_of_pi];
        }
        let CompleteElliptic { b, d, c, .. } = CompleteElliptic::new(complement);
        [
            third_of_pi * (R::TWO * b + complement * d),
            R::HALF * third_of_pi * (c - d),
        ]
    }
    #[inline]
    fn speed_scale(&self, _: R) -> R {
        R::ONE
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        R::ONE / speed
    }
    fn half_scales(&self, speed: R) -> [R; 2] {
        [R::ONE, R::ONE / speed.sqrt()]
    }
}

impl<R: Real> DryCoupling<R> for Coulomb {}

impl<R: Real> Coupling<R> for Coulomb {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        profile::wrench(self, slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        profile::jacobian(self, slide, rim)
    }
}

/// |v|^α for any −1 < α ≤ 128, from the power series and its continuation.
///
/// Works in f64 inside, for f32 too: on a processor without f64 it is slow.
/// *Accuracy*: at most 1e-14 relative in f64 for −0.99 ≤ α ≤ 50; in f32 5 ulp for
/// −0.75 ≤ α ≤ 10.
/// *Cost*: one series away from equal speeds; near them up to 52 expansions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<R> {
    alpha: R,
    phi: Gauss,
}

impl<R: Real> Power<R> {
    /// *Domain*: −1 < `alpha` ≤ [`PowerLaw::MAX_EXPONENT`].
    pub fn new(alpha: R) -> Result<Self, LawError> {
        let wide = validated_exponent(alpha.to_f64(), PowerLaw::<R>::MAX_EXPONENT)?;
        Ok(Self {
            alpha,
            phi: force_function(wide),
        })
    }

    /// Φ, Θ and Φ' in f64.
    fn factors(&self, x: f64, z: f64) -> [f64; 3] {
        let alpha = self.alpha.to_f64();
        let phi = self.phi.at(x, z);
        let theta = 2.0 / (3.0 + alpha) * (0.5 * (1.0 + alpha) * phi.value + z * phi.slope);
        [phi.value, theta, phi.slope]
    }
}

impl<R: Real> Profile<R> for Power<R> {
    fn exponent(&self) -> R {
        self.alpha
    }
    fn force_and_torque_factors(&self, ratio: R) -> [R; 2] {
        let h = ratio.to_f64();
        let [phi, theta, _] = self.factors(h * h, (1.0 - h) * (1.0 + h));
        [R::from_f64(phi), R::from_f64(theta)]
    }
    fn force_factor_and_slope(&self, complement: R) -> [R; 2] {
        let z = complement.to_f64();
        let [phi, _, slope] = self.factors(1.0 - z, z);
        [R::from_f64(phi), R::from_f64(slope)]
    }
}

impl<R: Real> Coupling<R> for Power<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        profile::wrench(self, slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        profile::jacobian(self, slide, rim)
    }
}
