//! What the commands do with the scenes of each body.
//!
//! A body has its own file here, and its line in the list of [`of`].

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
use tribos::scene::Scene;

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

/// The commands of a scene: the one list of bodies here.
pub fn of(any: &Scene) -> Box<dyn Commands + '_> {
    let motion = |scene| Box::new(MotionBody { scene, any });
    match any {
        Scene::Disk(scene) => motion(scene),
        Scene::Cylinder(scene) => motion(scene),
        Scene::Pipe(scene) => motion(scene),
        Scene::Plate(scene) => motion(scene),
        Scene::Curling(scene) => motion(scene),
        Scene::Spring(scene) => motion(scene),
        Scene::Incline(scene) => motion(scene),
        Scene::Turntable(scene) => motion(scene),
        Scene::Clamp(scene) => motion(scene),
        Scene::Powder(scene) => Box::new(scene),
        Scene::Grains(scene) => Box::new(scene),
        Scene::Gas(scene) => Box::new(scene),
        Scene::Tip(scene) => Box::new(scene),
    }
}
