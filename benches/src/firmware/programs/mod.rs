//! Bare-metal programs of an item, written and built: one that calls it and does nothing else, for
//! its flash, and one that measures the call.

use super::board::Board;
use super::items::Item;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// How far the compiler optimises, and the cargo profile for it.
pub const LEVELS: [(&str, &str); 2] = [("3", "release"), ("s", "small")];

const MANIFEST: &str = r#"[package]
name = "PACKAGE-programs"
version = "0.0.0"
edition = "2024"
publish = false

[workspace]

[dependencies]
tribos-core = { path = "ROOT/core" }
# Of the version in the lock file.
nalgebra = { version = "*", default-features = false, features = ["libm-force"] }
SUPPORT

# Debug records tell which functions were inlined; they take no flash.
[profile.release]
opt-level = 3
lto = "fat"
codegen-units = 1
panic = "abort"
debug = 1

[profile.small]
inherits = "release"
opt-level = "s"
"#;

/// The linker script of the start-up; the memory map comes from the boards' own build script.
const BUILD_SCRIPT: &str = "fn main() { println!(\"cargo::rustc-link-arg=-Tlink.x\"); }\n";

const COMMON: &str = include_str!("common.txt");

/// What a set of programs is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To be weighed: nothing but the call.
    Flash,
    /// To be run on an emulated board.
    Measure,
}

impl Purpose {
    fn name(self) -> &'static str {
        match self {
            Self::Flash => "flash",
            Self::Measure => "measure",
        }
    }

    fn template(self) -> &'static str {
        match self {
            Self::Flash => include_str!("flash.txt"),
            Self::Measure => include_str!("measure.txt"),
        }
    }

    fn manifest(self, root: &Path) -> String {
        let support = match self {
            Self::Flash => "",
            Self::Measure => "tribos-boards = { path = \"ROOT/boards\" }",
        };
        let manifest = MANIFEST.replace("PACKAGE", self.name());
        let manifest = manifest.replace("SUPPORT", support);
        manifest.replace("ROOT", &root.display().to_string())
    }
}

/// An item in one precision.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// What it names.
    pub item: Item,
    /// "f32" or "f64".
    pub precision: &'static str,
    /// For the name of its file.
    pub number: usize,
}

impl Program {
    fn file(&self, purpose: Purpose) -> String {
        format!("{}_{}", purpose.name(), self.number)
    }

    fn source(&self, purpose: Purpose) -> String {
        let code = self.item.code;
        let common = COMMON
            .replace("PRECISION", self.precision)
            .replace("BITS", self.precision.trim_start_matches('f'))
            .replace("STATICS", code.statics)
            .replace("PREPARE", code.prepare)
            .replace("READY", code.ready)
            .replace("CALL", code.call);
        common + purpose.template()
    }
}

/// Where the programs of a purpose live, and where their images go.
#[derive(Clone, Debug)]
pub struct Workshop {
    purpose: Purpose,
    folder: PathBuf,
    /// Of every purpose, so that the kernel is built once.
    target: PathBuf,
}

impl Workshop {
    /// Writes the programs into `folder`, with the workspace's own versions of dependencies.
    pub fn write(folder: &Path, purpose: Purpose, programs: &[Program]) -> Result<Self, String> {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let target = folder.join("target");
        let folder = folder.join(purpose.name());
        let bin = folder.join("src/bin");
        // Programs of an earlier run may have other numbers.
        let _ = fs::remove_dir_all(&bin);
        let written = (|| {
            fs::create_dir_all(&bin)?;
            fs::write(folder.join("Cargo.toml"), purpose.manifest(root))?;
            fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
            if purpose == Purpose::Measure {
                fs::write(folder.join("build.rs"), BUILD_SCRIPT)?;
            }
            for program in programs {
                let path = bin.join(program.file(purpose) + ".rs");
                fs::write(path, program.source(purpose))?;
            }
            Ok::<_, std::io::Error>(())
        })();
        written.map_err(|error| format!("cannot write {}: {error}", folder.display()))?;
        Ok(Self {
            purpose,
            folder,
            target,
        })
    }

    /// Builds the programs that fit `board` with a cargo profile; the images of the others are
    /// missing afterwards.
    pub fn build(&self, board: &Board, profile: &str, programs: &[Program]) -> Result<(), String> {
        board.installed()?;
        for program in programs {
            let _ = fs::remove_file(self.path(board, profile, program));
        }
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
        let bins = programs
            .iter()
            .flat_map(|p| ["--bin".into(), p.file(self.purpose)]);
        let output = Command::new(cargo)
            .args(["build", "--quiet", "--keep-going", "--target", board.target])
            .args(bins)
            .args(["--profile", profile, "--target-dir"])
            .arg(&self.target)
            .env("TRIBOS_BOARD", board.machine)
            .current_dir(&self.folder)
            .output()
            .map_err(|error| format!("cannot run cargo: {error}"))?;
        let message = String::from_utf8_lossy(&output.stderr);
        // Too large for the board is for the caller to see.
        if output.status.success() || message.contains("will not fit in region") {
            Ok(())
        } else {
            Err(format!("the programs do not build: {message}"))
        }
    }

    /// Where the image of a program is, if it was built.
    pub fn path(&self, board: &Board, profile: &str, program: &Program) -> PathBuf {
        let path = self.target.join(board.target);
        path.join(profile).join(program.file(self.purpose))
    }

    /// The image of a program.
    pub fn image(
        &self,
        board: &Board,
        profile: &str,
        program: &Program,
    ) -> Result<Vec<u8>, String> {
        let path = self.path(board, profile, program);
        fs::read(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))
    }
}
