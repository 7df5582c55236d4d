//! Distribution of the normal forces.

use super::Table;
use tribos_base::record::{ContactRow, Partner};

/// Width of a bin in mean forces.
const BIN: f64 = 0.25;
/// Largest number of bins; larger forces are in the last.
const MOST_BINS: usize = 400;

/// Normal forces of the contacts between spheres that push.
///
/// The tail is the exponential e^(−βf/⟨f⟩) of forces above the mean: 1/β is their mean excess (maximum
/// likelihood), with the standard error β/√n.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceDistribution {
    /// Mean force.
    pub mean: f64,
    /// Largest force.
    pub largest: f64,
    /// Number of contacts that push, and of those that pull.
    pub signs: [usize; 2],
    /// Mean pull of the contacts that pull; 0 if there is none.
    pub mean_pull: f64,
    /// Number of forces in bins of a quarter of the mean.
    pub counts: Vec<usize>,
    /// Decay β of the tail and its standard error; NaN without forces above the mean.
    pub tail: [f64; 2],
}

impl ForceDistribution {
    pub(super) fn of(contacts: &[ContactRow]) -> Option<Self> {
        let pairs = contacts
            .iter()
            .filter(|row| matches!(row.b, Partner::Particle(_)));
        let all: Vec<f64> = pairs.map(ContactRow::normal_force).collect();
        let pushes: Vec<f64> = all.iter().copied().filter(|force| *force > 0.0).collect();
        let pulls: Vec<f64> = all
            .iter()
            .filter(|force| **force < 0.0)
            .map(|force| -force)
            .collect();
        let average = |forces: &[f64]| forces.iter().sum::<f64>() / forces.len() as f64;
        if pushes.is_empty() {
            return None;
        }
        let mean = average(&pushes);
        let excess: Vec<f64> = pushes
            .iter()
            .filter(|f| **f > mean)
            .map(|f| f / mean - 1.0)
            .collect();
        let decay = 1.0 / average(&excess);
        let largest = pushes.iter().copied().fold(0.0, f64::max);
        let bin = |force: f64| ((force / (mean * BIN)) as usize).min(MOST_BINS - 1);
        let mut counts = vec![0; bin(largest) + 1];
        for force in &pushes {
            counts[bin(*force)] += 1;
        }
        Some(Self {
            mean,
            largest,
            signs: [pushes.len(), pulls.len()],
            mean_pull: if pulls.is_empty() {
                0.0
            } else {
                average(&pulls)
            },
            counts,
            tail: [decay, decay / (excess.len() as f64).sqrt()],
        })
    }

    /// Columns: force over the mean (middle of the bin), probability density, number of contacts.
    pub fn table(&self) -> Table {
        let row = |(bin, count): (usize, &usize)| {
            let count = *count as f64;
            vec![
                (bin as f64 + 0.5) * BIN,
                count / (self.signs[0] as f64 * BIN),
                count,
            ]
        };
        Table {
            name: "forces",
            columns: &["force_over_mean", "density", "contacts"],
            rows: self.counts.iter().enumerate().map(row).collect(),
        }
    }
}
