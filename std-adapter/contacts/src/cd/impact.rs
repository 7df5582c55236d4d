//! Impacts with restitution, which a step treats before its loads and lasting contacts.
//!
//! Contacts that would close in the step at their current velocities impact in rounds, until no
//! contact closes. A round has two parts, with M the masses, G the contact directions, U a
//! relative velocity, `-` before and `+` after:
//!
//! ```text
//! reflection:  w  = v⁻ + M⁻¹ G_n q,   0 ≤ q ⟂ U_n(w) ≥ 0   for all contacts that close
//!              v' = w + e (w − v⁻),   p_n = (1 + e) q
//! friction:    v⁺ = v' + M⁻¹ G_t p_t, |p_t| ≤ μ p_n, opposite to U_t⁺ where it slips
//! ```
//!
//! The reflection is Moreau's law without friction (Moreau, in: Nonsmooth Mechanics and
//! Applications, CISM 302, 1988). It dissipates exactly (1 − e²)/2 |w − v⁻|²_M for any number
//! of contacts, because q·U_n(w) = 0. Friction under given normal impulses is the
//! minimum of the energy over a convex set, and cannot raise the energy. Neither holds for Newton's law
//! with Coulomb friction, nor for Poisson's with more than one rough contact (Kane, Stanford
//! Mechanics Alumni Club Newsletter 6 (1983); Glocker, Multibody Syst. Dyn. 29 (2013) 77 and
//! 32 (2014) 431). For a single contact of spheres all these laws agree.
//!
//! Repeating the reflection until no contact approaches follows Smith, Kaufman, Vouga, Tamstorf and
//! Grinspun (ACM Trans. Graph. 31 (2012) 106). Second: friction after each reflection, e < 1,
//! and contacts that close within the step count as closed, so that several impacts of a body in
//! one step happen one after the other.

use super::assemble::PairGeometry;
use super::energy::ImpactEnergies;
use super::image::{ImageVelocity, Images, seen};
use super::memory::StoredForce;
use super::mixture::LawBook;
use super::moving_mesh::Surface;
use super::setup::keeps_motion;
use super::spheres::{Link, Spheres};
use super::wall::Wall;
use nalgebra::Vector3;
use tribos_core::contact::{
    Contact, ContactBody, ContactFriction, ContactGeometry, ContactModes, ContactVector,
    Frictionless, IndependentFriction, NormalLaw, SphereBody,
};
use tribos_core::internals::{Block, PreparedContact};

/// Most rounds per step. The approach that remains after them is stopped without rebound.
const MOST_ROUNDS: usize = 100;
/// Most sweeps for a part of a round. Two are enough if no body has two impacts. A part that
/// reaches the limit is counted; even then it does not raise the energy.
const MOST_SWEEPS: usize = 1000;
/// Approach speed below which there is no impact, relative to the fastest of the step's first round:
/// the energy of such an impact is 1e-18 of the energy of that one.
const SLOW: f64 = 1e-9;

/// Bodies whose contacts may close in a step, with the laws and loads that apply to them.
pub(super) struct Surroundings<'a, F> {
    /// Pairs of spheres, and spheres with walls.
    pub touching: [&'a [PairGeometry]; 2],
    /// Pairs of them whose second sphere is an image.
    pub images: &'a [ImageVelocity],
    /// One flag per sphere, true if awake.
    pub awake: &'a [bool],
    /// Contact laws.
    pub book: LawBook<'a, F>,
    /// Acceleration of all spheres.
    pub gravity: &'a Vector3<f64>,
    /// Points of the mesh at the contacts with walls; none without a mesh.
    pub surfaces: &'a [Surface],
    /// Length of the step.
    pub dt: f64,
}

/// Statistics of the impacts of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Counts {
    /// Contacts that received an impact, counted once per round.
    pub impacts: usize,
    /// Number of rounds.
    pub rounds: usize,
    /// Whether impacts remained after the last round.
    pub cut: bool,
    /// Reflections, and solutions of friction under them, that reached the limit of sweeps.
    pub unmet: usize,
}

/// The impacts of one step.
#[derive(Debug)]
pub(super) struct Impacts<F: ContactFriction<f64>> {
    /// Spheres after half of the loads and the impacts.
    pub spheres: Vec<SphereBody<f64>>,
    /// Walls after half of the loads and the impacts.
    pub walls: Vec<Wall>,
    /// Energies taken by the impacts, and the work of the loads so far.
    pub taken: ImpactEnergies,
    /// Statistics of the impacts.
    pub counts: Counts,
    /// Impulses of pairs and at walls; after [`Impacts::run`] in ascending order of the bodies.
    pub(super) impulses: [Vec<StoredForce<F::Modes>>; 2],
    pub(super) reflection: Spheres<IndependentFriction<f64, Frictionless>>,
    pub(super) friction: Spheres<F>,
    /// Most sweeps for a part of a round.
    pub(super) most_sweeps: usize,
}

