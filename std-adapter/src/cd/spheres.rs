//! Spheres and plates in contact, as an operator.

use super::operator::{Impulse, Operator, Visit, Watch};
use super::schedule::Schedule;
use tribos_core::contact::{Contact, ContactFriction, Modal, Modes, Plate, Sphere};

impl<M: Modes<f64>> Impulse for Modal<f64, M> {
    #[inline(always)]
    fn plus_scaled(&self, factor: f64, other: &Self) -> Self {
        Modal::plus_scaled(self, factor, other)
    }
}

/// A contact and the bodies that it joins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link<M: Modes<f64>> {
    /// First body, a sphere; second body, a sphere or a plate.
    pub bodies: [u32; 2],
    /// The contact.
    pub contact: Contact<f64, M>,
}

/// The contact problem of one time step.
///
/// Contacts are numbered: pairs of spheres first, those with plates after them.
#[derive(Clone, Debug)]
pub struct Spheres<F: ContactFriction<f64>> {
    /// Spheres with the velocities that belong to the present impulses.
    pub spheres: Vec<Sphere<f64>>,
    /// Plates, likewise.
    pub plates: Vec<Plate<f64>>,
    /// Spheres and plates with the velocities that they have without contacts.
    pub free: (Vec<Sphere<f64>>, Vec<Plate<f64>>),
    /// Contacts of spheres.
    pub pairs: Vec<Link<F::Modes>>,
    /// Contacts of a sphere with a plate.
    pub walls: Vec<Link<F::Modes>>,
    /// Friction between spheres, and at plates.
    pub friction: [F; 2],
    schedule: Schedule,
}

impl<F: ContactFriction<f64>> Spheres<F> {
    /// No bodies, no contacts.
    pub fn new(friction: [F; 2]) -> Self {
        Self {
            spheres: Vec::new(),
            plates: Vec::new(),
            free: (Vec::new(), Vec::new()),
            pairs: Vec::new(),
            walls: Vec::new(),
            friction,
            schedule: Schedule::default(),
        }
    }

    /// Puts the pairs in the order in which they are swept, and brings the velocities in line with
    /// new bodies, contacts and guesses.
    pub fn start(&mut self) {
        self.schedule.arrange(self.free.0.len(), &mut self.pairs);
        self.spheres.clone_from(&self.free.0);
        self.plates.clone_from(&self.free.1);
        self.refresh();
    }

    /// All links in the order of their numbers.
    pub fn links(&self) -> impl Iterator<Item = &Link<F::Modes>> {
        self.pairs.iter().chain(&self.walls)
    }

    #[inline(always)]
    fn visit_pair<W: Watch>(&mut self, index: usize, watch: &mut W) {
        if let Some(link) = self.pairs.get_mut(index) {
            update_pair(link, &self.friction[0], &mut self.spheres, watch);
        }
    }

    #[inline(always)]
    fn visit_wall<W: Watch>(&mut self, index: usize, watch: &mut W) {
        let Some(link) = self.walls.get_mut(index) else {
            return;
        };
        let [a, b] = link.bodies.map(|body| body as usize);
        if let (Some(a), Some(b)) = (self.spheres.get_mut(a), self.plates.get_mut(b)) {
            let change = link.contact.update(&self.friction[1], a, b);
            report(&link.contact, &change, watch);
        }
    }
}

/// Solves one pair and tells the watch.
#[inline(always)]
pub(super) fn update_pair<F: ContactFriction<f64>, W: Watch>(
    link: &mut Link<F::Modes>,
    friction: &F,
    spheres: &mut [Sphere<f64>],
    watch: &mut W,
) {
    let bodies = link.bodies.map(|body| body as usize);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        let change = link.contact.update(friction, a, b);
        report(&link.contact, &change, watch);
    }
}

#[inline(always)]
fn report<M: Modes<f64>, W: Watch>(
    contact: &Contact<f64, M>,
    change: &Modal<f64, M>,
    watch: &mut W,
) {
    let change_sq = change.dot_with_lever(change, contact.lever());
    watch.see(change_sq, contact.bound());
}

impl<F: ContactFriction<f64>> Operator for Spheres<F> {
    type Impulse = Modal<f64, F::Modes>;

    fn contacts(&self) -> usize {
        self.pairs.len() + self.walls.len()
    }

    fn impulse(&self, contact: usize) -> Self::Impulse {
        let walls = contact.wrapping_sub(self.pairs.len());
        let link = self.pairs.get(contact).or_else(|| self.walls.get(walls));
        link.map_or_else(Modal::default, |link| *link.contact.impulse())
    }

    fn dot(&self, contact: usize, a: &Self::Impulse, b: &Self::Impulse) -> f64 {
        let walls = contact.wrapping_sub(self.pairs.len());
        let link = self.pairs.get(contact).or_else(|| self.walls.get(walls));
        link.map_or(0.0, |link| a.dot_with_lever(b, link.contact.lever()))
    }

    fn guess(&mut self, contact: usize, impulse: &Self::Impulse) {
        let walls = contact.wrapping_sub(self.pairs.len());
        let (link, friction) = match self.pairs.get_mut(contact) {
            Some(link) => (Some(link), &self.friction[0]),
            None => (self.walls.get_mut(walls), &self.friction[1]),
        };
        if let Some(link) = link {
            link.contact.set_impulse_in_plane(impulse);
            link.contact.admit(friction);
        }
    }

    fn refresh(&mut self) {
        self.spheres.copy_from_slice(&self.free.0);
        self.plates.copy_from_slice(&self.free.1);
        for link in &self.pairs {
            let bodies = link.bodies.map(|body| body as usize);
            if let Ok([a, b]) = self.spheres.get_disjoint_mut(bodies) {
                link.contact.apply(link.contact.impulse(), a, b);
            }
        }
        for link in &self.walls {
            let [a, b] = link.bodies.map(|body| body as usize);
            if let (Some(a), Some(b)) = (self.spheres.get_mut(a), self.plates.get_mut(b)) {
                link.contact.apply(link.contact.impulse(), a, b);
            }
        }
    }

    fn sweep<W: Watch>(&mut self, visit: Visit<'_>, watch: &mut W) {
        let (pairs, walls) = (self.pairs.len(), self.walls.len());
        match visit {
            Visit::Forward => {
                (0..pairs).for_each(|index| self.visit_pair(index, watch));
                (0..walls).for_each(|index| self.visit_wall(index, watch));
            }
            Visit::Backward => {
                (0..walls)
                    .rev()
                    .for_each(|index| self.visit_wall(index, watch));
                (0..pairs)
                    .rev()
                    .for_each(|index| self.visit_pair(index, watch));
            }
            Visit::Listed(order) => {
                for &index in order {
                    let index = index as usize;
                    if index < pairs {
                        self.visit_pair(index, watch);
                    } else {
                        self.visit_wall(index - pairs, watch);
                    }
                }
            }
        }
    }
}
