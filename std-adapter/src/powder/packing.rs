//! A world with its contact modes hidden behind a trait: steps, states, contacts.

use super::carried::CarriedModes;
use super::checkpoint::Frozen;
use super::deposit::{Deposit, SUBSTRATE};
use super::error::CompactionError;
use crate::cd::internals::{Coefficients, Memory, Sleep, StoredForce};
use crate::cd::{
    ContactLaws, EnergyBalance, Laws, Setup, State, StepReport, Wall, World, WorldError, solid,
};
use crate::record::{ContactRow, Partner};
use crate::scene::{Coupling, PowderScene, WallLaw};
use nalgebra::Vector3;
use std::fmt::Debug;
use tribos_core::Error;
use tribos_core::contact::{
    Cohesion, ContactFriction, ContactModes, CoupledFriction, Modal, NormalLaw, Sphere, Thresholds,
    Touch, TouchError,
};
use tribos_core::coupling::table;
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};

/// Number of the piston among the walls.
///
/// ```
/// use tribos::powder::{Compaction, PISTON};
/// use tribos::record::Partner;
/// use tribos::run::drive;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// // In a packing that is blocked the spheres below the piston bear its load.
/// let mut compaction = Compaction::new(&scene)?;
/// drive(&mut compaction, |_, _| ())?;
/// let below = compaction.contacts().iter().filter(|row| row.b == Partner::Wall(PISTON));
/// let force: f64 = below.map(|row| row.force.z).sum();
/// assert!((force / scene.load() - 1.0).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const PISTON: u32 = 1;

/// Units of the powder: cohesion and density are 1.
const STRENGTH: f64 = 1.0;
const DENSITY: f64 = 1.0;

/// Spheres between a substrate and a piston, with any contact modes.
pub(super) trait Packing: Debug {
    /// Takes one step.
    fn step(&mut self) -> Result<StepReport, WorldError>;
    /// Elapsed time and number of steps.
    fn clock(&self) -> (f64, u64);
    /// Centres of the spheres.
    fn positions(&self) -> &[Vector3<f64>];
    /// Radii of the spheres.
    fn radii(&self) -> &[f64];
    /// Velocities, inverse masses and inertias of the spheres.
    fn spheres(&self) -> &[Sphere<f64>];
    /// Substrate and piston.
    fn walls(&self) -> &[Wall];
    /// Energy balance.
    fn energy(&self) -> &EnergyBalance;
    /// Contacts that carry a force or lie within the range of cohesion, with the forces of the last
    /// step, including its impacts, at the current positions.
    fn contacts(&self) -> Result<Vec<ContactRow>, TouchError>;
    /// The complete state of a run.
    fn freeze(&self) -> Frozen;
}

/// Builds the packing of a scene at its start or from a stored state. Modes whose coefficient is zero
/// are omitted if a type without them exists.
pub(super) fn build(
    scene: &PowderScene,
    deposit: &Deposit,
    frozen: Option<&Frozen>,
) -> Result<Box<dyn Packing>, CompactionError> {
    let (mu, mu_t, mu_n) = (scene.sliding, scene.rolling, scene.torsion);
    let at = (scene, deposit, frozen);
    let carried = scene.carried();
    match carried.coupling {
        Coupling::Independent => {}
        Coupling::Ellipsoid => return coupled(at, [ellipsoid(scene, mu)?, ellipsoid(scene, 0.0)?]),
        Coupling::Exact => return coupled(at, [exact(scene, mu)?, exact(scene, 0.0)?]),
    }
    match carried.modes {
        CarriedModes::Normal => boxed(at, [Thresholds::none(); 2]),
        CarriedModes::Sliding => boxed(
            at,
            both(scene, Thresholds::sliding(mu)?, Thresholds::sliding(0.0)?),
        ),
        CarriedModes::SlidingTorsion => boxed(
            at,
            both(
                scene,
                Thresholds::sliding_torsion(mu, mu_n)?,
                Thresholds::sliding_torsion(0.0, 0.0)?,
            ),
        ),
        CarriedModes::SlidingRolling => boxed(
            at,
            both(
                scene,
                Thresholds::sliding_rolling(mu, mu_t)?,
                Thresholds::sliding_rolling(0.0, 0.0)?,
            ),
        ),
        CarriedModes::All => boxed(
            at,
            both(
                scene,
                Thresholds::all(mu, mu_t, mu_n)?,
                Thresholds::all(0.0, 0.0, 0.0)?,
            ),
        ),
    }
}

/// Torque of pure spinning over force limit and radius, under uniform pressure.
const SPIN_TORQUE: f64 = 2.0 / 3.0;

/// Radius of the contact in r_eff that follows from its two thresholds.
fn contact_radius(scene: &PowderScene) -> f64 {
    scene.torsion / (scene.sliding * SPIN_TORQUE)
}

