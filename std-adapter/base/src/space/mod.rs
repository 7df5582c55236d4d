//! Periodic boxes, and neighbours within them.

mod grid;
#[doc(hidden)]
pub mod pairs;
mod periodic;
mod search;
#[cfg(test)]
mod sheared_tests;

pub use pairs::SpaceError;
#[doc(hidden)]
pub use periodic::AXES;
pub use periodic::PeriodicBox;
