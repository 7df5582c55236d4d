//! Pictures and films of runs.

pub mod deposit;
mod frames;
pub mod gas;
pub mod grains;
pub mod measure;
mod packing;
pub mod powder;
pub mod tip;

pub use frames::{FilmError, RunFrames};
