//! `tribos fit --as`: the fitted law as a program, a scene, or coefficients of a simulator.

use crate::failure::Failure;
use tribos::fit::{FittedLaw, Usage, UsageTarget};

/// What the fitted law is printed as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum As {
    /// A program in Rust, with the kernel's law where it has one.
    Rust,
    /// A program in C, with the C library where it has the law.
    C,
    /// Lines of Python.
    Python,
    /// A scene for `tribos run`.
    Scene,
    /// Attributes of MuJoCo, and what they lose.
    #[value(name = "mujoco")]
    MuJoCo,
    /// Arguments of Newton's model builder, and what they lose.
    Newton,
    /// Elements of SDF for Gazebo, and what they lose.
    Gazebo,
}

impl As {
    fn target(self) -> UsageTarget {
        match self {
            Self::Rust => UsageTarget::Rust,
            Self::C => UsageTarget::C,
            Self::Python => UsageTarget::Python,
            Self::Scene => UsageTarget::Scene,
            Self::MuJoCo => UsageTarget::MuJoCo,
            Self::Newton => UsageTarget::Newton,
            Self::Gazebo => UsageTarget::Gazebo,
        }
    }
}

/// The text for a target; a law that the target cannot hold is a failure that says what to take.
pub fn text(to: As, law: &FittedLaw<'_>) -> Result<String, Failure> {
    match law.usage(to.target()).map_err(Failure::input)? {
        Usage::Text(text) => Ok(text),
        Usage::NotPossible(why) => Err(Failure::input(format!("--as: {why}"))),
    }
}
