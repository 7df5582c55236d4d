//! From boundary to hydrodynamic lubrication.

use super::error::{not_negative, positive};
use super::limits::{minimum_between, scaled};
use super::{DryFriction, LawError, LocalLaw};
use crate::real::Real;

/// Parameters of [`Stribeck`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StribeckParameters<R> {
    /// Coefficients μₛ at rest and μ_d in boundary lubrication.
    pub dry: DryFriction<R>,
    /// Stribeck speed vₛ. *Domain*: 0 < vₛ < ∞.
    pub speed: R,
    /// Stribeck exponent δ; 1 and 2 are usual. *Domain*: 0 < δ < ∞.
    pub exponent: R,
    /// Viscous coefficient k. *Units*: 1/speed. *Domain*: 0 ≤ k < ∞.
    pub viscous: R,
}

/// μ(v) = μ_d + (μₛ − μ_d) exp(−(v/vₛ)^δ) + k v.
///
/// The first two terms are the boundary branch: dry contact that the film lifts away. The last is
/// the hydrodynamic branch: shear of the film.
///
/// *Units*: vₛ in speed, k in 1/speed, the rest dimensionless.
/// *Source*: Stribeck curve in the form of Bo and Pavelescu; thesis fig. 2.8.
///
/// ```
/// use tribos_core::law::{DryFriction, LocalLaw, Stribeck, StribeckParameters};
/// let bearing = Stribeck::new(StribeckParameters {
///     dry: DryFriction::new(0.15_f64, 0.1)?, // μₛ, μ_d
///     speed: 0.01, exponent: 2.0, viscous: 0.5, // m/s, 1, s/m
/// })?;
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
    parameters: StribeckParameters<R>,
}

/// Doublings after which the exponential has died out for every exponent the type can tell.
const DOUBLINGS: usize = 256;

impl<R: Real> Stribeck<R> {
    /// *Domain*: that of [`StribeckParameters`].
    pub fn new(parameters: StribeckParameters<R>) -> Result<Self, LawError> {
        positive("Stribeck speed", parameters.speed)?;
        positive("Stribeck exponent", parameters.exponent)?;
        not_negative("viscous coefficient", parameters.viscous)?;
        Ok(Self { parameters })
    }

    /// μ_d + (μₛ − μ_d) exp(−(v/vₛ)^δ).
    #[inline]
    pub fn boundary(&self, speed: R) -> R {
        self.parameters.dry.mu_dynamic() + self.drop() * self.faded(speed / self.parameters.speed)
    }

    /// k v.
    #[inline]
    pub fn hydrodynamic(&self, speed: R) -> R {
        scaled(self.parameters.viscous, speed)
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
        if !falls || self.parameters.viscous == R::ZERO {
            return None;
        }
        let mut rising = if steepest > self.parameters.speed {
            steepest
        } else {
            self.parameters.speed
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
        self.parameters.dry.mu_static() - self.parameters.dry.mu_dynamic()
    }

    /// exp(−x^δ)
    fn faded(&self, x: R) -> R {
        (-x.pow(self.parameters.exponent)).exp()
    }

    /// Speed at which the boundary branch falls most steeply: rest for δ ≤ 1, else
    /// vₛ ((δ − 1)/δ)^(1/δ).
    fn steepest_fall(&self) -> R {
        if self.parameters.exponent <= R::ONE {
            R::ZERO
        } else {
            let share = (self.parameters.exponent - R::ONE) / self.parameters.exponent;
            self.parameters.speed * share.pow(R::ONE / self.parameters.exponent)
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
        let x = speed / self.parameters.speed;
        let faded = self.faded(x);
        if faded == R::ZERO {
            return self.parameters.viscous;
        }
        let steepness = self.parameters.exponent / self.parameters.speed
            * x.pow(self.parameters.exponent - R::ONE);
        self.parameters.viscous - scaled(self.drop(), steepness * faded)
    }
}