/// Whether any contact law has restitution.
pub(super) fn has_restitution<F>(book: LawBook<'_, F>) -> bool {
    book.all().any(|law| law.normal.restitution() > 0.0)
}

impl<F: ContactFriction<f64>> Impacts<F> {
    /// No bodies.
    pub fn new(friction: [F; 2]) -> Self {
        Self {
            spheres: Vec::new(),
            walls: Vec::new(),
            taken: ImpactEnergies::default(),
            counts: Counts::default(),
            impulses: [Vec::new(), Vec::new()],
            reflection: Spheres::new([IndependentFriction::none(); 2]),
            friction: Spheres::new(friction),
            most_sweeps: MOST_SWEEPS,
        }
    }

    /// Applies half of the loads to bodies with the velocities of the step's start, then all impacts.
    pub fn run(
        &mut self,
        (spheres, walls): (&[SphereBody<f64>], &[Wall]),
        around: &Surroundings<'_, F>,
    ) {
        self.taken = ImpactEnergies::from_motion(spheres, walls);
        self.counts = Counts::default();
        self.impulses.iter_mut().for_each(Vec::clear);
        self.spheres.clear();
        self.spheres.extend_from_slice(spheres);
        self.walls.clear();
        self.walls.extend_from_slice(walls);
        self.load(around);
        let groups = coefficients(around.book);
        let mut slow = None;
        while self.counts.rounds < MOST_ROUNDS {
            let mut fastest = 0.0_f64;
            for restitution in &groups {
                let speed = self.gather(*restitution, around, slow.unwrap_or(0.0));
                if speed > 0.0 {
                    self.round(*restitution);
                }
                fastest = fastest.max(speed);
            }
            if fastest == 0.0 {
                break;
            }
            slow.get_or_insert(SLOW * fastest);
            self.counts.rounds += 1;
        }
        self.counts.cut = self.counts.rounds == MOST_ROUNDS;
        self.impulses.iter_mut().for_each(merge);
    }

    /// Impulses of the step's impacts divided by its length, of pairs and at walls.
    pub fn mean_forces(&self, dt: f64) -> [Vec<StoredForce<F::Modes>>; 2] {
        let over = |(bodies, impulse): &StoredForce<F::Modes>| {
            (
                *bodies,
                ContactVector::default().plus_scaled(1.0 / dt, impulse),
            )
        };
        [0, 1].map(|kind: usize| self.impulses[kind].iter().map(over).collect())
    }

    /// Applies the loads of half a step. With the other half after the impacts, a ball that
    /// bounces without loss returns to its initial height.
    fn load(&mut self, around: &Surroundings<'_, F>) {
        let half = 0.5 * around.dt;
        let bodies = self.spheres.iter_mut().zip(around.awake);
        for (sphere, _) in bodies.filter(|(_, awake)| **awake) {
            if keeps_motion(sphere) {
                continue;
            }
            let push = around.gravity * half;
            let mean = sphere.velocity + push * 0.5;
            self.taken.work += mean.dot(&push) / sphere.inv_mass;
            sphere.velocity += push;
        }
        for wall in &mut self.walls {
            if wall.plate.inv_mass > 0.0 {
                let push = wall.outward * (wall.force * wall.plate.inv_mass * half);
                let mean = wall.plate.velocity + push * 0.5;
                self.taken.work += wall.force * half * mean.dot(&wall.outward);
                wall.plate.velocity += push;
            }
        }
    }

