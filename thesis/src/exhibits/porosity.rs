//! Figure 4.7: final porosity over rolling and torsion friction.

mod claims;
mod grid;

pub(super) use claims::{ADDITIVITY, FLUCTUATION, few_sweeps};

use crate::exhibit::Exhibit;
use crate::runs::{Case, Effort, Run, Runs, System};
use crate::text::Text;
use anyhow::Result;
use std::sync::Arc;
use tribos::powder::PowderStopReason;
use tribos::statistics::statistics;
use tribos_report::drawing_grid::DrawingGrid;
use tribos_report::figure::Axis;
use tribos_report::surface::Surface;

const TEXT: Text = Text(include_str!("figure-4.7.md"));

/// Coefficients along both axes.
const CORNERS: [f64; 2] = [0.0, 1.0];
const GRID: [f64; 6] = [0.0, 0.1, 0.2, 0.4, 0.7, 1.0];
/// Deposits averaged: of the small system as many as in the thesis, one of the large system, and
/// five at the corners of a full grid.
const SMALL_SEEDS: u64 = 2;
const LARGE_SEEDS: u64 = 1;
const CORNER_SEEDS: u64 = 5;
/// Porosities shown, from below the thesis' lowest to the deposit's.
const SHOWN: (f64, f64) = (0.5, 0.95);

/// Final porosities of one system.
pub(super) struct Porosities {
    system: System,
    /// Coefficients, the same for μ_t and μ_n.
    mus: &'static [f64],
    /// Of each μ_t and μ_n: final porosities of some deposits.
    values: Vec<Vec<Vec<f64>>>,
    /// Runs that ended blocked, and all of them.
    blocked: [usize; 2],
    /// Porosities of the deposits before.
    initial: Vec<f64>,
    /// Their spheres.
    spheres: Vec<usize>,
}

impl Porosities {
    fn run(runs: &Runs, system: System) -> Result<Self> {
        let mus: &'static [f64] = match runs.effort() {
            Effort::Quick => &CORNERS,
            Effort::Full => &GRID,
        };
        let seeds = |mu: [f64; 2]| {
            let corner = mu.iter().all(|mu| CORNERS.contains(mu));
            1..=match (runs.effort(), system) {
                (Effort::Full, _) if corner => CORNER_SEEDS,
                (_, System::Tiny | System::Small) => SMALL_SEEDS,
                (_, System::Large) => LARGE_SEEDS,
            }
        };
        let cases = |mu: [f64; 2]| seeds(mu).map(move |seed| Case::new(system, mu, seed));

        // All at once, to keep every core busy; then one by one from what is done.
        let pairs = mus.iter().flat_map(|t| mus.iter().map(|n| [*t, *n]));
        let all = runs.of(&pairs.flat_map(cases).collect::<Vec<_>>())?;
        let is_blocked = |run: &&Arc<Run>| run.outcome.ending == Some(PowderStopReason::Blocked);
        let blocked = [all.iter().filter(is_blocked).count(), all.len()];
        let deposits = runs.of(&cases([1.0; 2]).collect::<Vec<_>>())?;
        let final_porosity = |case: Case| Ok(runs.one(&case)?.outcome.porosity_final);
        let values = mus.iter().map(|t| {
            let row = mus
                .iter()
                .map(|n| cases([*t, *n]).map(final_porosity).collect());
            row.collect::<Result<_>>()
        });
        let values = values.collect::<Result<_>>()?;
        Ok(Self {
            system,
            mus,
            values,
            blocked,
            initial: deposits
                .iter()
                .map(|run| run.outcome.porosity_initial)
                .collect(),
            spheres: deposits.iter().map(|run| run.outcome.particles).collect(),
        })
    }

    /// Mean and deviation at grid point (μ_t, μ_n); the deviation of one deposit is NaN.
    fn at(&self, i: usize, j: usize) -> (f64, f64) {
        statistics(&self.values[i][j])
    }

    /// The mean at (μ_t, μ_n) = (`i`, `j`) of the last coefficient, which is 1.
    fn corner(&self, i: usize, j: usize) -> (f64, f64) {
        statistics(self.each(i, j))
    }

    /// The same, deposit by deposit.
    fn each(&self, i: usize, j: usize) -> &[f64] {
        let last = self.mus.len() - 1;
        &self.values[i * last][j * last]
    }

    fn surface(&self) -> Surface {
        let (low, high) = SHOWN;
        let axes = [
            Axis::linear("μ_t"),
            Axis::linear("μ_n"),
            Axis::linear("porosity").range(low, high),
        ];
        let title = format!("{} system", self.system.name());
        Surface::new(title, axes, [self.mus, self.mus], |i, j| self.at(i, j).0)
            .errors(|i, j| self.at(i, j).1)
    }

    /// One line a grid point.
    fn rows(&self) -> Vec<Vec<f64>> {
        let [width, _] = self.system.size();
        let mut rows = Vec::new();
        for (i, rolling) in self.mus.iter().enumerate() {
            for (j, torsion) in self.mus.iter().enumerate() {
                let (mean, deviation) = self.at(i, j);
                let deposits = self.values[i][j].len() as f64;
                rows.push(vec![width, *rolling, *torsion, deposits, mean, deviation]);
            }
        }
        rows
    }
}

/// Surfaces of the systems.
pub fn figure_4_7(runs: &Runs) -> Result<Exhibit> {
    let small = Porosities::run(runs, System::Small)?;
    let large = match runs.effort() {
        Effort::Quick => None,
        Effort::Full => Some(Porosities::run(runs, System::Large)?),
    };
    let mut sheet = DrawingGrid::new("Final porosity", 2).drawing(small.surface());
    let mut rows = small.rows();
    if let Some(large) = &large {
        sheet = sheet.drawing(large.surface());
        rows.extend(large.rows());
    }
    let spheres: Vec<String> = small.spheres.iter().map(usize::to_string).collect();
    let at = match runs.effort() {
        Effort::Quick => " at four points, joined by a smooth sheet",
        Effort::Full => "",
    };
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort())
            .with("spheres", spheres.join(", "))
            .with("sheet", at),
        sheet,
        &[
            "width",
            "rolling",
            "torsion",
            "deposits",
            "porosity",
            "porosity_std",
        ],
        rows,
        claims::all(runs, &small, large.as_ref())?,
    )
    .seeded(1..=small.initial.len() as u64))
}
