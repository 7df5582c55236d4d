//! What to do with a fitted law: programs, scenes and coefficients that have its numbers.

mod c;
mod python;
mod reduced;
mod rust;
mod scene;
mod shape;
mod simulators;
mod spec;

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod samples;
#[cfg(test)]
mod tests;

use std::fmt;
use tribos_core::law::LawError;

/// A fitted law with its numbers.
///
/// ```
/// use tribos::fit::{FittedLaw, Usage, UsageTarget};
/// let parameters = [("mu_s", 0.4), ("mu_d", 0.2), ("vs", 0.05)];
/// let oil = FittedLaw { law: "stribeck", parameters: &parameters, is_per_load: true };
/// let python = oil.usage(UsageTarget::Python)?;
/// assert!(matches!(&python, Usage::Text(text) if text.contains("tribos.Law(\"stribeck\", mu_s=0.4")));
/// // What a target cannot hold is said in words.
/// let sum = FittedLaw { law: "maxwell", parameters: &[("k1", 1e5), ("f1", 2.0)], is_per_load: false };
/// assert!(matches!(sum.usage(UsageTarget::Scene)?, Usage::NotPossible(_)));
/// # Ok::<(), tribos::fit::UsageError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedLaw<'a> {
    /// Name of the law, as `tribos fit` knows it.
    pub law: &'a str,
    /// Names and values of its parameters; `inertia` and `offset` of the apparatus may be among them.
    pub parameters: &'a [(&'a str, f64)],
    /// True if friction is a coefficient, false if it is a force or a torque.
    pub is_per_load: bool,
}

/// Where a fitted law goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UsageTarget {
    /// A program in Rust with the kernel.
    Rust,
    /// A program in C; with the library where that has the law.
    C,
    /// Lines of Python.
    Python,
    /// A scene for `tribos run`.
    Scene,
    /// Attributes of MuJoCo.
    MuJoCo,
    /// Arguments of Newton's model builder.
    Newton,
    /// Elements of SDF, as Gazebo reads them.
    Gazebo,
}

/// What a target takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Usage {
    /// Text in the language of the target.
    Text(String),
    /// The target has nothing like the law: why, and what to take, as a sentence.
    NotPossible(String),
}

impl fmt::Display for Usage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Text(text) | Self::NotPossible(text)) = self;
        f.write_str(text)
    }
}

/// Why there is no text.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UsageError {
    /// No law has this name.
    #[error("there is no fitted law `{name}`; there are {}", shape::NAMES.join(", "))]
    Unknown {
        /// The rejected name.
        name: String,
    },
    /// A parameter is missing.
    #[error("{law} needs a value of `{parameter}`")]
    Missing {
        /// Name of the law.
        law: String,
        /// Name of the parameter.
        parameter: &'static str,
    },
    /// The law refuses a value.
    #[error("{law}: {error}")]
    Refused {
        /// Name of the law.
        law: String,
        /// What is wrong.
        error: LawError,
    },
}

impl FittedLaw<'_> {
    /// What the target takes to use this law.
    pub fn usage(&self, target: UsageTarget) -> Result<Usage, UsageError> {
        let shape = self.shape()?;
        Ok(match target {
            UsageTarget::Rust => Usage::Text(rust::program(self, &shape)),
            UsageTarget::C => Usage::Text(c::program(self, &shape)),
            UsageTarget::Python => Usage::Text(python::lines(self, &shape)),
            UsageTarget::Scene => scene::scene(self, &shape),
            UsageTarget::MuJoCo => simulators::mujoco(self, &shape),
            UsageTarget::Newton => simulators::newton(self, &shape),
            UsageTarget::Gazebo => simulators::gazebo(self, &shape),
        })
    }

    /// The law of steady sliding as scenes and `tribos wrench --law` take it; none where the catalogue has nothing like it.
    pub fn spec(&self) -> Result<Option<String>, UsageError> {
        Ok(self.shape()?.spec())
    }

    /// What friction is measured in, in words of a comment.
    fn unit(&self) -> &'static str {
        match self.is_per_load {
            true => "friction per load",
            false => "friction in N",
        }
    }
}

/// A number that every language here reads back to its last bit.
fn number(x: f64) -> String {
    format!("{x:?}")
}

/// Speeds at which programs print friction, in m/s.
const SHOWN_SPEEDS: [f64; 3] = [0.001, 0.01, 0.1];
/// Velocities of the steps that programs with a state print, in m/s: there and back.
const SHOWN_VELOCITIES: [f64; 3] = [0.01, 0.01, -0.01];
/// Length of these steps, in s.
const SHOWN_STEP: f64 = 0.001;

/// Programs of all laws, which the tests of the documentation run.
#[cfg(doctest)]
#[doc = include_str!("programs.md")]
struct Programs;
