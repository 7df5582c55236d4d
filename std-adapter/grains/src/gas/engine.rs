//! The methods that move a gas, behind one face.

use super::lattice::edge;
use super::state::GasState;
use super::time_stepped::{TimeSteppedGas, TimeSteppedState};
use crate::gas::scene::{GasMethod, GasScene};
use crate::packing::{PackingRunError, PlacementError};
use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_contacts::event::{Advance, HardSpheres, Motion, Stored};

/// A gas in motion.
#[derive(Debug)]
pub(super) enum GasEngine {
    Events(Box<HardSpheres>),
    Steps(TimeSteppedGas),
}

/// What a checkpoint holds of a gas.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum EngineCheckpoint {
    Events(Stored),
    Steps(Box<TimeSteppedState>),
}

impl GasEngine {
    /// A gas at its start.
    pub fn new(
        scene: &GasScene,
        bodies: &[(Vector3<f64>, Motion)],
    ) -> Result<Self, PackingRunError> {
        let length = edge(scene.count, scene.packing_fraction);
        match scene.method {
            GasMethod::Events => {
                let gas = HardSpheres::new(length, bodies, scene.impact()?, scene.contact_time)
                    .map_err(PlacementError::from)?;
                Ok(Self::Events(Box::new(gas)))
            }
            GasMethod::ContactDynamics | GasMethod::Soft => {
                TimeSteppedGas::new(scene, length, bodies).map(Self::Steps)
            }
        }
    }

    /// A gas that goes on from a checkpoint.
    pub fn thawed(scene: &GasScene, kept: EngineCheckpoint) -> Result<Self, PackingRunError> {
        let length = edge(scene.count, scene.packing_fraction);
        match kept {
            EngineCheckpoint::Events(stored) => {
                let (law, tc) = (scene.impact()?, scene.contact_time);
                let gas = HardSpheres::restore(stored, length, law, tc);
                Ok(Self::Events(Box::new(gas)))
            }
            EngineCheckpoint::Steps(kept) => {
                TimeSteppedGas::thawed(scene, length, &kept).map(Self::Steps)
            }
        }
    }

    /// What a checkpoint holds.
    pub fn kept(&self) -> EngineCheckpoint {
        match self {
            Self::Events(gas) => EngineCheckpoint::Events(gas.freeze()),
            Self::Steps(gas) => EngineCheckpoint::Steps(Box::new(gas.kept())),
        }
    }

    /// Goes on to a number of collisions or a time, with one step at most; none if neither is reached.
    pub fn advance(
        &mut self,
        collisions: u64,
        until: f64,
    ) -> Result<Option<Advance>, PackingRunError> {
        match self {
            Self::Events(gas) => Ok(Some(gas.advance(collisions, until))),
            Self::Steps(gas) => {
                gas.step()?;
                Ok(if gas.collisions() >= collisions {
                    Some(Advance::Collisions)
                } else {
                    (gas.time() >= until).then_some(Advance::Time)
                })
            }
        }
    }

    pub fn time(&self) -> f64 {
        match self {
            Self::Events(gas) => gas.time(),
            Self::Steps(gas) => gas.time(),
        }
    }

    /// Collisions of pairs since the start.
    pub fn collisions(&self) -> u64 {
        match self {
            Self::Events(gas) => gas.collisions(),
            Self::Steps(gas) => gas.collisions(),
        }
    }

    /// Energy lost in collisions since the start.
    pub fn lost(&self) -> f64 {
        match self {
            Self::Events(gas) => gas.dissipated_energy(),
            Self::Steps(gas) => gas.lost(),
        }
    }

    /// Collisions without loss within the contact time.
    pub fn cured(&self) -> u64 {
        match self {
            Self::Events(gas) => gas.lossless_collisions(),
            Self::Steps(_) => 0,
        }
    }

    /// Steps whose impacts were not solved to their tolerance.
    pub fn unmet(&self) -> u64 {
        match self {
            Self::Events(_) => 0,
            Self::Steps(gas) => gas.unmet(),
        }
    }

    /// Places within the cube, velocities and spins.
    pub fn state(&self) -> GasState {
        match self {
            Self::Events(gas) => GasState {
                places: gas.places(),
                motions: gas.motions().copied().collect(),
            },
            Self::Steps(gas) => gas.state(),
        }
    }
}

impl EngineCheckpoint {
    /// Adds the state to a checkpoint.
    pub fn put(&self, map: &mut Map<String, Value>) {
        match self {
            Self::Events(stored) => stored.put(map),
            Self::Steps(kept) => kept.put(map),
        }
    }

    /// Reads the state of a scene from a checkpoint.
    pub fn read(value: &Value, scene: &GasScene) -> Result<Self, CheckpointError> {
        match scene.method {
            GasMethod::Events => Stored::read(value, scene.count).map(Self::Events),
            GasMethod::ContactDynamics | GasMethod::Soft => {
                TimeSteppedState::read(value, scene.count).map(|kept| Self::Steps(Box::new(kept)))
            }
        }
    }
}
