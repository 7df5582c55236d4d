//! The contact problem of spheres and plates.

use super::aligned::Aligned;
use super::groups::{Grouping, Groups};
use super::image::{ImageVelocity, Images, seen};
use super::mixture::{Mixture, PairFriction, Same};
use super::momentum;
use super::operator::{Impulse, Monitor, Operator, Visit};
use super::schedule::Schedule;
use super::sweep::{WORTHWHILE, Way, report, solve_one, sweep_colour, sweep_images, sweep_links};
use rayon::prelude::*;
use std::sync::Arc;
use tribos_core::contact::{Contact, ContactFriction, ContactModes, Modal, Plate, Sphere};

impl<M: ContactModes<f64>> Impulse for Modal<f64, M> {
    #[inline(always)]
    fn plus_scaled(&self, factor: f64, other: &Self) -> Self {
        Modal::plus_scaled(self, factor, other)
    }
}

/// A contact and the bodies that it joins.
///
/// See [`Spheres`] for an example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link<M: ContactModes<f64>> {
    /// First body, a sphere; second body, a sphere or a plate.
    pub bodies: [u32; 2],
    /// The contact.
    pub contact: Contact<f64, M>,
}

/// The contact problem of one time step.
///
/// Contacts are numbered: pairs of spheres first, those with plates after them.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::cd::{Order, Stop};
/// use tribos::cd::internals::{Link, Spheres, Sweeper, solve};
/// use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, Plate, Sphere, Thresholds, Touch};
/// // Two balls of 1 kg and 5 cm, one upon the other; gravity has pulled for 1 ms.
/// let (up, dt) = (Vector3::z(), 1e-3);
/// let velocity = up * (-9.81 * dt);
/// let ball = Sphere { velocity, spin: Vector3::zeros(), inv_mass: 1.0, inv_inertia: 1e3 };
/// let floor = Plate { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// let mut stack = Spheres::new([Thresholds::sliding(0.3)?; 2]);
/// stack.free = (vec![ball; 2], vec![floor]);
/// let touch = Touch::spheres(&(up * 0.1), [0.05; 2])?;
/// let contact = Contact::new(&touch, &law, &ball, &ball, dt);
/// stack.pairs.push(Link { bodies: [0, 1], contact });
/// let touch = Touch::plate(0.05, &up, 0.05)?;
/// let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// stack.walls.push(Link { bodies: [0, 0], contact });
/// stack.start();
/// let iterations = solve(&mut stack, &mut Sweeper::new(Order::Fixed, 0), Stop::Local(1e-12), 1000);
/// assert!(iterations.met);
/// // The lower ball carries one weight, the floor two.
/// let forces = stack.links().map(|link| link.contact.impulse().normal / dt);
/// for (force, weight) in forces.zip([9.81, 2.0 * 9.81]) {
///     assert!((force - weight).abs() < 1e-9);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Spheres<F: ContactFriction<f64>> {
    /// Spheres with the velocities that follow from the current impulses.
    pub spheres: Vec<Aligned>,
    /// Plates with the velocities that follow from the current impulses.
    pub plates: Vec<Plate<f64>>,
    /// Spheres and plates with their velocities in the absence of contacts.
    pub free: (Vec<Sphere<f64>>, Vec<Plate<f64>>),
    /// Contacts of spheres.
    pub pairs: Vec<Link<F::Modes>>,
    /// Pairs whose second sphere takes part as an image across the border of a sheared cell, in ascending order.
    pub images: Vec<ImageVelocity>,
    /// Contacts of a sphere with a plate.
    pub walls: Vec<Link<F::Modes>>,
    /// Friction between spheres, and at plates.
    pub friction: [F; 2],
    /// Materials and their friction, in place of `friction`, if there are several.
    pub mixture: Option<Arc<Mixture<F>>>,
    schedule: Schedule,
    grouping: Grouping,
}

