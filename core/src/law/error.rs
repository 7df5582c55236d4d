//! Validation of law parameters.

use crate::real::Real;

/// An invalid parameter of a law, or of what it acts on: an inertia, a limit, a time step.
///
/// ```
/// use tribos_core::law::{CoulombLaw, DryFriction, LawError};
/// assert_eq!(CoulombLaw::new(-0.3), Err(LawError::Coefficient { given: -0.3 }));
/// let swapped = DryFriction::new(0.3, 0.5).map_err(|error| error.to_string());
/// let reason = "the static coefficient must not be below the dynamic coefficient";
/// assert_eq!(swapped, Err(reason.to_string()));
/// ```
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
    /// The exponent is not 0; dry friction requires α = 0.
    NotDry {
        /// What was given.
        given: f64,
    },
    /// A parameter is zero, negative, infinite or NaN.
    NotPositive {
        /// Which one.
        parameter: &'static str,
        /// What was given.
        given: f64,
    },
    /// A parameter is negative, infinite or NaN.
    Negative {
        /// Which one.
        parameter: &'static str,
        /// What was given.
        given: f64,
    },
    /// A parameter of either sign is infinite or NaN.
    NotFinite {
        /// Which one.
        parameter: &'static str,
        /// What was given.
        given: f64,
    },
    /// A fraction is NaN or not in [0, 1].
    NotAFraction {
        /// Which one.
        parameter: &'static str,
        /// What was given.
        given: f64,
    },
    /// Two parameters are in the wrong order.
    Order {
        /// The one that must not be the larger.
        smaller: &'static str,
        /// The one that must not be the smaller.
        larger: &'static str,
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
            Self::NotDry { given } => {
                write!(f, "dry friction has the exponent alpha = 0, not {given}")
            }
            Self::Exponent { given, max } => {
                write!(
                    f,
                    "the exponent alpha must satisfy -1 < alpha <= {max}, not {given}"
                )
            }
            Self::NotPositive { parameter, given } => {
                write!(
                    f,
                    "the {parameter} must be positive and finite, not {given}"
                )
            }
            Self::Negative { parameter, given } => {
                write!(
                    f,
                    "the {parameter} must be finite and not negative, not {given}"
                )
            }
            Self::NotFinite { parameter, given } => {
                write!(f, "the {parameter} must be finite, not {given}")
            }
            Self::NotAFraction { parameter, given } => {
                write!(f, "the {parameter} must be between 0 and 1, not {given}")
            }
            Self::Order { smaller, larger } => {
                write!(f, "the {larger} must not be below the {smaller}")
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

/// `value` if positive and finite.
pub(crate) fn positive<R: Real>(parameter: &'static str, value: R) -> Result<R, LawError> {
    if value > R::ZERO && value.is_finite() {
        Ok(value)
    } else {
        Err(LawError::NotPositive {
            parameter,
            given: value.to_f64(),
        })
    }
}

/// `value` if finite and not negative.
pub(crate) fn not_negative<R: Real>(parameter: &'static str, value: R) -> Result<R, LawError> {
    if value >= R::ZERO && value.is_finite() {
        Ok(value)
    } else {
        Err(LawError::Negative {
            parameter,
            given: value.to_f64(),
        })
    }
}

/// `value` if finite.
pub(crate) fn finite<R: Real>(parameter: &'static str, value: R) -> Result<R, LawError> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(LawError::NotFinite {
            parameter,
            given: value.to_f64(),
        })
    }
}

/// `value` if in [0, 1].
pub(crate) fn fraction<R: Real>(parameter: &'static str, value: R) -> Result<R, LawError> {
    if value >= R::ZERO && value <= R::ONE {
        Ok(value)
    } else {
        Err(LawError::NotAFraction {
            parameter,
            given: value.to_f64(),
        })
    }
}

/// Accepts `low` ≤ `high`.
pub(super) fn ordered<R: Real>(
    (smaller, low): (&'static str, R),
    (larger, high): (&'static str, R),
) -> Result<(), LawError> {
    if low <= high {
        Ok(())
    } else {
        Err(LawError::Order { smaller, larger })
    }
}
