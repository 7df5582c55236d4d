//! How much of a deposit is empty.

use super::Deposit;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// The bulk: a quarter of the height away from the substrate, whose spheres stand denser, and from
/// the highest point, below which the last ones stand apart.
pub const BULK: [f64; 2] = [0.25, 0.75];

impl Deposit {
    /// Free share of the volume below the highest point, from 0 to 1.
    ///
    /// *Formula*: 1 − V/(width² height), V the volume of all spheres (thesis, eq. 4.5, at the
    /// piston's start).
    pub fn porosity(&self) -> f64 {
        1.0 - self.solid_fraction(0.0, self.height)
    }

    /// Free share of the volume in the middle half of the height, from 0 to 1: free of the ends
    /// where the deposit is many times higher than its structure.
    pub fn bulk_porosity(&self) -> f64 {
        let [low, high] = BULK.map(|share| share * self.height);
        1.0 - self.solid_fraction(low, high)
    }

    /// Share of the volume between two heights that spheres fill, with the exact volumes of those
    /// cut by a plane. *Domain*: `low` < `high`; NaN for equal heights.
    pub fn solid_fraction(&self, low: f64, high: f64) -> f64 {
        let volume = volume_between(&self.positions, &self.radii, [low, high]);
        volume / (self.width * self.width * (high - low))
    }
}

/// Volume of spheres between two heights, with the exact volumes of those cut by a plane.
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
