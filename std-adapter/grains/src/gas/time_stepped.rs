//! A gas that moves by time steps: contact dynamics, or soft particles.

use super::soft;
use super::state::GasState;
use crate::gas::scene::{GasMethod, GasScene};
use crate::packing::PackingRunError;
use crate::packing::method::{FrictionCoupling, WallLaw};
use crate::packing::{Bodies, Material, Method, Packing, WorldSnapshot, build};
use nalgebra::Vector3;
use serde_json::{Map, Value};
use std::f64::consts::PI;
use tribos_base::record::checkpoint::damaged;
use tribos_base::record::{CheckpointError, ContactRow, Partner};
use tribos_base::space::PeriodicBox;
use tribos_contacts::cd::{ContactSolver, SolverMethod as Sweeps, StepLimits};
use tribos_contacts::event::Motion;
use tribos_core::contact::Attraction;

/// Density of spheres of mass 1 and radius 1.
pub(super) const DENSITY: f64 = 3.0 / (4.0 * PI);
/// Tolerance of lasting contacts, which a gas hardly has, and the most sweeps of a step.
const TOLERANCE: f64 = 1e-4;
const SWEEPS: usize = 1000;
/// Longest time step: the spheres' motion bounds it, unless all are at rest.
const LONGEST: f64 = 10.0;

/// A gas that a method with time steps moves.
#[derive(Debug)]
pub(super) struct TimeSteppedGas {
    packing: Box<dyn Packing>,
    length: f64,
    collisions: u64,
    /// Steps whose impacts were cut off or missed their tolerance.
    unmet: u64,
    /// Pairs that overlap, in ascending order, with soft particles.
    touching: Option<Vec<[u32; 2]>>,
}

/// What a checkpoint holds of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TimeSteppedState {
    frozen: WorldSnapshot,
    collisions: u64,
    unmet: u64,
}

impl TimeSteppedGas {
    /// A gas at its start.
    pub fn new(
        scene: &GasScene,
        length: f64,
        bodies: &[(Vector3<f64>, Motion)],
    ) -> Result<Self, PackingRunError> {
        // A new packing at rest, with the motions put in.
        let places = bodies.iter().map(|(place, _)| *place).collect();
        let still = Self::built(scene, length, places, None)?;
        let mut frozen = still.packing.snapshot();
        for (motion, (_, given)) in frozen.motions.iter_mut().zip(bodies) {
            *motion = [given.velocity, given.spin];
        }
        frozen.energy.kinetic_initial = None;
        let kept = TimeSteppedState {
            frozen,
            collisions: 0,
            unmet: 0,
        };
        Self::thawed(scene, length, &kept)
    }

    /// A gas that goes on from a checkpoint.
    pub fn thawed(
        scene: &GasScene,
        length: f64,
        kept: &TimeSteppedState,
    ) -> Result<Self, PackingRunError> {
        let places = kept.frozen.positions.clone();
        let gas = Self::built(scene, length, places, Some(&kept.frozen))?;
        Ok(Self {
            collisions: kept.collisions,
            unmet: kept.unmet,
            ..gas
        })
    }

    fn built(
        scene: &GasScene,
        length: f64,
        positions: Vec<Vector3<f64>>,
        frozen: Option<&WorldSnapshot>,
    ) -> Result<Self, PackingRunError> {
        let bodies = Bodies {
            space: PeriodicBox::new([Some(length); 3])?,
            radii: vec![1.0; positions.len()],
            positions,
            walls: Vec::new(),
            gravity: Vector3::zeros(),
        };
        let pairs =
            |frozen: &WorldSnapshot| frozen.forces[0].iter().map(|(pair, _)| *pair).collect();
        let touching = frozen.map_or_else(Vec::new, pairs);
        Ok(Self {
            packing: build(&material(scene), bodies, &method(scene), frozen)?,
            length,
            collisions: 0,
            unmet: 0,
            touching: (scene.method == GasMethod::Soft).then_some(touching),
        })
    }

    /// Takes one step and counts its collisions.
    pub fn step(&mut self) -> Result<(), PackingRunError> {
        let report = self.packing.step()?;
        self.collisions += report.impacts as u64;
        self.unmet += u64::from(report.impacts_cut || report.impacts_unmet > 0);
        if let Some(before) = self.touching.take() {
            let now = self.overlapping()?;
            self.collisions += new_contacts(&before, &now);
            self.touching = Some(now);
        }
        Ok(())
    }

