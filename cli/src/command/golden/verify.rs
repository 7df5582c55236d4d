//! `tribos golden verify`

use super::place::folder_of;
use super::{label, read, ticker};
use crate::command::print;
use crate::command::scene;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::golden::{Golden, Pinned, Verdict, measure};

/// Runs the scenes of a golden file again and compares: one line a scene.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    tribos golden verify scenes/golden.toml\n  \
    tribos golden verify scenes/golden.toml --only disk.toml --only pipe-a.toml")]
pub struct Arguments {
    /// A file that `tribos golden write` wrote.
    #[arg(value_name = "GOLDEN")]
    file: PathBuf,
    /// Check this scene only, named as in the file; may be repeated.
    #[arg(long, value_name = "SCENE")]
    only: Vec<String>,
}

impl Arguments {
    /// Runs, compares, and tells every scene.
    pub fn execute(self) -> Result<(), Failure> {
        let name = self.file.display().to_string();
        let golden = read(&self.file)?;
        let chosen = self.chosen(&golden)?;

        let folder = folder_of(&self.file);
        let mut failures = Vec::new();
        for pinned in &chosen {
            match check(pinned, folder) {
                Ok(line) => print(&line)?,
                Err(failure) => {
                    print(&format!("{}: {failure}\n", label(pinned)))?;
                    failures.push(failure);
                }
            }
        }
        conclude(&name, chosen.len(), failures)
    }

    /// The scenes to check.
    fn chosen<'a>(&self, golden: &'a Golden) -> Result<Vec<&'a Pinned>, Failure> {
        let has = |name: &&String| golden.scenes.iter().any(|scene| scene.path == **name);
        if let Some(unknown) = self.only.iter().find(|name| !has(name)) {
            let known: Vec<String> = golden.scenes.iter().map(label).collect();
            return Err(Failure::input(format!(
                "--only {unknown}: not in {}; its scenes are {}",
                self.file.display(),
                known.join(", ")
            )));
        }
        let is_chosen = |scene: &&Pinned| self.only.is_empty() || self.only.contains(&scene.path);
        Ok(golden.scenes.iter().filter(is_chosen).collect())
    }
}

/// Runs one scene; its line if all is the same.
fn check(pinned: &Pinned, folder: &Path) -> Result<String, Failure> {
    let file = folder.join(&pinned.path);
    let name = Path::new(&pinned.path);
    // A scene that comes with the program is pinned by its name.
    let path = if !file.exists() && scene::built_in(name).is_some() {
        name
    } else {
        &file
    };
    let scene = scene::read(path, &pinned.overrides)?;
    let measured = measure(&scene, ticker(&label(pinned)))?;
    match pinned.compare(&measured) {
        Verdict::Same => {
            let [columns, quantities, _] = pinned.results();
            Ok(format!(
                "{}: same, {} rows of {columns} columns, {quantities} quantities\n",
                label(pinned),
                pinned.rows()
            ))
        }
        Verdict::SceneChanged(what) => Err(Failure::Input(format!(
            "the scene has changed, its results cannot be compared: {what}; \
             change it back, or write the golden file again"
        ))),
        Verdict::Differs(difference) => Err(Failure::Mismatch(difference.to_string())),
    }
}

/// The gravest failure decides: results that differ, then failed runs, then input.
fn conclude(name: &str, scenes: usize, failures: Vec<Failure>) -> Result<(), Failure> {
    let message = format!("{} of {scenes} scenes are not as in {name}", failures.len());
    let any = |is: fn(&Failure) -> bool| failures.iter().any(is);
    if failures.is_empty() {
        Ok(())
    } else if any(|failure| matches!(failure, Failure::Mismatch(_))) {
        Err(Failure::Mismatch(message))
    } else if any(|failure| matches!(failure, Failure::Run(_))) {
        Err(Failure::Run(message))
    } else {
        Err(Failure::Input(message))
    }
}
