//! Scenes that come with the program.

use super::Scene;

/// A scene file that is part of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LibraryScene {
    /// Name of the file without its ending.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
}

/// The files of these names.
macro_rules! library {
    ($($name:literal),+ $(,)?) => {
        &[$(LibraryScene {
            name: $name,
            text: include_str!(concat!("../../scenes/", $name, ".toml")),
        }),+]
    };
}

/// The scenes of the folder `scenes/` that ship inside the program, by body and size.
///
/// ```
/// use tribos::scene::{LIBRARY, LibraryScene};
/// let disk: &LibraryScene = &LIBRARY[0];
/// assert_eq!(disk.name, "disk");
/// assert!(disk.summary().starts_with("A disk thrown over a table"));
/// assert_eq!(disk.takes(), "a moment");
/// let powders = LIBRARY.iter().filter(|scene| scene.body() == "powder");
/// assert!(powders.count() >= 2); // small and large
/// ```
pub const LIBRARY: &[LibraryScene] = library![
    "disk",
    "cylinder",
    "pipe-a",
    "pipe-b",
    "plate",
    "curling-draw",
    "curling-slow",
    "spring-block",
    "spring-paper",
    "spring-holds",
    "incline",
    "turntable",
    "clamp",
    "compaction-small",
    "compaction-large",
    "compaction-4193",
    "shear-periodic",
    "pressed",
    "compaction-soft",
    "gas-haff",
    "gas-clusters",
    "gas-collapse",
    "shear-cell",
    "column",
    "heap",
    "hopper",
    "drum",
    "cyclic",
    "shaken",
    "tip-reversible",
    "tip-irreversible",
    "tip-slid",
    "tip-metal",
];

/// The scene of this name.
///
/// ```
/// let disk = tribos::scene::library_scene("disk").ok_or("no disk")?;
/// assert_eq!(disk.body(), "disk");
/// # Ok::<(), &str>(())
/// ```
pub fn library_scene(name: &str) -> Option<LibraryScene> {
    LIBRARY.iter().copied().find(|scene| scene.name == name)
}

/// How the line of a file begins that says how long a run takes.
const TAKES: &str = "# Takes ";

impl LibraryScene {
    /// What it shows: the first line of the file.
    pub fn summary(&self) -> &'static str {
        let first = self.text.lines().next().unwrap_or_default();
        first.trim_start_matches(['#', ' '])
    }

    /// How long a run takes on one core, in words.
    pub fn takes(&self) -> &'static str {
        let mut lines = self.text.lines();
        let line = lines.find_map(|line| line.strip_prefix(TAKES));
        line.unwrap_or_default().trim_end_matches('.')
    }

    /// What it is about.
    pub fn body(&self) -> &'static str {
        Scene::parse(self.name, self.text, &[]).map_or("", |scene| scene.body())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_runs_as_it_is_and_says_what_it_shows_and_how_long_it_takes() {
        for scene in LIBRARY {
            Scene::parse(scene.name, scene.text, &[]).unwrap();
            assert!(scene.summary().ends_with('.'), "{}", scene.name);
            assert!(scene.summary().len() < 100, "{}", scene.name);
            assert!(!scene.takes().is_empty(), "{}", scene.name);
        }
    }

    #[test]
    fn every_scene_of_the_folder_is_there() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap();
            // Results pinned to the bit are no scenes.
            if path.extension().is_some_and(|ending| ending == "toml")
                && !name.starts_with("golden")
            {
                assert!(library_scene(name).is_some(), "{name}");
            }
        }
    }
}
