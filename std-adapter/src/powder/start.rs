//! Where the spheres of a run come from: a deposit, a file, or the last state of another run.

use super::deposit::Deposit;
use super::error::CompactionError;
use crate::cd::EnergyBalance;
use crate::measure::{Assembly, AssemblyError};
use crate::packing::Frozen;
use crate::record::ContactRow;
use crate::scene::PowderScene;
use crate::space::PeriodicBox;
use nalgebra::Vector3;
use std::ops::ControlFlow;
use std::path::Path;

/// Deepest overlap of spheres in a file, over the smaller radius: packings of soft spheres are that deep, and
/// rigid ones push such spheres apart.
const DEEPEST: f64 = 0.05;
/// Largest relative difference of a period from the scene's width.
const SAME_WIDTH: f64 = 1e-9;
/// Range of the mean radius of a file, whose lengths must be in mean radii.
const MEAN_RADII: [f64; 2] = [0.5, 2.0];

/// Spheres at the start of a run.
#[derive(Debug)]
pub(super) struct Start {
    pub deposit: Deposit,
    pub contacts: Vec<ContactRow>,
    /// Motion and forces of spheres that were not deposited.
    pub frozen: Option<Frozen>,
}

impl Start {
    /// Grows the deposit of the scene, or reads what it names.
    pub fn of(
        scene: &PowderScene,
        watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, CompactionError> {
        if let Some(path) = &scene.start {
            return Ok(read(scene, path)?);
        }
        let deposit = scene
            .ballistic()?
            .grow_watched(scene.until(), scene.seed, watch)?;
        Ok(Self {
            contacts: deposit.contacts(),
            deposit,
            frozen: None,
        })
    }
}

/// Spheres of a file or a run, between substrate and piston.
fn read(scene: &PowderScene, path: &Path) -> Result<Start, AssemblyError> {
    let file = path.display().to_string();
    let mut assembly = Assembly::read(path)?;
    for axis in [0, 1] {
        if assembly.space.lengths()[axis].is_none() {
            let mut periods = [None; 3];
            periods[axis] = Some(scene.width);
            assembly = assembly.with_periods(&file, periods)?;
        }
    }
    check_box(scene, &file, &assembly)?;
    let [x, y, _] = assembly.space.lengths();
    assembly.space = PeriodicBox::new([x, y, None]).map_err(|cause| AssemblyError::Box {
        file: file.clone(),
        cause,
    })?;
    let of_powder = [Vector3::z(), -Vector3::z()];
    match assembly.frozen.take() {
        // The walls are those of a powder: everything goes on where it was.
        Some(frozen) if assembly.outward == of_powder && frozen.walls[0].0 == 0.0 => {
            Ok(go_on(scene, assembly, &frozen))
        }
        frozen => {
            check_spheres(&file, &assembly)?;
            Ok(between_plates(scene, assembly, frozen.as_ref()))
        }
    }
}

/// Refuses another width than the scene's, and no spheres.
fn check_box(scene: &PowderScene, file: &str, assembly: &Assembly) -> Result<(), AssemblyError> {
    let refused = |reason: String| AssemblyError::Content {
        file: file.into(),
        reason,
    };
    if assembly.radii.is_empty() {
        return Err(refused("there is no sphere; give one or more".into()));
    }
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let length = assembly.space.lengths()[axis].unwrap_or(scene.width);
        if (length / scene.width - 1.0).abs() > SAME_WIDTH {
            return Err(refused(format!(
                "its period along {name} is {length}, and `width` is {}; set width = {length}",
                scene.width
            )));
        }
    }
    Ok(())
}

/// Refuses lengths in other units and spheres that overlap deeply.
fn check_spheres(file: &str, assembly: &Assembly) -> Result<(), AssemblyError> {
    let refused = |reason: String| AssemblyError::Content {
        file: file.into(),
        reason,
    };
    let mean = assembly.mean_radius();
    let [least, most] = MEAN_RADII;
    if !(least..=most).contains(&mean) {
        return Err(refused(format!(
            "the mean radius is {mean}; lengths are in mean radii: divide all of them by {mean}"
        )));
    }
    let deepest = assembly
        .deepest()
        .map_err(|cause| AssemblyError::Neighbours {
            file: file.into(),
            cause,
        })?;
    match deepest {
        Some((depth, [a, b])) if depth > DEEPEST => Err(refused(format!(
            "spheres {a} and {b} (from 0) overlap by {:.3} % of the smaller radius; at most {} % is taken",
            100.0 * depth,
            100.0 * DEEPEST
        ))),
        _ => Ok(()),
    }
}

/// A run that goes on with other parameters: the clock, the energies and the sleep begin anew.
fn go_on(scene: &PowderScene, assembly: Assembly, frozen: &Frozen) -> Start {
    let count = assembly.radii.len();
    let frozen = Frozen {
        time: 0.0,
        steps: 0,
        energy: EnergyBalance::default(),
        awake: vec![true; count],
        still: vec![0; count],
        ..frozen.clone()
    };
    Start {
        contacts: assembly.contacts,
        deposit: Deposit {
            positions: frozen.positions.clone(),
            radii: assembly.radii,
            parents: Vec::new(),
            width: scene.width,
            space: assembly.space,
            height: -frozen.walls[1].0,
        },
        frozen: Some(frozen),
    }
}

/// Spheres with the substrate at their lowest point and the piston at their highest.
fn between_plates(scene: &PowderScene, assembly: Assembly, old: Option<&Frozen>) -> Start {
    let [low, high] = assembly.extent(2);
    let lowered = |place: &Vector3<f64>| place - Vector3::z() * low;
    let positions: Vec<_> = assembly.positions.iter().map(lowered).collect();
    let count = positions.len();
    let rest = || vec![Vector3::zeros(); count];
    let velocities = assembly.velocities.unwrap_or_else(rest);
    let spins = assembly.spins.unwrap_or_else(rest);
    let motions = velocities.into_iter().zip(spins);
    let pairs = old.map_or(Vec::new(), |old| old.forces[0].clone());
    let frozen = Frozen {
        time: 0.0,
        steps: 0,
        positions: positions.clone(),
        motions: motions.map(|(velocity, spin)| [velocity, spin]).collect(),
        walls: vec![(0.0, Vector3::zeros()), (low - high, Vector3::zeros())],
        energy: EnergyBalance::default(),
        forces: [pairs, Vec::new()],
        impacts: [Vec::new(), Vec::new()],
        awake: vec![true; count],
        still: vec![0; count],
    };
    Start {
        contacts: Vec::new(),
        deposit: Deposit {
            positions,
            radii: assembly.radii,
            parents: Vec::new(),
            width: scene.width,
            space: assembly.space,
            height: high - low,
        },
        frozen: Some(frozen),
    }
}

#[cfg(test)]
mod tests;
