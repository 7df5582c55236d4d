//! Granular gases: spheres in a periodic cube that cool by their collisions.

mod checkpoint;
mod error;
mod frames;
mod medium;
mod outcome;
mod room;
mod run;
pub(crate) mod scene;
mod session;
mod size;
mod soft;
mod start;
mod state;
mod stepped;
#[cfg(test)]
mod tests;

pub use error::GasError;
#[doc(hidden)]
pub use outcome::COLUMNS;
pub use outcome::{Ending, Outcome};
pub(crate) use room::edge;
pub use run::Gas;
#[doc(hidden)]
pub use size::size;
#[doc(hidden)]
pub use soft::{SoftCollision, soft_collision};
pub use tribos_base::record::CheckpointError;
