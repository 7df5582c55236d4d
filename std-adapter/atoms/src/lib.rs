//! Molecular dynamics: pair potentials and embedded atoms, and a tip of atoms that is turned or slid on
//! a substrate.
//!
//! Users take it through the crate `tribos`, whose paths are the promise; what else is public here
//! serves the crates beside it and changes without notice.

pub mod md;
pub mod tip;

/// The scene of a tip.
pub mod scene {
    pub use crate::tip::scene::{
        DriveKind, DrivenHold, StageSteps, ThermostatBias, ThermostatKind, TipScene,
        TorqueNormalisation,
    };
}
