//! Which method solves the contacts of a step.

use super::anderson::Anderson;
use super::momentum::Momentum;
use super::nsgs::{self, Effort, Order, Stop, Sweeper};
use super::spheres::Spheres;
use tribos_core::contact::{ContactFriction, Modal, Modes};

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
    /// Gauss–Seidel with momentum, to a relative change.
    Momentum {
        /// Tolerance.
        tolerance: f64,
    },
    /// Anderson acceleration, to a relative change.
    Anderson {
        /// Tolerance.
        tolerance: f64,
        /// Window.
        window: usize,
    },
}

/// How contacts are solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solver {
    /// The method.
    pub method: Method,
    /// Most sweeps a step.
    pub most_sweeps: usize,
    /// Whether a step starts from the forces of the last one.
    pub warm_start: bool,
}

/// Buffers and streams of a method.
#[derive(Debug)]
pub(super) struct SolverState<M: Modes<f64>> {
    sweeper: Sweeper,
    momentum: Momentum<Modal<f64, M>>,
    anderson: Anderson<Modal<f64, M>>,
}

impl<M: Modes<f64>> SolverState<M> {
    pub fn new(solver: &Solver) -> Self {
        let order = match solver.method {
            Method::GaussSeidel { order, .. } => order,
            _ => Order::Alternating,
        };
        let window = match solver.method {
            Method::Anderson { window, .. } => window,
            _ => 0,
        };
        Self {
            sweeper: Sweeper::new(order),
            momentum: Momentum::default(),
            anderson: Anderson::new(window),
        }
    }

    pub fn solve<F: ContactFriction<f64, Modes = M>>(
        &mut self,
        solver: &Solver,
        problem: &mut Spheres<F>,
    ) -> Effort {
        let most = solver.most_sweeps;
        match solver.method {
            Method::GaussSeidel { stop, .. } => nsgs::solve(problem, &mut self.sweeper, stop, most),
            Method::Momentum { tolerance } => self.momentum.solve(problem, tolerance, most),
            Method::Anderson { tolerance, .. } => self.anderson.solve(problem, tolerance, most),
        }
    }
}
