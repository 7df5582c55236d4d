//! Tips turned or slid on a substrate.

use super::kind::RunKind;
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
use tribos::results::{Summary, SweptQuantity, swept};
use tribos::run::folder::Lock;
use tribos::scene::{DriveKind, TipScene};
use tribos::tip::{TipSimulation, TipSummary};

impl Commands for &TipScene {
    fn is_long(&self) -> bool {
        true
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        tip::run(self, order)
    }

    fn kind(&self) -> RunKind {
        let is_slid = self.drive == DriveKind::Slide;
        let belongs = |quantity: &SweptQuantity| match quantity.path[0] {
            "tip_temperature" => true,
            "slid" => is_slid,
            _ => !is_slid,
        };
        let mut quantities = swept(TipSummary::QUANTITIES);
        quantities.retain(belongs);
        if self.potential.is_metal() {
            for quantity in &mut quantities {
                quantity.unit = metal_unit(quantity.unit);
            }
        }
        if is_slid {
            let share = ["periodic", "/slid/motion", "periodic"];
            RunKind::of(quantities, ["Friction of the tip", "friction"], share)
        } else {
            let share = ["reversible", "/verdict", "reversible"];
            RunKind::of(quantities, ["Angle after the drive", "final_angle"], share)
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
            return Ok((outcome.json(*self), told));
        }
        let told = format!(
            "{} degrees driven, {} after it",
            shown(outcome.driven_angle_degrees),
            shown(outcome.final_angle_degrees)
        );
        Ok((outcome.json(*self), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::tip(self, out))
    }
}

/// The unit of a scene with a metal.
fn metal_unit(unit: &'static str) -> &'static str {
    match unit {
        "sigma" => "A",
        "eps/sigma" => "eV/A",
        "eps/k_B" => "K",
        other => other,
    }
}
