//! What is promised of the whole: the same bits everywhere, arbitrary input, damaged files.

mod damaged;
mod determinism;
mod digest_coverage;
mod found;
mod fuzz;
mod golden;
mod scene_bits;
mod shown;
mod tip_bits;
