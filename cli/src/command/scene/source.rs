//! Where a scene comes from: a file, or the name of one that comes with the program.

use crate::command::unknown::unknown;
use crate::failure::Failure;
use std::path::Path;
use tribos::scene::{self, LIBRARY, LibraryScene, Scene, library_scene};

/// Reads the scene in the file, or that of this name where there is no such file.
pub fn read(scene: &Path, overrides: &[String]) -> Result<Scene, Failure> {
    let name = scene.display().to_string();
    scene::parse_scene(&name, &text(scene)?, overrides).map_err(Failure::input)
}

/// Its text.
pub fn text(scene: &Path) -> Result<String, Failure> {
    if let Some(built_in) = built_in(scene) {
        return Ok(built_in.text.into());
    }
    std::fs::read_to_string(scene).map_err(|error| {
        let name = scene.display();
        // A bare word that is no file may be a name that is misspelt.
        Failure::input(match scene.to_str() {
            Some(word) if is_word(scene) => {
                unknown(&format!("no file and no scene `{word}`"), word, all())
            }
            _ => format!("cannot read the scene {name}: {error}"),
        })
    })
}

/// The scene of this name that comes with the program, or what was meant.
pub fn named(name: &str) -> Result<LibraryScene, Failure> {
    library_scene(name)
        .ok_or_else(|| Failure::input(unknown(&format!("no scene `{name}`"), name, all())))
}

/// The scene of this name that comes with the program, unless there is such a file.
pub fn built_in(scene: &Path) -> Option<LibraryScene> {
    if scene.exists() {
        return None;
    }
    library_scene(scene.to_str()?)
}

fn is_word(scene: &Path) -> bool {
    scene.components().count() == 1 && scene.extension().is_none()
}

/// All names.
pub fn all() -> impl Iterator<Item = &'static str> {
    LIBRARY.iter().map(|scene| scene.name)
}
