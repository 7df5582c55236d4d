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
pub const LIBRARY: &[LibraryScene] = &[
    LibraryScene {
        name: "disk",
        text: include_str!("../../scenes/disk.toml"),
    },
    LibraryScene {
        name: "cylinder",
        text: include_str!("../../scenes/cylinder.toml"),
    },
    LibraryScene {
        name: "pipe-a",
        text: include_str!("../../scenes/pipe-a.toml"),
    },
    LibraryScene {
        name: "pipe-b",
        text: include_str!("../../scenes/pipe-b.toml"),
    },
    LibraryScene {
        name: "plate",
        text: include_str!("../../scenes/plate.toml"),
    },
    LibraryScene {
        name: "curling-draw",
        text: include_str!("../../scenes/curling-draw.toml"),
    },
    LibraryScene {
        name: "curling-slow",
        text: include_str!("../../scenes/curling-slow.toml"),
    },
    LibraryScene {
        name: "spring-block",
        text: include_str!("../../scenes/spring-block.toml"),
    },
    LibraryScene {
        name: "spring-paper",
        text: include_str!("../../scenes/spring-paper.toml"),
    },
    LibraryScene {
        name: "spring-holds",
        text: include_str!("../../scenes/spring-holds.toml"),
    },
    LibraryScene {
        name: "incline",
        text: include_str!("../../scenes/incline.toml"),
    },
    LibraryScene {
        name: "turntable",
        text: include_str!("../../scenes/turntable.toml"),
    },
    LibraryScene {
        name: "clamp",
        text: include_str!("../../scenes/clamp.toml"),
    },
    LibraryScene {
        name: "compaction-small",
        text: include_str!("../../scenes/compaction-small.toml"),
    },
    LibraryScene {
        name: "compaction-large",
        text: include_str!("../../scenes/compaction-large.toml"),
    },
    LibraryScene {
        name: "compaction-4193",
        text: include_str!("../../scenes/compaction-4193.toml"),
    },
    LibraryScene {
        name: "shear-periodic",
        text: include_str!("../../scenes/shear-periodic.toml"),
    },
    LibraryScene {
        name: "compaction-soft",
        text: include_str!("../../scenes/compaction-soft.toml"),
    },
    LibraryScene {
        name: "gas-haff",
        text: include_str!("../../scenes/gas-haff.toml"),
    },
    LibraryScene {
        name: "gas-clusters",
        text: include_str!("../../scenes/gas-clusters.toml"),
    },
    LibraryScene {
        name: "gas-collapse",
        text: include_str!("../../scenes/gas-collapse.toml"),
    },
    LibraryScene {
        name: "shear-cell",
        text: include_str!("../../scenes/shear-cell.toml"),
    },
    LibraryScene {
        name: "column",
        text: include_str!("../../scenes/column.toml"),
    },
    LibraryScene {
        name: "heap",
        text: include_str!("../../scenes/heap.toml"),
    },
    LibraryScene {
        name: "hopper",
        text: include_str!("../../scenes/hopper.toml"),
    },
    LibraryScene {
        name: "drum",
        text: include_str!("../../scenes/drum.toml"),
    },
    LibraryScene {
        name: "cyclic",
        text: include_str!("../../scenes/cyclic.toml"),
    },
    LibraryScene {
        name: "shaken",
        text: include_str!("../../scenes/shaken.toml"),
    },
    LibraryScene {
        name: "tip-reversible",
        text: include_str!("../../scenes/tip-reversible.toml"),
    },
    LibraryScene {
        name: "tip-irreversible",
        text: include_str!("../../scenes/tip-irreversible.toml"),
    },
    LibraryScene {
        name: "tip-slid",
        text: include_str!("../../scenes/tip-slid.toml"),
    },
    LibraryScene {
        name: "tip-metal",
        text: include_str!("../../scenes/tip-metal.toml"),
    },
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
