//! Grains in boxes: gravity, pistons, moving plates, shaking.
//!
//! A [`GrainsScene`](crate::grains::scene::GrainsScene) says the box, the grains, their material and the loads,
//! which may be [`Ramp`]s in time. [`Grains`] runs it.

mod begin;
mod container;
mod cost;
mod error;
mod laden;
mod layout;
mod loads;
mod measure;
mod outcome;
mod parts;
mod placement;
mod ramp;
mod run;
pub(crate) mod scene;
mod session;
#[cfg(test)]
mod sheared_tests;
mod wall;

#[doc(hidden)]
pub use cost::{GrainsCost, cost, size, stable_step};
pub use error::GrainsError;
#[doc(hidden)]
pub use measure::COLUMNS;
pub use outcome::{Ending, Outcome};
pub use placement::PlacementError;
pub use ramp::{Ramp, RampError};
pub use run::Grains;

#[cfg(test)]
mod tests;
