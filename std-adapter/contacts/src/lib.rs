//! Spheres in contact: contact dynamics, contact problems as data, soft spheres, hard spheres from
//! collision to collision. No scene is known here.
//!
//! Users take it through the crate `tribos`, whose paths are the promise; what else is public here
//! serves the crates beside it and changes without notice.

pub mod cd;
pub mod event;
pub mod problem;
pub mod soft;
