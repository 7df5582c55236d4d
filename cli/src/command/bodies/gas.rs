//! Granular gases.

use super::LongBody;
use super::kind::{RunKind, told};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::gas as results;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::gas::{COLUMNS, GasSimulation, GasSummary, size};
use tribos::record::{WriteError, write_series};
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{GasScene, Key};

/// Gases.
static KIND: RunKind = RunKind {
    quantities: &[
        ("temperature", "/temperature"),
        ("theory", "/theory"),
        ("temperature_rotational", "/temperature_rotational"),
        ("theory_rotational", "/theory_rotational"),
        ("haff", "/haff"),
        ("time", "/time"),
        ("collisions", "/collisions"),
        ("energy_lost", "/energy_lost"),
        ("momentum", "/momentum"),
        ("density_variance", "/density_variance_final"),
        ("collisions_cured", "/collisions_cured"),
    ],
    drawn: ["Temperature at the end", "temperature [T0]"],
    share: ["collapsed", "/ending", "collapse"],
    told: &[
        told("temperature", 0, 1.0),
        told("mean field", 1, 1.0),
        told("time", 5, 1.0),
        told("collisions", 6, 1.0),
        told("clusters", 9, 1.0),
    ],
};

impl LongBody for GasScene {
    type Run = GasSimulation;
    type Summary = GasSummary;

    const KIND: &'static RunKind = &KIND;
    const KEYS: &'static [Key] = Self::KEYS;
    const SPHERES: &'static str = "spheres";
    const FILES: &'static [&'static str] = files::GAS;

    fn size(&self) -> RunSize {
        size(self)
    }

    fn state(run: &GasSimulation) -> String {
        let (collisions, time) = (run.collisions(), run.time());
        format!("{collisions:9.3} collisions a sphere  time {time:9.3}")
    }

    fn summary(run: &GasSimulation) -> GasSummary {
        run.outcome()
    }

    fn json(&self, summary: &GasSummary) -> Value {
        summary.json(self)
    }

    fn told(summary: &GasSummary) -> String {
        format!(
            "temperature {} after {} collisions a sphere, {:.1} s",
            shown(summary.temperature),
            shown(summary.collisions),
            summary.wall_seconds
        )
    }

    fn write_series(run: &GasSimulation, file: &Path) -> Result<(), WriteError> {
        write_series(file, &COLUMNS, run.series().iter().map(|row| &row[..]))
    }

    fn write(
        &self,
        (run, _): (&GasSimulation, &GasSummary),
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        results::write(run, (folder, order))
    }

    fn report(summary: &GasSummary) -> String {
        results::report(summary)
    }

    fn explanation(&self) -> Result<String, Failure> {
        explain::gas::text(self)
    }

    fn account(&self, summary: &Value, _: &str) -> String {
        after::gas(summary)
    }
}
