//! Methods for the contact problem of a step.

use super::accelerated::{Accelerated, Tolerance};
use super::gauss_seidel::{self, IterationOrder, Iterations, StopRule, Sweeper};
use super::operator::Operator;
use super::residual::Coefficients;
use super::spheres::Spheres;
use crate::problem::solve_directly;
use tribos_core::contact::{ContactFriction, ContactModes, ContactVector};

/// Method that solves the contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolverMethod {
    /// Plain non-linear Gauss–Seidel.
    GaussSeidel {
        /// Order in which contacts are visited.
        order: IterationOrder,
        /// Stopping rule.
        stop: StopRule,
    },
    /// Gauss–Seidel with momentum, see [`Accelerated`].
    Accelerated {
        /// Largest root mean square of a sweep's change relative to P.
        tolerance: f64,
    },
}

/// Solver settings.
///
/// The [module](super) has an example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSolver {
    /// The method.
    pub method: SolverMethod,
    /// Largest number of sweeps per step. The accelerated method adds at most half as many if its sweeps
    /// cycle, which may happen with large friction coefficients.
    pub most_sweeps: usize,
    /// Share, from 0 to 1, of the last step's forces that a step starts from.
    pub warm_start: f64,
}

impl Default for ContactSolver {
    /// Sweeps with momentum to 1e-9, at most 1000 per step, starting from the forces of the last step.
    fn default() -> Self {
        Self {
            method: SolverMethod::Accelerated { tolerance: 1e-9 },
            most_sweeps: 1000,
            warm_start: 1.0,
        }
    }
}

/// Buffers of the methods.
#[derive(Debug)]
pub(super) struct Workspace<M: ContactModes<f64>> {
    accelerated: Accelerated<ContactVector<f64, M>>,
}

impl<M: ContactModes<f64>> Default for Workspace<M> {
    fn default() -> Self {
        Self {
            accelerated: Accelerated::default(),
        }
    }
}

impl<M: ContactModes<f64>> Workspace<M> {
    /// Solves the contact problem of a step. The number of the step selects the stream of random orders;
    /// `speed` is the closing speed that the accelerated method may leave.
    pub fn solve<F: ContactFriction<f64, Modes = M> + Coefficients>(
        &mut self,
        solver: &ContactSolver,
        problem: &mut Spheres<F>,
        (step, speed): (u64, f64),
    ) -> Answer {
        let most = solver.most_sweeps;
        let mut handed_over = false;
        let iterations = match solver.method {
            SolverMethod::GaussSeidel { order, stop } => {
                gauss_seidel::solve(problem, &mut Sweeper::new(order, step), stop, most)
            }
            SolverMethod::Accelerated { tolerance } => {
                let relative = tolerance;
                let goal = Tolerance { relative, speed };
                self.accelerated.solve_or(problem, goal, most, |problem| {
                    handed_over = solve_as_data(problem, relative, most).is_some();
                    handed_over
                })
            }
        };
        Answer {
            iterations,
            handed_over,
        }
    }
}

/// How a contact problem was solved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    pub iterations: Iterations,
    /// Whether the impulses are those of a solver for general contact problems, improved by sweeps.
    pub handed_over: bool,
}

/// Time of a contact in a sweep, in multiplications.
const A_CONTACT: f64 = 40.0;
/// Largest foreseen cost of the other solver, in units of all sweeps that a step may take.
const DEARER: f64 = 4.0;
/// Largest residual of the other solver's answer, in units of the tolerance.
const FINER: f64 = 0.1;

/// Solves the problem with a factorisation, unless that is foreseen to be much dearer than all sweeps.
fn solve_as_data<F>(problem: &mut Spheres<F>, tolerance: f64, most: usize) -> Option<()>
where
    F: ContactFriction<f64> + Coefficients,
{
    let most_cost = DEARER * A_CONTACT * (problem.contacts() * most) as f64;
    let posed = problem.to_problem()?;
    let reduced = posed.problem.reduced().ok()?;
    let found = solve_directly(&reduced, FINER * tolerance, most_cost)?;
    problem.apply_solution(&posed, &found.impulses);
    Some(())
}
