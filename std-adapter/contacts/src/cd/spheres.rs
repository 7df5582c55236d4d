//! The contact problem of spheres and plates.

use super::aligned::Aligned;
use super::cell::CellBody;
use super::image::{ImageVelocity, Images, seen};
use super::mixture::{MaterialTable, PairFriction, Same};
use super::momentum::{Moving, extrapolate};
use super::moving_mesh::Surface;
use super::operator::{Impulse, Monitor, Operator, Visit};
use super::pairs::Pairs;
use super::schedule::Schedule;
use super::sweep::{
    AHEAD, Border, Stretch, SweepDirection, WORTHWHILE, fetch, solve_one, sweep_images,
    sweep_pairs, visit,
};
use super::vectors::Constants;
use rayon::prelude::*;
use std::sync::Arc;
use tribos_core::contact::{
    Contact, ContactFriction, ContactModes, ContactVector, SphereBody, WallBody,
};

impl<M: ContactModes<f64>> Impulse for ContactVector<f64, M> {
    #[inline(always)]
    fn plus_scaled(&self, factor: f64, other: &Self) -> Self {
        ContactVector::plus_scaled(self, factor, other)
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
/// use tribos::cd::{IterationOrder, StopRule};
/// use tribos::cd::internals::{Link, Spheres, Sweeper, solve};
/// use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// // Two balls of 1 kg and 5 cm, one upon the other; gravity has pulled for 1 ms.
/// let (up, dt) = (Vector3::z(), 1e-3);
/// let velocity = up * (-9.81 * dt);
/// let ball = SphereBody { velocity, spin: Vector3::zeros(), inv_mass: 1.0, inv_inertia: 1e3 };
/// let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// let mut stack = Spheres::new([IndependentFriction::sliding(0.3)?; 2]);
/// stack.free = (vec![ball; 2], vec![floor]);
/// let touch = ContactGeometry::spheres(&(up * 0.1), [0.05; 2])?;
/// let contact = Contact::new(&touch, &law, &ball, &ball, dt);
/// stack.join(&Link { bodies: [0, 1], contact });
/// let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// stack.walls.push(Link { bodies: [0, 0], contact });
/// stack.start();
/// let iterations = solve(&mut stack, &mut Sweeper::new(IterationOrder::Fixed, 0), StopRule::Local(1e-12), 1000);
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
    pub plates: Vec<WallBody<f64>>,
    /// Spheres and plates with their velocities in the absence of contacts.
    pub free: (Vec<SphereBody<f64>>, Vec<WallBody<f64>>),
    /// Contacts of spheres.
    pub pairs: Pairs<F::Modes>,
    /// Pairs whose second sphere takes part as an image across the border of a sheared cell, in ascending order.
    pub images: Vec<ImageVelocity>,
    /// Axes of a cell that deforms: with these the images begin as whole periods, and have velocities after
    /// [`Spheres::start`].
    pub cell: Option<CellBody>,
    /// Contacts of a sphere with a plate, or with a mesh, whose numbers follow those of the plates.
    pub walls: Vec<Link<F::Modes>>,
    /// Points of the mesh at these contacts, one a contact with plates too; none without a mesh.
    pub surfaces: Vec<Surface>,
    /// Friction between spheres, and at plates.
    pub friction: [F; 2],
    /// Materials and their friction, in place of `friction`, if there are several.
    pub mixture: Option<Arc<MaterialTable<F>>>,
    schedule: Schedule,
    /// What pairs that are solved four at a time need. Boxed: the memory of an owner in another language may not have
    /// its alignment.
    lanes: Option<Box<Constants>>,
}

impl<F: ContactFriction<f64>> Spheres<F> {
    /// A problem without bodies and contacts.
    pub fn new(friction: [F; 2]) -> Self {
        Self {
            spheres: Vec::new(),
            plates: Vec::new(),
            free: (Vec::new(), Vec::new()),
            pairs: Pairs::default(),
            images: Vec::new(),
            cell: None,
            walls: Vec::new(),
            surfaces: Vec::new(),
            friction,
            mixture: None,
            schedule: Schedule::default(),
            lanes: None,
        }
    }

