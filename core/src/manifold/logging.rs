//! `defmt::Format` of a manifold.

use super::ContactSystem;
use crate::contact::ContactFriction;
use crate::real::Real;
use defmt::{Format, Formatter};

impl<R, F, const BODIES: usize, const CONTACTS: usize> Format
    for ContactSystem<R, F, BODIES, CONTACTS>
where
    R: Real + Format,
    F: ContactFriction<R> + Format,
{
    fn format(&self, f: Formatter) {
        defmt::write!(
            f,
            "manifold of {=usize} bodies and {=usize} contacts: {}, {}",
            self.bodies.len(),
            self.contacts.len(),
            self.law,
            self.friction
        );
    }
}
