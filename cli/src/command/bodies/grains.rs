//! Grains in a box.

use super::LongBody;
use super::kind::{RunKind, told};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::grains as results;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::grains::{COLUMNS, GrainsSimulation, GrainsSummary, size};
use tribos::record::{WriteError, write_series};
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{ContactMethod, GrainsScene, Key};

/// Grains.
static KIND: RunKind = RunKind {
    quantities: &[
        ("solid_fraction", "/solid_fraction"),
        ("height", "/height"),
        ("coordination", "/coordination"),
        ("floor_force", "/floor_force"),
        ("plate_stress", "/plate_stress"),
        ("shear_stress", "/shear_stress"),
        ("stress_xx", "/stress_xx"),
        ("stress_zz", "/stress_zz"),
        ("stress_xz", "/stress_xz"),
        ("surface_angle", "/surface_angle"),
        ("time", "/time"),
        ("steps", "/steps"),
        ("iterations_total", "/iterations_total"),
        ("dissipation_normal", "/dissipation/normal"),
        ("dissipation_sliding", "/dissipation/sliding"),
        ("dissipation_rolling", "/dissipation/rolling"),
        ("dissipation_torsion", "/dissipation/torsion"),
    ],
    drawn: ["Final solid fraction", "solid fraction"],
    share: ["rest", "/ending", "rest"],
    told: &[
        told("solid fraction", 0, 1.0),
        told("contacts a grain", 2, 1.0),
        told("floor force", 3, 1.0),
        told("shear stress", 5, 1.0),
        told("angle [deg]", 9, 1.0),
    ],
};

impl LongBody for GrainsScene {
    type Run = GrainsSimulation;
    type Summary = GrainsSummary;

    const KIND: &'static RunKind = &KIND;
    const KEYS: &'static [Key] = Self::KEYS;
    const SPHERES: &'static str = "grains";
    const FILES: &'static [&'static str] = files::POWDER;

    fn size(&self) -> RunSize {
        size(self)
    }

    fn refuse(&self) -> Result<(), Failure> {
        Ok(GrainsSimulation::check(self)?)
    }

    fn sweeps(&self, run: &GrainsSimulation) -> Option<usize> {
        let sweeps = run.last_step().iterations.sweeps;
        (self.method == ContactMethod::ContactDynamics).then_some(sweeps)
    }

    fn state(run: &GrainsSimulation) -> String {
        format!("step {:7}  time {:9.4}", run.steps(), run.time())
    }

    fn summary(run: &GrainsSimulation) -> GrainsSummary {
        run.outcome()
    }

    fn json(&self, summary: &GrainsSummary) -> Value {
        summary.json(self)
    }

    fn told(summary: &GrainsSummary) -> String {
        format!(
            "solid fraction {} after {} steps, {:.1} s",
            shown(summary.column("solid_fraction").unwrap_or(f64::NAN)),
            summary.steps,
            summary.wall_seconds
        )
    }

    fn write_series(run: &GrainsSimulation, file: &Path) -> Result<(), WriteError> {
        write_series(file, &COLUMNS, run.series().iter().map(|row| &row[..]))
    }

    fn write(
        &self,
        (run, _): (&GrainsSimulation, &GrainsSummary),
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        results::write(self, run, (folder, order))
    }

    fn report(summary: &GrainsSummary) -> String {
        results::report(summary)
    }

    fn explanation(&self) -> Result<String, Failure> {
        explain::grains::text(self)
    }

    fn account(&self, summary: &Value, command: &str) -> String {
        after::packing(summary, &self.material(), command)
    }
}
