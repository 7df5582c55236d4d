//! The tip on a substrate, turned by a torque (thesis, section 5.3): a [`scene::TipScene`] becomes a
//! [`TipRun`], whose [`Outcome`] says whether it turned back, where it locked in and which layers
//! slipped.
//!
//! [`scene::TipScene`]: crate::scene::TipScene

mod build;
mod checkpoint;
mod cost;
mod energy;
#[doc(hidden)]
pub mod export;
mod frames;
mod outcome;
mod run;
mod session;
mod shape;
mod watch;

pub use build::BuildError;
#[doc(hidden)]
pub use build::{TipSystem, build};
#[doc(hidden)]
pub use cost::{TipCost, cost, size};
#[doc(hidden)]
pub use energy::DriveEnergy;
#[doc(hidden)]
pub use outcome::Plateau;
pub use outcome::{Outcome, Verdict};
pub use run::{TipError, TipRun};
#[doc(hidden)]
pub use shape::{LAYERS_OF_A_KIND, Outline, Part, Shape, Site};
