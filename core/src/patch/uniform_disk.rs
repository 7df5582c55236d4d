//! A flat circular contact with the same pressure everywhere.

use super::PatchError;
use crate::real::Real;

/// Pressure N/(πR²) on a disk of radius R (eq. 3.1).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UniformDisk<R> {
    radius: R,
}

impl<R: Real> UniformDisk<R> {
    /// *Domain*: 0 < `radius` < ∞. *Units*: length.
    pub fn new(radius: R) -> Result<Self, PatchError> {
        if radius > R::ZERO && radius.is_finite() {
            Ok(Self { radius })
        } else {
            Err(PatchError::Radius {
                given: radius.to_f64(),
            })
        }
    }

    /// The radius R of the contact.
    pub fn radius(&self) -> R {
        self.radius
    }
}
