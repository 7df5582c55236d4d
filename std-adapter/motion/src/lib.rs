//! Bodies that slide, stick, are pushed and let go, and friction laws from measurements.
//!
//! Users take it through the crate `tribos`, whose paths are the promise; what else is public here
//! serves the crates beside it and changes without notice.

mod error;
pub mod fit;
mod motion_run;
pub mod onset;
pub mod push;
pub mod slide;
pub mod stick;

pub use error::MotionError;
pub use motion_run::SceneRun;
#[doc(hidden)]
pub use motion_run::{MotionRun, MotionScene, measured_motion};

/// The scenes of all of them.
pub mod scene {
    pub use crate::push::scene::PushScene;
    pub use crate::slide::scene::*;
    pub use crate::stick::scene::*;
}
