//! Checks of all promises against independent references.
//!
//! The tests are in `tests/`, one file per promise; this library contains their shared parts. Of its modules
//! only [`rim_mean`] and [`tilted`], which are independent oracles, compute friction; other
//! references are the tables of `tables/` or formulas of the test that uses them.

pub mod atoms;
pub mod batches;
pub mod contacts;
pub mod cross;
pub mod fuzz;
pub mod gas;
pub mod hard;
pub mod holds;
pub mod laws;
pub mod least_distance;
pub mod linked;
pub mod meshes;
pub mod outlines;
pub mod packings;
pub mod patches;
pub mod problems;
pub mod pucks;
pub mod rebounds;
pub mod reference;
pub mod rim_mean;
pub mod sound;
pub mod surfaces;
pub mod sweep;
pub mod tables;
pub mod tilted;
pub mod tips;
pub mod tolerance;
pub mod worst;
