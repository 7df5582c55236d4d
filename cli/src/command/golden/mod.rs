//! `tribos golden`: results pinned to the bit, and checked.

mod place;
mod verify;
mod write;

use crate::command::progress::Meter;
use crate::failure::Failure;
use std::path::Path;
use tribos::golden::{Golden, Pinned};
use tribos::record::read_text;

/// Bytes of a golden file at most.
const MOST_BYTES: u64 = 256 << 20;

/// Pins what scenes compute, and checks that they still compute it, to the last bit.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    task: Task,
}

const EXAMPLES: &str = "\
Examples:
  Pin two scenes, and check them on another machine:
    tribos golden write scenes/disk.toml scenes/cylinder.toml --out golden.toml
    tribos golden verify golden.toml";

#[derive(Debug, clap::Subcommand)]
enum Task {
    /// Runs scenes and writes what they computed into one file.
    Write(write::Arguments),
    /// Runs the scenes of such a file again and compares: one line a scene.
    ///
    /// Exit codes: 0 all the same, 3 results differ, 2 a scene is missing, changed or refused, 1 a run
    /// failed; where several apply, the first of 3, 1, 2.
    Verify(verify::Arguments),
}

impl Arguments {
    /// Does it.
    pub fn execute(self) -> Result<(), Failure> {
        match self.task {
            Task::Write(arguments) => arguments.execute(),
            Task::Verify(arguments) => arguments.execute(),
        }
    }
}

/// Reads a golden file.
fn read(file: &Path) -> Result<Golden, Failure> {
    let name = file.display().to_string();
    let text = read_text(file, MOST_BYTES)
        .map_err(|error| Failure::input(format!("cannot read {name}: {error}")))?;
    Golden::parse(&name, &text).map_err(Failure::input)
}

/// A scene as it is told: its file, and what is set otherwise there.
fn label(pinned: &Pinned) -> String {
    let mut label = pinned.path.clone();
    for setting in &pinned.overrides {
        label += " ";
        label += setting;
    }
    label
}

/// Tells on standard error which scene is being run, for how long.
fn ticker(name: &str) -> impl FnMut() {
    let mut meter = Meter::new();
    move || {
        if meter.is_due(0.0) {
            meter.report_elapsed(format_args!("{name} is being run:"));
        }
    }
}
