//! Where a scene comes from: a file, or the name of one that comes with the program.

use crate::failure::Failure;
use std::path::Path;
use tribos::scene::{self, LIBRARY, LibraryScene, Scene, library_scene};

/// Reads the scene in the file, or that of this name where there is no such file.
pub fn read(scene: &Path, overrides: &[String]) -> Result<Scene, Failure> {
    match built_in(scene) {
        Some(built_in) => scene::parse_scene(built_in.name, built_in.text, overrides),
        None => scene::read_scene(scene, overrides),
    }
    .map_err(|error| match error {
        // A bare word that is no file may be a name that is misspelt.
        scene::SceneError::Unreadable { .. } if is_word(scene) => {
            Failure::input(format!("{error}; nor is it one of {}", names()))
        }
        error => Failure::input(error),
    })
}

/// The scene of this name that comes with the program.
pub fn named(name: &str) -> Result<LibraryScene, Failure> {
    library_scene(name)
        .ok_or_else(|| Failure::input(format!("no scene `{name}`; there are {}", names())))
}

fn built_in(scene: &Path) -> Option<LibraryScene> {
    if scene.exists() {
        return None;
    }
    library_scene(scene.to_str()?)
}

fn is_word(scene: &Path) -> bool {
    scene.components().count() == 1 && scene.extension().is_none()
}

/// All names.
pub fn names() -> String {
    let names: Vec<_> = LIBRARY.iter().map(|scene| scene.name).collect();
    names.join(", ")
}
