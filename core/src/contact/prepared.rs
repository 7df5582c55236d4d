//! A prepared contact as plain numbers: to be kept in other memory, or in another language.

use super::block::Block;
use crate::real::Real;
use nalgebra::Vector3;

/// All that [`Contact`](super::Contact) knows but its impulse, whatever its modes.
///
/// Any numbers are admitted; those that no contact has give impulses without meaning.
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
