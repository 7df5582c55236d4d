//! Where a scene comes from: a file, or the name of one that comes with the program.

use crate::command::suggestions::unknown;
use crate::failure::Failure;
use std::path::Path;
use tribos::record::read_text;
use tribos::scene::{Key, LIBRARY, LibraryScene, MOST_BYTES, Scene, earlier_names, library_scene};

/// Reads the scene in the file, or that of this name where there is no such file.
pub fn read(scene: &Path, overrides: &[String]) -> Result<Scene, Failure> {
    set_once(overrides)?;
    let name = scene.display().to_string();
    let text = text(scene)?;
    let scene = Scene::parse(&name, &text, overrides).map_err(Failure::input)?;
    note_earlier_names(&name, scene.as_body().keys(), &text, overrides);
    Ok(scene)
}

/// Says which keys are given by names of earlier versions.
pub fn note_earlier_names(name: &str, keys: &[Key], text: &str, overrides: &[String]) {
    for [was, now] in earlier_names(keys, text, overrides) {
        let line = format_args!("warning: {name}: `{was}` is called `{now}` now");
        crate::command::warn(line);
    }
}

/// Refuses a key that `--set` gives twice: one of its values would be lost.
fn set_once(overrides: &[String]) -> Result<(), Failure> {
    let key = |item: &String| item.split('=').next().unwrap_or_default().trim().to_owned();
    let keys: Vec<String> = overrides.iter().map(key).collect();
    let twice = (1..keys.len()).find(|&at| keys[..at].contains(&keys[at]));
    twice.map_or(Ok(()), |at| {
        let key = &keys[at];
        let message = format!("--set: `{key}` is given twice; give one value, or `tribos sweep`");
        Err(Failure::input(message))
    })
}

/// Its text.
pub fn text(scene: &Path) -> Result<String, Failure> {
    if let Some(built_in) = built_in(scene) {
        return Ok(built_in.text.into());
    }
    read_text(scene, MOST_BYTES).map_err(|error| {
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

/// The scene of this name that comes with the program, unless there is such a file; a folder of results is none.
pub fn built_in(scene: &Path) -> Option<LibraryScene> {
    if scene.exists() && !scene.is_dir() {
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
