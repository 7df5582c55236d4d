//! Scenes of bodies that hold, let go and hold again.

mod clamp;
mod incline;
mod spring;
mod turntable;

pub use clamp::ClampScene;
pub use incline::InclineScene;
pub use spring::{SpringFriction, SpringScene};
pub use turntable::TurntableScene;
