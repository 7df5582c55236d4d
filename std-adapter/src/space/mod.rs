//! Where particles are: periodic boxes, and who is near whom.

mod grid;
pub mod pairs;
mod periodic;

pub use periodic::{AXES, PeriodicBox, PeriodicBoxError};