    /// Collects the contacts with this coefficient of restitution that close faster than `slow`; returns the largest closing
    /// speed, or 0 if there is none.
    fn gather(&mut self, restitution: f64, around: &Surroundings<'_, F>, slow: f64) -> f64 {
        let (awake, gravity) = (around.awake, around.gravity.norm());
        let [pairs, walls] = around.touching;
        let closing = Closing {
            dt: around.dt,
            slow,
        };
        let reflection = &mut self.reflection;
        reflection.pairs.clear();
        reflection.images.clear();
        reflection.walls.clear();
        reflection.surfaces.clear();
        let mut fastest = 0.0_f64;
        let mut images = Images::new(around.images);
        for (pair, (bodies, touch)) in pairs.iter().enumerate() {
            let [a, b] = bodies.map(|body| body as usize);
            let image = images.of(pair);
            let law = &around.book.of_pair(*bodies).normal;
            if law.restitution() == restitution && (awake[a] || awake[b]) {
                let (a, b) = (&self.spheres[a], &seen(&self.spheres[b], image));
                let contact = prepare(touch, a, b);
                let speed = contact.velocity(a, b).normal;
                if closing.impacts(touch, law, &contact, [-speed, gravity]) {
                    fastest = fastest.max(-speed);
                    let number = reflection.pairs.len() as u32;
                    reflection.images.extend(image.map(|image| (number, image)));
                    let bodies = *bodies;
                    reflection.pairs.push(&Link { bodies, contact });
                }
            }
        }
        for (number, (bodies, touch)) in walls.iter().enumerate() {
            let [a, b] = bodies.map(|body| body as usize);
            let law = &around.book.at_wall(*bodies).normal;
            if law.restitution() == restitution && awake[a] {
                let (sphere, surface) = (&self.spheres[a], around.surfaces.get(number));
                let (contact, speed, load) = match (self.walls.get(b), surface) {
                    (Some(wall), _) => {
                        let contact = prepare(&at_plate(touch), sphere, &wall.plate);
                        let speed = contact.velocity(sphere, &wall.plate).normal;
                        let load = gravity + (wall.force * wall.plate.inv_mass).abs();
                        (contact, speed, load)
                    }
                    (None, Some(surface)) => {
                        let contact = prepare(&at_plate(touch), sphere, surface);
                        (contact, contact.velocity(sphere, surface).normal, gravity)
                    }
                    (None, None) => continue,
                };
                if closing.impacts(touch, law, &contact, [-speed, load]) {
                    fastest = fastest.max(-speed);
                    reflection.surfaces.extend(surface);
                    reflection.walls.push(Link {
                        bodies: *bodies,
                        contact,
                    });
                }
            }
        }
        fastest
    }
}

/// Criterion for an impact.
struct Closing {
    dt: f64,
    slow: f64,
}

impl Closing {
    /// True if the gap closes in the step, faster than the loads of one step and cohesion explain:
    /// slower contacts are lasting ones and belong to the contact problem of the step.
    fn impacts(
        &self,
        touch: &ContactGeometry<f64>,
        law: &NormalLaw<f64>,
        contact: &Contact<f64, Frictionless>,
        [speed, load]: [f64; 2],
    ) -> bool {
        let cohesion = law.cohesion();
        let within = touch.gap <= cohesion.range();
        let pull = if within { cohesion.strength() } else { 0.0 };
        let lasting = (load + pull / contact.block().mass_normal) * self.dt;
        speed * self.dt > touch.gap.max(0.0) && speed > lasting + self.slow
    }
}

/// Coefficients of restitution of the laws, each once: a reflection is guaranteed to lose energy only for a
/// common one.
fn coefficients<F>(book: LawBook<'_, F>) -> Vec<f64> {
    let mut all = Vec::new();
    for law in book.all() {
        let e = law.normal.restitution();
        if e > 0.0 && !all.contains(&e) {
            all.push(e);
        }
    }
    all
}

/// A sphere that has reached its plate: the lever of friction is the radius, whatever gap the last step
/// left. Between two spheres both levers end at one point within the gap, which conserves angular
/// momentum; a plate does not rotate.
fn at_plate(touch: &ContactGeometry<f64>) -> ContactGeometry<f64> {
    ContactGeometry {
        arms: [touch.lever, 0.0],
        ..*touch
    }
}

/// A contact without gap, cohesion and friction.
fn prepare(
    touch: &ContactGeometry<f64>,
    a: &impl ContactBody<f64>,
    b: &impl ContactBody<f64>,
) -> Contact<f64, Frictionless> {
    let prepared = PreparedContact {
        normal: touch.normal,
        arms: touch.arms,
        lever: touch.lever,
        block: Block::new(touch, a, b),
        cohesion: 0.0,
        allowance: 0.0,
        rests_open: false,
    };
    Contact::resume(&prepared, &ContactVector::default())
}

/// Sums the impulses of each contact, in ascending order of the bodies.
fn merge<M: ContactModes<f64>>(impulses: &mut Vec<StoredForce<M>>) {
    impulses.sort_by_key(|(bodies, _)| *bodies);
    impulses.dedup_by(|(bodies, later), (kept, sum)| {
        let same = bodies == kept;
        if same {
            *sum = sum.plus_scaled(1.0, later);
        }
        same
    });
}
