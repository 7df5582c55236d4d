//! Stress of a packing: contacts and fluctuations of the motion.

use super::Assembly;
use crate::packing::Stress;
use crate::packing::branch;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;

/// Mean stress in the box, positive for compression. *Units*: force over area.
///
/// *Formula*: σ_ij = Σ F_i l_j/V over the contacts (thesis, eq. 4.10, with the opposite sign), plus
/// Σ m u_i u_j/V over the spheres with u the velocity relative to their centre of mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StressTensor {
    /// Share of the contacts that push.
    pub plus: Matrix3<f64>,
    /// Share of the contacts that pull.
    pub minus: Matrix3<f64>,
    /// Share of the fluctuations of the motion.
    pub kinetic: Matrix3<f64>,
}

impl StressTensor {
    pub(super) fn of(assembly: &Assembly, density: Option<f64>) -> Self {
        let volume = assembly.volume();
        let along = |row: &_| branch(row, &assembly.radii);
        let stress = Stress::of(&assembly.contacts, along, volume);
        Self {
            plus: stress.plus,
            minus: stress.minus,
            kinetic: kinetic(assembly, density) / volume,
        }
    }

    /// Sum of all shares.
    pub fn total(&self) -> Matrix3<f64> {
        self.plus + self.minus + self.kinetic
    }

    /// Mean pressure, a third of the trace.
    pub fn pressure(&self) -> f64 {
        self.total().trace() / 3.0
    }

    /// Deviator q = √(3/2 s:s), s the deviatoric part: |σ_1 − σ_3| of uniaxial stress.
    pub fn deviator(&self) -> f64 {
        let total = self.total();
        let symmetric = (total + total.transpose()) * 0.5;
        let deviatoric = symmetric - Matrix3::identity() * self.pressure();
        (1.5 * deviatoric.norm_squared()).sqrt()
    }
}

/// Masses with the density that is given, or those of the spheres, or that of the scene, or 1.
pub(super) fn masses(assembly: &Assembly, density: Option<f64>) -> Vec<f64> {
    let of_scene = assembly.scene["density"].as_f64().unwrap_or(1.0);
    let own = |sphere: usize| assembly.densities.as_ref()?.get(sphere).copied();
    let mass = |(sphere, r): (usize, &f64)| {
        let density = density.or_else(|| own(sphere)).unwrap_or(of_scene);
        density * (4.0 / 3.0 * PI * r * r * r)
    };
    assembly.radii.iter().enumerate().map(mass).collect()
}

/// Σ m u u.
fn kinetic(assembly: &Assembly, density: Option<f64>) -> Matrix3<f64> {
    let Some(velocities) = &assembly.velocities else {
        return Matrix3::zeros();
    };
    let masses = masses(assembly, density);
    let moving = || velocities.iter().zip(&masses);
    let total: f64 = masses.iter().sum();
    let momentum: Vector3<f64> = moving().map(|(velocity, mass)| velocity * *mass).sum();
    let mean = momentum / total;
    moving()
        .map(|(velocity, mass)| (velocity - mean) * (velocity - mean).transpose() * *mass)
        .sum()
}
