//! Periodic boxes, and neighbours within them.

mod grid;
pub mod pairs;
mod periodic;

pub use periodic::{AXES, PeriodicBox, PeriodicBoxError};
