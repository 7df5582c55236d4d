//! Whether a contact sticks.

use crate::real::Real;

/// State of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Grip {
    /// At rest, and friction balances what drives it.
    Stick,
    /// In motion, or about to be.
    Slip,
}

impl Grip {
    /// Sticks for |`drive`| ≤ `limit`; NaN slips.
    #[inline]
    pub(super) fn of<R: Real>(drive: R, limit: R) -> Self {
        if drive.abs() <= limit {
            Self::Stick
        } else {
            Self::Slip
        }
    }
}
