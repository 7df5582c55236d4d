//! What is promised of the whole: the same bits everywhere, arbitrary input, damaged files.

mod coverage;
mod damaged;
mod determinism;
mod found;
mod fuzz;
mod golden;
mod scene_bits;
mod tip_bits;