/// What a contact of a joint set carries at a coefficient, in P and P r_eff.
pub(super) fn ellipsoid(scene: &PowderScene, mu: f64) -> Result<Ellipsoid<f64>, Error> {
    Ellipsoid::new(mu, contact_radius(scene), SPIN_TORQUE)
}

/// Exact limit surface that joins sliding and torsion at a coefficient `mu`.
pub(super) fn exact(
    scene: &PowderScene,
    mu: f64,
) -> Result<LimitSurface<f64, table::Coulomb>, Error> {
    LimitSurface::new(table::Coulomb, mu, contact_radius(scene))
}

/// A world in which sliding and torsion share a set: one between spheres, one at smooth walls.
fn coupled<S: FrictionSet<f64> + Copy + Debug + Send + Sync + 'static>(
    at: (&PowderScene, &Deposit, Option<&Frozen>),
    [rough, smooth]: [S; 2],
) -> Result<Box<dyn Packing>, CompactionError> {
    let scene = at.0;
    let mu_t = scene.rolling;
    if mu_t > 0.0 {
        let law = |set, mu_t| CoupledFriction::all(set, mu_t);
        boxed(at, both(scene, law(rough, mu_t)?, law(smooth, 0.0)?))
    } else {
        let law = CoupledFriction::sliding_torsion;
        boxed(at, both(scene, law(rough), law(smooth)))
    }
}

/// Friction between spheres and at walls.
fn both<F: Copy>(scene: &PowderScene, rough: F, smooth: F) -> [F; 2] {
    match scene.wall {
        WallLaw::Full => [rough, rough],
        WallLaw::Smooth | WallLaw::Bare => [rough, smooth],
    }
}

/// A world with these contact modes.
fn boxed<F: ContactFriction<f64> + Coefficients + Debug + 'static>(
    (scene, deposit, frozen): (&PowderScene, &Deposit, Option<&Frozen>),
    friction: [F; 2],
) -> Result<Box<dyn Packing>, CompactionError> {
    let cohesion = Cohesion::new(STRENGTH, scene.cohesion_range, scene.attraction)?;
    let pair = NormalLaw::new(cohesion, scene.restitution)?;
    let wall = match scene.wall {
        WallLaw::Full | WallLaw::Smooth => pair,
        WallLaw::Bare => NormalLaw::new(Cohesion::NONE, scene.restitution)?,
    };
    let [of_pairs, of_walls] = friction;
    let laws = Laws {
        pairs: ContactLaws {
            normal: pair,
            friction: of_pairs,
        },
        walls: ContactLaws {
            normal: wall,
            friction: of_walls,
        },
    };
    let up = Vector3::z();
    let setup = Setup {
        space: deposit.space,
        positions: deposit.positions.clone(),
        radii: deposit.radii.clone(),
        spheres: deposit.radii.iter().map(|&r| solid(r, DENSITY)).collect(),
        // The order of SUBSTRATE and PISTON.
        walls: vec![
            Wall::fixed(up, 0.0),
            Wall::piston(-up, -deposit.height, scene.piston_mass, scene.load()),
        ],
        step_limits: scene.step_limits(),
        solver: scene.contact_solver(),
        sleep_speed: scene.still_speed,
        ..Setup::new(laws)
    };
    let mut world = World::new(setup)?;
    if let Some(frozen) = frozen {
        thaw(frozen, world.state_mut());
    }
    Ok(Box::new(world))
}

/// Restores a stored state in a new world of the same bodies.
fn thaw<M: ContactModes<f64>>(frozen: &Frozen, state: &mut State<M>) {
    state.time = frozen.time;
    state.steps = frozen.steps;
    state.positions.clone_from(&frozen.positions);
    for (sphere, [velocity, spin]) in state.spheres.iter_mut().zip(&frozen.motions) {
        (sphere.velocity, sphere.spin) = (*velocity, *spin);
    }
    for (wall, (place, velocity)) in state.walls.iter_mut().zip(&frozen.walls) {
        (wall.place, wall.plate.velocity) = (*place, *velocity);
    }
    state.energy = frozen.energy;
    state.sleep = Sleep::restored(frozen.awake.clone(), frozen.still.clone());
    state.memory = memory(&frozen.forces);
    state.impacts = memory(&frozen.impacts);
}

/// Forces in the modes of a world.
fn memory<M: ContactModes<f64>>(forces: &Forces) -> Memory<M> {
    let modal = |(bodies, force): &([u32; 2], Force)| {
        let modal = Modal::new(force.normal, force.sliding, force.rolling, force.torsion);
        (*bodies, modal)
    };
    Memory {
        forces: [0, 1].map(|kind: usize| forces[kind].iter().map(modal).collect()),
    }
}

