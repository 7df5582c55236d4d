//! Contact problems of packings, their solvers, and the cost of both.

pub mod conjugate;
pub mod drawn;
pub mod jammed;
pub mod ladder;
pub mod powder;
pub mod problems;
pub mod scaling;
pub mod updates;
pub mod work;