    /// Adds a contact of two of the free spheres.
    pub fn join(&mut self, link: &Link<F::Modes>) {
        self.pairs.push(link);
    }

    /// Sorts the pairs into the order of the sweep, and updates the velocities for new bodies, contacts and
    /// initial guesses.
    pub fn start(&mut self) {
        let count = self.free.0.len();
        let schedule = &mut self.schedule;
        schedule.arrange(count, self.pairs.view(), &mut self.images);
        if let Some(cell) = &mut self.cell {
            cell.periods.clear();
            let periods = self
                .images
                .iter()
                .map(|(_, periods)| <[f64; 3]>::from(*periods));
            cell.periods.extend(periods);
        }
        self.pairs.arrange(&schedule.order(), schedule.parts());
        self.lanes = match &self.mixture {
            None => self.friction[0]
                .independent_limits()
                .map(|limits| Box::new(Constants::new(limits))),
            Some(_) => None,
        };
        self.spheres.clear();
        self.spheres
            .extend(self.free.0.iter().map(|sphere| Aligned(*sphere)));
        self.plates.clone_from(&self.free.1);
        self.refresh();
    }

    /// Solves every pair by itself until the next [`Spheres::start`]; for comparisons, as the bits are the same.
    pub fn without_lanes(&mut self) {
        self.lanes = None;
    }

