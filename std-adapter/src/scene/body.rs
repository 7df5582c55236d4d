//! Scenes of any body: `body` decides which vocabulary the rest is read in.

use super::entries::{Entries, Value};
use super::key::{Domain, Key};
use super::planar::PlanarScene;
use super::powder::PowderScene;
use super::problem::{Origin, Problem};
use super::slider::{SliderScene, key};
use super::tip::TipScene;
use super::{SceneError, text_of};
use std::path::Path;

/// The key that every vocabulary has.
pub(super) const BODY: Key = key(
    "body",
    "-",
    "what the scene is about (default disk)",
    Domain::OneOf(&["disk", "cylinder", "pipe", "curling", "powder", "tip"]),
);

/// A validated scene of any body.
#[derive(Debug)]
pub enum Scene {
    /// A flat, round body: its path is straight.
    Disk(SliderScene),
    /// A body that slides along a path in the plane.
    Planar(PlanarScene),
    /// A powder under a piston.
    Powder(Box<PowderScene>),
    /// A tip turned on a substrate.
    Tip(Box<TipScene>),
}

/// Reads the scene in `path` with `overrides` of the form `key=value` put over it.
///
/// ```
/// use std::path::Path;
/// use tribos::scene::{Scene, SceneError, read_scene};
/// let scene = read_scene(Path::new("../scenes/disk.toml"), &["speed=2".into()])?;
/// assert!(matches!(scene, Scene::Disk(disk) if disk.speed == 2.0)); // m/s
/// let nowhere = read_scene(Path::new("nowhere.toml"), &[]);
/// assert!(matches!(nowhere, Err(SceneError::Unreadable { .. })));
/// # Ok::<(), SceneError>(())
/// ```
pub fn read_scene(path: &Path, overrides: &[String]) -> Result<Scene, SceneError> {
    parse_scene(&path.display().to_string(), &text_of(path)?, overrides)
}

/// As [`read_scene`], from text; `name` stands for the file in messages.
///
/// ```
/// use tribos::scene::{Scene, parse_scene};
/// let text = "body = \"pipe\"\nspeed = 1.74\nspin = 10.2\ncoefficient = 0.2\ngravity = 9.81\n\
///             radius = 0.05\ninner_radius = 0.046\nheight = 0.15\nmass = 0.5";
/// let scene = parse_scene("pipe.toml", text, &[])?;
/// assert!(matches!(scene, Scene::Planar(_)));
/// # Ok::<(), tribos::scene::SceneError>(())
/// ```
pub fn parse_scene(name: &str, text: &str, overrides: &[String]) -> Result<Scene, SceneError> {
    Entries::parse(text, overrides)
        .and_then(|(entries, problems)| read(entries, problems))
        .map_err(|problems| SceneError::Invalid {
            name: name.to_owned(),
            problems,
        })
}

fn read(entries: Entries, problems: Vec<Problem>) -> Result<Scene, Vec<Problem>> {
    let body = match entries.values.get(BODY.name) {
        None => "disk".to_owned(),
        Some((Value::Text(text), _)) => text.clone(),
        Some((other, origin)) => return Err(refusal(other.kind(), *origin, problems)),
    };
    if body == "disk" {
        return SliderScene::from_entries(entries, problems).map(Scene::Disk);
    }
    if body == "powder" {
        let scene = PowderScene::from_entries(entries, problems)?;
        return Ok(Scene::Powder(Box::new(scene)));
    }
    if body == "tip" {
        let scene = TipScene::from_entries(entries, problems)?;
        return Ok(Scene::Tip(Box::new(scene)));
    }
    match PlanarScene::keys(&body) {
        Some(keys) => PlanarScene::from_entries(keys, entries, problems).map(Scene::Planar),
        None => {
            let origin = entries
                .values
                .get(BODY.name)
                .map_or(Origin::File, |at| at.1);
            let meant = super::nearest(&body, super::bodies())
                .map_or(String::new(), |near| format!("; did you mean \"{near}\"?"));
            Err(refusal(&format!("\"{body}\"{meant}"), origin, problems))
        }
    }
}

/// Without a body nothing else can be judged.
fn refusal(given: &str, origin: Origin, mut problems: Vec<Problem>) -> Vec<Problem> {
    let domain = BODY.domain.describe();
    let message = format!("`body` must be {domain}, not {given}");
    problems.push(Problem::new(origin, message));
    problems
}
