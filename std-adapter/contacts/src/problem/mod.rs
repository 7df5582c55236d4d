//! Contact problems as data: impulses at contacts, velocities that depend on them, and the laws of both.
//!
//! A [`Reduced`] problem has u = W r + q. [`solve`] finds impulses that every contact admits, and [`residual`]
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
#[doc(hidden)]
pub use file::{Fault, Place};
pub use file::{FileError, Format, Problem};
pub use global::Global;
pub use law::{ContactLaw, Friction, Layout};
pub use matrix::Matrix;
pub use reduced::Reduced;
pub use residual::{Residual, residual};
pub(crate) use solve::solve_directly;
pub use solve::{Ending, Method, Progress, Settings, Solution, solve};
pub use squeeze::Squeeze;
