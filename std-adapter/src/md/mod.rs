//! Molecular dynamics: atoms that act on each other up to a cut-off.

pub mod atoms;
pub mod interaction;
pub mod neighbours;
pub mod pair;
