//! Solvers of contact problems, and the policy that chooses among them.

mod automatic;
mod blocks;
mod bodies;
mod cone;
mod delassus_block;
mod factor;
mod gradient;
mod interior;
mod natural;
mod newton;
mod options;
mod prepared;
mod proof;
mod proximal;
mod scaling;
mod sweeps;
mod symbolic;
mod system;
#[cfg(test)]
mod tests;

pub use automatic::solve;
pub(crate) use automatic::solve_directly;
pub use options::{ProblemMethod, Solution, SolverOptions, SolverProgress, SolverStatus};
