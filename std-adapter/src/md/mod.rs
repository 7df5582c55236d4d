//! Molecular dynamics: atoms that act on each other up to a cut-off.

pub mod atoms;
pub mod configuration;
pub mod eam;
pub mod extended_xyz;
pub mod interaction;
pub mod lammps;
pub mod neighbours;
pub mod pair;
pub mod text;
