//! `tribos golden`: results pinned to the bit, and checked.

mod place;
mod verify;
mod write;

use crate::command::progress::Meter;
use crate::failure::Failure;

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

/// Tells on standard error which scene is being run, for how long.
fn ticker(name: &str) -> impl FnMut() {
    let mut meter = Meter::new();
    move || {
        if meter.is_due(0.0) {
            meter.tell_open(format_args!("{name} is being run:"));
        }
    }
}
