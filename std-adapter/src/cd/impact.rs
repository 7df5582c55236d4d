//! Impacts with restitution: what a step does before its loads and lasting contacts.
//!
//! Contacts that would close in the step by their present velocities impact in rounds, until none
//! closes any more. A round has two parts, with M the masses, G the contacts' directions, U a
//! relative velocity, `-` before and `+` after:
//!
//! ```text
//! reflection:  w  = v⁻ + M⁻¹ G_n q,   0 ≤ q ⟂ U_n(w) ≥ 0   for all contacts that close
//!              v' = w + e (w − v⁻),   p_n = (1 + e) q
//! friction:    v⁺ = v' + M⁻¹ G_t p_t, |p_t| ≤ μ p_n, opposite to U_t⁺ where it slips
//! ```
//!
//! The reflection is Moreau's law without friction (Moreau, in: Nonsmooth Mechanics and
//! Applications, CISM 302, 1988). It takes (1 − e²)/2 |w − v⁻|²_M of the energy, whatever the number
//! of contacts, and nothing else, because q·U_n(w) = 0. Friction under given normal impulses is the
//! minimum of the energy over a convex set, and cannot raise it. Neither holds for Newton's law
//! with Coulomb friction, nor for Poisson's with more than one rough contact (Kane, Stanford
//! Mechanics Alumni Club Newsletter 6 (1983); Glocker, Multibody Syst. Dyn. 29 (2013) 77 and
//! 32 (2014) 431). For a single contact of spheres all of them are the same.
//!
//! Repeating the reflection until nothing approaches follows Smith, Kaufman, Vouga, Tamstorf and
//! Grinspun (ACM Trans. Graph. 31 (2012) 106). Differences: friction after each reflection, e < 1,
//! and contacts that close within the step count as closed, so that several impacts of a body in
//! one step follow each other.

use super::assemble::Touching;
use super::energy::Taken;
use super::memory::StoredForce;
use super::setup::{Laws, Wall};
use super::spheres::{Link, Spheres};
use nalgebra::Vector3;
use tribos_core::contact::{
    Body, Contact, ContactFriction, ContactModes, Frictionless, Modal, NormalLaw, Sphere,
    Thresholds, Touch,
};
use tribos_core::internals::{Block, PreparedContact};

/// Rounds of a step at most. What is left of an approach after them is stopped without rebound.
const MOST_ROUNDS: usize = 100;
/// Sweeps of a part of a round at most. Two are enough where no body has two impacts. A part that
/// uses them up is counted; it raises no energy then either.
const MOST_SWEEPS: usize = 1000;
/// Approach, in units of the fastest of the step's first round, below which there is no impact:
/// its energy is 1e-18 of that one's.
const SLOW: f64 = 1e-9;

/// Bodies whose contacts may close in a step, and what governs them.
pub(super) struct Surroundings<'a, F> {
    /// Pairs of spheres, and spheres with walls.
    pub touching: [&'a [Touching]; 2],
    /// One flag a sphere.
    pub awake: &'a [bool],
    /// Contact laws.
    pub laws: &'a Laws<F>,
    /// Acceleration of all spheres.
    pub gravity: &'a Vector3<f64>,
    /// Length of the step.
    pub dt: f64,
}

/// What the impacts of a step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Counts {
    /// Contacts that took an impact, each once a round.
    pub impacts: usize,
    /// Rounds.
    pub rounds: usize,
    /// Whether impacts still went on after the last round.
    pub cut: bool,
    /// Reflections, and solutions of friction under them, that used up their sweeps.
    pub unmet: usize,
}

/// The impacts of one step.
#[derive(Debug)]
pub(super) struct Impacts<F: ContactFriction<f64>> {
    /// Spheres as half of the loads and the impacts leave them.
    pub spheres: Vec<Sphere<f64>>,
    /// Walls, likewise.
    pub walls: Vec<Wall>,
    /// Energies that impacts took, and the work of the loads until then.
    pub taken: Taken,
    /// How many there were.
    pub counts: Counts,
    /// Impulses of pairs and at walls, after [`Impacts::run`] in ascending order of the bodies.
    pub(super) impulses: [Vec<StoredForce<F::Modes>>; 2],
    pub(super) reflection: Spheres<Thresholds<f64, Frictionless>>,
    pub(super) friction: Spheres<F>,
    /// Sweeps of a part of a round at most.
    pub(super) most_sweeps: usize,
}

/// Whether any contact can rebound.
pub(super) fn rebounds<F>(laws: &Laws<F>) -> bool {
    laws.normal().iter().any(|law| law.restitution() > 0.0)
}

impl<F: ContactFriction<f64>> Impacts<F> {
    /// No bodies.
    pub fn new(friction: [F; 2]) -> Self {
        Self {
            spheres: Vec::new(),
            walls: Vec::new(),
            taken: Taken::default(),
            counts: Counts::default(),
            impulses: [Vec::new(), Vec::new()],
            reflection: Spheres::new([Thresholds::none(); 2]),
            friction: Spheres::new(friction),
            most_sweeps: MOST_SWEEPS,
        }
    }