impl<F: ContactFriction<f64>> Spheres<F> {
    /// A problem without bodies and contacts.
    pub fn new(friction: [F; 2]) -> Self {
        Self {
            spheres: Vec::new(),
            plates: Vec::new(),
            free: (Vec::new(), Vec::new()),
            pairs: Vec::new(),
            images: Vec::new(),
            walls: Vec::new(),
            friction,
            mixture: None,
            schedule: Schedule::default(),
            grouping: Grouping::default(),
        }
    }

    /// Sorts the pairs into the order of the sweep, and updates the velocities for new bodies, contacts and
    /// initial guesses.
    pub fn start(&mut self) {
        let count = self.free.0.len();
        self.schedule
            .arrange(count, &mut self.pairs, &mut self.images);
        self.spheres.clear();
        self.spheres
            .extend(self.free.0.iter().map(|sphere| Aligned(*sphere)));
        self.plates.clone_from(&self.free.1);
        self.group();
        self.refresh();
    }

    /// Groups the pairs that are solved four at a time.
    fn group(&mut self) {
        let limits = match &self.mixture {
            None => self.friction[0].independent_limits(),
            Some(_) => None,
        };
        let parts = self.schedule.parts();
        self.grouping
            .arrange(limits, parts, &self.pairs, &self.spheres);
    }

    /// Solves every pair by itself until the next [`Spheres::start`]; for comparisons, as the bits are the same.
    pub fn without_lanes(&mut self) {
        self.grouping.clear();
    }

    /// Number of pairs that are solved four at a time.
    pub fn side_by_side(&self) -> usize {
        self.grouping.count()
    }

    /// Friction between two spheres.
    #[inline(always)]
    pub(super) fn pair_friction(&self, bodies: [u32; 2]) -> &F {
        match &self.mixture {
            None => &self.friction[0],
            Some(mixture) => &mixture.of_pair(bodies).friction,
        }
    }

    /// Friction of a sphere at a plate.
    #[inline(always)]
    pub(super) fn wall_friction(&self, bodies: [u32; 2]) -> &F {
        match &self.mixture {
            None => &self.friction[1],
            Some(mixture) => &mixture.at_wall(bodies).friction,
        }
    }

    /// The spheres with their current velocities.
    pub fn moving(&self) -> impl Iterator<Item = &Sphere<f64>> {
        self.spheres.iter().map(|sphere| &sphere.0)
    }

    /// All links in the order of their numbers.
    pub fn links(&self) -> impl Iterator<Item = &Link<F::Modes>> {
        self.pairs.iter().chain(&self.walls)
    }

    /// The pairs with their relative velocities, those of images where these take part.
    pub(super) fn pair_velocities(
        &self,
    ) -> impl Iterator<Item = (&Link<F::Modes>, Modal<f64, F::Modes>)> {
        let mut images = Images::new(&self.images);
        self.pairs.iter().enumerate().map(move |(pair, link)| {
            let [a, b] = link.bodies.map(|body| &self.spheres[body as usize]);
            let velocity = match images.of(pair) {
                None => link.contact.velocity(&a.0, &b.0),
                image => link.contact.velocity(&a.0, &seen(b, image)),
            };
            (link, velocity)
        })
    }

    /// Energy that the pairs transfer to the shear that moves their images.
    pub(super) fn shear_work(&self) -> f64 {
        let work = |(pair, velocity): &ImageVelocity| {
            self.pairs.get(*pair as usize).map_or(0.0, |link| {
                let contact = &link.contact;
                contact.impulse().linear(contact.normal()).dot(velocity)
            })
        };
        self.images.iter().map(work).sum()
    }

    /// Sweeps the pairs: blocks in parallel, then pairs across blocks. The data of the monitor do not depend
    /// on the number of threads.
    fn sweep_pairs<W: Monitor>(&mut self, way: Way, watch: &mut W) {
        match self.mixture.clone() {
            None => self.sweep_pairs_with(&Same(self.friction[0]), way, watch),
            Some(mixture) => self.sweep_pairs_with(&*mixture, way, watch),
        }
    }

