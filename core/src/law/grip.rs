//! Whether a contact sticks.

use crate::real::Real;

/// State of a contact.
///
/// ```
/// use tribos_core::law::{DryFriction, StickSlip};
/// let floor = DryFriction::new(0.5_f64, 0.4)?;
/// let weight = 200.0; // N
/// let pushed = [90.0, 110.0].map(|push| floor.at_rest(push / weight));
/// assert_eq!(pushed, [StickSlip::Stick, StickSlip::Slip]);
/// assert_eq!(floor.at_rest(f64::NAN), StickSlip::Slip); // what is not known holds nothing
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StickSlip {
    /// At rest, and friction balances what drives it.
    Stick,
    /// In motion, or about to be.
    Slip,
}

impl StickSlip {
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
