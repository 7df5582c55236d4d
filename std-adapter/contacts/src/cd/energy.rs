//! Energy balance.
//!
//! With velocities v⁺ after and v⁻ before a step of implicit Euler, impulses p and external loads
//! f, the kinetic energy T changes by
//!
//! ```text
//! T⁺ − T⁻ = f·v⁺ dt + Σ p·U⁺ − ½ |v⁺ − v⁻|²_M
//! ```
//!
//! exactly: the first term is external work (positions move with v⁺), the second is the energy taken by
//! the contact modes, the last is the energy lost in inelastic collisions. Only the work and a pull of
//! cohesion that closes a gap can raise the energy, so the scheme creates none.

use super::setup::keeps_motion;
use super::spheres::{Link, Spheres};
use super::to_problem::unit_sphere;
use super::wall::Wall;
use nalgebra::Vector3;
use tribos_core::contact::{
    Contact, ContactFriction, ContactModes, ContactVector, SphereBody, WallBody,
};

/// Energy balance of a run. *Units*: energy.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::cd::{EnergyBalance, IterationOrder, StopRule, Wall};
/// # use tribos::cd::internals::{Link, Spheres, Sweeper, solve};
/// # use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// # let (up, dt) = (Vector3::z(), 1e-3);
/// # let (spin, velocity) = (Vector3::zeros(), Vector3::new(1.0, 0.0, -2.0));
/// # let ball = SphereBody { velocity, spin, inv_mass: 1.0, inv_inertia: 1e3 };
/// # let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// # let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// # let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// # let mut problem = Spheres::new([IndependentFriction::sliding(0.0)?; 2]);
/// # problem.free = (vec![ball], vec![floor]);
/// # problem.walls.push(Link { bodies: [0, 0], contact });
/// # problem.start();
/// // A ball of 1 kg falls on a smooth floor at 2 m/s, does not rebound, and drifts on at 1 m/s.
/// solve(&mut problem, &mut Sweeper::new(IterationOrder::Fixed, 0), StopRule::Fixed, 1);
/// let mut book = EnergyBalance::default();
/// let before = (&[ball][..], &[Wall::fixed(up, 0.0)][..]);
/// book.add_step(&[true], before, &problem, &Vector3::zeros(), dt);
/// assert_eq!((book.normal, book.kinetic), (2.0, 0.5)); // J
/// // What is left goes if the ball is stopped by hand.
/// book.add_sleep(&problem.spheres[0]);
/// assert_eq!((book.stilled, book.kinetic, book.imbalance()), (0.5, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyBalance {
    /// Work of the loads on walls, of prescribed motions of walls and spheres, of gravity, and of a shear.
    pub work: f64,
    /// Energy lost in collisions and in closing gaps.
    pub normal: f64,
    /// Energy lost in sliding.
    pub sliding: f64,
    /// Energy lost in rolling.
    pub rolling: f64,
    /// Energy lost in torsion.
    pub torsion: f64,
    /// Work against cohesion: stored in stretched contacts, or lost in broken ones.
    pub cohesion: f64,
    /// Elastic energy of soft contacts, less that at the start; 0 for rigid ones.
    pub elastic: f64,
    /// Kinetic energy of bodies at the moment they are put to sleep.
    pub stilled: f64,
    /// Current kinetic energy.
    pub kinetic: f64,
    /// Kinetic energy at the first entry; `None` before it.
    pub kinetic_initial: Option<f64>,
}

impl EnergyBalance {
    /// Residual of the balance: rounding errors of rigid contacts, errors of the step of soft ones.
    pub fn imbalance(&self) -> f64 {
        let spent = self.normal + self.sliding + self.rolling + self.torsion + self.cohesion;
        let kept = self.kinetic - self.kinetic_initial.unwrap_or(self.kinetic);
        self.work - spent - self.stilled - kept - self.elastic
    }

