//! Contact problems as data: impulses at contacts, velocities that depend on them, and the laws of both.
//!
//! A [`ReducedProblem`] problem has u = W r + q. [`solve`] finds impulses that every contact admits, and [`residual`]
//! judges them without the solvers' code.

mod error;
mod file;
mod global;
mod law;
mod matrix;
mod reduced;
mod residual;
mod solve;
mod squeeze;
#[cfg(test)]
mod tests;

pub use error::ProblemError;
pub use file::{ContactProblem, ProblemFormat};
#[doc(hidden)]
pub use file::{Fault, FilePosition};
pub use global::GlobalProblem;
pub use law::{ContactComponents, ContactThresholds, Friction};
pub use matrix::SparseMatrix;
pub use reduced::ReducedProblem;
pub use residual::{ProblemResidual, residual};
pub(crate) use solve::solve_directly;
pub use solve::{ProblemMethod, Solution, SolverOptions, SolverProgress, SolverStatus, solve};
pub use squeeze::Squeeze;
