//! What is measured of a gas at one time.

use nalgebra::Vector3;
use tribos_contacts::event::{Motion, Temperatures};

/// Moment of inertia of a sphere.
const INERTIA: f64 = 0.4;
/// Mean number of spheres in a cell in which they are counted.
const A_CELL: f64 = 8.0;

/// Places, velocities and spins at one time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct GasState {
    pub places: Vec<Vector3<f64>>,
    pub motions: Vec<Motion>,
}

impl GasState {
    /// Mean energies of motion relative to the centre of mass, and of spin.
    pub fn temperatures(&self) -> Temperatures {
        let count = self.motions.len() as f64;
        let mean = self.momentum() / count;
        let moving = |motion: &Motion| (motion.velocity - mean).norm_squared();
        let spinning = |motion: &Motion| INERTIA * motion.spin.norm_squared();
        Temperatures {
            translational: self.motions.iter().map(moving).sum::<f64>() / (3.0 * count),
            rotational: self.motions.iter().map(spinning).sum::<f64>() / (3.0 * count),
        }
    }

    /// Kinetic energy a sphere.
    pub fn energy(&self) -> f64 {
        let square =
            |motion: &Motion| motion.velocity.norm_squared() + INERTIA * motion.spin.norm_squared();
        let sum: f64 = self.motions.iter().map(square).sum();
        0.5 * sum / self.motions.len() as f64
    }

    /// Total momentum.
    pub fn momentum(&self) -> Vector3<f64> {
        self.motions.iter().map(|motion| motion.velocity).sum()
    }

    /// Variance of the numbers of spheres in cells of about eight, over their mean: 1 if places are independent,
    /// less in a dense fluid, and more in clusters.
    pub fn density_variance(&self, length: f64) -> f64 {
        let spheres = self.places.len() as f64;
        let edge = libm::cbrt(spheres / A_CELL).floor().max(1.0) as usize;
        let mut counts = vec![0_u32; edge * edge * edge];
        let along = |x: f64| ((x / length * edge as f64) as usize).min(edge - 1);
        for place in &self.places {
            let [x, y, z] = [along(place.x), along(place.y), along(place.z)];
            counts[(z * edge + y) * edge + x] += 1;
        }
        let mean = spheres / counts.len() as f64;
        let square = |&count: &u32| {
            let off = f64::from(count) - mean;
            off * off
        };
        counts.iter().map(square).sum::<f64>() / spheres
    }
}
