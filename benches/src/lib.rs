//! Speed against error: what the kernel costs, what it is worth, and what else there is.
//!
//! One program, `fronts`, makes the fronts that the documentation shows: kernel (one evaluation of
//! force and torque), patches (every patch, law and tier), integrators (one stop of a sliding,
//! spinning disk), contacts (of packings, and their solvers), atoms (molecular dynamics beside
//! LAMMPS) and firmware (what each costs on a microcontroller). The benches under `benches/` time the same methods with criterion.

pub mod args;
pub mod baselines;
pub mod catalogue;
pub mod clock;
pub mod contact;
pub mod errors;
pub mod firmware;
pub mod fronts;
pub mod methods;
pub mod mix;
pub mod packing;
pub mod patches;
pub mod picture;
pub mod power_law;
pub mod reference;
pub mod stepping;
pub mod timing;
pub mod written;
