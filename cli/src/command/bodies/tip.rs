//! Tips turned or slid on a substrate.

use super::kind::{RunKind, told};
use super::no_result::session;
use super::{Commands, NoResult};
use crate::command::digits::shown;
use crate::command::explain::{after, tip as text};
use crate::command::run::request::RunRequest;
use crate::command::run::resource_check::{MemoryPermission, check};
use crate::command::run::tip;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::scene::{DriveKind, TipScene};
use tribos::tip::TipSimulation;

/// Turned tips.
static KIND: RunKind = RunKind {
    quantities: &[
        ("final_angle", "/final_angle_degrees"),
        ("driven_angle", "/driven_angle_degrees"),
        ("largest_angle", "/largest_angle_degrees"),
        ("tip_temperature", "/tip_temperature"),
    ],
    drawn: ["Angle after the drive", "final angle [degree]"],
    share: ["reversible", "/verdict", "reversible"],
    told: &[
        told("final angle [deg]", 0, 1.0),
        told("driven [deg]", 1, 1.0),
        told("largest [deg]", 2, 1.0),
        told("tip T [eps/k_B]", 3, 1.0),
    ],
};

/// Slid tips.
static SLID: RunKind = RunKind {
    quantities: &[
        ("friction", "/slid/friction"),
        ("friction_forth", "/slid/friction_forth"),
        ("friction_back", "/slid/friction_back"),
        ("normal_force", "/slid/normal_force"),
        ("period", "/slid/period"),
        ("peak_force", "/slid/peak_force"),
        ("tip_temperature", "/tip_temperature"),
    ],
    drawn: ["Friction of the tip", "loop area over path"],
    share: ["periodic", "/slid/motion", "periodic"],
    told: &[
        told("friction", 0, 1.0),
        told("normal force", 3, 1.0),
        told("period", 4, 1.0),
        told("tip T", 6, 1.0),
    ],
};

impl Commands for &TipScene {
    fn is_long(&self) -> bool {
        true
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        tip::run(self, order)
    }

    fn kind(&self) -> &'static RunKind {
        match self.drive {
            DriveKind::Torque => &KIND,
            DriveKind::Slide => &SLID,
        }
    }

    fn summarize(&self, lock: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        check(&tribos::tip::size(self), "atoms", MemoryPermission::Usual)
            .map_err(NoResult::Refused)?;
        let run: TipSimulation = session(lock).run(*self)?;
        let outcome = run.outcome();
        let written = lock.check().map_err(Failure::from);
        written
            .and_then(|()| tip::write_series(&run, lock.folder()))
            .map_err(NoResult::Stopped)?;
        if let Some(slid) = &outcome.slid {
            let (friction, normal) = (shown(slid.friction), shown(slid.normal_force));
            let told = format!("friction {friction} at a normal force of {normal}");
            return Ok((outcome.json(self), told));
        }
        let told = format!(
            "{} degrees driven, {} after it",
            shown(outcome.driven_angle),
            shown(outcome.final_angle)
        );
        Ok((outcome.json(self), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::tip(self, out))
    }
}
