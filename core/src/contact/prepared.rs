//! A prepared contact as plain numbers: to be kept in other memory, or in another language.

use super::block::Block;
use crate::real::Real;
use nalgebra::Vector3;

/// All that [`Contact`](super::Contact) knows but its impulse, whatever its modes.
///
/// Any numbers are admitted; those that no contact has give impulses without meaning.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::{Cohesion, Contact, NormalLaw, Plate, PreparedContact, Sphere};
/// use tribos_core::contact::{Thresholds, Touch};
/// let spin = Vector3::new(0.0, 0.0, 0.0);
/// let velocity = Vector3::new(1.0, 0.0, -0.1);
/// let mut ball = Sphere { velocity, spin, inv_mass: 1.0, inv_inertia: 1e3 };
/// let mut floor = Plate { velocity: spin, inv_mass: 0.0 };
/// let touch = Touch::plate(0.05, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
/// let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// let friction = Thresholds::sliding(0.3_f64)?;
/// let contact = Contact::new(&touch, &law, &ball, &floor, 1e-3);
/// let kept: PreparedContact<f64> = contact.prepared();
/// let mut resumed = Contact::resume(&kept, contact.impulse());
/// assert_eq!(resumed, contact);
/// resumed.update(&friction, &mut ball, &mut floor);
/// # Ok::<(), tribos_core::Error>(())
/// ```
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
