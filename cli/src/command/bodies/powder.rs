//! Powders under a piston.

use super::kind::{Listed, RunKind, told};
use super::no_result::session;
use super::{Commands, NoResult};
use crate::command::digits::shown;
use crate::command::explain::{after, powder as text};
use crate::command::run::powder;
use crate::command::run::request::RunRequest;
use crate::command::run::resource_check::{MemoryPermission, check};
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::powder::PowderSimulation;
use tribos::run::folder::Lock;
use tribos::scene::PowderScene;

/// Powders.
static KIND: Listed = Listed {
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

impl Commands for &PowderScene {
    fn is_long(&self) -> bool {
        true
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        powder::run(self, order)
    }

    fn kind(&self) -> RunKind {
        KIND.kind()
    }

    fn summarize(&self, lock: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        check(
            &tribos::powder::size(self),
            "spheres",
            MemoryPermission::Usual,
        )
        .map_err(NoResult::Refused)?;
        let run: PowderSimulation = session(lock).run(*self)?;
        let outcome = run.outcome();
        let told = format!(
            "porosity {} % after {} steps, {:.1} s",
            shown(100.0 * outcome.porosity[1]),
            outcome.steps,
            outcome.wall_seconds
        );
        Ok((outcome.json(self), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self)
    }

    fn account(&self, out: Option<&Path>, command: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::powder(self, out, command))
    }
}
