//! Porosity of ballistic deposits against the inverse capture radius (fig. 4.5).

use super::{Ballistic, DepositTarget};
use crate::packing::PlacementError;
use tribos_base::statistics::statistics;

/// Columns of the table; lengths in radii, standard deviations of single deposits.
pub const COLUMNS: [&str; 8] = [
    "inv_capture_radius",
    "capture_radius",
    "porosity",
    "porosity_std",
    "bulk_porosity",
    "bulk_porosity_std",
    "particles",
    "particles_std",
];

/// Capture radii, beginning with spheres that stick where they touch.
const CAPTURE_RADII: [f64; 10] = [10.0, 8.0, 6.0, 5.0, 4.0, 3.5, 3.0, 2.5, 2.2, 2.0];

/// Number of deposits averaged for each point, as in the thesis.
const SEEDS: u64 = 5;

/// Porosity against the capture radius.
#[derive(Debug)]
pub struct PorosityCurve {
    /// One row per capture radius, in decreasing order.
    pub rows: Vec<[f64; COLUMNS.len()]>,
}

impl PorosityCurve {
    /// Grows deposits on a base of `width`, with five seeds starting at `seed`.
    pub fn new(width: f64, until: DepositTarget, seed: u64) -> Result<Self, PlacementError> {
        let mut rows = Vec::new();
        for capture in CAPTURE_RADII {
            let ballistic = Ballistic::new(width, 1.0, capture)?;
            let sample = Sample::new(&ballistic, until, (0..SEEDS).map(|n| seed.wrapping_add(n)))?;
            let mut row = [1.0 / capture, capture, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            for (pair, values) in [sample.porosity, sample.bulk, sample.particles]
                .iter()
                .enumerate()
            {
                let (mean, deviation) = statistics(values);
                row[2 + 2 * pair] = mean;
                row[3 + 2 * pair] = deviation;
            }
            rows.push(row);
        }
        Ok(Self { rows })
    }

    /// Points (1/r_capt, solid fraction of the bulk) in order of decreasing r_capt.
    pub fn solid(&self) -> Vec<(f64, f64)> {
        let point = |row: &[f64; COLUMNS.len()]| (row[0], 1.0 - row[4]);
        self.rows.iter().map(point).collect()
    }
}

/// Several deposits with the same parameters.
#[derive(Debug)]
pub struct Sample {
    /// Porosity below the highest point.
    pub porosity: Vec<f64>,
    /// Bulk porosity.
    pub bulk: Vec<f64>,
    /// Number of spheres.
    pub particles: Vec<f64>,
}

impl Sample {
    /// Grows one deposit per seed.
    pub fn new(
        ballistic: &Ballistic,
        until: DepositTarget,
        seeds: impl Iterator<Item = u64>,
    ) -> Result<Self, PlacementError> {
        let mut sample = Self {
            porosity: Vec::new(),
            bulk: Vec::new(),
            particles: Vec::new(),
        };
        for seed in seeds {
            let deposit = ballistic.grow(until, seed)?;
            sample.porosity.push(deposit.porosity());
            sample.bulk.push(deposit.bulk_porosity());
            sample.particles.push(deposit.positions.len() as f64);
        }
        Ok(sample)
    }
}
