//! Porosity of a deposit.

use super::Deposit;
use crate::packing::volume_between;

/// The bulk: a quarter of the height away from the substrate, near which spheres are denser, and from
/// the highest point, below which the last spheres are sparse.
pub const BULK: [f64; 2] = [0.25, 0.75];

impl Deposit {
    /// Porosity: free share of the volume below the highest point, from 0 to 1.
    ///
    /// *Formula*: 1 − V/(width² height), V the volume of all spheres (thesis, eq. 4.5, with the piston in its
    /// initial position).
    pub fn porosity(&self) -> f64 {
        1.0 - self.solid_fraction(0.0, self.height)
    }

    /// Porosity in the middle half of the height, from 0 to 1: free of end effects if
    /// the deposit is many times higher than its structure.
    ///
    /// ```
    /// use tribos::powder::deposit::{BULK, Ballistic, DepositTarget};
    /// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Cut(61.5), 1)?;
    /// let [low, high] = BULK.map(|share| share * deposit.height);
    /// assert_eq!(deposit.bulk_porosity(), 1.0 - deposit.solid_fraction(low, high));
    /// // The two halves of a deposit hold all of its spheres.
    /// let (middle, top) = (0.5 * deposit.height, deposit.height);
    /// let halves = deposit.solid_fraction(0.0, middle) + deposit.solid_fraction(middle, top);
    /// assert!((1.0 - 0.5 * halves - deposit.porosity()).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bulk_porosity(&self) -> f64 {
        let [low, high] = BULK.map(|share| share * self.height);
        1.0 - self.solid_fraction(low, high)
    }

    /// Solid fraction between two heights, with the exact volumes of spheres
    /// cut by a plane. *Domain*: `low` < `high`; NaN for equal heights.
    pub fn solid_fraction(&self, low: f64, high: f64) -> f64 {
        let volume = volume_between(&self.positions, &self.radii, [low, high]);
        volume / (self.width * self.width * (high - low))
    }
}