    /// Half of the loads on bodies with the velocities of the step's start, then all impacts.
    pub fn run(
        &mut self,
        (spheres, walls): (&[Sphere<f64>], &[Wall]),
        around: &Surroundings<'_, F>,
    ) {
        self.taken = Taken::from_motion(spheres, walls);
        self.counts = Counts::default();
        self.impulses.iter_mut().for_each(Vec::clear);
        self.spheres.clear();
        self.spheres.extend_from_slice(spheres);
        self.walls.clear();
        self.walls.extend_from_slice(walls);
        self.load(around);
        let groups = groups(around.laws);
        let mut slow = None;
        while self.counts.rounds < MOST_ROUNDS {
            let mut fastest = 0.0_f64;
            for (kinds, restitution) in &groups {
                let speed = self.gather(*kinds, around, slow.unwrap_or(0.0));
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

    /// Impulses of the step's impacts over its length, of pairs and at walls.
    pub fn mean_forces(&self, dt: f64) -> [Vec<StoredForce<F::Modes>>; 2] {
        let over = |(bodies, impulse): &StoredForce<F::Modes>| {
            (*bodies, Modal::default().plus_scaled(1.0 / dt, impulse))
        };
        [0, 1].map(|kind: usize| self.impulses[kind].iter().map(over).collect())
    }

    /// Lets the loads act for half of the step. With the other half after the impacts a ball that
    /// bounces without loss comes back to its height.
    fn load(&mut self, around: &Surroundings<'_, F>) {
        let half = 0.5 * around.dt;
        let bodies = self.spheres.iter_mut().zip(around.awake);
        for (sphere, _) in bodies.filter(|(_, awake)| **awake) {
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

    /// Collects the contacts of these kinds that close faster than `slow`; returns the speed of the
    /// fastest, 0 if there is none.
    fn gather(&mut self, kinds: [bool; 2], around: &Surroundings<'_, F>, slow: f64) -> f64 {
        let (awake, gravity) = (around.awake, around.gravity.norm());
        let [pair_law, wall_law] = &around.laws.normal();
        let [pairs, walls] = around.touching;
        let closing = Closing {
            dt: around.dt,
            slow,
        };
        let reflection = &mut self.reflection;
        reflection.pairs.clear();
        reflection.walls.clear();
        let mut fastest = 0.0_f64;
        for (bodies, touch) in pairs.iter().filter(|_| kinds[0]) {
            let [a, b] = bodies.map(|body| body as usize);
            if awake[a] || awake[b] {
                let contact = prepare(touch, &self.spheres[a], &self.spheres[b]);
                let speed = contact.velocity(&self.spheres[a], &self.spheres[b]).normal;
                if closing.impacts(touch, pair_law, &contact, [-speed, gravity]) {
                    fastest = fastest.max(-speed);
                    reflection.pairs.push(Link {
                        bodies: *bodies,
                        contact,
                    });
                }
            }
        }
        for (bodies, touch) in walls.iter().filter(|_| kinds[1]) {
            let [a, b] = bodies.map(|body| body as usize);
            if awake[a] {
                let wall = &self.walls[b];
                let contact = prepare(&at_plate(touch), &self.spheres[a], &wall.plate);
                let speed = contact.velocity(&self.spheres[a], &wall.plate).normal;
                let load = gravity + (wall.force * wall.plate.inv_mass).abs();
                if closing.impacts(touch, wall_law, &contact, [-speed, load]) {
                    fastest = fastest.max(-speed);
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

/// When a contact takes an impact.
struct Closing {
    dt: f64,
    slow: f64,
}

impl Closing {
    /// True if the gap closes in the step, faster than the loads of one step and cohesion make it:
    /// slower contacts last, and are the matter of the step's own problem.
    fn impacts(
        &self,
        touch: &Touch<f64>,
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

/// Kinds of contacts, pairs and walls, that rebound with the same coefficient: the energy of a
/// reflection falls for a common one.
fn groups<F>(laws: &Laws<F>) -> Vec<([bool; 2], f64)> {
    let [pair, wall] = laws.normal().map(|law| law.restitution());
    let groups = if pair == wall {
        vec![([true, true], pair)]
    } else {
        vec![([true, false], pair), ([false, true], wall)]
    };
    groups.into_iter().filter(|(_, e)| *e > 0.0).collect()
}

/// A sphere that has reached its plate: friction's lever is the radius, whatever gap the last step
/// left. Between two spheres the levers end at one point within the gap, which keeps angular
/// momentum; a plate does not turn.
fn at_plate(touch: &Touch<f64>) -> Touch<f64> {
    Touch {
        arms: [touch.lever, 0.0],
        ..*touch
    }
}

/// A contact without gap, cohesion and friction.
fn prepare(
    touch: &Touch<f64>,
    a: &impl Body<f64>,
    b: &impl Body<f64>,
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
    Contact::resume(&prepared, &Modal::default())
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
