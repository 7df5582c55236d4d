//! Coulomb friction made smooth at rest by a hyperbolic tangent.

use super::error::{positive, validated_coefficient};
use super::limits::scaled;
use super::{LawError, LocalLaw};
use crate::real::Real;

/// μ(v) = μ tanh(v/v_t).
///
/// The form in which games and multibody codes make Coulomb friction differentiable. It holds nothing:
/// below the speed v_t it is a viscous film, under which a body on a slope creeps.
///
/// *Units*: v_t in speed, the rest dimensionless. *Accuracy*: 4 ulp of the friction.
/// *Special values*: 0 at rest, μ at infinite speed.
/// *Source*: P. E. Dupont, Proc. American Control Conf. (1990) 1370; Andersson, Söderberg, Björklund,
/// Tribol. Int. 40 (2007) 580, eq. 8.
///
/// ```
/// use tribos_core::law::{LocalLaw, TanhLaw};
/// let wheel = TanhLaw::new(0.8_f64, 0.01)?; // v_t in m/s
/// assert_eq!((wheel.friction(0.0), wheel.friction(1.0)), (0.0, 0.8));
/// assert_eq!(wheel.slope(0.0), 80.0);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TanhLaw<R> {
    mu: R,
    speed: R,
}

impl<R: Real> TanhLaw<R> {
    /// Law with the coefficient μ of fast sliding and the speed v_t.
    ///
    /// *Domain*: 0 ≤ `mu` < ∞, 0 < `speed` < ∞.
    pub fn new(mu: R, speed: R) -> Result<Self, LawError> {
        validated_coefficient(mu)?;
        positive("speed of the rise", speed)?;
        Ok(Self { mu, speed })
    }
}

impl<R: Real> LocalLaw<R> for TanhLaw<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        // tanh x = −t/(2 + t) with t = exp(−2x) − 1, which loses no digits near rest.
        let t = (-(R::TWO * (speed / self.speed))).exp_m1();
        self.mu * (-t / (R::TWO + t))
    }
    /// μ/(v_t cosh²(v/v_t)).
    #[inline]
    fn slope(&self, speed: R) -> R {
        // 1/cosh x = 2s/(1 + s²) with s = exp(−x), in which nothing grows.
        let s = (-(speed / self.speed)).exp();
        let inv_cosh = R::TWO * s / (R::ONE + s * s);
        scaled(self.mu, inv_cosh * (inv_cosh / self.speed))
    }
}
