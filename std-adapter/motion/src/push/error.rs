//! Why a push is refused.

use tribos_base::record::brief;
use tribos_base::scene::InvalidScene;
use tribos_friction::FrictionError;

/// A contact, a friction set or a path that no push can be computed for.
///
/// ```
/// use tribos::push::{PointContact, PushError};
/// let nowhere = PointContact::new([0.0, 0.0], [0.0, 0.0], 0.3);
/// assert!(matches!(nowhere, Err(PushError::Normal)));
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PushError {
    /// A number is infinite or NaN, or has the wrong sign.
    #[error("{what} must be {domain}, not {given}")]
    Number {
        /// Which one.
        what: &'static str,
        /// What it may be.
        domain: &'static str,
        /// What was given.
        given: f64,
    },
    /// The inward normal of a contact is zero.
    #[error("the inward normal must have a direction")]
    Normal,
    /// The two ends of a line contact coincide.
    #[error("the ends of a line contact must lie apart")]
    Line,
    /// The floor carries no friction: any force moves the body at any speed.
    #[error("the force limit of the body on the floor must be finite and > 0, not {0}")]
    Frictionless(f64),
    /// The search for the motion under a push missed: the body would not follow its pusher.
    #[error(
        "the motion under the push was not found: {} m/s of the pusher's velocity are left at the contact; lengths \
         and loads of the patch are too far apart",
        brief(.left)
    )]
    NotFound {
        /// Velocity of the pusher that neither the body nor the slip takes, in m/s.
        left: f64,
    },
    /// The steps of a path became too short to go on.
    #[error(
        "the path cannot be followed beyond {} s to a tolerance of {tolerance}; allow a larger one",
        brief(.time)
    )]
    Steps {
        /// Where it stopped.
        time: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// The patch of a scene.
    #[error(transparent)]
    Refusal(#[from] FrictionError),
    /// A scene that was made in a program.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
}

/// The number, if it is finite.
pub(super) fn finite(what: &'static str, given: f64) -> Result<f64, PushError> {
    let domain = "a finite number";
    match given.is_finite() {
        true => Ok(given),
        false => Err(PushError::Number {
            what,
            domain,
            given,
        }),
    }
}

/// The number, if it is finite and at least 0.
pub(super) fn not_negative(what: &'static str, given: f64) -> Result<f64, PushError> {
    let domain = "a finite number >= 0";
    match given.is_finite() && given >= 0.0 {
        true => Ok(given),
        false => Err(PushError::Number {
            what,
            domain,
            given,
        }),
    }
}
