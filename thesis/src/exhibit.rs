//! One figure or table of the thesis with its claims, and what exhibits share.

use super::text::Prose;
use anyhow::Result;
use std::panic::Location;
use tribos_core::coupling::ReducedWrench;
use tribos_core::coupling::{ReducedFriction, table::DiskTable64};
use tribos_core::modes::TerminalMotion;
use tribos_report::claim::Claim;
use tribos_report::image::Drawing;
use tribos_report::player::Film;

/// What one maker returns.
#[allow(missing_debug_implementations)] // Figures have none.
pub struct Exhibit {
    pub prose: Prose,
    /// Shown below the figure.
    pub film: Option<Film>,
    /// Pages of their own beside the report, by name.
    pub pages: Vec<(String, Film)>,
    pub drawing: Box<dyn Drawing>,
    pub columns: Vec<&'static str>,
    pub rows: Vec<Vec<f64>>,
    pub claims: Vec<Claim>,
    /// Of its random runs, one after the other.
    pub seeds: Vec<u64>,
    /// The file that makes it, and that of kept runs that it reads, from the project's root.
    pub source: String,
}

impl Exhibit {
    /// Without a film.
    #[track_caller]
    pub fn new(
        prose: Prose,
        drawing: impl Drawing + 'static,
        columns: &[&'static str],
        rows: Vec<Vec<f64>>,
        claims: Vec<Claim>,
    ) -> Self {
        Self {
            prose,
            film: None,
            pages: Vec::new(),
            drawing: Box::new(drawing),
            columns: columns.to_vec(),
            rows,
            claims,
            seeds: Vec::new(),
            source: source(Location::caller().file()),
        }
    }

    /// With the seeds of its random runs.
    pub fn seeded(self, seeds: impl IntoIterator<Item = u64>) -> Self {
        let seeds = seeds.into_iter().collect();
        Self { seeds, ..self }
    }

    /// From runs that are kept in a file beside it, which names their commands.
    pub fn kept(self, file: &str) -> Self {
        let source = format!("{}, and runs kept in {}", self.source, source(file));
        Self { source, ..self }
    }

    /// The first text in which a placeholder is not filled.
    pub fn unfilled(&self) -> Option<String> {
        let claims = self.claims.iter().flat_map(|claim| {
            let (place, statement) = (claim.place.clone(), claim.statement.clone());
            [place, statement, claim.verdict.evidence()]
        });
        let Prose {
            heading, caption, ..
        } = self.prose.clone();
        let prose = self.prose.paragraphs.iter().cloned();
        let mut all = claims.chain(prose).chain([heading, caption]);
        all.find(|text| text.contains(['{', '}']))
    }
}

/// The path in the project of a file that was compiled.
fn source(file: &str) -> String {
    let file = file.replace('\\', "/");
    let within = file
        .rsplit_once("src/")
        .map_or(file.as_str(), |(_, within)| within);
    format!("thesis/src/{within}")
}

/// The table of one exponent.
pub fn table(alpha: f64) -> Result<DiskTable64> {
    Ok(DiskTable64::new(alpha)?)
}

/// Final motion for one exponent and inertia ratio.
pub fn modes(alpha: f64, inertia_ratio: f64) -> Result<TerminalMotion<f64, DiskTable64>> {
    Ok(TerminalMotion::new(table(alpha)?, inertia_ratio)?)
}

/// F and T at ε with ωR = 1.
pub fn at(table: &DiskTable64, ratio: f64) -> [f64; 2] {
    let ReducedWrench { force, torque } = table.reduced_wrench(ratio, 1.0);
    [force, torque]
}

/// `n` + 1 numbers from `from` to `to`, equally spaced.
pub fn linear(from: f64, to: f64, n: usize) -> Vec<f64> {
    (0..=n)
        .map(|i| from + (to - from) * i as f64 / n as f64)
        .collect()
}

/// `n` + 1 numbers from `from` to `to`, equally spaced in the logarithm.
pub fn geometric(from: f64, to: f64, n: usize) -> Vec<f64> {
    linear(from.ln(), to.ln(), n)
        .into_iter()
        .map(f64::exp)
        .collect()
}

/// Column `y` of the rows against column `x`.
pub fn points(rows: &[Vec<f64>], x: usize, y: usize) -> Vec<(f64, f64)> {
    rows.iter().map(|row| (row[x], row[y])).collect()
}
