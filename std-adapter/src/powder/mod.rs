//! Cohesive powders of spheres.

mod blocked;
mod carried;
mod checkpoint;
mod compaction;
mod cost;
#[doc(hidden)]
pub mod deposit;
mod error;
mod frames;
mod limits;
mod outcome;
mod packing;
mod session;
mod statistics;
mod stress;

pub use crate::record::CheckpointError;
#[doc(hidden)]
pub use blocked::{Means, Window};
#[doc(hidden)]
pub use carried::{Carried, CarriedModes};
#[doc(hidden)]
pub use compaction::COLUMNS;
pub use compaction::{Compaction, Ending};
#[doc(hidden)]
pub use cost::{PowderCost, cost, size};
pub use deposit::DepositError;
pub use error::CompactionError;
#[doc(hidden)]
pub use limits::Limits;
pub use outcome::Outcome;
#[doc(hidden)]
pub use packing::PISTON;
pub use statistics::Statistics;
#[doc(hidden)]
pub use stress::Stress;

#[cfg(test)]
mod tests;
