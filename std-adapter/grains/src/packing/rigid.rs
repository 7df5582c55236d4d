//! A world of contact dynamics with its contact modes hidden behind the trait of packings.

use super::{
    Bodies, Force, Forces, Material, Method, ModeSet, OptionalFeatures, Packing, PackingRunError,
    WorldSnapshot, soft,
};
use crate::packing::method::{FrictionCoupling, WallLaw};
use nalgebra::Vector3;
use std::fmt::Debug;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::space::PeriodicBox;
use tribos_contacts::cd::internals::{Coefficients, Memory, Sleep, StoredForce};
use tribos_contacts::cd::{
    self, AxisControl, CellState, ContactMaterial, EnergyBalance, Facing, MaterialTable,
    StepReport, StopRule, Wall, World, WorldError, WorldMaterials, WorldSetup, WorldState,
};
use tribos_contacts::problem::GlobalProblem;
use tribos_contacts::soft::{SoftSetup, Sprung};
use tribos_core::contact::{
    ContactError, ContactFriction, ContactGeometry, ContactModes, ContactVector, CoupledFriction,
    IndependentFriction, SphereBody,
};
use tribos_core::limit_surface::FrictionSet;

/// What a world starts from.
type Parts<'a> = (
    &'a Material,
    (Bodies, &'a OptionalFeatures),
    &'a Method,
    Option<&'a WorldSnapshot>,
);

/// Builds a world whose type has the modes that resist.
pub(super) fn build(
    material: &Material,
    bodies: (Bodies, &OptionalFeatures),
    method: &Method,
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    let carried = bodies.1.widest(material).carried();
    let at = (material, bodies, method, frozen);
    match carried.coupling {
        FrictionCoupling::Independent => {}
        FrictionCoupling::Ellipsoid => {
            return coupled(at, |m| Ok([m.ellipsoid(m.sliding)?, m.ellipsoid(0.0)?]));
        }
        FrictionCoupling::Exact => {
            return coupled(at, |m| Ok([m.exact(m.sliding)?, m.exact(0.0)?]));
        }
    }
    match carried.modes {
        ModeSet::Normal => boxed(at, |_| Ok([IndependentFriction::none(); 2])),
        ModeSet::Sliding => boxed(at, |m| {
            let of = IndependentFriction::sliding;
            Ok(both(m, of(m.sliding)?, of(0.0)?))
        }),
        ModeSet::SlidingTorsion => boxed(at, |m| {
            let of = IndependentFriction::sliding_torsion;
            Ok(both(m, of(m.sliding, m.torsion)?, of(0.0, 0.0)?))
        }),
        ModeSet::SlidingRolling => boxed(at, |m| {
            let of = IndependentFriction::sliding_rolling;
            Ok(both(m, of(m.sliding, m.rolling)?, of(0.0, 0.0)?))
        }),
        ModeSet::All => boxed(at, |m| {
            let of = IndependentFriction::all;
            let rough = of(m.sliding, m.rolling, m.torsion)?;
            Ok(both(m, rough, of(0.0, 0.0, 0.0)?))
        }),
    }
}

/// A world in which sliding and torsion share a set: one between spheres, one at smooth walls.
fn coupled<S: FrictionSet<f64> + Copy + Debug + Send + Sync + 'static>(
    at: Parts<'_>,
    sets: impl Fn(&Material) -> Result<[S; 2], PackingRunError>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    if at.1.1.widest(at.0).rolling > 0.0 {
        boxed(at, |m| {
            let [rough, smooth] = sets(m)?;
            let law = |set, mu_t| CoupledFriction::all(set, mu_t);
            Ok(both(m, law(rough, m.rolling)?, law(smooth, 0.0)?))
        })
    } else {
        boxed(at, |m| {
            let law = CoupledFriction::sliding_torsion;
            let [rough, smooth] = sets(m)?;
            Ok(both(m, law(rough), law(smooth)))
        })
    }
}

/// Friction between spheres and at walls.
fn both<F: Copy>(material: &Material, rough: F, smooth: F) -> [F; 2] {
    match material.wall {
        WallLaw::Full => [rough, rough],
        WallLaw::Smooth | WallLaw::Bare => [rough, smooth],
    }
}

/// Laws of a material with this friction.
fn laws<F: Copy>(
    material: &Material,
    friction: [F; 2],
) -> Result<WorldMaterials<F>, PackingRunError> {
    let normal = material.normal_laws()?;
    let law = |kind: usize| ContactMaterial {
        normal: normal[kind],
        friction: friction[kind],
    };
    Ok(WorldMaterials {
        pairs: law(0),
        walls: law(1),
    })
}

