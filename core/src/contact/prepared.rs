//! A prepared contact as plain numbers, for storage outside of Rust.

use super::block::Block;
use crate::real::Real;
use nalgebra::Vector3;

/// Everything in a [`Contact`](super::Contact) except its impulse, independent of its modes.
///
/// Values are not validated; inconsistent ones give meaningless impulses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedContact<R: Real> {
    /// Unit normal, from the first body to the second.
    pub normal: Vector3<R>,
    /// Distances of the centres from the contact point.
    pub arms: [R; 2],
    /// r_eff
    pub lever: R,
    /// Effective masses.
    pub block: Block<R>,
    /// F_coh dt, or 0 beyond the range of cohesion.
    pub cohesion: R,
    /// Speed of approach that the law takes as closed; minus the rebound speed.
    pub allowance: R,
    /// True if cohesion lets the gap, now open, stay as it is.
    pub rests_open: bool,
}