    /// Number of pairs that are solved four at a time.
    pub fn lane_pairs(&self) -> usize {
        let view = self.pairs.view();
        self.lanes.as_ref().map_or(0, |_| view.together())
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

    /// The point of the mesh at a contact with a wall; `None` if that is a plate.
    #[inline(always)]
    pub(super) fn surface(&self, wall: usize) -> Option<&Surface> {
        let surface = self.surfaces.get(wall)?;
        let is_plate = (self.walls.get(wall)?.bodies[1] as usize) < self.free.1.len();
        (!is_plate).then_some(surface)
    }

    /// Relative velocity at a contact with a wall, of a sphere and plates in this motion.
    pub(super) fn velocity_at_wall(
        &self,
        wall: usize,
        (sphere, plates): (&SphereBody<f64>, &[WallBody<f64>]),
    ) -> ContactVector<f64, F::Modes> {
        let link = &self.walls[wall];
        match self.surface(wall) {
            None => link
                .contact
                .velocity(sphere, &plates[link.bodies[1] as usize]),
            Some(surface) => link.contact.velocity(sphere, surface),
        }
    }

    /// Contacts with walls and their relative velocities.
    pub(super) fn wall_velocities(
        &self,
    ) -> impl Iterator<Item = (Link<F::Modes>, ContactVector<f64, F::Modes>)> {
        self.walls.iter().enumerate().map(|(wall, link)| {
            let sphere = &self.spheres[link.bodies[0] as usize].0;
            (*link, self.velocity_at_wall(wall, (sphere, &self.plates)))
        })
    }

    /// The spheres with their current velocities.
    pub fn moving(&self) -> impl Iterator<Item = &SphereBody<f64>> {
        self.spheres.iter().map(|sphere| &sphere.0)
    }

    /// All links in the order of their numbers.
    pub fn links(&self) -> impl Iterator<Item = Link<F::Modes>> {
        self.pairs.iter().chain(self.walls.iter().copied())
    }

    /// The pairs with their relative velocities, those of images where these take part.
    pub(super) fn pair_velocities(
        &self,
    ) -> impl Iterator<Item = (Link<F::Modes>, ContactVector<f64, F::Modes>)> {
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
    /// on the number of threads. `swept` are the impulses after the sweep before, or empty.
    fn sweep_all<W: Monitor>(
        &mut self,
        way: SweepDirection,
        swept: &[ContactVector<f64, F::Modes>],
        watch: &mut W,
    ) {
        match self.mixture.clone() {
            None => self.sweep_with(&Same(self.friction[0]), way, swept, watch),
            Some(mixture) => self.sweep_with(&*mixture, way, swept, watch),
        }
    }

    fn sweep_with<W: Monitor>(
        &mut self,
        friction: &impl PairFriction<F>,
        way: SweepDirection,
        swept: &[ContactVector<f64, F::Modes>],
        watch: &mut W,
    ) {
        if way == SweepDirection::Backward {
            self.sweep_images(friction, way, swept, watch);
            self.sweep_across(friction, way, swept, watch);
        }
        let across = self.schedule.across().start;
        let mut parts = Vec::with_capacity(self.schedule.blocks.len());
        let (view, impulses) = self.pairs.split();
        let (mut spheres, mut impulses) = (&mut self.spheres[..], &mut impulses[..across]);
        for block in &self.schedule.blocks {
            let (bodies, own);
            (bodies, spheres) = spheres.split_at_mut(block.spheres.len());
            (own, impulses) = impulses.split_at_mut(block.pairs.len());
            let stretch = Stretch {
                pairs: view,
                part: block.pairs.clone(),
                impulses: own,
                swept: swept.get(block.pairs.clone()).unwrap_or_default(),
                lanes: self.lanes.as_deref(),
            };
            parts.push((stretch, (block.spheres.start as u32, bodies), watch.fork()));
        }
        let sweep = |(pairs, spheres, mut watch): (Stretch<'_, F::Modes>, (u32, &mut [_]), W)| {
            sweep_pairs(pairs, spheres, friction, way, &mut watch);
            watch
        };
        let seen: Vec<W> = if shared(across) {
            parts.into_par_iter().map(sweep).collect()
        } else {
            parts.into_iter().map(sweep).collect()
        };
        for seen in &seen {
            watch.join(seen);
        }
        if way == SweepDirection::Forward {
            self.sweep_across(friction, way, swept, watch);
            self.sweep_images(friction, way, swept, watch);
        }
    }

    /// Sweeps the pairs across blocks.
    fn sweep_across<W: Monitor>(
        &mut self,
        friction: &impl PairFriction<F>,
        way: SweepDirection,
        swept: &[ContactVector<f64, F::Modes>],
        watch: &mut W,
    ) {
        let across = self.schedule.across();
        let (view, impulses) = self.pairs.split();
        let stretch = Stretch {
            pairs: view,
            part: across.clone(),
            swept: swept.get(across.clone()).unwrap_or_default(),
            lanes: self.lanes.as_deref(),
            impulses: &mut impulses[across],
        };
        sweep_pairs(stretch, (0, &mut self.spheres), friction, way, watch);
    }

    /// Sweeps the pairs with an image.
    fn sweep_images<W: Monitor>(
        &mut self,
        friction: &impl PairFriction<F>,
        way: SweepDirection,
        swept: &[ContactVector<f64, F::Modes>],
        watch: &mut W,
    ) {
        let border = self.schedule.images..self.pairs.len();
        let (view, impulses) = self.pairs.split();
        let stretch = Stretch {
            pairs: view,
            part: border.clone(),
            swept: swept.get(border.clone()).unwrap_or_default(),
            lanes: None,
            impulses: &mut impulses[border],
        };
        let spheres = &mut self.spheres[..];
        let border = Border {
            images: &self.images,
            cell: self.cell.as_mut(),
            first: 0,
        };
        sweep_images(stretch, border, spheres, friction, way, watch);
        self.move_images();
    }

    fn extrapolate_with(
        &mut self,
        friction: &impl PairFriction<F>,
        beta: f64,
        swept: &mut Vec<ContactVector<f64, F::Modes>>,
    ) {
        self.release();
        let pairs = self.pairs.len();
        let mut at_walls = swept.split_off(pairs);
        self.extrapolate_pairs(friction, beta, swept);
        std::mem::swap(&mut self.pairs.impulses, swept);
        for (wall, swept) in at_walls.iter_mut().enumerate() {
            let now = self.impulse(pairs + wall);
            let step = now.minus(swept);
            self.guess(pairs + wall, &now.plus_scaled(beta, &step));
            *swept = now;
        }
        swept.append(&mut at_walls);
        self.apply_walls();
        self.follow_cell();
    }

    /// Applies the impulses of pairs further on, and puts them in the place of those after the sweep before.
    fn extrapolate_pairs(
        &mut self,
        friction: &impl PairFriction<F>,
        beta: f64,
        swept: &mut [ContactVector<f64, F::Modes>],
    ) {
        let across = self.schedule.across().start;
        let (view, now) = (self.pairs.view(), &self.pairs.impulses);
        let (swept, swept_across) = swept.split_at_mut(across);
        let mut parts = Vec::with_capacity(self.schedule.blocks.len());
        let (mut spheres, mut swept) = (&mut self.spheres[..], swept);
        for block in &self.schedule.blocks {
            let (bodies, own);
            (bodies, spheres) = spheres.split_at_mut(block.spheres.len());
            (own, swept) = swept.split_at_mut(block.pairs.len());
            let moving = Moving {
                pairs: view,
                part: block.pairs.clone(),
                now: &now[block.pairs.clone()],
                swept: own,
                lanes: self.lanes.as_deref(),
            };
            parts.push((moving, (block.spheres.start as u32, bodies)));
        }
        let go_on = |(pairs, spheres): (Moving<'_, F::Modes>, (u32, &mut [_]))| {
            extrapolate(pairs, spheres, friction, beta);
        };
        if shared(across) {
            parts.into_par_iter().for_each(go_on);
        } else {
            parts.into_iter().for_each(go_on);
        }
        let moving = Moving {
            pairs: view,
            part: across..now.len(),
            now: &now[across..],
            swept: swept_across,
            lanes: self.lanes.as_deref(),
        };
        extrapolate(moving, (0, &mut self.spheres), friction, beta);
    }

    /// Gives all bodies their velocities in the absence of contacts.
    fn release(&mut self) {
        for (sphere, free) in self.spheres.iter_mut().zip(&self.free.0) {
            sphere.0 = *free;
        }
        self.plates.copy_from_slice(&self.free.1);
    }

    /// Applies the impulses at plates.
    fn apply_walls(&mut self) {
        for (wall, link) in self.walls.iter().enumerate() {
            let [a, b] = link.bodies.map(|body| body as usize);
            let Some(a) = self.spheres.get_mut(a) else {
                continue;
            };
            if let Some(b) = self.plates.get_mut(b) {
                link.contact.apply(link.contact.impulse(), &mut a.0, b);
            } else if let Some(b) = self.surfaces.get_mut(wall) {
                link.contact.apply(link.contact.impulse(), &mut a.0, b);
            }
        }
    }

    /// Solves one pair.
    fn visit_pair<W: Monitor>(&mut self, index: usize, watch: &mut W) {
        let spheres = &mut self.spheres[..];
        let (one, both) = (Same(self.friction[0]), self.mixture.as_deref());
        let (view, impulses) = self.pairs.split();
        let Some(image) = index.checked_sub(self.schedule.images) else {
            let Some(impulse) = impulses.get_mut(index) else {
                return;
            };
            let (pair, steps) = ((view, index), (impulse, None));
            match both {
                None => solve_one(pair, steps, (0, spheres), &one, watch),
                Some(both) => solve_one(pair, steps, (0, spheres), both, watch),
            }
            return;
        };
        if let Some(impulses) = impulses.get_mut(index..=index) {
            let stretch = Stretch {
                pairs: view,
                part: index..index + 1,
                impulses,
                swept: &[],
                lanes: None,
            };
            let border = Border {
                images: &self.images[image..],
                cell: self.cell.as_mut(),
                first: image,
            };
            let way = SweepDirection::Forward;
            match both {
                None => sweep_images(stretch, border, spheres, &one, way, watch),
                Some(both) => sweep_images(stretch, border, spheres, both, way, watch),
            }
            self.move_images();
        }
    }

    #[inline(always)]
    fn visit_wall<W: Monitor>(
        &mut self,
        index: usize,
        swept: Option<&ContactVector<f64, F::Modes>>,
        watch: &mut W,
    ) {
        let Some(link) = self.walls.get_mut(index) else {
            return;
        };
        let friction = match &self.mixture {
            None => &self.friction[1],
            Some(mixture) => &mixture.at_wall(link.bodies).friction,
        };
        let [a, b] = link.bodies.map(|body| body as usize);
        let Some(a) = self.spheres.get_mut(a) else {
            return;
        };
        // A sphere that sticks is held by one visit.
        if let Some(b) = self.plates.get_mut(b) {
            let hold =
                |contact: &mut Contact<_, _>| contact.hold_or_take_turn(friction, &mut a.0, b);
            visit(&mut link.contact, swept, hold).tell(watch);
        } else if let Some(b) = self.surfaces.get_mut(index) {
            let hold =
                |contact: &mut Contact<_, _>| contact.hold_or_take_turn(friction, &mut a.0, b);
            visit(&mut link.contact, swept, hold).tell(watch);
        }
    }
}

impl<F: ContactFriction<f64>> Operator for Spheres<F> {
    type Impulse = ContactVector<f64, F::Modes>;

    fn contacts(&self) -> usize {
        self.pairs.len() + self.walls.len()
    }

    fn impulse(&self, contact: usize) -> Self::Impulse {
        let walls = contact.wrapping_sub(self.pairs.len());
        let wall = || Some(self.walls.get(walls)?.contact.impulse());
        let impulse = self.pairs.impulses.get(contact).or_else(wall);
        impulse.copied().unwrap_or_default()
    }

    fn dot(&self, contact: usize, a: &Self::Impulse, b: &Self::Impulse) -> f64 {
        let walls = contact.wrapping_sub(self.pairs.len());
        let wall = || self.walls.get(walls).copied();
        let link = self.pairs.get(contact).or_else(wall);
        link.map_or(0.0, |link| {
            a.dot_with_lever(b, link.contact.effective_radius())
        })
    }

    fn guess(&mut self, contact: usize, impulse: &Self::Impulse) {
        let walls = contact.wrapping_sub(self.pairs.len());
        if let Some(mut link) = self.pairs.get(contact) {
            link.contact.set_impulse_in_plane(impulse);
            link.contact
                .project_impulse(self.pair_friction(link.bodies));
            self.pairs.impulses[contact] = *link.contact.impulse();
        } else if let Some(link) = self.walls.get_mut(walls) {
            let friction = match &self.mixture {
                None => &self.friction[1],
                Some(mixture) => &mixture.at_wall(link.bodies).friction,
            };
            link.contact.set_impulse_in_plane(impulse);
            link.contact.project_impulse(friction);
        }
    }

    fn refresh(&mut self) {
        self.release();
        let view = self.pairs.view();
        for (at, link) in self.pairs.iter().enumerate() {
            fetch(view.bodies(at + AHEAD), &self.spheres, 0);
            let bodies = link.bodies.map(|body| body as usize);
            if let Ok([a, b]) = self.spheres.get_disjoint_mut(bodies) {
                let contact = &link.contact;
                contact.apply(contact.impulse(), &mut a.0, &mut b.0);
            }
        }
        self.apply_walls();
        self.follow_cell();
    }

    fn sweep_on<W: Monitor>(&mut self, swept: &[Self::Impulse], watch: &mut W) {
        self.sweep_all(SweepDirection::Forward, swept, watch);
        let pairs = self.pairs.len();
        for wall in 0..self.walls.len() {
            self.visit_wall(wall, swept.get(pairs + wall), watch);
        }
    }

    /// *Panics* if `swept` has no impulse for a pair.
    fn extrapolate(&mut self, beta: f64, swept: &mut Vec<Self::Impulse>) {
        match self.mixture.clone() {
            None => self.extrapolate_with(&Same(self.friction[0]), beta, swept),
            Some(mixture) => self.extrapolate_with(&*mixture, beta, swept),
        }
    }

    fn sweep<W: Monitor>(&mut self, visit: Visit<'_>, watch: &mut W) {
        let (pairs, walls) = (self.pairs.len(), self.walls.len());
        match visit {
            Visit::Forward => self.sweep_on(&[], watch),
            Visit::Backward => {
                for wall in (0..walls).rev() {
                    self.visit_wall(wall, None, watch);
                }
                self.sweep_all(SweepDirection::Backward, &[], watch);
            }
            Visit::Listed(order) => {
                for &index in order {
                    let index = index as usize;
                    match index.checked_sub(pairs) {
                        None => self.visit_pair(index, watch),
                        Some(wall) => self.visit_wall(wall, None, watch),
                    }
                }
            }
        }
    }
}

/// Whether so many pairs are work for several threads.
fn shared(pairs: usize) -> bool {
    pairs >= WORTHWHILE && rayon::current_num_threads() > 1
}
