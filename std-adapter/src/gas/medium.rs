//! The methods that move a gas, behind one face.

use super::error::GasError;
use super::room::edge;
use super::state::GasState;
use crate::cd::{Method as Sweeps, Solver, StepLimits};
use crate::event::{Advance, HardSpheres, Motion, Stored};
use crate::packing::{Bodies, Frozen, Material, Method, Packing, build};
use crate::record::CheckpointError;
use crate::record::kept::damaged;
use crate::scene::{Coupling, GasMethod, GasScene, WallLaw};
use crate::space::PeriodicBox;
use nalgebra::Vector3;
use serde_json::{Map, Value};
use std::f64::consts::PI;
use tribos_core::contact::Attraction;

/// Density of spheres of mass 1 and radius 1.
const DENSITY: f64 = 3.0 / (4.0 * PI);
/// Tolerance of lasting contacts, which a gas hardly has, and the most sweeps of a step.
const TOLERANCE: f64 = 1e-4;
const SWEEPS: usize = 1000;
/// Longest time step: the spheres' motion bounds it, unless all are at rest.
const LONGEST: f64 = 10.0;

/// A gas in motion.
#[derive(Debug)]
pub(super) enum Medium {
    Events(Box<HardSpheres>),
    Steps(Stepped),
}

/// A gas that a method with time steps moves.
#[derive(Debug)]
pub(super) struct Stepped {
    packing: Box<dyn Packing>,
    length: f64,
    collisions: u64,
    /// Steps whose impacts were cut off or missed their tolerance.
    unmet: u64,
}

/// What a checkpoint holds of a gas.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kept {
    Events(Stored),
    Steps {
        frozen: Box<Frozen>,
        collisions: u64,
        unmet: u64,
    },
}

impl Medium {
    /// A gas at its start.
    pub fn new(scene: &GasScene, bodies: &[(Vector3<f64>, Motion)]) -> Result<Self, GasError> {
        let length = edge(scene.count, scene.fraction);
        match scene.method {
            GasMethod::Events => {
                let gas = HardSpheres::new(length, bodies, scene.impact()?, scene.contact_time)?;
                Ok(Self::Events(Box::new(gas)))
            }
            GasMethod::ContactDynamics => {
                // A new packing at rest, with the motions put in.
                let places = bodies.iter().map(|(place, _)| *place).collect();
                let still = stepped(scene, length, places, None)?;
                let mut frozen = still.packing.freeze();
                for (motion, (_, given)) in frozen.motions.iter_mut().zip(bodies) {
                    *motion = [given.velocity, given.spin];
                }
                frozen.energy.kinetic_initial = None;
                let places = frozen.positions.clone();
                stepped(scene, length, places, Some(&frozen)).map(Self::Steps)
            }
        }
    }

    /// A gas that goes on from a checkpoint.
    pub fn thawed(scene: &GasScene, kept: Kept) -> Result<Self, GasError> {
        let length = edge(scene.count, scene.fraction);
        match kept {
            Kept::Events(stored) => {
                let (law, tc) = (scene.impact()?, scene.contact_time);
                let gas = HardSpheres::thawed(stored, length, law, tc);
                Ok(Self::Events(Box::new(gas)))
            }
            Kept::Steps {
                frozen,
                collisions,
                unmet,
            } => {
                let places = frozen.positions.clone();
                let gas = stepped(scene, length, places, Some(frozen.as_ref()))?;
                Ok(Self::Steps(Stepped {
                    collisions,
                    unmet,
                    ..gas
                }))
            }
        }
    }

    /// What a checkpoint holds.
    pub fn kept(&self) -> Kept {
        match self {
            Self::Events(gas) => Kept::Events(gas.freeze()),
            Self::Steps(gas) => Kept::Steps {
                frozen: Box::new(gas.packing.freeze()),
                collisions: gas.collisions,
                unmet: gas.unmet,
            },
        }
    }

    /// Goes on to a number of collisions or a time, with one step at most; none if neither is reached.
    pub fn advance(&mut self, collisions: u64, until: f64) -> Result<Option<Advance>, GasError> {
        match self {
            Self::Events(gas) => Ok(Some(gas.advance(collisions, until))),
            Self::Steps(gas) => {
                let report = gas.packing.step()?;
                gas.collisions += report.impacts as u64;
                gas.unmet += u64::from(report.impacts_cut || report.impacts_unmet > 0);
                Ok(if gas.collisions >= collisions {
                    Some(Advance::Collisions)
                } else {
                    (gas.packing.clock().0 >= until).then_some(Advance::Time)
                })
            }
        }
    }

