//! Granular gases.

use super::kind::{Listed, RunKind, told};
use super::no_result::session;
use super::{Commands, NoResult};
use crate::command::digits::shown;
use crate::command::explain::{after, gas as text};
use crate::command::run::gas;
use crate::command::run::request::RunRequest;
use crate::command::run::resource_check::{MemoryPermission, check};
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::gas::GasSimulation;
use tribos::run::folder::Lock;
use tribos::scene::GasScene;

/// Gases.
static KIND: Listed = Listed {
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

impl Commands for &GasScene {
    fn is_long(&self) -> bool {
        true
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        gas::run(self, order)
    }

    fn kind(&self) -> RunKind {
        KIND.kind()
    }

    fn summarize(&self, lock: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        check(&tribos::gas::size(self), "spheres", MemoryPermission::Usual)
            .map_err(NoResult::Refused)?;
        let run: GasSimulation = session(lock).run(*self)?;
        let outcome = run.outcome();
        let told = format!(
            "temperature {} after {} collisions a sphere, {:.1} s",
            shown(outcome.temperature),
            shown(outcome.collisions),
            outcome.wall_seconds
        );
        Ok((outcome.json(self), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::gas(self, out))
    }
}
