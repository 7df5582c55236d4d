//! Granular gases: spheres in a periodic cube that cool by their collisions.

mod checkpoint;
mod engine;
mod lattice;
mod outcome;
mod run;
pub(crate) mod scene;
mod session;
mod size;
mod soft;
mod start;
mod state;
mod time_stepped;

pub use crate::packing::PackingStopReason as GasStopReason;
pub(crate) use lattice::edge;
#[doc(hidden)]
pub use outcome::COLUMNS;
pub use outcome::GasSummary;
pub use run::GasSimulation;
#[doc(hidden)]
pub use size::size;
#[doc(hidden)]
pub use soft::{SoftCollision, soft_collision};
pub use tribos_base::record::CheckpointError;
