//! Solvers of contact problems, and the policy that chooses among them.

mod asked;
mod blocks;
mod bodies;
mod cone;
mod factor;
mod gradient;
mod interior;
mod local;
mod natural;
mod newton;
mod policy;
mod prepared;
mod proof;
mod proximal;
mod scaling;
mod sweeps;
mod symbolic;
mod system;
#[cfg(test)]
mod tests;

pub use asked::{ProblemMethod, Solution, SolverOptions, SolverProgress, SolverStatus};
pub use policy::solve;
pub(crate) use policy::solve_directly;
