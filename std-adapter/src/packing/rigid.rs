//! A world of contact dynamics with its contact modes hidden behind the trait of packings.

use super::{Bodies, CarriedModes, Force, Forces, Frozen, Material, Method, Packing, PackingError};
use crate::cd::internals::{Coefficients, Memory, Sleep, StoredForce};
use crate::cd::{
    ContactLaws, EnergyBalance, Laws, Setup, State, StepReport, Wall, World, WorldError, solid,
};
use crate::record::{ContactRow, Partner};
use crate::scene::{Coupling, WallLaw};
use nalgebra::Vector3;
use std::fmt::Debug;
use tribos_core::contact::{
    ContactFriction, ContactModes, CoupledFriction, Modal, Sphere, Thresholds, Touch, TouchError,
};
use tribos_core::limit_surface::FrictionSet;

/// What a world starts from.
type Parts<'a> = (&'a Material, Bodies, &'a Method, Option<&'a Frozen>);

/// Builds a world whose type has the modes that resist.
pub(super) fn build(
    material: &Material,
    bodies: Bodies,
    method: &Method,
    frozen: Option<&Frozen>,
) -> Result<Box<dyn Packing>, PackingError> {
    let (mu, mu_t, mu_n) = (material.sliding, material.rolling, material.torsion);
    let at = (material, bodies, method, frozen);
    let carried = material.carried();
    match carried.coupling {
        Coupling::Independent => {}
        Coupling::Ellipsoid => {
            return coupled(at, [material.ellipsoid(mu)?, material.ellipsoid(0.0)?]);
        }
        Coupling::Exact => return coupled(at, [material.exact(mu)?, material.exact(0.0)?]),
    }
    match carried.modes {
        CarriedModes::Normal => boxed(at, [Thresholds::none(); 2]),
        CarriedModes::Sliding => boxed(
            at,
            both(
                material,
                Thresholds::sliding(mu)?,
                Thresholds::sliding(0.0)?,
            ),
        ),
        CarriedModes::SlidingTorsion => boxed(
            at,
            both(
                material,
                Thresholds::sliding_torsion(mu, mu_n)?,
                Thresholds::sliding_torsion(0.0, 0.0)?,
            ),
        ),
        CarriedModes::SlidingRolling => boxed(
            at,
            both(
                material,
                Thresholds::sliding_rolling(mu, mu_t)?,
                Thresholds::sliding_rolling(0.0, 0.0)?,
            ),
        ),
        CarriedModes::All => boxed(
            at,
            both(
                material,
                Thresholds::all(mu, mu_t, mu_n)?,
                Thresholds::all(0.0, 0.0, 0.0)?,
            ),
        ),
    }
}

/// A world in which sliding and torsion share a set: one between spheres, one at smooth walls.
fn coupled<S: FrictionSet<f64> + Copy + Debug + Send + Sync + 'static>(
    at: Parts<'_>,
    [rough, smooth]: [S; 2],
) -> Result<Box<dyn Packing>, PackingError> {
    let material = at.0;
    let mu_t = material.rolling;
    if mu_t > 0.0 {
        let law = |set, mu_t| CoupledFriction::all(set, mu_t);
        boxed(at, both(material, law(rough, mu_t)?, law(smooth, 0.0)?))
    } else {
        let law = CoupledFriction::sliding_torsion;
        boxed(at, both(material, law(rough), law(smooth)))
    }
}

/// Friction between spheres and at walls.
fn both<F: Copy>(material: &Material, rough: F, smooth: F) -> [F; 2] {
    match material.wall {
        WallLaw::Full => [rough, rough],
        WallLaw::Smooth | WallLaw::Bare => [rough, smooth],
    }
}

/// A world with these contact modes.
fn boxed<F: ContactFriction<f64> + Coefficients + Debug + 'static>(
    (material, bodies, method, frozen): Parts<'_>,
    friction: [F; 2],
) -> Result<Box<dyn Packing>, PackingError> {
    let Method::ContactDynamics {
        solver,
        step_limits,
        still_speed,
    } = *method;
    let normal = material.normal_laws()?;
    let law = |kind: usize| ContactLaws {
        normal: normal[kind],
        friction: friction[kind],
    };
    let laws = Laws {
        pairs: law(0),
        walls: law(1),
    };
    let spheres = bodies.radii.iter();
    let setup = Setup {
        spheres: spheres.map(|&r| solid(r, material.density)).collect(),
        space: bodies.space,
        positions: bodies.positions,
        radii: bodies.radii,
        walls: bodies.walls,
        gravity: bodies.gravity,
        step_limits,
        solver,
        sleep_speed: still_speed,
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

    fn walls_mut(&mut self) -> Option<&mut [Wall]> {
        Some(&mut self.state_mut().walls)
    }

    fn set_gravity(&mut self, gravity: Vector3<f64>) -> bool {
        World::set_gravity(self, gravity);
        true
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
