//! Which bodies may come into contact before the next search.

use super::contact::SoftContact;
use super::world::SoftWorld;
use crate::cd::{Wall, WorldError, keeps_motion};
use nalgebra::Vector3;
use tribos_core::contact::{ContactBody, ContactFriction, ContactGeometry, ContactModes};
use tribos_core::internals::Block;

/// Margin of the list beyond the range of the contacts, in units of the smallest radius: some hundred steps of
/// usual runs.
const SKIN: f64 = 0.3;

impl<F: ContactFriction<f64>> SoftWorld<F> {
    /// Renews the list of neighbours once something has moved by half the margin.
    pub(super) fn list_neighbours(&mut self) -> Result<(), WorldError> {
        let far = 0.5 * (self.skin - self.image_drift);
        let positions = &self.state.positions;
        let moved = |(x, y): (&Vector3<f64>, &Vector3<f64>)| (x - y).norm_squared() > far * far;
        let shifted = |(wall, y): (&Wall, &f64)| (wall.place - y).abs() > far;
        let is_listed = self.listed
            && (self.image_drift == 0.0 || far > 0.0)
            && !positions.iter().zip(&self.listed_at).any(moved)
            && !self.state.walls.iter().zip(&self.listed_walls).any(shifted);
        if is_listed {
            return Ok(());
        }
        if self.setup.cell.is_some() {
            self.skin = self.default_skin();
        }
        let [range, at_walls] = self.ranges;
        let step = self.state.steps;
        let found = self.cells.find(
            &self.state.space,
            positions,
            &self.setup.radii,
            range + self.skin,
        );
        let pairs = found.map_err(|cause| WorldError::Neighbours { step, cause })?;
        let (spheres, radii) = (&self.state.spheres, &self.setup.radii);
        // Two that keep their motion do not feel each other.
        let feels = |body: u32| !keeps_motion(&spheres[body as usize]);
        let pairs = pairs
            .iter()
            .filter(|pair| pair.iter().any(|body| feels(*body)));
        let pairs = pairs.map(|&bodies| {
            let [i, j] = bodies.map(|body| body as usize);
            let block = block([radii[i], radii[j]], &spheres[i], &spheres[j]);
            SoftContact::apart(bodies, &block)
        });
        let mut lists = [pairs.collect(), Vec::new()];
        for (i, x) in positions.iter().enumerate() {
            if !feels(i as u32) {
                continue;
            }
            for (w, wall) in self.state.walls.iter().enumerate() {
                let height = wall.facing(&self.state.space, x).height;
                if height - radii[i] <= at_walls + self.skin {
                    let block = block([radii[i], 0.0], &spheres[i], &wall.plate);
                    lists[1].push(SoftContact::apart([i as u32, w as u32], &block));
                }
            }
        }
        // Contacts with the mesh are found after every step.
        let planes = self.state.walls.len() as u32;
        let at_mesh = self.state.contacts[1]
            .iter()
            .filter(|contact| contact.bodies[1] >= planes);
        lists[1].extend(at_mesh);
        lists[1].sort_by_key(|contact| contact.bodies);
        for (new, old) in lists.iter_mut().zip(&self.state.contacts) {
            recall(new, old);
        }
        self.state.contacts = lists;
        self.listed = true;
        self.image_drift = 0.0;
        self.listed_at.clone_from(&self.state.positions);
        self.listed_walls.clear();
        self.listed_walls
            .extend(self.state.walls.iter().map(|wall| wall.place));
        Ok(())
    }

    /// Margin that fits into the periods.
    pub(super) fn default_skin(&self) -> f64 {
        let smallest = self
            .setup
            .radii
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let largest = self.setup.radii.iter().copied().fold(0.0, f64::max);
        let [range, _] = self.ranges;
        let lengths = self.state.space.lengths().into_iter().flatten();
        let room = lengths.fold(f64::INFINITY, f64::min) * 0.5 - 2.0 * largest - range;
        let skin = (SKIN * smallest).min(room);
        if skin > 0.0 && skin.is_finite() {
            skin
        } else {
            0.0
        }
    }
}

/// Effective masses of two bodies whose surfaces just touch.
pub(super) fn block(
    radii: [f64; 2],
    a: &impl ContactBody<f64>,
    b: &impl ContactBody<f64>,
) -> Block<f64> {
    let touch = ContactGeometry {
        normal: Vector3::zeros(),
        gap: 0.0,
        arms: radii,
        lever: 0.0,
    };
    Block::new(&touch, a, b)
}

/// Takes over springs; both lists are in ascending order of their bodies.
fn recall<M: ContactModes<f64>>(new: &mut [SoftContact<M>], old: &[SoftContact<M>]) {
    let mut old = old.iter().peekable();
    for contact in new {
        while old.next_if(|old| old.bodies < contact.bodies).is_some() {}
        if let Some(old) = old.next_if(|old| old.bodies == contact.bodies) {
            contact.recall(old);
        }
    }
}
