//! Contacts of soft spheres with a mesh, which are found anew after every step.

use super::contact::SoftContact;
use super::neighbours::block;
use super::world::SoftWorld;
use crate::cd::{Facing, Surface, keeps_motion};
use tribos_core::contact::{ContactFriction, ContactModes};

/// Least cosine between the normals of two contacts of which the second takes over the springs of the first, where a
/// sphere rolls from one part of the mesh onto the next.
const SAME_CONTACT: f64 = 0.5;

/// A sphere in range of a mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Met {
    /// The sphere, and the number of the contact after those of the walls.
    pub bodies: [u32; 2],
    pub facing: Facing,
    pub surface: Surface,
}

impl<F: ContactFriction<f64>> SoftWorld<F> {
    /// Finds the contacts with the mesh at the end of a step of length `dt`.
    pub(super) fn meet_mesh(&mut self, dt: f64) {
        let Some(mesh) = &self.setup.mesh else {
            return;
        };
        self.met_at = self.state.time + dt;
        let (pose, space) = (mesh.at(self.met_at), &self.setup.space);
        let [_, range] = self.ranges;
        let walls = self.state.walls.len() as u32;
        self.met.clear();
        let spheres = self.state.positions.iter().zip(&self.setup.radii);
        for ((i, (x, radius)), sphere) in (0_u32..).zip(spheres).zip(&self.state.spheres) {
            if keeps_motion(sphere) {
                continue;
            }
            for meeting in pose.meetings(space, x, radius + range) {
                let Facing { outward, height } = meeting.facing;
                self.met.push(Met {
                    bodies: [i, walls + meeting.number],
                    facing: meeting.facing,
                    surface: pose.surface(space, &(x - outward * height)),
                });
            }
        }
        let apart = |met: &Met| {
            let [i, _] = met.bodies.map(|body| body as usize);
            let block = block(
                [self.setup.radii[i], 0.0],
                &self.state.spheres[i],
                &met.surface,
            );
            SoftContact::apart(met.bodies, &block)
        };
        let contacts = &mut self.state.contacts[1];
        let (at_walls, old) = std::mem::take(contacts)
            .into_iter()
            .partition(|contact| contact.bodies[1] < walls);
        *contacts = at_walls;
        contacts.extend(carried(old, &self.met, apart));
        contacts.sort_by_key(|contact| contact.bodies);
    }
}

/// The entry of these bodies, from a list in ascending order.
pub(super) fn find(met: &[Met], bodies: [u32; 2]) -> Option<&Met> {
    met.get(met.binary_search_by_key(&bodies, |met| met.bodies).ok()?)
}

/// The contacts that are in range, with the springs that they had, and those that let go.
fn carried<M: ContactModes<f64>>(
    old: Vec<SoftContact<M>>,
    met: &[Met],
    apart: impl Fn(&Met) -> SoftContact<M>,
) -> Vec<SoftContact<M>> {
    let mut left: Vec<_> = old
        .into_iter()
        .map(|contact| (find(met, contact.bodies).is_some(), contact))
        .collect();
    let mut contacts: Vec<_> = left
        .iter()
        .filter(|(is_met, _)| *is_met)
        .map(|(_, contact)| *contact)
        .collect();
    let known = contacts.len();
    left.retain(|(is_met, contact)| !is_met && contact.in_range);
    for met in met {
        if contacts[..known]
            .binary_search_by_key(&met.bodies, |contact| contact.bodies)
            .is_ok()
        {
            continue;
        }
        // A sphere that has just left another part of the mesh, on which it touched almost the same point.
        let closeness = |contact: &SoftContact<M>| -contact.normal.dot(&met.facing.outward);
        let same = left
            .iter()
            .enumerate()
            .filter(|(_, (_, old))| old.bodies[0] == met.bodies[0]);
        let same = same.max_by(|(_, (_, a)), (_, (_, b))| closeness(a).total_cmp(&closeness(b)));
        contacts.push(match same.map(|(at, (_, old))| (at, closeness(old))) {
            Some((at, cosine)) if cosine > SAME_CONTACT => {
                let (_, mut kept) = left.swap_remove(at);
                kept.bodies = met.bodies;
                kept
            }
            _ => apart(met),
        });
    }
    contacts.extend(left.into_iter().map(|(_, contact)| contact));
    contacts
}
