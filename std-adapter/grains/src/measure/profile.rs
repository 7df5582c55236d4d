//! Porosity in slices.

use super::{Assembly, Table};
use crate::packing::volume_between;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Porosity in slices across an axis, with the exact volumes of spheres cut by the planes.
#[derive(Clone, Debug, PartialEq)]
pub struct PorosityProfile {
    /// The axis: 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// Slices from low to high: low end, high end, porosity, number of centres.
    pub slices: Vec<[f64; 4]>,
}

/// Free share of the volume of the box.
pub(super) fn porosity(assembly: &Assembly) -> f64 {
    let solid: f64 = assembly
        .radii
        .iter()
        .map(|r| 4.0 / 3.0 * PI * r * r * r)
        .sum();
    1.0 - solid / assembly.volume()
}

impl PorosityProfile {
    pub(super) fn of(assembly: &Assembly, axis: usize, slices: usize) -> Self {
        let [low, high] = assembly.bounds[axis];
        let (places, radii) = along(assembly, axis);
        let area = assembly.volume() / (high - low);
        let edge = |n: usize| low + (high - low) * (n as f64 / slices as f64);
        let slice = |n: usize| {
            let [from, to] = [edge(n), edge(n + 1)];
            let solid = volume_between(&places, &radii, [from, to]);
            // Centres in the box, each in one slice.
            let own = places.iter().take(assembly.positions.len());
            let centres = own.filter(|place| (from..to).contains(&place.z)).count();
            [from, to, 1.0 - solid / (area * (to - from)), centres as f64]
        };
        Self {
            axis,
            slices: (0..slices).map(slice).collect(),
        }
    }

    /// Columns: ends of the slice, porosity, number of centres.
    pub fn table(&self) -> Table {
        Table {
            name: "porosity-profile",
            columns: &["low", "high", "porosity", "centres"],
            rows: self.slices.iter().map(|slice| slice.to_vec()).collect(),
        }
    }
}

/// Places in the cell with the axis as z, and after them the images across a periodic border.
fn along(assembly: &Assembly, axis: usize) -> (Vec<Vector3<f64>>, Vec<f64>) {
    let wrapped = assembly
        .positions
        .iter()
        .map(|place| assembly.space.wrap(place)[axis]);
    let heights: Vec<f64> = wrapped.collect();
    let mut all: Vec<(f64, f64)> = heights
        .iter()
        .copied()
        .zip(assembly.radii.iter().copied())
        .collect();
    if let Some(length) = assembly.space.lengths()[axis] {
        for (height, radius) in heights.iter().zip(&assembly.radii) {
            for image in [height - length, height + length] {
                if image + radius > 0.0 && image - radius < length {
                    all.push((image, *radius));
                }
            }
        }
    }
    all.into_iter()
        .map(|(height, radius)| (Vector3::z() * height, radius))
        .unzip()
}