    /// Takes the energy of moving spheres before the first entry.
    #[doc(hidden)]
    pub fn before_first<'a>(&mut self, spheres: impl Iterator<Item = &'a SphereBody<f64>>) {
        if self.kinetic_initial.is_none() {
            let each = spheres.map(|sphere| kinetic_energy(sphere, &sphere.velocity, &sphere.spin));
            self.kinetic = each.sum();
        }
    }

    /// Adds one step; spheres and walls are those at its start.
    pub fn add_step<F: ContactFriction<f64>>(
        &mut self,
        awake: &[bool],
        (before, walls): (&[SphereBody<f64>], &[Wall]),
        problem: &Spheres<F>,
        gravity: &Vector3<f64>,
        dt: f64,
    ) {
        let mut kinetic = 0.0;
        let mut initial = 0.0;
        for ((old, new), awake) in before.iter().zip(&problem.spheres).zip(awake) {
            let mass = 1.0 / new.inv_mass;
            kinetic += kinetic_energy(new, &new.velocity, &new.spin);
            initial += kinetic_energy(new, &old.velocity, &old.spin);
            let change = (new.velocity - old.velocity, new.spin - old.spin);
            self.normal += kinetic_energy(new, &change.0, &change.1);
            if *awake && !keeps_motion(new) {
                self.work += mass * gravity.dot(&new.velocity) * dt;
            }
        }
        for (wall, plate) in walls.iter().zip(&problem.plates) {
            if plate.inv_mass > 0.0 {
                self.work += wall.force * wall.outward.dot(&plate.velocity) * dt;
                let mass = 1.0 / plate.inv_mass;
                let [new, old] = [plate, &wall.plate].map(|plate| along(wall, &plate.velocity));
                kinetic += 0.5 * mass * (new * new);
                initial += 0.5 * mass * (old * old);
                self.normal += 0.5 * mass * ((new - old) * (new - old));
            }
        }
        self.kinetic_initial.get_or_insert(initial);
        self.kinetic = kinetic;
        self.contacts(problem);
    }

    /// Energy taken by each mode: −p·U⁺.
    fn contacts<F: ContactFriction<f64>>(&mut self, problem: &Spheres<F>) {
        for (link, velocity) in problem.pair_velocities() {
            self.modes(&link.contact, &velocity);
            self.work -= problem.driven_by_pair(&link);
        }
        if !problem.images.is_empty() {
            self.work -= problem.shear_work();
        }
        for (wall, (link, velocity)) in problem.wall_velocities().enumerate() {
            self.modes(&link.contact, &velocity);
            self.work -= problem.driven_by_wall(wall);
        }
    }

    fn modes<M: ContactModes<f64>>(
        &mut self,
        contact: &Contact<f64, M>,
        u: &ContactVector<f64, M>,
    ) {
        let p = contact.impulse();
        // P pushes, cohesion pulls.
        self.normal -= contact.bound() * u.normal;
        self.cohesion += contact.cohesion() * u.normal;
        self.sliding -= p.sliding().dot(&u.sliding());
        self.rolling -= p.rolling().dot(&u.rolling());
        self.torsion -= p.torsion() * u.torsion();
    }

    /// Adds the impacts of a step, before the step itself.
    pub(super) fn add_impacts(&mut self, taken: &ImpactEnergies) {
        self.kinetic_initial.get_or_insert(taken.kinetic);
        self.work += taken.work;
        self.normal += taken.normal;
        self.sliding += taken.sliding;
        self.rolling += taken.rolling;
        self.torsion += taken.torsion;
    }

    /// Adds the work on a sphere that goes on as its image across the border of a sheared cell, from its
    /// kinetic energy before and after.
    pub(super) fn cross(&mut self, before: f64, after: f64) {
        self.work += after - before;
        self.kinetic += after - before;
    }

    /// Adds the energy of a body that is put to sleep.
    pub fn add_sleep(&mut self, sphere: &SphereBody<f64>) {
        if keeps_motion(sphere) {
            return;
        }
        let energy = 0.5 * sphere.velocity.norm_squared() / sphere.inv_mass
            + 0.5 * sphere.spin.norm_squared() / sphere.inv_inertia;
        self.stilled += energy;
        self.kinetic -= energy;
    }
}