    fn sweep_pairs_with<W: Monitor>(
        &mut self,
        friction: &impl PairFriction<F>,
        way: Way,
        watch: &mut W,
    ) {
        let blocks = self.schedule.blocks.len();
        let across = self
            .schedule
            .blocks
            .last()
            .map_or(0, |block| block.pairs.end);
        let border = self.schedule.images;
        if way == Way::Backward {
            let (spheres, pairs) = (&mut self.spheres[..], &mut self.pairs[border..]);
            sweep_images((pairs, &self.images), spheres, friction, way, watch);
            let colours = self.schedule.across.iter().rev();
            for colour in colours.cloned() {
                let groups = self.grouping.of(colour.clone());
                let (spheres, pairs) = (&mut self.spheres[..], &mut self.pairs[colour]);
                sweep_colour(pairs, groups, spheres, friction, way, watch);
            }
        }
        let mut parts = Vec::with_capacity(blocks);
        let (mut spheres, mut pairs) = (&mut self.spheres[..], &mut self.pairs[..across]);
        for block in &self.schedule.blocks {
            let (own, rest) = spheres.split_at_mut(block.spheres.len());
            let (links, others) = pairs.split_at_mut(block.pairs.len());
            (spheres, pairs) = (rest, others);
            let groups = self.grouping.of(block.pairs.clone());
            parts.push((block.spheres.start as u32, own, links, groups, watch.fork()));
        }
        let sweep = |(first, spheres, links, groups, watch): &mut (
            u32,
            &mut [_],
            &mut [_],
            Option<Groups<'_>>,
            W,
        )| {
            sweep_links(links, *groups, (*first, spheres), friction, way, watch);
        };
        if across >= WORTHWHILE && rayon::current_num_threads() > 1 {
            parts.par_iter_mut().for_each(sweep);
        } else {
            parts.iter_mut().for_each(sweep);
        }
        for (_, _, _, _, seen) in &parts {
            watch.join(seen);
        }
        if way == Way::Forward {
            for colour in self.schedule.across.iter().cloned() {
                let groups = self.grouping.of(colour.clone());
                let (spheres, pairs) = (&mut self.spheres[..], &mut self.pairs[colour]);
                sweep_colour(pairs, groups, spheres, friction, way, watch);
            }
            let (spheres, pairs) = (&mut self.spheres[..], &mut self.pairs[border..]);
            sweep_images((pairs, &self.images), spheres, friction, way, watch);
        }
    }

    fn extrapolate_with(
        &mut self,
        friction: &impl PairFriction<F>,
        beta: f64,
        [start, swept]: [&mut [Modal<f64, F::Modes>]; 2],
    ) {
        let pairs = self.pairs.len();
        let (start, start_walls) = start.split_at_mut(pairs.min(start.len()));
        let (swept, swept_walls) = swept.split_at_mut(pairs.min(swept.len()));
        let groups = self.grouping.of(0..pairs);
        momentum::extrapolate(&mut self.pairs, groups, friction, beta, [start, swept]);
        let walls = start_walls.iter_mut().zip(swept_walls);
        for (wall, (start, swept)) in walls.enumerate() {
            let now = self.impulse(pairs + wall);
            let step = now.minus(swept);
            self.guess(pairs + wall, &now.plus_scaled(beta, &step));
            *start = self.impulse(pairs + wall);
            *swept = now;
        }
    }

