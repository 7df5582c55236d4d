//! Disks on a straight path.

use super::kind::{RunKind, told};
use super::{Commands, NoResult, at_once};
use crate::command::digits::shown;
use crate::command::explain::{after, slide as text};
use crate::command::run::disk;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::scene::DiskScene;
use tribos::slide;

/// Flat disks, in the units of their scene.
static KIND: RunKind = RunKind {
    quantities: &[
        ("distance", "/distance"),
        ("angle", "/angle"),
        ("end_time", "/end_time"),
        ("final_ratio", "/final_ratio"),
        ("limit_ratio", "/limit_ratio"),
        ("steps", "/steps"),
        ("initial_energy", "/initial_energy"),
        ("energy_dissipated", "/energy_dissipated"),
        ("energy_error", "/energy_error"),
    ],
    drawn: ["Distance to rest", "distance"],
    share: ["rest", "/ending", "rest"],
    told: &[
        told("distance", 0, 1.0),
        told("angle [rad]", 1, 1.0),
        told("time", 2, 1.0),
        told("final ratio", 3, 1.0),
    ],
};

impl Commands for &DiskScene {
    fn is_long(&self) -> bool {
        false
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        disk::run(self, order)
    }

    fn kind(&self) -> &'static RunKind {
        &KIND
    }

    fn summarize(&self, _: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        let outcome = slide::run(self, |_| ())?.outcome;
        let (distance, angle) = (shown(outcome.distance), shown(outcome.angle));
        let told = format!("distance {distance}, {angle} rad");
        Ok((outcome.json(self), told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::disk(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        at_once(out)?;
        after::disk(self)
    }
}
