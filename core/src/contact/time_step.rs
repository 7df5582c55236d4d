//! The length of a time step.

use crate::law::{LawError, validated_positive};
use crate::real::Real;

/// The length of a time step: positive and finite.
///
/// ```
/// use tribos_core::contact::TimeStep;
/// let frame = TimeStep::new(1.0 / 60.0)?; // s
/// assert_eq!(frame.dt(), 1.0 / 60.0);
/// assert!(TimeStep::new(-1e-3).is_err()); // not back in time
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TimeStep<R>(R);

impl<R: Real> TimeStep<R> {
    /// *Domain*: 0 < `dt` < ∞.
    pub fn new(dt: R) -> Result<Self, LawError> {
        Ok(Self(validated_positive("time step", dt)?))
    }

    /// The length Δt.
    pub fn dt(self) -> R {
        self.0
    }
}
