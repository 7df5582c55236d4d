//! Figures, pictures and films of runs, and pages of claims. This crate contains no physics.

pub mod claim;
pub mod diagram;
pub mod digits;
pub mod drawing_grid;
pub mod figure;
mod html;
pub mod image;
pub mod limit_surface;
pub mod packing;
pub mod page;
pub mod player;
pub mod runs;
mod solid;
pub mod surface;
pub mod verdict;
