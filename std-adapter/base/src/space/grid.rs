//! A coarse grid over positions, with a limited number of cells.

use super::PeriodicBox;
use nalgebra::Vector3;
use std::ops::RangeInclusive;

/// Largest number of cells per particle; cells smaller than the particles' distance only cost time.
const CELLS_PER_PARTICLE: f64 = 4.0;

/// Cells per edge along x. Cells of a row are adjacent in memory, so that narrow ones leave out more
/// particles at no cost.
const CELLS_PER_EDGE: f64 = 3.0;

/// Relative tolerance for the rounding of a position, a difference and a cell number, about 1e-15.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// One axis cut into cells; the first and the last of an open one have no outer end.
#[derive(Clone, Copy, Debug, Default)]
struct Axis {
    length: Option<f64>,
    low: f64,
    inv_width: f64,
    cells: usize,
    /// Largest displacement of a position by rounding, in the unit of positions.
    rounding: f64,
}

/// Cells over three axes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Grid {
    axes: [Axis; 3],
}

impl Grid {
    /// Cells about `edge` wide over `positions`, a third of it along x, wider if there would be too many.
    /// *Domain*: finite positions.
    pub fn new(space: &PeriodicBox, positions: &[Vector3<f64>], edge: f64) -> Self {
        let most = (CELLS_PER_PARTICLE * positions.len() as f64).max(1.0);
        let mut extents = [[0.0; 2]; 3];
        let mut counts = [1.0; 3];
        for axis in 0..3 {
            extents[axis] = extent(space.lengths()[axis], axis, positions);
            let [low, high] = extents[axis];
            let width = if axis == 0 {
                edge / CELLS_PER_EDGE
            } else {
                edge
            };
            counts[axis] = cells_along(high - low, width);
        }
        // Halve the finest axis until the cells are few.
        while counts.iter().product::<f64>() > most {
            let finest = (0..3).fold(0, |a, b| if counts[b] > counts[a] { b } else { a });
            counts[finest] = (0.5 * counts[finest]).floor();
        }
        Self {
            axes: std::array::from_fn(|axis| {
                Axis::new(space.lengths()[axis], extents[axis], counts[axis])
                    .with_roundings(axis, positions)
            }),
        }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.axes.iter().map(|axis| axis.cells).product()
    }

    /// The cell of a position.
    pub fn cell(&self, place: &Vector3<f64>) -> usize {
        let [x, y, z] = self.axes;
        let row = self.row(y.cell(place.y), z.cell(place.z));
        row + x.cell(place.x)
    }

    /// First cell of a row along x.
    fn row(&self, y: usize, z: usize) -> usize {
        (z * self.axes[1].cells + y) * self.axes[0].cells
    }

    /// Calls `visit` with every run of adjacent cells that may contain positions within `reach`
    /// of `place`, each cell once.
    pub fn near(
        &self,
        place: &Vector3<f64>,
        reach: f64,
        mut visit: impl FnMut(RangeInclusive<usize>),
    ) {
        let [x, y, z] = self.axes;
        let along_x = x.near(place.x, reach);
        for z in z.near(place.z, reach).into_iter().flatten().flatten() {
            for y in y.near(place.y, reach).into_iter().flatten().flatten() {
                let row = self.row(y, z);
                for run in along_x.iter().flatten() {
                    visit(row + run.start()..=row + run.end());
                }
            }
        }
    }
}

/// Where the cells along an axis begin and end.
fn extent(length: Option<f64>, axis: usize, positions: &[Vector3<f64>]) -> [f64; 2] {
    match length {
        Some(length) => [0.0, length],
        None => positions
            .iter()
            .map(|place| place[axis])
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
                [low.min(x), high.max(x)]
            }),
    }
}

/// Cells along an axis whose cube is still a finite number, about the cube root of the largest one.
const MOST_CELLS: f64 = 5.6e102;

/// Whole cells at least `edge` wide, one or more.
fn cells_along(extent: f64, edge: f64) -> f64 {
    let cells = (extent / edge).floor();
    // The other branch also handles 0/0 and the absence of particles.
    if cells >= 1.0 {
        cells.min(MOST_CELLS)
    } else {
        1.0
    }
}

impl Axis {
    fn new(length: Option<f64>, [low, high]: [f64; 2], cells: f64) -> Self {
        let inv_width = cells / (high - low);
        Self {
            length,
            low,
            // All positions coincide: one cell.
            inv_width: if inv_width.is_finite() {
                inv_width
            } else {
                0.0
            },
            cells: cells as usize,
            rounding: 0.0,
        }
    }

    /// Sets the rounding tolerance from the size of the coordinates.
    fn with_roundings(mut self, axis: usize, positions: &[Vector3<f64>]) -> Self {
        let largest = positions
            .iter()
            .fold(self.length.unwrap_or(0.0), |most, place| {
                most.max(place[axis].abs())
            });
        self.rounding = ROUNDING * largest;
        self
    }

    /// Cell of a coordinate; never decreases with it.
    fn cell(&self, x: f64) -> usize {
        (((x - self.low) * self.inv_width) as usize).min(self.cells - 1)
    }

    /// Cells within `reach` of a coordinate: one run, or two where it crosses the end of a period.
    fn near(&self, x: f64, reach: f64) -> [Option<RangeInclusive<usize>>; 2] {
        let reach = reach * (1.0 + ROUNDING) + self.rounding;
        let (low, high) = (x - reach, x + reach);
        let last = self.cells - 1;
        let (from, to) = (self.cell(low), self.cell(high));
        match self.length {
            Some(length) if low < 0.0 || high >= length => {
                // One of the ends comes back in from the other side.
                let (from, to) = if low < 0.0 {
                    (self.cell(low + length), to)
                } else {
                    (from, self.cell(high - length))
                };
                if from <= to {
                    [Some(0..=last), None]
                } else {
                    [Some(0..=to), Some(from..=last)]
                }
            }
            _ => [Some(from..=to), None],
        }
    }
}