    /// Solves one pair.
    fn visit_pair<W: Monitor>(&mut self, index: usize, watch: &mut W) {
        let spheres = &mut self.spheres[..];
        let (one, both) = (Same(self.friction[0]), self.mixture.as_deref());
        let Some(image) = index.checked_sub(self.schedule.images) else {
            match both {
                None => solve_one(&mut self.pairs, index, (0, spheres), &one, watch),
                Some(both) => solve_one(&mut self.pairs, index, (0, spheres), both, watch),
            }
            return;
        };
        if let Some(link) = self.pairs.get_mut(index..=index) {
            let pairs = (link, &self.images[image..]);
            match both {
                None => sweep_images(pairs, spheres, &one, Way::Forward, watch),
                Some(both) => sweep_images(pairs, spheres, both, Way::Forward, watch),
            }
        }
    }

    #[inline(always)]
    fn visit_wall<W: Monitor>(&mut self, index: usize, watch: &mut W) {
        let Some(link) = self.walls.get_mut(index) else {
            return;
        };
        let friction = match &self.mixture {
            None => &self.friction[1],
            Some(mixture) => &mixture.at_wall(link.bodies).friction,
        };
        let [a, b] = link.bodies.map(|body| body as usize);
        if let (Some(a), Some(b)) = (self.spheres.get_mut(a), self.plates.get_mut(b)) {
            let change = link.contact.update(friction, &mut a.0, b);
            report(&link.contact, &change, watch);
        }
    }
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
        let mixture = self.mixture.as_deref();
        let (link, kind) = match self.pairs.get_mut(contact) {
            Some(link) => (Some(link), 0),
            None => (self.walls.get_mut(walls), 1),
        };
        if let Some(link) = link {
            let friction = match (mixture, kind) {
                (None, _) => &self.friction[kind],
                (Some(mixture), 0) => &mixture.of_pair(link.bodies).friction,
                (Some(mixture), _) => &mixture.at_wall(link.bodies).friction,
            };
            link.contact.set_impulse_in_plane(impulse);
            link.contact.admit(friction);
        }
    }

    fn refresh(&mut self) {
        for (sphere, free) in self.spheres.iter_mut().zip(&self.free.0) {
            sphere.0 = *free;
        }
        self.plates.copy_from_slice(&self.free.1);
        let groups = self.grouping.of(0..self.pairs.len());
        momentum::apply(&self.pairs, groups, &mut self.spheres);
        for link in &self.walls {
            let [a, b] = link.bodies.map(|body| body as usize);
            if let (Some(a), Some(b)) = (self.spheres.get_mut(a), self.plates.get_mut(b)) {
                link.contact.apply(link.contact.impulse(), &mut a.0, b);
            }
        }
    }

    fn along(&self, start: &[Self::Impulse], swept: &[Self::Impulse]) -> f64 {
        let mut sum = 0.0;
        for ((link, start), swept) in self.links().zip(start).zip(swept) {
            let moved = link.contact.impulse().minus(start);
            sum += moved.dot_with_lever(&start.minus(swept), link.contact.lever());
        }
        sum
    }

    fn extrapolate(&mut self, beta: f64, start: &mut [Self::Impulse], swept: &mut [Self::Impulse]) {
        match self.mixture.clone() {
            None => self.extrapolate_with(&Same(self.friction[0]), beta, [start, swept]),
            Some(mixture) => self.extrapolate_with(&*mixture, beta, [start, swept]),
        }
    }

    fn sweep<W: Monitor>(&mut self, visit: Visit<'_>, watch: &mut W) {
        let (pairs, walls) = (self.pairs.len(), self.walls.len());
        match visit {
            Visit::Forward => {
                self.sweep_pairs(Way::Forward, watch);
                (0..walls).for_each(|index| self.visit_wall(index, watch));
            }
            Visit::Backward => {
                (0..walls)
                    .rev()
                    .for_each(|index| self.visit_wall(index, watch));
                self.sweep_pairs(Way::Backward, watch);
            }
            Visit::Listed(order) => {
                for &index in order {
                    let index = index as usize;
                    match index.checked_sub(pairs) {
                        None => self.visit_pair(index, watch),
                        Some(wall) => self.visit_wall(wall, watch),
                    }
                }
            }
        }
    }
}
