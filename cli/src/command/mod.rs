//! The subcommands, one module each.

mod columns;
mod deposit;
mod eval;
mod export;
mod golden;
mod inverse;
mod laws;
mod modes;
mod number;
mod parallel;
mod patch;
mod profile;
mod reproduce;
mod run;
mod sweep;
mod tier;
mod view;
mod wrench;

use crate::failure::Failure;
use std::io::Write;

/// What to do.
#[derive(Debug, clap::Subcommand)]
pub enum Command {
    /// Friction force and torque of a sliding, spinning disk.
    Wrench(wrench::Arguments),
    /// Final motion: fixed points of the velocity ratio and the phase diagram.
    Modes(modes::Arguments),
    /// Friction laws: formulas, parameters, units, sources; curves of the local ones.
    Laws(laws::Arguments),
    /// The launches after which a body comes to rest at a wanted pose.
    Inverse(inverse::Arguments),
    /// Simulate a scene.
    Run(run::Arguments),
    /// A run as a film in a web page, as pictures or as a film file.
    View(view::Arguments),
    /// Ballistic deposits of spheres: grown, exported, their porosity.
    Deposit(deposit::Arguments),
    /// Forces, energy and pressure of atoms as a file has them.
    Eval(eval::Arguments),
    /// A scene as files of another program.
    Export(export::Arguments),
    /// Results of scenes pinned to the bit, and checked on other machines or later.
    Golden(golden::Arguments),
    /// A powder compacted for all combinations of some keys and seeds.
    Sweep(sweep::Arguments),
    /// Reproduce the thesis' figures and tables, claim by claim.
    Reproduce(reproduce::Arguments),
}

impl Command {
    /// Does it.
    pub fn execute(self) -> Result<(), Failure> {
        match self {
            Self::Wrench(arguments) => arguments.execute(),
            Self::Modes(arguments) => arguments.execute(),
            Self::Laws(arguments) => arguments.execute(),
            Self::Inverse(arguments) => arguments.execute(),
            Self::Run(arguments) => arguments.execute(),
            Self::View(arguments) => arguments.execute(),
            Self::Deposit(arguments) => arguments.execute(),
            Self::Eval(arguments) => arguments.execute(),
            Self::Export(arguments) => arguments.execute(),
            Self::Golden(arguments) => arguments.execute(),
            Self::Sweep(arguments) => arguments.execute(),
            Self::Reproduce(arguments) => arguments.execute(),
        }
    }
}

/// Prints; a reader that went away is not an error.
fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::run(format!(
            "cannot write to standard output: {error}"
        ))),
        _ => Ok(()),
    }
}
