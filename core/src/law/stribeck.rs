//! From boundary to hydrodynamic lubrication.

use super::error::{not_negative, positive};
use super::limits::{minimum_between, scaled};
use super::{DryFriction, LawError, LocalLaw};
use crate::real::Real;

/// μ(v) = μ_d + (μₛ − μ_d) exp(−(v/vₛ)^δ) + k v.
///
/// The first two terms are the boundary branch: dry contact that the film lifts away. The last is
/// the hydrodynamic branch: shear of the film.
///
/// *Units*: vₛ in speed, k in 1/speed, the rest dimensionless.
/// *Source*: Stribeck curve in the form of Bo and Pavelescu; thesis fig. 2.8.
///
/// ```
/// use tribos_core::law::{DryFriction, LocalLaw, Stribeck};
/// let bearing = Stribeck::new(DryFriction::new(0.15_f64, 0.1)?, 0.01, 2.0, 0.5)?;
/// assert!((bearing.boundary(0.0) - 0.15).abs() < 1e-15); // no film at rest
/// // At 1 m/s it carries: mu_d and the shear of the film are left.
/// assert!((bearing.friction(1.0) - (0.1 + bearing.hydrodynamic(1.0))).abs() < 1e-15);
/// let turns = |speed| bearing.slope(0.9 * speed) < 0.0 && bearing.slope(1.1 * speed) > 0.0;
/// assert!(bearing.minimum().is_some_and(turns));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stribeck<R> {
    dry: DryFriction<R>,
    speed: R,
    exponent: R,
    viscous: R,
}

/// Doublings after which the exponential has died out for every exponent the type can tell.
const DOUBLINGS: usize = 256;

impl<R: Real> Stribeck<R> {
    /// Coefficients at rest and in boundary lubrication, Stribeck speed vₛ, exponent δ (1 and 2
    /// are usual), viscous coefficient k.
    ///
    /// *Domain*: 0 < vₛ, δ < ∞; 0 ≤ k < ∞.
    pub fn new(
        dry: DryFriction<R>,
        stribeck_speed: R,
        exponent: R,
        viscous: R,
    ) -> Result<Self, LawError> {
        Ok(Self {
            dry,
            speed: positive("Stribeck speed", stribeck_speed)?,
            exponent: positive("Stribeck exponent", exponent)?,
            viscous: not_negative("viscous coefficient", viscous)?,
        })
    }

    /// μ_d + (μₛ − μ_d) exp(−(v/vₛ)^δ).
    #[inline]
    pub fn boundary(&self, speed: R) -> R {
        self.dry.mu_dynamic() + self.drop() * self.faded(speed / self.speed)
    }

    /// k v.
    #[inline]
    pub fn hydrodynamic(&self, speed: R) -> R {
        scaled(self.viscous, speed)
    }

    /// Speed of least friction between the two branches; `None` if the law has no minimum at a
    /// positive speed.
    ///
    /// For δ > 1 friction rises first, falls, and rises again: this is the second turn.
    /// *Accuracy*: where the computed slope changes sign, some ulp times vₛ/speed.
    pub fn minimum(&self) -> Option<R> {
        let steepest = self.steepest_fall();
        // Without fall there is no minimum, without viscosity no rise after it.
        let falls = self.slope(steepest) < R::ZERO;
        if !falls || self.viscous == R::ZERO {
            return None;
        }
        let mut rising = if steepest > self.speed {
            steepest
        } else {
            self.speed
        };
        for _ in 0..DOUBLINGS {
            if self.slope(rising) >= R::ZERO {
                return Some(minimum_between(self, steepest, rising));
            }
            rising *= R::TWO;
        }
        None
    }

    /// μₛ − μ_d
    fn drop(&self) -> R {
        self.dry.mu_static() - self.dry.mu_dynamic()
    }

    /// exp(−x^δ)
    fn faded(&self, x: R) -> R {
        (-x.pow(self.exponent)).exp()
    }

    /// Speed at which the boundary branch falls most steeply: rest for δ ≤ 1, else
    /// vₛ ((δ − 1)/δ)^(1/δ).
    fn steepest_fall(&self) -> R {
        if self.exponent <= R::ONE {
            R::ZERO
        } else {
            let share = (self.exponent - R::ONE) / self.exponent;
            self.speed * share.pow(R::ONE / self.exponent)
        }
    }
}

impl<R: Real> LocalLaw<R> for Stribeck<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        self.boundary(speed) + self.hydrodynamic(speed)
    }
    /// At rest: −∞ for δ < 1, −(μₛ − μ_d)/vₛ + k for δ = 1, k above.
    #[inline]
    fn slope(&self, speed: R) -> R {
        let x = speed / self.speed;
        let faded = self.faded(x);
        if faded == R::ZERO {
            return self.viscous;
        }
        let steepness = self.exponent / self.speed * x.pow(self.exponent - R::ONE);
        self.viscous - scaled(self.drop(), steepness * faded)
    }
}
