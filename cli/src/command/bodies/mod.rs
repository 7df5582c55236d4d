//! What the commands do with the scenes of each body.
//!
//! Bodies in motion share a file; every other has its own.

mod gas;
mod grains;
mod kind;
mod long;
pub mod motion;
mod no_result;
mod powder;
mod tip;

pub use kind::RunKind;
pub use long::LongBody;
pub use no_result::NoResult;

use super::run::request::RunRequest;
use crate::failure::Failure;
use motion::MotionBody;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::scene::{RunBy, Scene};

/// What the commands ask of a scene.
pub trait Commands {
    /// Whether a run takes long enough for checkpoints and frames.
    fn is_long(&self) -> bool;

    /// Runs the scene and writes its results into a folder.
    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure>;

    /// What a sweep makes a table of.
    fn kind(&self) -> RunKind;

    /// One run of a sweep, on from a checkpoint if there is one: the summary, and a line about it.
    fn summarize(&self, folder: &Arc<Lock>) -> Result<(Value, String), NoResult>;

    /// Laws, modes and unknowns that the scene carries, and their cost.
    fn explanation(&self) -> Result<String, Failure>;

    /// Where the energy of the run in `out` went; of a sliding body without one, since it takes a
    /// moment. `command` runs the scene beside `out`.
    fn account(&self, out: Option<&Path>, command: &str) -> Result<String, Failure>;
}

/// The commands of a scene.
pub fn of(any: &Scene) -> Box<dyn Commands + '_> {
    match any.run_by() {
        RunBy::Motion(scene) => Box::new(MotionBody { scene, any }),
        RunBy::Powder(scene) => Box::new(scene),
        RunBy::Grains(scene) => Box::new(scene),
        RunBy::Gas(scene) => Box::new(scene),
        RunBy::Tip(scene) => Box::new(scene),
    }
}