/// Forces in all modes.
fn forces<M: ContactModes<f64>>(memory: &Memory<M>) -> Forces {
    let force = |(bodies, modal): &StoredForce<M>| (*bodies, Force::of(modal));
    [0, 1].map(|kind: usize| memory.forces[kind].iter().map(force).collect())
}

/// Forces of pairs and at walls, with their bodies.
pub(super) type Forces = [Vec<([u32; 2], Force)>; 2];

/// Force and torque of a contact, in all modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Force {
    pub normal: f64,
    pub sliding: Vector3<f64>,
    pub rolling: Vector3<f64>,
    pub torsion: f64,
}

impl Force {
    fn of<M: ContactModes<f64>>(modal: &Modal<f64, M>) -> Self {
        Self {
            normal: modal.normal,
            sliding: modal.sliding(),
            rolling: modal.rolling(),
            torsion: modal.torsion(),
        }
    }

    /// A row of the contact table, with the geometry of the contact.
    fn row(&self, a: u32, b: Partner, touch: &Touch<f64>) -> ContactRow {
        let normal = touch.normal;
        ContactRow {
            a,
            b,
            normal,
            gap: touch.gap,
            force: normal * self.normal + self.sliding,
            torque: normal * self.torsion + self.rolling,
        }
    }
}

impl<F: ContactFriction<f64> + Coefficients + Debug> Packing for World<F> {
    fn step(&mut self) -> Result<StepReport, WorldError> {
        World::step(self)
    }

    fn clock(&self) -> (f64, u64) {
        (self.state().time, self.state().steps)
    }

    fn positions(&self) -> &[Vector3<f64>] {
        &self.state().positions
    }

    fn radii(&self) -> &[f64] {
        &self.setup().radii
    }

    fn spheres(&self) -> &[Sphere<f64>] {
        &self.state().spheres
    }

    fn walls(&self) -> &[Wall] {
        &self.state().walls
    }

    fn energy(&self) -> &EnergyBalance {
        &self.state().energy
    }

    fn contacts(&self) -> Result<Vec<ContactRow>, TouchError> {
        let (setup, state) = (self.setup(), self.state());
        let [pairs, walls] = &state.memory.forces;
        let [pair_law, wall_law] = &setup.laws.normal();
        let mut rows = Vec::with_capacity(pairs.len() + walls.len());
        let with_impact = |kind, bodies, force: &Modal<f64, F::Modes>| {
            let impact = state.impacts.force(kind, bodies);
            impact.map_or(*force, |impact| force.plus_scaled(1.0, impact))
        };
        for ([a, b], force) in pairs {
            let force = with_impact(0, [*a, *b], force);
            let [i, j] = [*a as usize, *b as usize];
            let apart = setup
                .space
                .displacement(&state.positions[i], &state.positions[j]);
            let touch = Touch::spheres(&apart, [setup.radii[i], setup.radii[j]])?;
            if force.normal != 0.0 || touch.gap <= pair_law.cohesion().range() {
                rows.push(Force::of(&force).row(*a, Partner::Particle(*b), &touch));
            }
        }
        for ([a, b], force) in walls {
            let force = with_impact(1, [*a, *b], force);
            let (i, wall) = (*a as usize, &state.walls[*b as usize]);
            let height = wall.outward.dot(&state.positions[i]) - wall.place;
            let touch = Touch::plate(height, &wall.outward, setup.radii[i])?;
            if force.normal != 0.0 || touch.gap <= wall_law.cohesion().range() {
                rows.push(Force::of(&force).row(*a, Partner::Wall(*b), &touch));
            }
        }
        Ok(rows)
    }

    fn freeze(&self) -> Frozen {
        let state = self.state();
        Frozen {
            time: state.time,
            steps: state.steps,
            positions: state.positions.clone(),
            motions: state.spheres.iter().map(|s| [s.velocity, s.spin]).collect(),
            walls: state
                .walls
                .iter()
                .map(|wall| (wall.place, wall.plate.velocity))
                .collect(),
            energy: state.energy,
            forces: forces(&state.memory),
            impacts: forces(&state.impacts),
            awake: state.sleep.awake().to_vec(),
            still: state.sleep.still().to_vec(),
        }
    }
}

/// Vector from the first centre of a contact to the second, or perpendicular to the wall.
pub(super) fn branch(contact: &ContactRow, radii: &[f64]) -> Vector3<f64> {
    let other = contact.b.particle().map_or(0.0, |b| radii[b as usize]);
    contact.normal * (radii[contact.a as usize] + other + contact.gap)
}

/// True for a contact of a sphere with this wall.
pub(super) fn is_at(contact: &ContactRow, wall: u32) -> bool {
    contact.b == Partner::Wall(wall)
}

const _: () = assert!(SUBSTRATE == 0 && PISTON == 1);
