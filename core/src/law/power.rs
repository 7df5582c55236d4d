//! Friction that grows or falls with a power of the speed.

use super::limits::scaled;
use super::{LawError, LocalLaw, validated_coefficient, validated_exponent};
use crate::real::Real;

/// γ|v|^α for real α > −1.
///
/// The dissipation potential γ|v|^(α+1)/(α+1) is convex only for α ≥ 0: below, friction falls with
/// speed, diverges at rest, and neither uniqueness nor implicit steps are promised.
///
/// *Units*: γ carries (time/length)^α. (The thesis writes γ^α for γ.)
/// *Source*: eq. 3.6.
///
/// ```
/// use tribos_core::law::{LocalLaw, PowerLaw};
/// let ice = PowerLaw::new(-0.5_f64, 0.008)?; // speeds in m/s
/// assert_eq!(ice.friction(1.0), ice.coefficient());
/// assert!((ice.friction(4.0) - 0.004).abs() < 1e-17); // half at four times the speed
/// let steepness = ice.slope(4.0) * 4.0 / ice.friction(4.0); // d ln(friction)/d ln(speed)
/// assert!((steepness - ice.alpha()).abs() < 1e-15);
/// assert!(!ice.is_convex()); // falls with speed
/// assert!(PowerLaw::new(2.0 * PowerLaw::<f64>::MAX_EXPONENT, 0.008).is_err());
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerLaw<R> {
    alpha: R,
    coefficient: R,
}

impl<R: Real> PowerLaw<R> {
    /// Largest exponent of the law: beyond it, reduced forces overflow for ordinary speeds.
    pub const MAX_EXPONENT: f64 = 128.0;

    /// *Domain*: −1 < `alpha` ≤ [`PowerLaw::MAX_EXPONENT`], 0 ≤ `coefficient` < ∞.
    pub fn new(alpha: R, coefficient: R) -> Result<Self, LawError> {
        validated_exponent(alpha.to_f64(), Self::MAX_EXPONENT)?;
        Ok(Self {
            alpha,
            coefficient: validated_coefficient(coefficient)?,
        })
    }

    /// The exponent α.
    pub fn alpha(&self) -> R {
        self.alpha
    }

    /// The coefficient γ.
    pub fn coefficient(&self) -> R {
        self.coefficient
    }

    /// True for α ≥ 0: the potential is convex and friction monotone.
    pub fn is_convex(&self) -> bool {
        self.alpha >= R::ZERO
    }
}

impl<R: Real> LocalLaw<R> for PowerLaw<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        scaled(self.coefficient, power(speed, self.alpha))
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        let slope = power(speed, self.alpha - R::ONE);
        scaled(self.coefficient * self.alpha, slope)
    }
}

/// `speed` to the power `exponent`; NaN stays NaN, also to the power 0.
#[inline]
fn power<R: Real>(speed: R, exponent: R) -> R {
    if speed.is_nan() {
        speed
    } else {
        speed.pow(exponent)
    }
}
