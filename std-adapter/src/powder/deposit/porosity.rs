//! Porosity of a deposit.

use super::Deposit;
use nalgebra::Vector3;
use std::f64::consts::PI;

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
    /// use tribos::powder::deposit::{BULK, Ballistic, Until};
    /// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(Until::Cut(61.5), 1)?;
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

/// Volume of spheres between two heights, with the exact volumes of those cut by a plane.
///
/// ```
/// use nalgebra::Vector3;
/// use std::f64::consts::PI;
/// use tribos::powder::deposit::volume_between;
/// // The lower half of a ball with radius 2, and a cap of it 1 high: π h² (3R − h)/3.
/// let (centre, radius) = ([Vector3::zeros()], [2.0]);
/// let half = volume_between(&centre, &radius, [-2.0, 0.0]);
/// assert!((half - 16.0 / 3.0 * PI).abs() < 1e-13);
/// let cap = volume_between(&centre, &radius, [1.0, 5.0]);
/// assert!((cap - 5.0 / 3.0 * PI).abs() < 1e-13);
/// ```
pub fn volume_between(positions: &[Vector3<f64>], radii: &[f64], [low, high]: [f64; 2]) -> f64 {
    let spheres = positions.iter().zip(radii);
    let between = |(centre, &radius): (&Vector3<f64>, &f64)| {
        volume_below(high - centre.z, radius) - volume_below(low - centre.z, radius)
    };
    spheres.map(between).sum()
}

/// Volume of a sphere below a plane `height` above its centre.
fn volume_below(height: f64, radius: f64) -> f64 {
    if height <= -radius {
        0.0
    } else {
        // A cap of this depth: π depth² (3R − depth)/3.
        let depth = height.min(radius) + radius;
        PI / 3.0 * depth * depth * (3.0 * radius - depth)
    }
}
