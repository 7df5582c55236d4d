//! Grains in boxes: gravity, pistons, moving plates, shaking.
//!
//! A [`GrainsScene`](crate::grains::scene::GrainsScene) says the box, the grains, their material and the loads,
//! which may be [`Ramp`]s in time. [`GrainsSimulation`] runs it.

mod bound;
#[cfg(test)]
mod bound_tests;
mod container;
mod cost;
#[doc(hidden)]
pub mod export;
mod from_scene;
mod grains_body;
mod initial_grains;
mod layout;
mod loads;
mod materials;
mod measure;
mod mesh;
mod outcome;
mod placement;
mod ramp;
pub(crate) mod scene;
mod texts;
mod wall;

pub(crate) use bound::held_types;

pub use crate::packing::PackingStopReason as GrainsStopReason;
#[doc(hidden)]
pub use container::{PlateOutline, plates};
#[doc(hidden)]
pub use cost::{cost, size, stable_step};
pub use grains_body::GrainsSimulation;
pub use materials::PropertyList;
#[doc(hidden)]
pub use measure::{COLUMNS, GrainsLine};
pub use outcome::GrainsSummary;
#[doc(hidden)]
pub use outcome::{HopperFlow, averages};
pub use ramp::Ramp;
pub use texts::{Coordinates, GrainTypes};
