//! Dry friction that does not depend on speed.

use super::{LawError, LocalLaw, validated_coefficient};
use crate::real::Real;

/// Coulomb's law: friction = μ × load, against the sliding velocity.
///
/// *Units*: μ is dimensionless. *Source*: eq. 3.6 with α = 0.
///
/// ```
/// use tribos_core::law::{CoulombLaw, LocalLaw};
/// let rubber = CoulombLaw::new(0.8_f64)?;
/// let [creeping, fast] = [1e-6, 10.0].map(|speed| rubber.friction(speed) * 12.0); // m/s, N
/// assert_eq!(creeping, fast);
/// assert_eq!(fast, rubber.mu() * 12.0);
/// assert_eq!(rubber.slope(10.0), 0.0);
/// assert!((rubber.friction_angle().tan() - 0.8).abs() < 1e-15); // a slope of 39 degrees
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombLaw<R> {
    mu: R,
}

impl<R: Real> CoulombLaw<R> {
    /// *Domain*: 0 ≤ `mu` < ∞.
    pub fn new(mu: R) -> Result<Self, LawError> {
        Ok(Self {
            mu: validated_coefficient(mu)?,
        })
    }

    /// The dynamic friction coefficient μ.
    pub fn mu(&self) -> R {
        self.mu
    }

    /// Angle of friction atan μ: the steepest slope on which a body holds whose static coefficient
    /// is μ.
    ///
    /// *Units*: radians. *Source*: Euler; thesis section 2.1, fig. 2.2.
    #[inline]
    pub fn friction_angle(&self) -> R {
        self.mu.atan()
    }
}

impl<R: Real> LocalLaw<R> for CoulombLaw<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        if speed.is_nan() { speed } else { self.mu }
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        if speed.is_nan() { speed } else { R::ZERO }
    }
}
