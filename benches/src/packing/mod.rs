//! Contact problems of contact dynamics and what solvers make of them.

pub mod jammed;
pub mod problems;
pub mod updates;
