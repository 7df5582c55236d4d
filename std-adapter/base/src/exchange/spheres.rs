//! What files say of spheres besides what they say of atoms.

use super::text::{Line, TextError};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// What a column says of how heavy a sphere is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Weight {
    Density,
    Mass,
}

/// A box that may repeat, and lean along x over z.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    /// Low and high end along each axis, if the file says them.
    pub bounds: Option<[[f64; 2]; 3]>,
    /// Displacement along x of the images one period higher along z.
    pub tilt: f64,
    /// Axes along which space repeats; none without bounds.
    pub is_periodic: [bool; 3],
    /// Whether the file does not say which axes are periodic.
    pub is_silent: bool,
}

/// Radii and angular velocities in the order of the atoms.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spheres {
    /// The line that names the columns.
    pub line: usize,
    /// Radii, where the file has them.
    pub radii: Option<Vec<f64>>,
    /// Angular velocities, where the file has them.
    pub spins: Option<Vec<Vector3<f64>>>,
    /// Numbers of the materials from 1, where the file has a column of them that is not the species.
    pub materials: Option<Vec<u8>>,
    /// Densities, where the file has them or masses.
    pub densities: Option<Vec<f64>>,
    /// Displacement along x of the images one period higher along z.
    pub tilt: f64,
    /// Whether the file does not say which axes are periodic.
    pub is_silent: bool,
}

/// The refusal of a box with angles.
pub(super) fn tilted(line: usize) -> TextError {
    TextError::Unsupported {
        line,
        what: "a tilted box".into(),
        cure: "atoms have orthogonal boxes, spheres also boxes that lean along x over z: cut such a cell",
    }
}

impl Spheres {
    /// Empty lists of the properties that the file has: radii, spins, densities.
    pub(super) fn begin(line: Line<'_>, [radii, spins, densities]: [bool; 3]) -> Self {
        Self {
            line: line.number,
            radii: radii.then(Vec::new),
            spins: spins.then(Vec::new),
            densities: densities.then(Vec::new),
            ..Self::default()
        }
    }

    /// Refuses a box that leans: atoms have orthogonal ones.
    pub(super) fn upright(&self) -> Result<(), TextError> {
        if self.tilt == 0.0 {
            Ok(())
        } else {
            Err(tilted(self.line))
        }
    }

    /// Adds the radius of a sphere, if there is a column of them.
    pub(super) fn add_radius(
        &mut self,
        line: Line<'_>,
        word: &str,
        factor: f64,
    ) -> Result<(), TextError> {
        if let Some(radii) = &mut self.radii {
            radii.push(factor * line.positive("the size of a sphere", word)?);
        }
        Ok(())
    }

    /// Adds the density of a sphere, if there is a column of them or of masses.
    pub(super) fn add_density(
        &mut self,
        line: Line<'_>,
        word: &str,
        kind: Weight,
    ) -> Result<(), TextError> {
        let Some(densities) = &mut self.densities else {
            return Ok(());
        };
        let radius = self.radii.as_ref().and_then(|radii| radii.last().copied());
        densities.push(match (kind, radius) {
            (Weight::Mass, Some(radius)) => {
                let mass = line.positive("the mass of a sphere", word)?;
                mass / (4.0 / 3.0 * PI * radius * radius * radius)
            }
            _ => line.positive("the density of a sphere", word)?,
        });
        Ok(())
    }
}
