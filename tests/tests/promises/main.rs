//! What is promised of the whole: the same bits everywhere, arbitrary input, damaged files, the kept
//! surface of the libraries.

mod coverage;
mod damaged;
mod found;
mod fuzz;
mod golden;
mod names;
mod pages;
mod scene_bits;
mod surface;
mod tip_bits;
mod walls;
