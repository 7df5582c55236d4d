//! Which method solves the contacts of a step.

use super::accelerated::{Accelerated, Tolerance};
use super::nsgs::{self, Iterations, Order, Stop, Sweeper};
use super::spheres::Spheres;
use tribos_core::contact::{ContactFriction, ContactModes, Modal};

/// A method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Plain non-linear Gauss–Seidel.
    GaussSeidel {
        /// Order of visits.
        order: Order,
        /// Rule.
        stop: Stop,
    },
    /// Gauss–Seidel with momentum, as [`Accelerated`] does it.
    Accelerated {
        /// Largest change of a sweep relative to P, in the root mean square.
        tolerance: f64,
    },
}

/// How contacts are solved.
///
/// The [module](super) has an example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solver {
    /// The method.
    pub method: Method,
    /// Most sweeps a step. The accelerated method adds half as many at most where its sweeps go round
    /// in a circle, as they may with large coefficients of friction.
    pub most_sweeps: usize,
    /// Whether a step starts from the forces of the last one.
    pub warm_start: bool,
}

impl Default for Solver {
    /// Sweeps with momentum to 1e-9, at most 1000 a step, each step from the forces of the last.
    fn default() -> Self {
        Self {
            method: Method::Accelerated { tolerance: 1e-9 },
            most_sweeps: 1000,
            warm_start: true,
        }
    }
}

/// Buffers of the methods.
#[derive(Debug)]
pub(super) struct Workspace<M: ContactModes<f64>> {
    accelerated: Accelerated<Modal<f64, M>>,
}

impl<M: ContactModes<f64>> Default for Workspace<M> {
    fn default() -> Self {
        Self {
            accelerated: Accelerated::default(),
        }
    }
}

impl<M: ContactModes<f64>> Workspace<M> {
    /// Solves the problem of a step. Its number picks the stream of random orders; `speed` is what
    /// the accelerated method may leave of a closing speed.
    pub fn solve<F: ContactFriction<f64, Modes = M>>(
        &mut self,
        solver: &Solver,
        problem: &mut Spheres<F>,
        (step, speed): (u64, f64),
    ) -> Iterations {
        let most = solver.most_sweeps;
        match solver.method {
            Method::GaussSeidel { order, stop } => {
                nsgs::solve(problem, &mut Sweeper::new(order, step), stop, most)
            }
            Method::Accelerated { tolerance } => {
                let relative = tolerance;
                self.accelerated
                    .solve(problem, Tolerance { relative, speed }, most)
            }
        }
    }
}