    pub fn time(&self) -> f64 {
        match self {
            Self::Events(gas) => gas.time(),
            Self::Steps(gas) => gas.packing.clock().0,
        }
    }

    /// Collisions of pairs since the start.
    pub fn collisions(&self) -> u64 {
        match self {
            Self::Events(gas) => gas.collisions(),
            Self::Steps(gas) => gas.collisions,
        }
    }

    /// Energy lost in collisions since the start.
    pub fn lost(&self) -> f64 {
        match self {
            Self::Events(gas) => gas.lost(),
            Self::Steps(gas) => {
                let energy = gas.packing.energy();
                energy.normal + energy.sliding
            }
        }
    }

    /// Collisions without loss within the contact time.
    pub fn cured(&self) -> u64 {
        match self {
            Self::Events(gas) => gas.cured(),
            Self::Steps(_) => 0,
        }
    }

    /// Steps whose impacts were not solved to their tolerance.
    pub fn unmet(&self) -> u64 {
        match self {
            Self::Events(_) => 0,
            Self::Steps(gas) => gas.unmet,
        }
    }

    /// Places within the cube, velocities and spins.
    pub fn state(&self) -> GasState {
        match self {
            Self::Events(gas) => GasState {
                places: gas.places(),
                motions: gas.motions().copied().collect(),
            },
            Self::Steps(gas) => {
                let length = gas.length;
                let inside = |x: f64| {
                    let inside = x - length * (x / length).floor();
                    if inside < length { inside } else { 0.0 }
                };
                let places = gas.packing.positions().iter();
                let spheres = gas.packing.spheres().iter();
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
        }
    }
}

/// A gas of contact dynamics.
fn stepped(
    scene: &GasScene,
    length: f64,
    positions: Vec<Vector3<f64>>,
    frozen: Option<&Frozen>,
) -> Result<Stepped, GasError> {
    let bodies = Bodies {
        space: PeriodicBox::new([Some(length); 3])?,
        radii: vec![1.0; positions.len()],
        positions,
        walls: Vec::new(),
        gravity: Vector3::zeros(),
    };
    let method = Method::ContactDynamics {
        solver: Solver {
            method: Sweeps::Accelerated {
                tolerance: TOLERANCE,
            },
            most_sweeps: SWEEPS,
            warm_start: true,
        },
        step_limits: StepLimits {
            motion: scene.motion,
            longest: LONGEST,
        },
        still_speed: 0.0,
    };
    Ok(Stepped {
        packing: build(&material(scene), bodies, &method, frozen)?,
        length,
        collisions: 0,
        unmet: 0,
    })
}

/// The contacts of a gas carry no cohesion.
fn material(scene: &GasScene) -> Material {
    Material {
        density: DENSITY,
        cohesion: 0.0,
        cohesion_range: 0.0,
        attraction: Attraction::Pull,
        restitution: scene.restitution,
        sliding: scene.friction.unwrap_or(0.0),
        rolling: 0.0,
        torsion: 0.0,
        coupling: Coupling::Independent,
        wall: WallLaw::Full,
    }
}

impl Kept {
    /// Adds the state to a checkpoint.
    pub fn put(&self, map: &mut Map<String, Value>) {
        match self {
            Self::Events(stored) => stored.put(map),
            Self::Steps {
                frozen,
                collisions,
                unmet,
            } => {
                frozen.put(map);
                map.insert("collisions".into(), (*collisions).into());
                map.insert("unmet".into(), (*unmet).into());
            }
        }
    }

    /// Reads the state of a scene from a checkpoint.
    pub fn read(value: &Value, scene: &GasScene) -> Result<Self, CheckpointError> {
        match scene.method {
            GasMethod::Events => Stored::read(value, scene.count).map(Self::Events),
            GasMethod::ContactDynamics => {
                let frozen = Frozen::read(value)?;
                if !frozen.fits(scene.count, 0) {
                    return Err(damaged("numbers of spheres"));
                }
                let whole = |name: &str| value[name].as_u64().ok_or_else(|| damaged(name));
                Ok(Self::Steps {
                    frozen: Box::new(frozen),
                    collisions: whole("collisions")?,
                    unmet: whole("unmet")?,
                })
            }
        }
    }
}
