//! Cohesive powders of spheres.

pub mod deposit;