/// Energies taken by the impacts of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ImpactEnergies {
    /// Kinetic energy before the impacts.
    pub kinetic: f64,
    /// Work of loads and of prescribed wall motions.
    pub work: f64,
    /// Energy lost along the normals.
    pub normal: f64,
    /// Energy lost in sliding.
    pub sliding: f64,
    /// Energy lost in rolling.
    pub rolling: f64,
    /// Energy lost in torsion.
    pub torsion: f64,
}

impl ImpactEnergies {
    /// Zero losses, for bodies in their current motion.
    pub fn from_motion(spheres: &[SphereBody<f64>], walls: &[Wall]) -> Self {
        let moving =
            |sphere: &SphereBody<f64>| kinetic_energy(sphere, &sphere.velocity, &sphere.spin);
        let plates = walls.iter().filter(|wall| wall.plate.inv_mass > 0.0);
        let gliding = |wall: &Wall| {
            let speed = along(wall, &wall.plate.velocity);
            0.5 * (speed * speed) / wall.plate.inv_mass
        };
        Self {
            kinetic: spheres.iter().map(moving).sum::<f64>() + plates.map(gliding).sum::<f64>(),
            ..Self::default()
        }
    }
}

/// Speed of a wall along its normal: its drive keeps the part across, whatever it bears.
fn along(wall: &Wall, velocity: &Vector3<f64>) -> f64 {
    wall.outward.dot(velocity)
}

/// ½ m v² + ½ I ω² of a sphere's mass and inertia; 0 of a sphere that keeps its motion, whose drive has the energy.
pub(crate) fn kinetic_energy(sphere: &SphereBody<f64>, v: &Vector3<f64>, w: &Vector3<f64>) -> f64 {
    if keeps_motion(sphere) {
        return 0.0;
    }
    let (mass, inertia) = (1.0 / sphere.inv_mass, 1.0 / sphere.inv_inertia);
    0.5 * (mass * v.norm_squared() + inertia * w.norm_squared())
}

impl<F: ContactFriction<f64>> Spheres<F> {
    /// Energy that a pair transfers to the drive of a sphere that keeps its motion.
    pub(super) fn driven_by_pair(&self, link: &Link<F::Modes>) -> f64 {
        let bodies = link.bodies.map(|body| &self.spheres[body as usize].0);
        if !bodies.iter().any(|body| keeps_motion(body)) {
            return 0.0;
        }
        let (mut a, mut b) = (unit_sphere(), unit_sphere());
        link.contact.apply(link.contact.impulse(), &mut a, &mut b);
        let work = |(body, pushed): (&SphereBody<f64>, SphereBody<f64>)| {
            body.velocity.dot(&pushed.velocity) + body.spin.dot(&pushed.spin)
        };
        let each = bodies.into_iter().zip([a, b]);
        each.filter(|(body, _)| keeps_motion(body)).map(work).sum()
    }

    /// Energy that a contact transfers to the drive of its wall.
    pub(super) fn driven_by_wall(&self, wall: usize) -> f64 {
        let link = &self.walls[wall];
        let Some(surface) = self.surface(wall) else {
            return driven_work(link, &self.plates[link.bodies[1] as usize]);
        };
        let (impulse, normal) = (link.contact.impulse(), link.contact.normal());
        impulse.linear(normal).dot(&surface.velocity) + impulse.angular(normal).dot(&surface.spin)
    }
}

/// Energy transferred to the drive of a wall. The drive bears the impulse on the wall: all of it if the wall
/// is not movable, else the part across the normal.
fn driven_work<M: ContactModes<f64>>(link: &Link<M>, wall: &WallBody<f64>) -> f64 {
    let normal = link.contact.normal();
    let felt = if wall.inv_mass > 0.0 {
        normal * wall.velocity.dot(normal)
    } else {
        Vector3::zeros()
    };
    let impulse = link.contact.impulse().linear(normal);
    impulse.dot(&(wall.velocity - felt))
}
