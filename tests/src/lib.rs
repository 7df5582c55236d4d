//! Checks of all promises against independent sources.
//!
//! The tests are in `tests/`, one file per promise; this library has their shared parts. No module of
//! this crate computes friction except [`rim_mean`] and [`tilted`], which are independent oracles; other
//! references are the tables of `tables/` or formulas of the test that uses them.

pub mod atoms;
pub mod contacts;
pub mod cross;
pub mod fuzz;
pub mod gas;
pub mod hard;
pub mod laws;
pub mod least_distance;
pub mod linked;
pub mod outlines;
pub mod packings;
pub mod patches;
pub mod pucks;
pub mod rebounds;
pub mod reference;
pub mod rim_mean;
pub mod sound;
pub mod surfaces;
pub mod sweep;
pub mod tables;
pub mod tiers;
pub mod tilted;
pub mod tips;
pub mod tolerance;
pub mod worst;
