//! Packings: spheres between walls, with a material and a method for their contacts chosen at run time.
//!
//! A body's scene says the `Material`, the `Bodies` and the `Method`; `build` makes a `Packing` of them. A
//! [`PackingRun`] runs it: the `PackingBody` says its loads, its measures and when it ends.

mod about;
mod active_modes;
pub mod assembly;
mod body;
mod checkpoint;
mod cost;
mod energy;
pub(crate) mod export;
mod initial_state;
mod kinds;
mod last;
mod limits;
mod material;
pub mod method;
mod mixture;
mod optional_features;
mod placement_error;
mod read;
mod rigid;
mod run;
mod run_error;
mod setting_error;
mod sizes;
mod snapshot;
mod soft;
mod statistics;
mod stop_reason;
mod stored;
mod stress;
mod totals;
mod volume;
mod world;
mod write;

pub use active_modes::{ActiveModes, ModeSet};
pub use assembly::Assembly;
pub(crate) use body::{ContactKeys, MeasuredState, MeasurementSchedule, PackingBody, RunLimits};
pub use cost::PackingCost;
pub(crate) use cost::{BYTES_A_SPHERE, SOFT_SECONDS, stable_step, stable_step_between};
pub use energy::{Dissipation, PackingEnergy};
pub(crate) use initial_state::{InitialSpheres, SAME_PERIOD, deepest, given};
pub(crate) use kinds::{Kinds, mixed, origin};
pub use limits::Limits;
pub use material::Material;
pub(crate) use mixture::{Component, LawChanges, Mixture, SecondMaterialKeys};
pub(crate) use optional_features::OptionalFeatures;
pub use placement_error::{MOST_SPHERES, PlacementError};
pub use read::{AssemblyError, PackingColumns, PackingColumnsError, PackingFormat};
pub(crate) use read::{COLUMNS, COLUMNS_ALONE};
pub use run::PackingRun;
pub use run_error::PackingRunError;
pub use setting_error::SettingError;
pub(crate) use sizes::SIZES;
pub use sizes::{Radii, SizeDistribution};
pub(crate) use snapshot::{Force, Forces, WorldSnapshot};
pub use statistics::{ContactStatistics, NormalForces, ThresholdShares};
pub use stop_reason::PackingStopReason;
pub use stored::STATE;
pub(crate) use stored::{Shape, Stored, scene};
pub use stress::Stress;
pub(crate) use totals::Totals;
pub use volume::volume_between;
pub(crate) use world::{Bodies, Method, Packing, Springs, branch, build, build_with, is_at};
pub use write::WrittenPacking;
