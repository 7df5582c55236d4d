//! What is asked of a solver, and what it answers.

use super::super::residual::ProblemResidual;
use super::super::squeeze::Squeeze;

/// A method for a contact problem.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ProblemMethod {
    /// Sweeps, then, where their foreseen cost is that of several factorisations, the interior point method,
    /// Newton's method near its end, and proximal points.
    #[default]
    Automatic,
    /// Gauss–Seidel sweeps with momentum.
    Sweeps,
    /// Projected gradients with momentum.
    Gradient,
    /// Interior point method and Newton's method near its end.
    Interior,
    /// Proximal points with Newton's method.
    Proximal,
}

impl ProblemMethod {
    /// All methods.
    pub const ALL: [Self; 5] = [
        Self::Automatic,
        Self::Sweeps,
        Self::Gradient,
        Self::Interior,
        Self::Proximal,
    ];

    /// Its name in commands and summaries.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Automatic => "automatic",
            Self::Sweeps => "sweeps",
            Self::Gradient => "gradient",
            Self::Interior => "interior",
            Self::Proximal => "proximal",
        }
    }
}

/// What is asked of a solver.
#[derive(Clone, Debug, PartialEq)]
pub struct SolverOptions {
    /// Largest residual of a solution, plain and scaled.
    pub tolerance: f64,
    /// Method.
    pub method: ProblemMethod,
    /// Most sweeps.
    pub most_sweeps: usize,
    /// Most factorisations.
    pub most_factorisations: usize,
    /// Impulses to start from, in the units of the problem; without them from zero, as from a list of another
    /// length or with numbers that are not finite.
    pub start: Option<Vec<f64>>,
}

impl Default for SolverOptions {
    /// 1e-8, the method chosen by foreseen cost, at most 200,000 sweeps and 2,000 factorisations.
    fn default() -> Self {
        Self {
            tolerance: 1e-8,
            method: ProblemMethod::Automatic,
            most_sweeps: 200_000,
            most_factorisations: 2000,
            start: None,
        }
    }
}

/// How a solver ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolverStatus {
    /// Both residuals are at most the tolerance.
    Converged,
    /// All methods stopped above the tolerance, with work left.
    Stalled,
    /// The work allowed was spent.
    OutOfWork,
    /// The problem has no solution: [`Solution::squeeze`] is the proof.
    Insoluble,
}

impl SolverStatus {
    /// Its name in summaries.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Stalled => "stalled",
            Self::OutOfWork => "out of work",
            Self::Insoluble => "insoluble",
        }
    }
}

/// Work done, and the residual.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolverProgress {
    /// Sweeps so far.
    pub sweeps: usize,
    /// Factorisations so far.
    pub factorisations: usize,
    /// Scaled residual of the point at hand; the larger of both sizes where it was judged.
    pub residual: f64,
    /// The method at work.
    pub method: ProblemMethod,
}

/// Impulses, and what is known of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Impulses, in the units and in the order of the problem.
    pub impulses: Vec<f64>,
    /// Velocities u = W r + q.
    pub velocities: Vec<f64>,
    /// Their residuals, judged apart from the solver.
    pub residual: ProblemResidual,
    /// Why the solver ended.
    pub ending: SolverStatus,
    /// Proof that there is no solution, where one was found.
    pub squeeze: Option<Squeeze>,
    /// The method that found them.
    pub method: ProblemMethod,
    /// Sweeps made.
    pub sweeps: usize,
    /// Interior point, Newton and proximal steps made, one factorisation each.
    pub factorisations: usize,
}