    /// Pairs that overlap, in ascending order.
    fn overlapping(&self) -> Result<Vec<[u32; 2]>, PackingRunError> {
        let step = self.packing.clock().1;
        let contacts = self.packing.contacts();
        let contacts = contacts.map_err(|cause| PackingRunError::Touch { step, cause })?;
        let pair = |contact: &ContactRow| match contact.b {
            Partner::Particle(b) => Some([contact.a, b]),
            Partner::Wall(_) => None,
        };
        Ok(contacts.iter().filter_map(pair).collect())
    }

    pub fn time(&self) -> f64 {
        self.packing.clock().0
    }

    pub fn collisions(&self) -> u64 {
        self.collisions
    }

    pub fn unmet(&self) -> u64 {
        self.unmet
    }

    /// Energy lost in collisions since the start.
    pub fn lost(&self) -> f64 {
        let energy = self.packing.energy();
        energy.normal + energy.sliding
    }

    /// Places within the cube, velocities and spins.
    pub fn state(&self) -> GasState {
        let length = self.length;
        let inside = |x: f64| {
            let inside = x - length * (x / length).floor();
            if inside < length { inside } else { 0.0 }
        };
        let places = self.packing.positions().iter();
        let spheres = self.packing.spheres().iter();
        GasState {
            places: places.map(|place| place.map(inside)).collect(),
            motions: spheres
                .map(|sphere| Motion {
                    velocity: sphere.velocity,
                    spin: sphere.spin,
                })
                .collect(),
        }
    }

    /// What a checkpoint holds.
    pub fn kept(&self) -> TimeSteppedState {
        TimeSteppedState {
            frozen: self.packing.snapshot(),
            collisions: self.collisions,
            unmet: self.unmet,
        }
    }
}

/// Number of pairs that are not among those before; both in ascending order.
fn new_contacts(before: &[[u32; 2]], now: &[[u32; 2]]) -> u64 {
    let mut before = before.iter().peekable();
    let is_new = |pair: &&[u32; 2]| {
        while before.next_if(|old| old < pair).is_some() {}
        before.next_if(|old| old == pair).is_none()
    };
    now.iter().filter(is_new).count() as u64
}

/// How the contacts of a step are found and solved.
fn method(scene: &GasScene) -> Method {
    if scene.method == GasMethod::Soft {
        return Method::Soft(soft::springs(scene, LONGEST));
    }
    Method::ContactDynamics {
        solver: ContactSolver {
            method: Sweeps::Accelerated {
                tolerance: TOLERANCE,
            },
            most_sweeps: SWEEPS,
            warm_start: 1.0,
        },
        step_limits: StepLimits {
            motion: scene.max_displacement,
            longest: LONGEST,
        },
        still_speed: 0.0,
    }
}

/// The contacts of a gas carry no cohesion.
fn material(scene: &GasScene) -> Material {
    Material {
        density: DENSITY,
        cohesion: 0.0,
        cohesion_range: 0.0,
        attraction: Attraction::Pull,
        restitution: scene.restitution,
        sliding: scene.mu.unwrap_or(0.0),
        rolling: 0.0,
        torsion: 0.0,
        coupling: FrictionCoupling::Independent,
        wall: WallLaw::Full,
        stiffness: soft::stiffness(scene),
    }
}

impl TimeSteppedState {
    /// Adds the state to a checkpoint.
    pub fn put(&self, map: &mut Map<String, Value>) {
        self.frozen.put(map);
        map.insert("collisions".into(), self.collisions.into());
        map.insert("unmet".into(), self.unmet.into());
    }

    /// Reads the state of so many spheres from a checkpoint.
    pub fn read(value: &Value, count: usize) -> Result<Self, CheckpointError> {
        let frozen = WorldSnapshot::read(value)?;
        if !frozen.fits(count, 0, false) {
            return Err(damaged("numbers of spheres"));
        }
        let whole = |name: &str| value[name].as_u64().ok_or_else(|| damaged(name));
        Ok(Self {
            frozen,
            collisions: whole("collisions")?,
            unmet: whole("unmet")?,
        })
    }
}
