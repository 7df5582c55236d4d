//! Bodies that hold, let go and hold again: a slider on a spring, a block on an incline, a body on a
//! turntable, a body in a pinch.
//!
//! Rest is exact: a body that holds has the velocity zero and stays where it is, to the bit. The instants
//! at which it lets go and stops are computed, not taken from the grid of the series.

pub mod clamp;
pub mod incline;
pub(crate) mod scene;
pub mod spring;
pub mod turntable;

pub use crate::error::MotionError;
