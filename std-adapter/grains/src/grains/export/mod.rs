//! Files with which LAMMPS runs the same grains, by the pair style and the walls of `engines/lammps`.

mod quantity;
mod script;
#[cfg(test)]
mod tests;

use super::bound::Holder;
use super::grains_body::GrainsBody;
use super::layout::Layout;
use crate::grains::scene::{Axis, GrainsScene};
pub use crate::packing::export::ExportError;
use crate::packing::export::{UNLIKE_WALLS, commands};
use crate::packing::{InitialSpheres, Method, PackingBody};
use nalgebra::Vector3;
use script::Script;
use std::ops::ControlFlow;
pub use tribos_base::exchange::lammps::Export;
use tribos_base::exchange::lammps::{SphereRows, sphere_data_file};

/// Room beyond walls and grains in the box of the files, in radii of the largest grain.
const ROOM: f64 = 2.0;

/// The start of a scene's run: `grains.data`, the grains with their velocities, and `in.grains`, laws, loads, walls and the
/// run.
///
/// ```
/// use tribos::grains::export::{Export, ExportError, start};
/// use tribos::scene::{ContactMethod, GrainsScene};
/// let soft = GrainsScene { count: 20, method: ContactMethod::Soft, ..GrainsScene::default() };
/// let files: Export = start(&soft)?;
/// assert!(files.data.contains("20 atoms"));
/// assert!(files.script.contains("fix weight all gravity 9.81 vector 0 0 -1"));
/// // LAMMPS has no walls of triangles.
/// let mesh = GrainsScene { mesh: Some("blade.stl".into()), ..soft };
/// assert!(matches!(start(&mesh), Err(ExportError::Beyond { key: "mesh", .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn start(scene: &GrainsScene) -> Result<Export, ExportError> {
    let Method::Soft(springs) = scene.contact_method() else {
        return Err(ExportError::Rigid);
    };
    let invalid = |error| ExportError::Start(error);
    scene.check().map_err(|error| invalid(error.into()))?;
    refuse(scene)?;
    let placed = GrainsBody::place(scene, &mut |_| ControlFlow::Continue(()));
    let (body, start) = placed.map_err(invalid)?;
    let is_free = |kind| scene.holder(kind).is_none();
    let (pairs, at_walls) = commands(&scene.mixture(), &springs, &start.kinds, is_free);
    if at_walls.is_none() && !body.layout.parts.is_empty() {
        let key = if scene.materials.is_some() {
            "materials"
        } else {
            "mu_second"
        };
        return Err(beyond(key, UNLIKE_WALLS));
    }
    let laws = [pairs, at_walls.unwrap_or_default()];
    let bounds = bounds(scene, &body.layout, &start);
    let mut script = Script::new((scene, &springs), &body, &start, laws);
    Ok(Export {
        name: "grains",
        data: data(scene, &body.layout, &start, bounds),
        script: script.text(),
        notes: script.notes,
    })
}

fn beyond(key: &'static str, reason: &'static str) -> ExportError {
    ExportError::Beyond { key, reason }
}

/// Refuses what LAMMPS cannot hold.
fn refuse(scene: &GrainsScene) -> Result<(), ExportError> {
    if scene.mesh.is_some() {
        return Err(beyond(
            "mesh",
            "LAMMPS has no walls of triangles; leave `mesh` out, glue grains in its place (types in `fixed_kinds` or \
             `driven_kinds` of an `initial_state`), or add regions to in.grains: fix wall/gran/tribos takes them",
        ));
    }
    if scene.sheared().is_some() {
        return Err(beyond(
            "shear_rate",
            "the images of a sheared box are rigid grains of Tribos; for springs take a plate, boundary_z = \"walls\" and \
             `lid_speed_x`",
        ));
    }
    if scene.driven_angular_velocity.constant() != Some(0.0) {
        return Err(beyond(
            "driven_angular_velocity",
            "fix move of LAMMPS turns no group whose axis moves or whose rate changes; leave it out and add `fix move rotate` \
             to in.grains",
        ));
    }
    const DEFORMS: [[&str; 2]; 3] = [
        ["wall_stress_x", "wall_velocity_x"],
        ["wall_stress_y", "wall_velocity_y"],
        ["wall_stress_z", "wall_velocity_z"],
    ];
    for (axis, keys) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(DEFORMS) {
        let given = [scene.pressure(axis), scene.velocity(axis)];
        let key = keys.into_iter().zip(given).find(|(_, load)| load.is_some());
        if let Some((key, _)) = key.filter(|_| scene.is_periodic(axis)) {
            return Err(beyond(
                key,
                "a periodic box that deforms follows other equations in LAMMPS (fix deform, fix nph/sphere); take walls along this \
                 axis",
            ));
        }
    }
    Ok(())
}

/// Ends of the box of the files: periods, and room beyond walls and grains elsewhere.
fn bounds(scene: &GrainsScene, layout: &Layout, start: &InitialSpheres) -> [[f64; 2]; 3] {
    let largest = start.radii.iter().copied().fold(0.0, f64::max);
    let room = ROOM * largest;
    let periods = layout.space.lengths();
    [0, 1, 2].map(|axis: usize| {
        if let Some(period) = periods[axis] {
            return [0.0, period];
        }
        let along = start.positions.iter().map(|place| place[axis]);
        let is_flat = axis == 1 && scene.is_flat();
        let high = if is_flat { 0.0 } else { layout.lengths[axis] };
        let [low, high] = along.fold([0.0_f64, high], |[low, high], x| [low.min(x), high.max(x)]);
        [low - room, high + room]
    })
}

/// Grains with their types and densities, and the velocities of those that move freely.
fn data(
    scene: &GrainsScene,
    layout: &Layout,
    start: &InitialSpheres,
    bounds: [[f64; 2]; 3],
) -> String {
    let positions = match &start.frozen {
        Some(frozen) => &frozen.positions,
        None => &start.positions,
    };
    let places: Vec<Vector3<f64>> = positions.iter().map(|x| layout.space.wrap(x)).collect();
    let motions = start.frozen.as_ref().map(|frozen| {
        let kinds = frozen.motions.iter().zip(&start.kinds.materials);
        let is_free = |kind: u8| scene.holder(kind).is_none();
        let all = kinds.map(|(motion, kind)| {
            if is_free(*kind) {
                *motion
            } else {
                [Vector3::zeros(); 2]
            }
        });
        let pairs: Vec<[Vector3<f64>; 2]> = all.collect();
        [0, 1].map(|of: usize| pairs.iter().map(|pair| pair[of]).collect::<Vec<_>>())
    });
    sphere_data_file(&SphereRows {
        bounds,
        tilt: 0.0,
        positions: &places,
        radii: &start.radii,
        materials: start.kinds.mixed(),
        densities: &start.kinds.densities,
        velocities: motions
            .as_ref()
            .map(|[velocities, _]| velocities.as_slice()),
        spins: motions.as_ref().map(|[_, spins]| spins.as_slice()),
    })
}

/// The word for a holder in a script: the name of its group.
fn group(holder: Holder) -> &'static str {
    match holder {
        Holder::Box => "fixed",
        Holder::Drive => "driven",
        Holder::Lid => "lid",
    }
}
