//! Powders under a piston.

use super::LongBody;
use super::kind::{RunKind, told};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::powder as results;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::powder::{COLUMNS, PowderSimulation, PowderSummary, size};
use tribos::record::{WriteError, write_series};
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{ContactMethod, Key, PowderScene};

/// A packing is seldom blocked within fewer steps.
const FEW: u64 = 5_000;

/// Powders.
static KIND: RunKind = RunKind {
    quantities: &[
        ("porosity_final", "/porosity_final"),
        ("porosity_bulk", "/porosity_bulk"),
        ("porosity_initial", "/porosity_initial"),
        ("particles", "/particles"),
        ("contacts", "/contacts"),
        ("coordination", "/statistics/mean_coordination"),
        ("stress_zz", "/stress_zz"),
        ("stress_zz_plus", "/stress_zz_plus"),
        ("stress_zz_minus", "/stress_zz_minus"),
        ("steps", "/steps"),
        ("iterations_total", "/iterations_total"),
        ("dissipation_normal", "/dissipation/normal"),
        ("dissipation_sliding", "/dissipation/sliding"),
        ("dissipation_rolling", "/dissipation/rolling"),
        ("dissipation_torsion", "/dissipation/torsion"),
        ("dissipation_cohesion", "/dissipation/cohesion"),
    ],
    drawn: ["Final porosity", "porosity"],
    share: ["blocked", "/ending", "blocked"],
    told: &[
        told("porosity [%]", 0, 100.0),
        told("contacts a sphere", 5, 1.0),
        told("stress_zz", 6, 1.0),
        told("plus", 7, 1.0),
        told("minus", 8, 1.0),
    ],
};

impl LongBody for PowderScene {
    type Run = PowderSimulation;
    type Summary = PowderSummary;

    const KIND: &'static RunKind = &KIND;
    const KEYS: &'static [Key] = Self::KEYS;
    const SPHERES: &'static str = "spheres";
    const FILES: &'static [&'static str] = files::POWDER;

    fn size(&self) -> RunSize {
        size(self)
    }

    fn refuse(&self) -> Result<(), Failure> {
        Ok(PowderSimulation::check(self)?)
    }

    fn growth(placed: usize, expected: f64) -> Option<String> {
        Some(format!(
            "deposit: {placed} spheres have fallen, about {expected:.0} will be below the cut"
        ))
    }

    fn sweeps(&self, run: &PowderSimulation) -> Option<usize> {
        let sweeps = run.last_step().iterations.sweeps;
        (self.method == ContactMethod::ContactDynamics).then_some(sweeps)
    }

    fn state(run: &PowderSimulation) -> String {
        format!(
            "step {:6}  height {:8.4}  porosity {:7.3} %",
            run.steps(),
            run.height(),
            100.0 * run.porosity()
        )
    }

    /// Where a time is given, or so few steps that they may end it before the packing is blocked.
    fn is_end_known(&self) -> bool {
        self.duration.is_some() || self.max_steps <= FEW
    }

    fn summary(run: &PowderSimulation) -> PowderSummary {
        run.outcome()
    }

    fn json(&self, summary: &PowderSummary) -> Value {
        summary.json(self)
    }

    fn told(summary: &PowderSummary) -> String {
        format!(
            "porosity {} % after {} steps, {:.1} s",
            shown(100.0 * summary.porosity[1]),
            summary.steps,
            summary.wall_seconds
        )
    }

    fn write_series(run: &PowderSimulation, file: &Path) -> Result<(), WriteError> {
        write_series(file, &COLUMNS, run.series().iter().map(|row| &row[..]))
    }

    fn write(
        &self,
        (run, summary): (&PowderSimulation, &PowderSummary),
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        results::write(self, run, (folder, order), summary)
    }

    fn report(summary: &PowderSummary) -> String {
        results::report(summary)
    }

    fn explanation(&self) -> Result<String, Failure> {
        explain::powder::text(self)
    }

    fn account(&self, summary: &Value, command: &str) -> String {
        after::packing(summary, &self.material(), command)
    }
}
