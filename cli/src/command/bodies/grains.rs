//! Grains in a box.

use super::kind::{Listed, RunKind, told};
use super::no_result::session;
use super::{Commands, NoResult};
use crate::command::digits::shown;
use crate::command::explain::{after, grains as text};
use crate::command::run::grains;
use crate::command::run::request::RunRequest;
use crate::command::run::resource_check::{MemoryPermission, check};
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::grains::GrainsSimulation;
use tribos::run::folder::Lock;
use tribos::scene::GrainsScene;

/// Grains.
static KIND: Listed = Listed {
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

impl Commands for &GrainsScene {
    fn is_long(&self) -> bool {
        true
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        grains::run(self, order)
    }

    fn kind(&self) -> RunKind {
        KIND.kind()
    }

    fn summarize(&self, lock: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        check(
            &tribos::grains::size(self),
            "grains",
            MemoryPermission::Usual,
        )
        .map_err(NoResult::Refused)?;
        let run: GrainsSimulation = session(lock).run(*self)?;
        let outcome = run.outcome();
        let told = format!(
            "solid fraction {} after {} steps, {:.1} s",
            shown(outcome.column("solid_fraction").unwrap_or(f64::NAN)),
            outcome.steps,
            outcome.wall_seconds
        );
        Ok((outcome.json(self), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::grains(self, out))
    }
}
