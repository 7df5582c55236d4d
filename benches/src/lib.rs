//! Speed against error: cost and accuracy of the kernel and of its alternatives.
//!
//! One program, `fronts`, makes the fronts that the documentation shows: kernel (one evaluation of force
//! and torque), batch (calls one by one and in batches), patches (every patch, law and tier), integrators (one
//! stop of a sliding, spinning disk), contacts (of packings, and their solvers), scale (packings of a thousand
//! to a million spheres), methods (events, contact dynamics and soft particles), problems (contact problems beside
//! Siconos), atoms (molecular dynamics beside LAMMPS), modes (whole runs with a mode left out) and firmware (the cost of
//! each on a microcontroller). The benches under `benches/` time the same methods with criterion.

pub mod args;
pub mod baselines;
pub mod catalogue;
pub mod clock;
pub mod command_line;
pub mod contact;
pub mod errors;
pub mod firmware;
pub mod front;
pub mod fronts;
pub mod methods;
pub mod mix;
pub mod outlines;
pub mod packing;
pub mod patches;
pub mod picture;
pub mod power_law;
pub mod reference;
pub mod stepping;
pub mod timing;
pub mod written;