/// The laws of several materials; `of` gives those of one between spheres and at walls.
fn table<F: Copy>(
    bodies: &Bodies,
    extras: &OptionalFeatures,
    of: impl Fn(&Material) -> Result<WorldMaterials<F>, PackingRunError>,
) -> Result<Option<MaterialTable<F>>, PackingRunError> {
    let Some((mixture, indices)) = &extras.mixture else {
        return Ok(None);
    };
    let count = mixture.components().len();
    let mut laws = Vec::with_capacity(count * count);
    for a in 0..count {
        for b in 0..count {
            let [pair, wall] = mixture.laws([a, b]);
            laws.push(WorldMaterials {
                pairs: of(pair)?.pairs,
                walls: of(wall)?.walls,
            });
        }
    }
    // The law at a wall is that of the sphere.
    let law = |[a, b]: [u8; 2]| laws[usize::from(a) * count + usize::from(b)];
    let walls = vec![0; bodies.walls.len()];
    Ok(Some(MaterialTable::new(indices.clone(), walls, law)))
}

/// A world with these contact modes; `friction` gives that of a material between spheres and at walls.
fn boxed<F: ContactFriction<f64> + Coefficients + Debug + 'static>(
    (material, (bodies, extras), method, frozen): Parts<'_>,
    friction: impl Fn(&Material) -> Result<[F; 2], PackingRunError>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    let of = |material: &Material| laws(material, friction(material)?);
    let sprung = |material: &Material| {
        let stiffness = material.stiffness;
        let on_spring = |friction| Sprung {
            stiffness,
            friction,
        };
        laws(material, friction(material)?.map(on_spring))
    };
    let first = of(material)?;
    let (solver, step_limits, still_speed) = match *method {
        Method::ContactDynamics {
            solver,
            step_limits,
            still_speed,
        } => (solver, step_limits, still_speed),
        Method::Soft(springs) => {
            let setup = SoftSetup {
                spheres: extras.spheres(material, &bodies.radii),
                mixture: table(&bodies, extras, sprung)?,
                ..SoftSetup::new(first, material.stiffness)
            };
            return soft::boxed(setup, (bodies, extras), &springs, frozen);
        }
    };
    let setup = WorldSetup {
        spheres: extras.spheres(material, &bodies.radii),
        mesh: extras.mesh.clone(),
        mixture: table(&bodies, extras, of)?,
        space: bodies.space,
        positions: bodies.positions,
        radii: bodies.radii,
        walls: bodies.walls,
        gravity: bodies.gravity,
        step_limits,
        solver,
        sleep_speed: still_speed,
        ..WorldSetup::new(first)
    };
    // A box that keeps its lengths is sheared alone.
    let mut setup = match extras
        .cell
        .filter(|cell| cell.axes != [AxisControl::Fixed; 3])
    {
        Some(cell) => setup.deforming(cell),
        None => setup.sheared(extras.shear_rate),
    };
    for (sphere, velocity) in setup.spheres.iter_mut().zip(&extras.velocities) {
        sphere.velocity += velocity;
    }
    let mut world = World::new(setup)?;
    if let Some(frozen) = frozen {
        restore(frozen, world.state_mut())?;
    }
    Ok(Box::new(world))
}

/// Restores a stored state in a new world of the same bodies.
fn restore<M: ContactModes<f64>>(
    frozen: &WorldSnapshot,
    state: &mut WorldState<M>,
) -> Result<(), WorldError> {
    state.time = frozen.time;
    state.steps = frozen.steps;
    state.positions.clone_from(&frozen.positions);
    for (sphere, [velocity, spin]) in state.spheres.iter_mut().zip(&frozen.motions) {
        (sphere.velocity, sphere.spin) = (*velocity, *spin);
    }
    for (wall, (place, velocity)) in state.walls.iter_mut().zip(&frozen.walls) {
        (wall.place, wall.plate.velocity) = (*place, *velocity);
    }
    state.shear_offset = frozen.shear_offset;
    if let (Some(cell), Some(kept)) = (&mut state.cell, frozen.cell) {
        *cell = cell_state(kept, frozen)?;
    }
    state.energy = frozen.energy;
    state.energy.before_first(state.spheres.iter());
    state.sleep = Sleep::restored(frozen.awake.clone(), frozen.still.clone());
    state.memory = memory(&frozen.forces);
    state.impacts = memory(&frozen.impacts);
    Ok(())
}

/// A cell from its lengths, 0 along an open axis, and their speeds.
pub(super) fn cell_state(
    [lengths, speeds]: [[f64; 3]; 2],
    frozen: &WorldSnapshot,
) -> Result<CellState, WorldError> {
    let space = PeriodicBox::new(lengths.map(|length| Some(length).filter(|length| *length > 0.0)));
    let step = frozen.steps;
    let space = space.map_err(|cause| WorldError::Neighbours { step, cause })?;
    Ok(CellState {
        space: space.sheared(frozen.shear_offset),
        speeds,
    })
}

