//! What files say of spheres besides what they say of atoms.

use super::text::{Line, TextError};
use nalgebra::Vector3;

/// Radii and angular velocities in the order of the atoms.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Spheres {
    /// The line that names the columns.
    pub line: usize,
    pub radii: Option<Vec<f64>>,
    pub spins: Option<Vec<Vector3<f64>>>,
}

impl Spheres {
    /// Empty lists of the properties that the file has.
    pub(super) fn begin(line: Line<'_>, has_radii: bool, has_spins: bool) -> Self {
        Self {
            line: line.number,
            radii: has_radii.then(Vec::new),
            spins: has_spins.then(Vec::new),
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
}
