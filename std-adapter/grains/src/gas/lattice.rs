//! The cube of a gas and the sites on which its spheres start.

use nalgebra::Vector3;
use std::f64::consts::{PI, SQRT_2};

/// Distance of neighbouring sites at least, in R.
const APART: f64 = 2.0 + 1e-6;
/// The narrowest cube, in R: what the cells of events need.
const NARROWEST: f64 = 6.0 + 1e-6;
/// Most cells of the lattice along an edge.
const MOST: f64 = 1000.0;

/// Edge of the cube of so many spheres at a packing fraction.
pub(crate) fn edge(count: usize, fraction: f64) -> f64 {
    libm::cbrt(count as f64 * 4.0 / 3.0 * PI / fraction)
}

/// Whether a cube of this edge is wide enough.
pub(crate) fn is_wide(length: f64) -> bool {
    length >= NARROWEST
}

/// Cells along an edge of the closest lattice that the spheres fit on: face-centred cubic, with vacancies at
/// random, so that it melts.
pub(crate) fn lattice(count: usize, length: f64) -> Option<usize> {
    let cells = (length / (SQRT_2 * APART)).floor().min(MOST) as usize;
    (4 * cells * cells * cells >= count).then_some(cells)
}

/// Site of a lattice of so many cells along the edge of the cube.
pub(super) fn site(number: usize, cells: usize, length: f64) -> Vector3<f64> {
    /// Sites of a cell, in halves of its edge.
    const SITES: [[f64; 3]; 4] = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
    ];
    let (cell, kind) = (number / 4, number % 4);
    let corner = [cell % cells, cell / cells % cells, cell / (cells * cells)];
    let half = 0.5 * length / cells as f64;
    let at = |axis: usize| (2.0 * corner[axis] as f64 + SITES[kind][axis]) * half;
    Vector3::new(at(0), at(1), at(2))
}
