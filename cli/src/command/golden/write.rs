//! `tribos golden write`

use super::place::{folder_of, relative};
use super::{label, read, ticker};
use crate::command::{file, scene};
use crate::failure::Failure;
use std::path::PathBuf;
use tribos::golden::{Golden, Pinned, measure};
use tribos::record::write_atomically;
use tribos::scene::Scene;

/// Runs scenes and writes what they computed into one file.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    tribos golden write scenes/disk.toml scenes/pipe-a.toml --out scenes/my-golden.toml\n  \
    tribos golden write scenes/disk.toml --set spin=50 --out fast.toml\n  \
    tribos golden write scenes/disk.toml --set spin=99 --append --out fast.toml\n  \
    tribos golden verify fast.toml")]
pub struct Arguments {
    /// Scenes: TOML files such as scenes/disk.toml, or names that `tribos scene list` has.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// The file to write; one of that name is replaced.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Keep the scenes that the file has; one pinned with the same overrides is replaced.
    #[arg(long)]
    append: bool,
    /// Replace or add a key of every scene; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl Arguments {
    /// Runs and writes. All scenes are read before the first is run.
    pub fn execute(self) -> Result<(), Failure> {
        let scenes: Vec<Scene> = self
            .scenes
            .iter()
            .map(|path| scene::read(path, &self.overrides))
            .collect::<Result<_, _>>()?;
        for path in &self.scenes {
            file::refuse_input("--out", &self.out, path)?;
        }
        let folder = folder_of(&self.out);
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::run(format!("cannot make {}: {error}", folder.display())))?;

        let mut golden = self.kept()?;
        for (path, scene) in self.scenes.iter().zip(&scenes) {
            let name = relative(path, folder);
            let measured = measure(scene, ticker(&name))?;
            let pinned = Pinned::new(name, self.overrides.clone(), &measured);
            let [columns, quantities, _] = pinned.results();
            crate::command::print(&format!(
                "{}: {} rows of {columns} columns, {quantities} quantities\n",
                label(&pinned),
                pinned.rows()
            ))?;
            golden
                .scenes
                .retain(|old| old.path != pinned.path || old.overrides != pinned.overrides);
            golden.scenes.push(pinned);
        }
        write_atomically(&self.out, golden.text().as_bytes())?;
        crate::command::print(&format!("written to {}\n", self.out.display()))
    }

    /// What the file has already, if that is to stay.
    fn kept(&self) -> Result<Golden, Failure> {
        if self.append && self.out.exists() {
            read(&self.out)
        } else {
            Ok(Golden::default())
        }
    }
}
