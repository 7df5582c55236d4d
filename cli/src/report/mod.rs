//! What people look at: figures, text tables and the page of a reproduction.

pub mod claim;
pub mod digits;
pub mod figure;
pub mod image;
pub mod packing;
pub mod page;
pub mod player;
pub mod sheet;
mod solid;
pub mod surface;
pub mod verdict;
