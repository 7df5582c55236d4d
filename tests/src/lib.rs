//! Checks of all promises against independent references.
//!
//! The tests are in `tests/`, one file per promise; this library contains their shared parts. Of its modules
//! only [`rim_mean`] and [`tilted`], which are independent oracles, compute friction; other
//! references are the tables of `tables/` or formulas of the test that uses them.

#[cfg(feature = "library")]
pub mod atoms;
pub mod batches;
pub mod contacts;
#[cfg(feature = "library")]
pub mod cross;
#[cfg(feature = "library")]
pub mod fuzz;
#[cfg(feature = "library")]
pub mod gas;
#[cfg(feature = "library")]
pub mod hard;
pub mod holds;
pub mod laws;
pub mod least_distance;
#[cfg(feature = "library")]
pub mod linked;
pub mod meshes;
pub mod outlines;
#[cfg(feature = "library")]
pub mod packings;
#[cfg(feature = "library")]
pub mod pages;
pub mod patches;
#[cfg(feature = "library")]
pub mod problems;
pub mod pucks;
#[cfg(feature = "library")]
pub mod rebounds;
pub mod reference;
pub mod rim_mean;
#[cfg(feature = "library")]
pub mod sound;
pub mod surfaces;
pub mod sweep;
pub mod tables;
pub mod tilted;
#[cfg(feature = "library")]
pub mod tips;
pub mod tolerance;
pub mod worst;
