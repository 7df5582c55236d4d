//! Event-driven dynamics of hard spheres: free flight from one binary collision to the next.
//!
//! Spheres are equal and solid, in a periodic cube. *Units*: lengths in the radius R, masses in the mass m of a
//! sphere; the unit of velocity is free. A collision is instantaneous and [`Impact`] gives its outcome;
//! between collisions motion is exact. Dense dissipative gases collapse: infinitely many collisions in a finite
//! time. [`HardSpheres::advance`] reports it, and a contact time (the TC model) prevents it.

mod body;
mod cells;
mod impact;
mod queue;
mod spheres;
mod stored;
#[cfg(test)]
mod tests;
mod theory;

pub use impact::{Impact, ImpactError, Motion, Tangential};
pub use spheres::{Advance, EventError, HardSpheres};
#[doc(hidden)]
pub use stored::Stored;
pub use theory::{Temperatures, collision_rate, contact_value};
