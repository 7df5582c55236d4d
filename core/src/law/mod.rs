//! Local friction laws: what a surface element that slides with a given speed resists with.

mod coulomb;
mod power;

pub use coulomb::Coulomb;
pub use power::PowerLaw;

use crate::real::Real;

/// A law of the local sliding speed: friction force per unit load, along the velocity.
///
/// *Units*: `speed` in any unit of velocity; the result is dimensionless.
pub trait LocalLaw<R: Real> {
    /// Friction per load at `speed` > 0.
    fn friction(&self, speed: R) -> R;
    /// Derivative of [`LocalLaw::friction`] at `speed` > 0.
    fn slope(&self, speed: R) -> R;
}

/// Why a law was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LawError {
    /// The coefficient is negative, infinite or NaN.
    Coefficient {
        /// What was given.
        given: f64,
    },
    /// The exponent is NaN or not in (−1, `max`].
    Exponent {
        /// What was given.
        given: f64,
        /// Largest exponent of the chosen tier.
        max: f64,
    },
}

impl core::fmt::Display for LawError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Coefficient { given } => {
                write!(
                    f,
                    "the coefficient must be finite and not negative, not {given}"
                )
            }
            Self::Exponent { given, max } => {
                write!(
                    f,
                    "the exponent alpha must satisfy -1 < alpha <= {max}, not {given}"
                )
            }
        }
    }
}

impl core::error::Error for LawError {}

/// `alpha` if −1 < alpha ≤ `max`.
pub(crate) const fn validated_exponent(alpha: f64, max: f64) -> Result<f64, LawError> {
    if alpha > -1.0 && alpha <= max {
        Ok(alpha)
    } else {
        Err(LawError::Exponent { given: alpha, max })
    }
}

/// `coefficient` if finite and not negative.
pub(crate) fn validated_coefficient<R: Real>(coefficient: R) -> Result<R, LawError> {
    if coefficient >= R::ZERO && coefficient.is_finite() {
        Ok(coefficient)
    } else {
        Err(LawError::Coefficient {
            given: coefficient.to_f64(),
        })
    }
}
