//! A world of soft spheres with its contact modes hidden behind the trait of packings.

use super::rigid::cell_state;
use super::{
    Bodies, Force, Forces, OptionalFeatures, Packing, PackingRunError, Springs, WorldSnapshot,
};
use nalgebra::Vector3;
use std::fmt::Debug;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::space::PeriodicBox;
use tribos_contacts::cd::{AxisControl, EnergyBalance, StepLimits, StepReport, Wall, WorldError};
use tribos_contacts::problem::GlobalProblem;
use tribos_contacts::soft::{SoftContact, SoftSetup, SoftState, SoftWorld};
use tribos_core::contact::{
    ContactError, ContactFriction, ContactGeometry, ContactModes, ContactVector, SphereBody,
};

/// A world of soft spheres. A step of the packing is as long as one of contact dynamics and made of as many
/// steps of the world as the springs need.
#[derive(Debug)]
struct SoftPacking<F: ContactFriction<f64>> {
    world: SoftWorld<F>,
    steps: u64,
    limits: StepLimits,
}

/// A packing of these spheres, with a mesh if there is one; `laws` has the spheres, their materials and contact modes.
pub(super) fn boxed<F: ContactFriction<f64> + Debug + 'static>(
    laws: SoftSetup<F>,
    (bodies, extras): (Bodies, &OptionalFeatures),
    springs: &Springs,
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    let limits = springs.step_limits;
    let mut setup = SoftSetup {
        mesh: extras.mesh.clone(),
        space: bodies.space,
        positions: bodies.positions,
        radii: bodies.radii,
        walls: bodies.walls,
        gravity: bodies.gravity,
        damping: springs.damping,
        longest: limits.longest,
        steps_per_collision: springs.steps_per_collision,
        cell: extras.cell,
        ..laws
    };
    for (sphere, velocity) in setup.spheres.iter_mut().zip(&extras.velocities) {
        sphere.velocity += velocity;
    }
    let mut world = SoftWorld::new(setup)?;
    if let Some(frozen) = frozen {
        thaw(frozen, &mut world)?;
    }
    let steps = frozen.map_or(0, |frozen| frozen.steps);
    Ok(Box::new(SoftPacking {
        world,
        steps,
        limits,
    }))
}

/// Restores a stored state in a new world of the same bodies.
fn thaw<F: ContactFriction<f64>>(
    frozen: &WorldSnapshot,
    world: &mut SoftWorld<F>,
) -> Result<(), WorldError> {
    let state = world.state_mut();
    state.time = frozen.time;
    state.steps = frozen.steps;
    state.positions.clone_from(&frozen.positions);
    for (sphere, [velocity, spin]) in state.spheres.iter_mut().zip(&frozen.motions) {
        (sphere.velocity, sphere.spin) = (*velocity, *spin);
    }
    for (wall, (place, velocity)) in state.walls.iter_mut().zip(&frozen.walls) {
        (wall.place, wall.plate.velocity) = (*place, *velocity);
    }
    if let Some(kept) = frozen.cell {
        let cell = cell_state(kept, frozen)?;
        (state.space, state.speeds) = (cell.space, cell.speeds);
    }
    state.energy = frozen.energy;
    state.energy.before_first(state.spheres.iter());
    state.origin = frozen.origin;
    world.restore(&[0, 1].map(|kind: usize| {
        let stored = frozen.forces[kind].iter().zip(&frozen.impacts[kind]);
        let contact = |((bodies, force), (_, springs)): (&Stored, &Stored)| {
            (*bodies, [modal(force), modal(springs)])
        };
        stored.map(contact).collect()
    }))
}

/// A stored force, or stored springs, with the bodies.
type Stored = ([u32; 2], Force);

fn modal<M: ContactModes<f64>>(force: &Force) -> ContactVector<f64, M> {
    ContactVector::new(force.normal, force.sliding, force.rolling, force.torsion)
}

/// Forces of the contacts in range, or their springs.
fn stored<M: ContactModes<f64>>(
    state: &SoftState<M>,
    part: impl Fn(&SoftContact<M>) -> ContactVector<f64, M>,
) -> Forces {
    let one = |contact: &SoftContact<M>| (contact.bodies, Force::of(&part(contact)));
    [0, 1].map(|kind: usize| {
        let contacts = state.contacts[kind].iter();
        contacts
            .filter(|contact| contact.in_range)
            .map(one)
            .collect()
    })
}

