//! Cohesive powders of spheres.

mod blocked;
mod compaction;
mod cost;
#[doc(hidden)]
pub mod deposit;
mod error;
#[doc(hidden)]
pub mod export;
mod outcome;
mod parts;
mod press;
pub(crate) mod scene;
mod session;
mod start;

pub use crate::packing::ContactStatistics;
#[doc(hidden)]
pub use crate::packing::{ActiveModes, Limits, Material, ModeSet, STATE, Stress};
#[doc(hidden)]
pub use blocked::{Means, Window};
pub use compaction::PowderSimulation;
#[doc(hidden)]
pub use cost::{PowderCost, cost, size, stable_step};
pub use deposit::DepositError;
pub use error::CompactionError;
#[doc(hidden)]
pub use outcome::COLUMNS;
pub use outcome::{PowderStopReason, PowderSummary};
#[doc(hidden)]
pub use parts::PISTON;
pub use tribos_base::record::CheckpointError;

#[cfg(test)]
mod tests;
