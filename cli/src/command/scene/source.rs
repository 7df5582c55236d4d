//! Where a scene comes from: a file, or the name of one that comes with the program.

use crate::failure::Failure;
use std::path::Path;
use tribos::record::read_text;
use tribos::scene::{self, LIBRARY, LibraryScene, MOST_BYTES, Scene, library_scene};

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
    read_text(scene, MOST_BYTES).map_err(|error| {
        let name = scene.display();
        // A bare word that is no file may be a name that is misspelt.
        let names = if is_word(scene) {
            format!("; nor is it one of {}", names())
        } else {
            String::new()
        };
        Failure::input(format!("cannot read {name}: {error}{names}"))
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
