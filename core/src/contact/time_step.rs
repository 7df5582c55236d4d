//! The length of a time step.

use crate::real::Real;

/// The length of a time step: positive and finite.
///
/// ```
/// use tribos_core::contact::{TimeStep, TimeStepError};
/// let frame = TimeStep::new(1.0 / 60.0)?; // s
/// assert_eq!(frame.dt(), 1.0 / 60.0);
/// assert_eq!(TimeStep::new(-1e-3), Err(TimeStepError { given: -1e-3 })); // not back in time
/// # Ok::<(), TimeStepError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TimeStep<R>(R);

/// A step that is zero, negative, infinite or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TimeStepError {
    /// What was given.
    pub given: f64,
}

impl<R: Real> TimeStep<R> {
    /// *Domain*: 0 < `dt` < ∞.
    pub fn new(dt: R) -> Result<Self, TimeStepError> {
        if dt > R::ZERO && dt.is_finite() {
            Ok(Self(dt))
        } else {
            let given = dt.to_f64();
            Err(TimeStepError { given })
        }
    }

    /// The length Δt.
    pub fn dt(self) -> R {
        self.0
    }
}

impl core::fmt::Display for TimeStepError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let given = self.given;
        write!(f, "a time step must be positive and finite, not {given}")
    }
}

impl core::error::Error for TimeStepError {}
