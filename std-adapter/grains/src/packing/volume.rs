//! Volumes of spheres that planes cut.

use nalgebra::Vector3;
use std::f64::consts::PI;

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