/// Forces in the modes of a world.
fn memory<M: ContactModes<f64>>(forces: &Forces) -> Memory<M> {
    let modal = |(bodies, force): &([u32; 2], Force)| {
        let modal = ContactVector::new(force.normal, force.sliding, force.rolling, force.torsion);
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
    pub(super) fn of<M: ContactModes<f64>>(modal: &ContactVector<f64, M>) -> Self {
        Self {
            normal: modal.normal,
            sliding: modal.sliding(),
            rolling: modal.rolling(),
            torsion: modal.torsion(),
        }
    }

    /// A row of the contact table, with the geometry of the contact.
    pub(super) fn row(&self, a: u32, b: Partner, touch: &ContactGeometry<f64>) -> ContactRow {
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

    fn spheres(&self) -> &[SphereBody<f64>] {
        &self.state().spheres
    }

    fn walls(&self) -> &[Wall] {
        &self.state().walls
    }

    fn walls_mut(&mut self) -> &mut [Wall] {
        &mut self.state_mut().walls
    }

    fn place(&mut self, sphere: usize, at: Vector3<f64>, [velocity, spin]: [Vector3<f64>; 2]) {
        let state = self.state_mut();
        state.positions[sphere] = at;
        let body = &mut state.spheres[sphere];
        (body.velocity, body.spin) = (velocity, spin);
    }

    fn space(&self) -> PeriodicBox {
        World::space(self)
    }

    fn set_gravity(&mut self, gravity: Vector3<f64>) {
        World::set_gravity(self, gravity);
    }

    fn set_axes(&mut self, axes: [AxisControl; 3]) {
        World::set_axes(self, axes);
    }

    fn energy(&self) -> &EnergyBalance {
        &self.state().energy
    }

    fn problem(&self) -> Option<GlobalProblem> {
        self.problem().to_problem().map(|posed| posed.problem)
    }

    fn is_rigid(&self) -> bool {
        // Whoever asks for a number of sweeps takes what they leave.
        let method = self.setup().solver.method;
        !matches!(
            method,
            cd::SolverMethod::GaussSeidel {
                stop: StopRule::Fixed,
                ..
            }
        )
    }

    fn contacts(&self) -> Result<Vec<ContactRow>, ContactError> {
        let (setup, state, space) = (self.setup(), self.state(), self.space());
        let [pairs, walls] = &state.memory.forces;
        let book = setup.book();
        let mut rows = Vec::with_capacity(pairs.len() + walls.len());
        let mesh = setup.mesh.as_ref().map(|mesh| mesh.at(state.time));
        let with_impact = |kind, bodies, force: &ContactVector<f64, F::Modes>| {
            let impact = state.impacts.force(kind, bodies);
            impact.map_or(*force, |impact| force.plus_scaled(1.0, impact))
        };
        for ([a, b], force) in pairs {
            let force = with_impact(0, [*a, *b], force);
            let [i, j] = [*a as usize, *b as usize];
            let apart = space.displacement(&state.positions[i], &state.positions[j]);
            let touch = ContactGeometry::spheres(&apart, [setup.radii[i], setup.radii[j]])?;
            if force.normal != 0.0 || touch.gap <= book.of_pair([*a, *b]).normal.cohesion().range()
            {
                rows.push(Force::of(&force).row(*a, Partner::Particle(*b), &touch));
            }
        }
        for ([a, b], force) in walls {
            let force = with_impact(1, [*a, *b], force);
            let (i, wall) = (*a as usize, *b as usize);
            let x = &state.positions[i];
            let facing = match state.walls.get(wall) {
                Some(wall) => Some(wall.facing(&setup.space, x)),
                None => mesh.and_then(|mesh| {
                    let number = *b - state.walls.len() as u32;
                    mesh.facing(number, &setup.space, x)
                }),
            };
            let Some(Facing { outward, height }) = facing else {
                continue;
            };
            let touch = ContactGeometry::plate(height, &outward, setup.radii[i])?;
            if force.normal != 0.0 || touch.gap <= book.at_wall([*a, *b]).normal.cohesion().range()
            {
                rows.push(Force::of(&force).row(*a, Partner::Wall(*b), &touch));
            }
        }
        Ok(rows)
    }

    fn snapshot(&self) -> WorldSnapshot {
        let state = self.state();
        WorldSnapshot {
            time: state.time,
            steps: state.steps,
            positions: state.positions.clone(),
            motions: state.spheres.iter().map(|s| [s.velocity, s.spin]).collect(),
            walls: state
                .walls
                .iter()
                .map(|wall| (wall.place, wall.plate.velocity))
                .collect(),
            shear_offset: state.shear_offset,
            energy: state.energy,
            forces: forces(&state.memory),
            impacts: forces(&state.impacts),
            awake: state.sleep.awake().to_vec(),
            still: state.sleep.slow_steps().to_vec(),
            origin: None,
            cell: state.cell.map(|CellState { space, speeds }| {
                [space.lengths().map(|length| length.unwrap_or(0.0)), speeds]
            }),
        }
    }
}
