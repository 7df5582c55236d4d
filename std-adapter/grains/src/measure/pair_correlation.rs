//! Pair correlation of the centres.

use super::{Assembly, Table};
use std::f64::consts::PI;
use tribos_base::space::SpaceError;
use tribos_base::space::pairs::Cells;

/// Reach without a choice, in mean radii.
const REACH: f64 = 10.0;

/// Pair correlation g(r): number of centres at a distance r from another, over that of an ideal gas of the same
/// density.
///
/// Across open axes only spheres farther than r from the faces of the box count as centres (minus sampling), so
/// that g needs no correction there. Bins without such a sphere are NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct PairCorrelation {
    /// Width of a bin; bin k is from k to k + 1 widths.
    pub width: f64,
    /// g in each bin.
    pub values: Vec<f64>,
    /// Mean number of centres up to the end of each bin.
    pub within: Vec<f64>,
}

impl PairCorrelation {
    pub(super) fn of(
        assembly: &Assembly,
        reach: Option<f64>,
        bins: usize,
    ) -> Result<Self, SpaceError> {
        let reach = reach.unwrap_or_else(|| usual(assembly));
        let width = reach / bins as f64;
        let (counts, centres) = counts(assembly, reach, bins)?;
        let density = assembly.positions.len() as f64 / assembly.volume();
        let edge = |k: usize| k as f64 * width;
        let mean = |k: usize| counts[k] / centres[k];
        let ideal = |k: usize| {
            let (low, high) = (edge(k), edge(k + 1));
            density * 4.0 / 3.0 * PI * (high * high * high - low * low * low)
        };
        let mut sum = 0.0;
        let so_far = |k: usize| {
            sum += mean(k);
            sum
        };
        Ok(Self {
            width,
            values: (0..bins).map(|k| mean(k) / ideal(k)).collect(),
            within: (0..bins).map(so_far).collect(),
        })
    }

    /// Columns r (middle of the bin), g and the number of centres up to the end of the bin.
    pub fn table(&self) -> Table {
        let bins = self.values.iter().zip(&self.within).enumerate();
        let row = |(k, (g, within)): (usize, (&f64, &f64))| {
            vec![(k as f64 + 0.5) * self.width, *g, *within]
        };
        Table {
            name: "pair-correlation",
            columns: &["r", "g", "within"],
            rows: bins.map(row).collect(),
        }
    }
}

/// Ten mean radii, half of every period, or a third of an open side.
fn usual(assembly: &Assembly) -> f64 {
    /// Least distance from half a period.
    const INSIDE: f64 = 1.0 - 1e-12;
    let mut reach = REACH * assembly.mean_radius();
    for (axis, [low, high]) in assembly.bounds.into_iter().enumerate() {
        reach = match assembly.space.lengths()[axis] {
            Some(length) => reach.min(0.5 * INSIDE * length),
            None => reach.min((high - low) / 3.0),
        };
    }
    reach
}

/// For each bin the number of pairs seen from spheres that count as centres, and the number of these.
fn counts(
    assembly: &Assembly,
    reach: f64,
    bins: usize,
) -> Result<(Vec<f64>, Vec<f64>), SpaceError> {
    let points = vec![0.0; assembly.positions.len()];
    let scale = bins as f64 / reach;
    // Number of bins for which each sphere is far enough from open faces.
    let inner = |place: &nalgebra::Vector3<f64>| {
        let open = (0..3).filter(|&axis| assembly.space.lengths()[axis].is_none());
        let depth = open.map(|axis| {
            let [low, high] = assembly.bounds[axis];
            (place[axis] - low).min(high - place[axis])
        });
        (depth.fold(reach, f64::min).max(0.0) * scale).floor() as usize
    };
    let inner: Vec<usize> = assembly.positions.iter().map(inner).collect();
    let farther = |bin: usize| inner.iter().filter(|last| **last > bin).count() as f64;
    let centres = (0..bins).map(farther).collect();
    let (space, positions) = (&assembly.space, &assembly.positions);
    let count = |pairs: &[[u32; 2]], counts: &mut [f64]| {
        for pair in pairs {
            let [a, b] = pair.map(|index| index as usize);
            let way = space.displacement(&positions[a], &positions[b]);
            let bin = (way.norm() * scale) as usize;
            if let Some(count) = counts.get_mut(bin) {
                *count += [a, b].iter().filter(|index| inner[**index] > bin).count() as f64;
            }
        }
    };
    let zeros = vec![0.0; bins];
    let counts = Cells::default().sums(space, positions, &points, (reach, &zeros), count)?;
    Ok((counts, centres))
}
