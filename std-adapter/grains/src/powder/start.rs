//! Where the spheres of a run come from: a deposit, a file, or the last state of another run.

use super::deposit::Deposit;
use super::error::CompactionError;
use crate::packing::method::ContactMethod;
use crate::packing::{Assembly, AssemblyError};
use crate::packing::{Kinds, WorldSnapshot, given};
use crate::powder::scene::PowderScene;
use nalgebra::Vector3;
use std::ops::ControlFlow;
use std::path::Path;
use tribos_base::record::ContactRow;

/// Spheres at the start of a run.
#[derive(Debug)]
pub(super) struct Start {
    pub deposit: Deposit,
    pub kinds: Kinds,
    pub contacts: Vec<ContactRow>,
    /// Motion and forces of spheres that were not deposited.
    pub frozen: Option<WorldSnapshot>,
}

impl Start {
    /// Grows the deposit of the scene, or reads what it names. Spheres of a file keep their numbers.
    pub fn of(
        scene: &PowderScene,
        watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, CompactionError> {
        if let Some(path) = &scene.initial_state {
            return Ok(read(scene, path)?);
        }
        let deposit = scene
            .ballistic()?
            .grow_watched(scene.until(), scene.seed, watch)?
            .numbered_for_run();
        Ok(Self {
            kinds: scene.kinds(deposit.radii.len()),
            contacts: deposit.contacts(),
            deposit,
            frozen: None,
        })
    }
}

/// Spheres of a file or a run, between substrate and piston.
fn read(scene: &PowderScene, path: &Path) -> Result<Start, AssemblyError> {
    let width = Some((scene.width, "width"));
    let mut assembly = given(path, [width, width, None], (1.0, scene.method))?;
    in_units_of_first(&mut assembly);
    let of_powder = [Vector3::z(), -Vector3::z()];
    match assembly.frozen.take() {
        // The walls are those of a powder: everything goes on where it was.
        Some(frozen) if assembly.outward == of_powder && frozen.walls[0].0 == 0.0 => {
            Ok(go_on(scene, assembly, &frozen))
        }
        _ => Ok(between_plates(scene, &assembly)),
    }
}

/// Densities of a file in units of that of its first sphere of the first material: that of a powder is 1.
fn in_units_of_first(assembly: &mut Assembly) {
    let is_first = |sphere: &usize| match &assembly.materials {
        Some(materials) => materials.get(*sphere) == Some(&1),
        None => true,
    };
    let first = (0..assembly.radii.len()).find(is_first);
    if let (Some(first), Some(densities)) = (first, &mut assembly.densities)
        && let Some(unit) = densities.get(first).copied()
    {
        densities.iter_mut().for_each(|density| *density /= unit);
    }
}

/// Materials and densities of the spheres of a file or a run.
fn kinds(scene: &PowderScene, assembly: &Assembly) -> Kinds {
    let drawn = (scene.seed, scene.second_fraction);
    Kinds::given(assembly, drawn, (&scene.material(), &scene.differences()))
}

/// A run that goes on with other parameters.
fn go_on(scene: &PowderScene, assembly: Assembly, frozen: &WorldSnapshot) -> Start {
    Start {
        kinds: kinds(scene, &assembly),
        contacts: assembly.contacts,
        deposit: Deposit {
            positions: frozen.positions.clone(),
            radii: assembly.radii,
            parents: Vec::new(),
            width: scene.width,
            space: assembly.space,
            height: -frozen.walls[1].0,
        },
        frozen: Some(frozen.at_start(scene.method == ContactMethod::Soft)),
    }
}

/// Spheres with the substrate at their lowest point and the piston at their highest.
fn between_plates(scene: &PowderScene, assembly: &Assembly) -> Start {
    let [low, high] = assembly.extent(2);
    let lowered = |place: &Vector3<f64>| place - Vector3::z() * low;
    let positions: Vec<_> = assembly.positions.iter().map(lowered).collect();
    let walls = [0.0, low - high].into_iter();
    Start {
        frozen: Some(WorldSnapshot::moving(positions.clone(), assembly, walls)),
        kinds: kinds(scene, assembly),
        contacts: Vec::new(),
        deposit: Deposit {
            positions,
            radii: assembly.radii.clone(),
            parents: Vec::new(),
            width: scene.width,
            space: assembly.space,
            height: high - low,
        },
    }
}

#[cfg(test)]
mod tests;
