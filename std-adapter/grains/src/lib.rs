//! Packings of grains: powders under a piston, grains in boxes, granular gases, and what is measured
//! on them.
//!
//! Users take it through the crate `tribos`, whose paths are the promise; what else is public here
//! serves the crates beside it and changes without notice.

pub mod gas;
pub mod grains;
pub mod measure;
pub mod packing;
pub mod powder;

/// The scenes of all of them.
pub mod scene {
    pub use crate::gas::scene::{GasMethod, GasScene};
    pub use crate::grains::scene::{
        Adhesion, Axis, Container, EndBoundary, GrainsScene, SideBoundary,
    };
    pub use crate::packing::method::{ContactMethod, FrictionCoupling, NormalForce, WallLaw};
    pub use crate::powder::scene::{
        BlockedCriterion, PowderScene, SweepMethod, SweepOrder, SweepStop,
    };
}
