//! Why nothing is deposited.

use super::MOST_SPHERES;
use crate::space::PeriodicBoxError;

/// A deposit that cannot be grown.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, DepositError, Until};
/// // Captured at less than a diameter, spheres would overlap.
/// let inside = Ballistic::new(20.0, 1.0, 1.5);
/// assert_eq!(inside, Err(DepositError::CaptureRadius { given: 1.5, least: 2.0 }));
/// let nothing = Ballistic::new(20.0, 1.0, 3.0)?.grow(Until::Count(0), 1);
/// assert_eq!(nothing, Err(DepositError::Empty));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DepositError {
    /// A length is not a finite positive number.
    #[error("the {name} must be finite and positive, not {given}")]
    NotPositive {
        /// Which one.
        name: &'static str,
        /// What was given.
        given: f64,
    },
    /// The base is no period.
    #[error(transparent)]
    Base(#[from] PeriodicBoxError),
    /// The bounds of the radii are in the wrong order.
    #[error("the smallest radius, {low}, exceeds the largest, {high}")]
    Radii {
        /// Smallest radius.
        low: f64,
        /// Largest radius.
        high: f64,
    },
    /// Spheres would be captured inside each other.
    #[error("the capture radius {given} is less than a diameter; give at least {least}")]
    CaptureRadius {
        /// What was given.
        given: f64,
        /// Least possible.
        least: f64,
    },
    /// A sphere could be captured by two images of another.
    #[error("spheres capture each other over {farthest}: the width {width} must be twice that")]
    Narrow {
        /// Side of the base.
        width: f64,
        /// Largest distance of capture.
        farthest: f64,
    },
    /// No sphere at all, or a cut below the first.
    #[error("a deposit has one sphere or more; ask for one, or for a height above a diameter")]
    Empty,
    /// More spheres than memory.
    #[error("the deposit needs more than {MOST_SPHERES} spheres; make it lower or narrower")]
    TooMany,
    /// Whoever watched the growth stopped it.
    #[error("the growth of the deposit was stopped")]
    Stopped,
}
