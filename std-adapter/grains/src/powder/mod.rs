//! Cohesive powders of spheres.

mod blocked;
mod cost;
#[doc(hidden)]
pub mod deposit;
#[doc(hidden)]
pub mod export;
mod from_scene;
mod outcome;
mod powder_body;
pub(crate) mod scene;
mod start;

pub use crate::packing::ContactStatistics;
pub use crate::packing::PackingStopReason as PowderStopReason;
#[doc(hidden)]
pub use crate::packing::{
    ActiveModes, Dissipation, Limits, Material, ModeSet, NormalForces, PackingCost, PackingEnergy,
    STATE, Stress, ThresholdShares,
};
#[doc(hidden)]
pub use blocked::{Means, Window};
#[doc(hidden)]
pub use cost::{cost, size, stable_step};
pub use outcome::PowderSummary;
#[doc(hidden)]
pub use outcome::{COLUMNS, MeanStress, PistonBalance};
#[doc(hidden)]
pub use powder_body::PISTON;
pub use powder_body::PowderSimulation;
pub use tribos_base::record::CheckpointError;
