//! Impacts with restitution, before the loads and the lasting contacts of a step.
//!
//! Contacts that would close in the step by their bodies' velocities impact one after the other, in
//! the order in which they were added, until none closes any more. Every impact is that of two
//! bodies alone, by Newton's law along the normal and Coulomb's across it. For spheres and plates it
//! never raises the energy: the normal passes through both centres, so that friction and restitution
//! do not meet (Kane's example of a gain needs several contacts solved at once, or a body whose
//! normal misses the centre; Glocker, Multibody Syst. Dyn. 29 (2013) 77).

use super::solve::pair;
use super::{ContactPair, ContactSystem};
use crate::contact::{Contact, ContactFriction, ContactVector, NormalLaw};
use crate::real::Real;

/// Approach, in units of the fastest of the first round, below which there is no impact: its energy
/// is 1e-12 of that one's.
const SLOW: f64 = 1e-6;

impl<R: Real, F: ContactFriction<R>, const BODIES: usize, const CONTACTS: usize>
    ContactSystem<R, F, BODIES, CONTACTS>
{
    /// Computes all impacts, in at most `rounds` rounds over the contacts. What approaches after them
    /// is stopped without rebound.
    pub(super) fn impact(&mut self, dt: R, rounds: u32) {
        for joint in &mut self.contacts {
            joint.impact = ContactVector::default();
        }
        let mut slow = R::ZERO;
        for round in 0..rounds {
            let fastest = self.impact_round(dt, slow);
            let over = fastest <= R::ZERO;
            if over {
                return;
            }
            if round == 0 {
                slow = fastest * R::from_f64(SLOW);
            }
        }
    }

    /// One round; returns the fastest approach of a contact that took an impact, 0 without any.
    fn impact_round(&mut self, dt: R, slow: R) -> R {
        let mut fastest = R::ZERO;
        for ContactPair {
            bodies,
            touch,
            impact,
            ..
        } in &mut self.contacts
        {
            let Some([a, b]) = pair(&mut self.bodies, *bodies) else {
                continue;
            };
            let law = &self.law;
            let mut contact =
                Contact::new(touch, &law.without_cohesion(), &a.member, &b.member, dt);
            let approach = -contact.velocity(&a.member, &b.member).normal;
            // What loads and cohesion bring about in one step lasts, and is no impact.
            let lasting = (a.most_acceleration(&self.gravity)
                + b.most_acceleration(&self.gravity)
                + pull(law, touch.gap) / contact.block().mass_normal)
                * dt;
            let rebounds = contact.approach_limit() < R::ZERO && approach > lasting + slow;
            if rebounds {
                let change = contact.update(&self.friction, &mut a.member, &mut b.member);
                *impact = impact.plus_scaled(R::ONE, &change);
                fastest = if approach > fastest {
                    approach
                } else {
                    fastest
                };
            }
        }
        fastest
    }

    /// Adds the impulses of impacts to those of the step.
    pub(super) fn add_impacts(&mut self) {
        for joint in &mut self.contacts {
            if let Some(solved) = &mut joint.solved {
                let sum = solved.contact.impulse().plus_scaled(R::ONE, &joint.impact);
                solved.contact.set_impulse_in_plane(&sum);
            }
        }
    }
}

/// Cohesion at a gap.
fn pull<R: Real>(law: &NormalLaw<R>, gap: R) -> R {
    let cohesion = law.cohesion();
    if gap <= cohesion.range() {
        cohesion.strength()
    } else {
        R::ZERO
    }
}
