//! The subcommands, one module each.

mod inverse;
mod modes;
mod number;
mod patch;
mod reproduce;
mod run;
mod tier;
mod wrench;

use crate::failure::Failure;

/// What to do.
#[derive(Debug, clap::Subcommand)]
pub enum Command {
    /// Friction force and torque of a sliding, spinning disk.
    Wrench(wrench::Arguments),
    /// Final motion: fixed points of the velocity ratio and the phase diagram.
    Modes(modes::Arguments),
    /// The launches after which a body comes to rest at a wanted pose.
    Inverse(inverse::Arguments),
    /// Simulate a scene.
    Run(run::Arguments),
    /// Reproduce the thesis' figures and tables, claim by claim.
    Reproduce(reproduce::Arguments),
}

impl Command {
    /// Does it.
    pub fn execute(self) -> Result<(), Failure> {
        match self {
            Self::Wrench(arguments) => arguments.execute(),
            Self::Modes(arguments) => arguments.execute(),
            Self::Inverse(arguments) => arguments.execute(),
            Self::Run(arguments) => arguments.execute(),
            Self::Reproduce(arguments) => arguments.execute(),
        }
    }
}
