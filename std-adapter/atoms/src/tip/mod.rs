//! The tip on a substrate, turned by a torque or slid by a support (thesis, section 5.3): a [`scene::TipScene`] becomes a
//! [`TipSimulation`], whose [`TipSummary`] says whether it turned back, where it locked in and which layers
//! slipped.
//!
//! [`scene::TipScene`]: crate::tip::scene::TipScene

mod build;
mod checkpoint;
mod cost;
mod energy;
#[doc(hidden)]
pub mod export;
mod forces;
mod lattice;
mod loop_work;
mod monitor;
mod outcome;
mod potential;
mod run;
pub(crate) mod scene;
mod session;
mod shape;
mod sliding_summary;
mod start;

pub use crate::md::system::Integrator;
#[doc(hidden)]
pub use build::{TipSystem, build};
#[doc(hidden)]
pub use cost::{TipCost, cost, size};
pub use energy::DriveEnergy;
#[doc(hidden)]
pub use forces::TipForces;
pub use lattice::CrystalFace;
pub use outcome::{AnglePlateau, Reversal, TipSummary};
pub use potential::TipPotential;
pub use run::{TipError, TipSimulation};
pub use shape::TipOutline;
#[doc(hidden)]
pub use shape::{AtomRole, LAYERS_OF_A_KIND, Shape, Site};
pub use sliding_summary::SlidingSummary;
pub use start::EquilibriumCheck;
