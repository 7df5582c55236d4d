//! Where the spheres of a run come from: a deposit, a file, or the last state of another run.

use super::deposit::Deposit;
use crate::packing::PackingRunError;
use crate::packing::method::ContactMethod;
use crate::packing::{Assembly, AssemblyError};
use crate::packing::{InitialSpheres, Kinds, WorldSnapshot, given};
use crate::powder::scene::PowderScene;
use nalgebra::Vector3;
use std::ops::ControlFlow;
use std::path::Path;

/// Grows the deposit of the scene, or reads what it names. Spheres of a file keep their numbers.
pub(super) fn start(
    scene: &PowderScene,
    watch: impl FnMut(usize) -> ControlFlow<()>,
) -> Result<(Deposit, InitialSpheres), PackingRunError> {
    if let Some(path) = &scene.initial_state {
        return Ok(read(scene, path)?);
    }
    let deposit = scene
        .ballistic()?
        .grow_watched(scene.until(), scene.seed, watch)?
        .numbered_for_run();
    let start = InitialSpheres {
        positions: deposit.positions.clone(),
        radii: deposit.radii.clone(),
        periods: [None; 3],
        kinds: scene.kinds(deposit.radii.len()),
        contacts: deposit.contacts(),
        frozen: None,
    };
    Ok((deposit, start))
}

/// Spheres of a file or a run, between substrate and piston.
fn read(scene: &PowderScene, path: &Path) -> Result<(Deposit, InitialSpheres), AssemblyError> {
    let width = Some((scene.width, "width"));
    let mixture = scene.mixture();
    let mut assembly = given(
        (path, scene.columns.as_ref()),
        ([width, width, None], false),
        (1.0, scene.method, mixture.components().len()),
        |_| false,
    )?;
    in_units_of_first(&mut assembly);
    let of_powder = [Vector3::z(), -Vector3::z()];
    let kinds = Kinds::given(&assembly, scene.seed, &mixture);
    let kept = assembly.frozen.take().filter(|frozen| {
        assembly.outward == of_powder && frozen.walls.first().is_some_and(|wall| wall.0 == 0.0)
    });
    let (height, contacts, frozen) = match kept {
        // The walls are those of a powder: everything goes on where it was, with other parameters.
        Some(frozen) => {
            let contacts = std::mem::take(&mut assembly.contacts);
            let is_soft = scene.method == ContactMethod::Soft;
            (-frozen.walls[1].0, contacts, frozen.at_start(is_soft))
        }
        // The substrate is at the lowest point of the spheres, the piston at their highest.
        None => {
            let [low, high] = assembly.extent(2);
            let lowered = |place: &Vector3<f64>| place - Vector3::z() * low;
            let positions = assembly.positions.iter().map(lowered).collect();
            let walls = [0.0, low - high].into_iter();
            let frozen = WorldSnapshot::moving(positions, &assembly, walls);
            (high - low, Vec::new(), frozen)
        }
    };
    let deposit = Deposit {
        positions: frozen.positions.clone(),
        radii: assembly.radii.clone(),
        parents: Vec::new(),
        width: scene.width,
        space: assembly.space,
        height,
    };
    let start = InitialSpheres {
        positions: frozen.positions.clone(),
        radii: assembly.radii,
        periods: [None; 3],
        kinds,
        contacts,
        frozen: Some(frozen),
    };
    Ok((deposit, start))
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
