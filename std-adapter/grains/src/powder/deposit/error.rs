//! Errors of the growth of a deposit.

use super::MOST_SPHERES;
use crate::packing::SizesError;
use tribos_base::space::PeriodicBoxError;

/// Why a deposit cannot be grown.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, DepositError, DepositTarget};
/// // Captured at less than a diameter, spheres would overlap.
/// let inside = Ballistic::new(20.0, 1.0, 1.5);
/// assert_eq!(inside, Err(DepositError::CaptureRadius { given: 1.5, least: 2.0 }));
/// let nothing = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Count(0), 1);
/// assert_eq!(nothing, Err(DepositError::Empty));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DepositError {
    /// A length is not a finite positive number.
    #[error("the {name} must be finite and positive, not {given}")]
    NotPositive {
        /// Name of the length.
        name: &'static str,
        /// Value given.
        given: f64,
    },
    /// The width of the base is not a valid period.
    #[error(transparent)]
    Base(#[from] PeriodicBoxError),
    /// The distribution of the radii is refused.
    #[error(transparent)]
    Sizes(#[from] SizesError),
    /// The bounds of the radii are in the wrong order.
    #[error("the smallest radius, {low}, exceeds the largest, {high}")]
    Radii {
        /// Smallest radius.
        low: f64,
        /// Largest radius.
        high: f64,
    },
    /// Spheres would overlap when captured.
    #[error("the capture radius {given} is less than a diameter; give at least {least}")]
    CaptureRadius {
        /// Value given.
        given: f64,
        /// Smallest valid value.
        least: f64,
    },
    /// A sphere could be captured by two periodic images of another.
    #[error("spheres capture each other over {farthest}: the width {width} must be twice that")]
    Narrow {
        /// Side of the base.
        width: f64,
        /// Largest distance at which spheres are captured.
        farthest: f64,
    },
    /// The deposit has no sphere, or is cut below the first one.
    #[error("a deposit has one sphere or more; ask for one, or for a height above a diameter")]
    Empty,
    /// There are more spheres than fit into memory.
    #[error("the deposit needs more than {MOST_SPHERES} spheres; make it lower or narrower")]
    TooMany,
    /// The observer stopped the growth.
    #[error("the growth of the deposit was stopped")]
    Stopped,
}