impl<F: ContactFriction<f64> + Debug> Packing for SoftPacking<F> {
    fn step(&mut self) -> Result<StepReport, WorldError> {
        // As far as contact dynamics would go: the longest step, or the largest motion.
        let speed = self.world.fastest();
        let span = self.limits.longest.min(self.limits.motion / speed);
        let (mut elapsed, mut overlap) = (0.0, 0.0_f64);
        loop {
            let report = self.world.step()?;
            elapsed += report.dt;
            overlap = overlap.max(report.overlap);
            if elapsed + 0.5 * report.dt >= span {
                self.steps += 1;
                return Ok(StepReport {
                    dt: elapsed,
                    overlap,
                    ..report
                });
            }
        }
    }

    fn clock(&self) -> (f64, u64) {
        (self.world.state().time, self.steps)
    }

    fn positions(&self) -> &[Vector3<f64>] {
        &self.world.state().positions
    }

    fn radii(&self) -> &[f64] {
        &self.world.setup().radii
    }

    fn spheres(&self) -> &[SphereBody<f64>] {
        &self.world.state().spheres
    }

    fn walls(&self) -> &[Wall] {
        &self.world.state().walls
    }

    fn walls_mut(&mut self) -> &mut [Wall] {
        &mut self.world.state_mut().walls
    }

    fn place(&mut self, sphere: usize, at: Vector3<f64>, [velocity, spin]: [Vector3<f64>; 2]) {
        let state = self.world.state_mut();
        state.positions[sphere] = at;
        let body = &mut state.spheres[sphere];
        (body.velocity, body.spin) = (velocity, spin);
    }

    fn set_gravity(&mut self, gravity: Vector3<f64>) {
        self.world.set_gravity(gravity);
    }

    fn set_axes(&mut self, axes: [AxisControl; 3]) {
        self.world.set_axes(axes);
    }

    fn energy(&self) -> &EnergyBalance {
        &self.world.state().energy
    }

    fn problem(&self) -> Option<GlobalProblem> {
        None
    }

    fn is_rigid(&self) -> bool {
        false
    }

    fn contacts(&self) -> Result<Vec<ContactRow>, ContactError> {
        let [pairs, walls] = &self.world.state().contacts;
        let in_range = |contact: &&SoftContact<F::Modes>| contact.in_range;
        let row = |contact: &SoftContact<F::Modes>, b: Partner| {
            let touch = ContactGeometry {
                normal: contact.normal,
                gap: contact.gap,
                arms: [0.0; 2],
                lever: 0.0,
            };
            Force::of(&contact.force).row(contact.bodies[0], b, &touch)
        };
        let pairs = pairs.iter().filter(in_range);
        let pairs = pairs.map(|contact| row(contact, Partner::Particle(contact.bodies[1])));
        let walls = walls.iter().filter(in_range);
        let walls = walls.map(|contact| row(contact, Partner::Wall(contact.bodies[1])));
        Ok(pairs.chain(walls).collect())
    }

    fn space(&self) -> PeriodicBox {
        self.world.state().space
    }

    fn snapshot(&self) -> WorldSnapshot {
        let state = self.world.state();
        let bodies = state.spheres.len();
        WorldSnapshot {
            time: state.time,
            steps: self.steps,
            positions: state.positions.clone(),
            motions: state.spheres.iter().map(|s| [s.velocity, s.spin]).collect(),
            walls: state
                .walls
                .iter()
                .map(|wall| (wall.place, wall.plate.velocity))
                .collect(),
            shear_offset: state.space.offset(),
            energy: state.energy,
            forces: stored(state, |contact| contact.force),
            // A soft contact has no impacts; its springs take their place.
            impacts: stored(state, SoftContact::stored),
            awake: vec![true; bodies],
            still: vec![0; bodies],
            origin: state.origin,
            cell: self.world.setup().cell.map(|_| {
                [
                    state.space.lengths().map(|length| length.unwrap_or(0.0)),
                    state.speeds,
                ]
            }),
        }
    }
}
