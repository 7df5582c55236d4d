//! Small problems with known answers on which events, contact dynamics and soft particles are compared.
//!
//! *Units*: radius R, mass m and weight m g of a sphere are 1; hence the time √(R/g).

mod ball;
mod column;
mod deposit;
mod gas;
mod pile;
mod slope;

pub use ball::Ball;
pub use column::Column;
pub use deposit::Compacted;
pub use gas::Cooling;
pub use slope::Slope;

use anyhow::Result;
use std::fmt;

/// A method with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// From collision to collision.
    Events,
    /// Constraint forces.
    ContactDynamics {
        /// Root mean square of a sweep's change over P at which a step's sweeps end.
        tolerance: f64,
        /// Most sweeps of a step.
        sweeps: usize,
        /// Longest step, or largest motion in a step of a gas.
        step: f64,
    },
    /// Springs and dashpots.
    Soft {
        /// Normal stiffness, in the trial's unit.
        stiffness: f64,
        /// Least number of steps of a collision.
        steps: f64,
    },
}

/// Most sweeps where a tolerance is to end them.
pub const SWEEPS: usize = 10_000;
/// Usual number of steps of a collision.
pub const STEPS: f64 = 35.0;

impl Method {
    /// Contact dynamics whose sweeps end by their tolerance.
    pub fn rigid(tolerance: f64, step: f64) -> Self {
        let sweeps = SWEEPS;
        Self::ContactDynamics {
            tolerance,
            sweeps,
            step,
        }
    }

    /// Soft particles with the usual step.
    pub fn soft(stiffness: f64) -> Self {
        let steps = STEPS;
        Self::Soft { stiffness, steps }
    }

    /// Name of the method.
    pub fn name(self) -> &'static str {
        match self {
            Self::Events => "events",
            Self::ContactDynamics { .. } => "contact dynamics",
            Self::Soft { .. } => "soft particles",
        }
    }
}

/// The parameters.
impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Events => write!(f, "-"),
            Self::ContactDynamics {
                tolerance,
                sweeps,
                step,
            } if sweeps < SWEEPS => {
                write!(f, "tolerance {tolerance:e}; {sweeps} sweeps; step {step}")
            }
            Self::ContactDynamics {
                tolerance, step, ..
            } => write!(f, "tolerance {tolerance:e}; step {step}"),
            Self::Soft { stiffness, steps } if steps > STEPS => {
                write!(f, "k {stiffness:e}; {steps} steps a collision")
            }
            Self::Soft { stiffness, .. } => write!(f, "k {stiffness:e}"),
        }
    }
}

/// What a trial finds.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialResult {
    /// Errors, in the order of the trial's quantities.
    pub errors: Vec<f64>,
    /// Updates of contacts, collisions of events, or spheres moved in a gas.
    pub updates: f64,
}

/// A trial that is set up.
pub type PreparedTrial = Box<dyn FnOnce() -> Result<TrialResult>>;

/// A problem with a known answer.
pub trait Trial {
    /// What is in error, with its unit.
    fn quantities(&self) -> &'static [&'static str];
    /// Sets it up for a method.
    fn ready(&self, method: Method) -> Result<PreparedTrial>;
}

/// Sets a trial up and runs it.
pub fn run(trial: &dyn Trial, method: Method) -> Result<TrialResult> {
    trial.ready(method)?()
}
