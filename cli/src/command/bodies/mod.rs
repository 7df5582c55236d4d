//! What the commands do with the scenes of each body.

use super::explain::{after, powder as powder_text, slide as slide_text, tip as tip_text};
use super::sweep::body::Unfinished;
use super::sweep::{self, kind};
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::scene::{PowderScene, Scene, SliderScene, TipScene};
use tribos::slide::PlanarScene;

/// What the commands ask of a scene.
pub trait Commands {
    /// What a sweep makes a table of.
    fn kind(&self) -> &'static kind::Kind;

    /// One run of a sweep, on from a checkpoint if there is one: the summary, and a line about it.
    fn run(&self, folder: &Arc<Lock>) -> Result<(Value, String), Unfinished>;

    /// Laws, modes and unknowns that the scene carries, and their cost.
    fn explanation(&self) -> Result<String, Failure>;

    /// Where the energy of the run in `out` went; of a sliding body without one, since it takes a
    /// moment. `command` runs the scene beside `out`.
    fn account(&self, out: Option<&Path>, command: &str) -> Result<String, Failure>;
}

/// The commands of a scene: the one list of bodies here.
pub fn of(scene: &Scene) -> Box<dyn Commands + '_> {
    let path = |scene, laws| Box::new(InPlane { scene, laws });
    match scene {
        Scene::Disk(scene) => Box::new(scene),
        Scene::Cylinder(scene) => path(scene, slide_text::cylinder(scene)),
        Scene::Pipe(scene) => path(scene, slide_text::pipe(scene)),
        Scene::Curling(scene) => path(scene, slide_text::curling(scene)),
        Scene::Powder(scene) => Box::new(scene),
        Scene::Tip(scene) => Box::new(scene),
    }
}

/// A body in the plane, and what is told of its laws.
struct InPlane<'a> {
    scene: &'a dyn PlanarScene,
    laws: String,
}

impl Commands for &SliderScene {
    fn kind(&self) -> &'static kind::Kind {
        &kind::DISK
    }

    fn run(&self, _: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
        sweep::body::slide(self)
    }

    fn explanation(&self) -> Result<String, Failure> {
        slide_text::disk(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        at_once(out)?;
        after::disk(self)
    }
}

impl Commands for InPlane<'_> {
    fn kind(&self) -> &'static kind::Kind {
        &kind::PLANAR
    }

    fn run(&self, _: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
        sweep::body::path(self.scene)
    }

    fn explanation(&self) -> Result<String, Failure> {
        slide_text::planar(self.scene, &self.laws)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        at_once(out)?;
        after::planar(self.scene)
    }
}

impl Commands for &PowderScene {
    fn kind(&self) -> &'static kind::Kind {
        &kind::POWDER
    }

    fn run(&self, folder: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
        sweep::body::compact(self, folder)
    }

    fn explanation(&self) -> Result<String, Failure> {
        powder_text::text(self)
    }

    fn account(&self, out: Option<&Path>, command: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::powder(self, out, command))
    }
}

impl Commands for &TipScene {
    fn kind(&self) -> &'static kind::Kind {
        &kind::TIP
    }

    fn run(&self, folder: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
        sweep::body::turn(self, folder)
    }

    fn explanation(&self) -> Result<String, Failure> {
        tip_text::text(self)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        out.map_or(Ok(String::new()), |out| after::tip(self, out))
    }
}

/// Refuses the folder of a run that is not needed.
fn at_once(out: Option<&Path>) -> Result<(), Failure> {
    let refused = "--out is for powders and tips; a sliding body is accounted for without it";
    out.map_or(Ok(()), |_| Err(Failure::input(refused)))
}
