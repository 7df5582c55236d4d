//! Bodies along a path in the plane.

use super::kind::{RunKind, told};
use super::{Commands, NoResult, at_once};
use crate::command::digits::shown;
use crate::command::explain::{after, slide as text};
use crate::command::interrupt;
use crate::command::run::path;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::slide::{self, PlanarScene};

/// A body in the plane, and what is said of its laws.
pub struct PlanarBodyCommands<'a> {
    pub scene: &'a dyn PlanarScene,
    pub laws: String,
}

/// Bodies along a path in the plane.
static KIND: RunKind = RunKind {
    quantities: &[
        ("curl", "/curl"),
        ("x", "/x"),
        ("path_length", "/path_length"),
        ("angle", "/angle"),
        ("end_time", "/end_time"),
        ("final_ratio", "/final_ratio"),
        ("max_lean", "/max_lean"),
        ("steps", "/steps"),
        ("initial_energy", "/initial_energy"),
        ("energy_dissipated", "/energy_dissipated"),
        ("energy_error", "/energy_error"),
    ],
    drawn: ["Curl, to the left if positive", "curl [m]"],
    share: ["rest", "/ending", "rest"],
    told: &[
        told("forward [m]", 1, 1.0),
        told("curl [m]", 0, 1.0),
        told("angle [rad]", 3, 1.0),
        told("time [s]", 4, 1.0),
    ],
};

impl Commands for PlanarBodyCommands<'_> {
    fn is_long(&self) -> bool {
        false
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        path::run(self.scene, order)
    }

    fn kind(&self) -> &'static RunKind {
        &KIND
    }

    fn summarize(&self, _: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        let run = slide::follow_path(self.scene, &mut |_| !interrupt::is_asked())?;
        let outcome = run.outcome;
        let [x, y] = outcome.arrival.point.position.map(shown);
        Ok((
            outcome.json(self.scene),
            format!("{x} m forward, curl {y} m"),
        ))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::planar(self.scene, &self.laws)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        at_once(out)?;
        after::planar(self.scene)
    }
}
