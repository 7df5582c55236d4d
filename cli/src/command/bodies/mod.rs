//! What the commands do with the scenes of each body.
//!
//! A body has its own file here, and its line in the list of [`of`].

mod disk;
mod gas;
mod grains;
mod kind;
mod long;
mod no_result;
mod planar;
mod powder;
mod stick_slip;
mod tip;

pub use kind::RunKind;
pub use long::LongBody;
pub use no_result::NoResult;

use super::explain::slide;
use super::run::request::RunRequest;
use crate::failure::Failure;
use planar::PlanarBodyCommands;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use stick_slip::StickSlipBody;
use tribos::run::folder::Lock;
use tribos::scene::Scene;

/// What the commands ask of a scene.
pub trait Commands {
    /// Whether a run takes long enough for checkpoints and frames.
    fn is_long(&self) -> bool;

    /// Runs the scene and writes its results into a folder.
    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure>;

    /// What a sweep makes a table of.
    fn kind(&self) -> &'static RunKind;

    /// One run of a sweep, on from a checkpoint if there is one: the summary, and a line about it.
    fn summarize(&self, folder: &Arc<Lock>) -> Result<(Value, String), NoResult>;

    /// Laws, modes and unknowns that the scene carries, and their cost.
    fn explanation(&self) -> Result<String, Failure>;

    /// Where the energy of the run in `out` went; of a sliding body without one, since it takes a
    /// moment. `command` runs the scene beside `out`.
    fn account(&self, out: Option<&Path>, command: &str) -> Result<String, Failure>;
}

/// The commands of a scene: the one list of bodies here.
pub fn of(scene: &Scene) -> Box<dyn Commands + '_> {
    let path = |scene, laws| Box::new(PlanarBodyCommands { scene, laws });
    match scene {
        Scene::Disk(scene) => Box::new(scene),
        Scene::Cylinder(scene) => path(scene, slide::cylinder(scene)),
        Scene::Pipe(scene) => path(scene, slide::pipe(scene)),
        Scene::Plate(scene) => path(scene, slide::plate(scene)),
        Scene::Curling(scene) => path(scene, slide::curling(scene)),
        Scene::Spring(scene) => Box::new(StickSlipBody::new(scene, &stick_slip::SPRING)),
        Scene::Incline(scene) => Box::new(StickSlipBody::new(scene, &stick_slip::INCLINE)),
        Scene::Turntable(scene) => Box::new(StickSlipBody::new(scene, &stick_slip::TURNTABLE)),
        Scene::Clamp(scene) => Box::new(StickSlipBody::new(scene, &stick_slip::CLAMP)),
        Scene::Powder(scene) => Box::new(scene),
        Scene::Grains(scene) => Box::new(scene),
        Scene::Gas(scene) => Box::new(scene),
        Scene::Tip(scene) => Box::new(scene),
    }
}

/// Refuses the folder of a run that is not needed.
fn at_once(out: Option<&Path>) -> Result<(), Failure> {
    let refused = "--out is for powders, grains, gases and tips; the energy balance of a sliding body needs no run";
    out.map_or(Ok(()), |_| Err(Failure::input(refused)))
}
