//! Where the grains of a run come from: random places, a file, or the last state of another run.

use super::bound;
use super::layout::Layout;
use super::placement;
use super::wall::{InitialWall, WallId};
use crate::grains::scene::{Axis, Container, EndBoundary, GrainsScene, SideBoundary};
use crate::packing::AssemblyError;
use crate::packing::PackingRunError;
use crate::packing::method::ContactMethod;
use crate::packing::{InitialSpheres, Kinds, WorldSnapshot, deepest, given};
use nalgebra::Vector3;
use std::ops::ControlFlow;
use std::path::Path;
use tribos_base::record::{ContactRow, Partner};
use tribos_contacts::cd::{MovingMesh, Wall};

/// Largest distance of grains from the plane of a flat box that counts as the rounding of a file, in radii of the
/// largest: twice that of frames, which count in 65535ths of two such radii.
const OFF_PLANE: f64 = 2.0 / 65_535.0;

/// Grains at their random places, or those that the scene names.
pub(super) fn start(
    (scene, mesh): (&GrainsScene, Option<&MovingMesh>),
    watch: impl FnMut(usize) -> ControlFlow<()>,
) -> Result<InitialSpheres, PackingRunError> {
    match &scene.initial_state {
        Some(path) => read(scene, path),
        None => {
            let mut start = placement::start((scene, mesh), watch)?;
            bound::add(scene, &mut start);
            Ok(start)
        }
    }
}

/// Grains of a file or a run in the box of the scene.
fn read(scene: &GrainsScene, path: &Path) -> Result<InitialSpheres, PackingRunError> {
    let (flat, depth) = (scene.is_flat(), scene.box_depth());
    let x = (scene.boundary_x == SideBoundary::Periodic).then_some((scene.width, "width"));
    let y = (scene.boundary_y == SideBoundary::Periodic && !flat).then_some((depth, "depth"));
    let z = (scene.boundary_z == EndBoundary::Periodic)
        .then(|| (scene.height.unwrap_or(0.0), "height"));
    let mixture = scene.mixture();
    let mut assembly = given(
        (path, scene.columns.as_ref()),
        ([x, y, z], scene.deforms()),
        (scene.radius, scene.method, mixture.components().len()),
        |kind| scene.holder(kind).is_some(),
    )?;
    let is_driven = scene.sheared().is_some() || scene.deforms();
    if scene.method == ContactMethod::Soft && assembly.space.offset() != 0.0 && !is_driven {
        return Err(AssemblyError::Content {
            file: path.display().to_string(),
            reason: "its cell leans along x over z, and springs know sheared images where `shear_rate`, a stress or a \
                     speed drives the box; give one, or set method = \"contact-dynamics\""
                .into(),
        }
        .into());
    }
    let frozen = assembly.frozen.take();
    let mut start = InitialSpheres {
        positions: assembly.positions.clone(),
        radii: assembly.radii.clone(),
        periods: if scene.deforms() {
            assembly.space.lengths()
        } else {
            [None; 3]
        },
        kinds: Kinds::given(&assembly, scene.seed, &mixture),
        contacts: Vec::new(),
        frozen: None,
    };
    if scene.sheared().is_some() && !scene.bound(&start).is_empty() {
        return Err(AssemblyError::Content {
            file: path.display().to_string(),
            reason: "a sheared box has no fixed or driven grains; leave out `shear_rate`".into(),
        }
        .into());
    }
    let layout = Layout::of(scene, &start)?;
    let inward: Vec<Vector3<f64>> = layout.parts.iter().map(|part| part.inward).collect();
    if let Some(frozen) = frozen.filter(|_| assembly.outward == inward) {
        // The walls are those of the scene: everything goes on where it was.
        // What closes the slot anew cuts through grains that were on their way.
        check_walls(scene, path, &start, &layout, |part| {
            part.face == WallId::Lid
        })?;
        start.contacts = assembly.contacts;
        let mut frozen = frozen.at_start(scene.method == ContactMethod::Soft);
        // Forces at another mesh are of no use.
        if assembly.scene["mesh"] != scene.json()["mesh"] {
            let walls = inward.len();
            let at_wall = |([_, wall], _): &([u32; 2], _)| (*wall as usize) < walls;
            for [_, forces] in [&mut frozen.forces, &mut frozen.impacts] {
                forces.retain(at_wall);
            }
            let of_box =
                |row: &ContactRow| !matches!(row.b, Partner::Wall(wall) if wall as usize >= walls);
            start.contacts.retain(of_box);
        }
        start.frozen = Some(frozen);
        return Ok(start);
    }

    // The box of the file begins where that of the scene does, and the lowest grain lies on the floor. In a hopper
    // or a drum grains stay where they are in the box of the file, or at their coordinates without one.
    let mut origin = Vector3::from(assembly.bounds.map(|[low, _]| low));
    if scene.container != Container::Box {
        if !assembly.has_box {
            (origin.x, origin.z) = (0.0, 0.0);
        }
    } else if z.is_none() {
        origin.z = assembly.extent(2)[0];
    }
    if flat {
        origin.y = 0.0;
    }
    for place in &mut start.positions {
        *place -= origin;
    }
    let layout = Layout::of(scene, &start)?;
    check_inside(scene, path, &start, &layout)?;
    if flat {
        start.positions.iter_mut().for_each(|place| place.y = 0.0);
    }
    let walls = layout.parts.iter().map(|part| part.place);
    start.frozen = Some(WorldSnapshot::moving(
        start.positions.clone(),
        &assembly,
        walls,
    ));
    Ok(start)
}

/// Refuses grains beyond a wall, and grains beside the plane of a flat box.
fn check_inside(
    scene: &GrainsScene,
    path: &Path,
    start: &InitialSpheres,
    layout: &Layout,
) -> Result<(), AssemblyError> {
    let refused = |reason: String| AssemblyError::Content {
        file: path.display().to_string(),
        reason,
    };
    let ends = [
        (scene.boundary_x == SideBoundary::Walls).then_some((scene.width, "x", "width")),
        (scene.boundary_y == SideBoundary::Walls).then_some((scene.box_depth(), "y", "depth")),
        scene
            .height
            .filter(|_| scene.boundary_z == EndBoundary::Walls)
            .map(|height| (height, "z", "height")),
    ];
    // Soft grains may reach as far into a wall as into each other.
    let beyond = deepest(scene.method);
    let off_plane = OFF_PLANE * start.radii.iter().copied().fold(0.0, f64::max);
    let free = |(grain, _): &(usize, _)| scene.holder(start.kinds.materials[*grain]).is_none();
    let grains = start.positions.iter().zip(&start.radii).enumerate();
    for (grain, (place, radius)) in grains.filter(free) {
        for (axis, end) in ends.into_iter().enumerate() {
            let Some((length, name, key)) = end else {
                continue;
            };
            let room = (1.0 - beyond) * radius;
            if place[axis] < room || place[axis] > length - room {
                return Err(refused(format!(
                    "grain {grain} (from 0) reaches beyond the walls at {name} = 0 and {length}; make `{key}` larger"
                )));
            }
        }
        if scene.is_flat() && place.y.abs() > off_plane {
            return Err(refused(format!(
                "grain {grain} (from 0) is at y = {}; with dimension = 2 all are at y = 0",
                place.y
            )));
        }
    }
    let is_side = |part: &InitialWall| matches!(part.face, WallId::Side(Axis::X | Axis::Y, _));
    check_walls(scene, path, start, layout, |part| !is_side(part))
}

/// Refuses grains that reach into some of the walls, as far as these are shut.
fn check_walls(
    scene: &GrainsScene,
    path: &Path,
    start: &InitialSpheres,
    layout: &Layout,
    is_meant: impl Fn(&InitialWall) -> bool,
) -> Result<(), AssemblyError> {
    let beyond = deepest(scene.method);
    let is_shut = |part: &&InitialWall| part.face != WallId::Lid || scene.open_time > 0.0;
    let meant = layout.parts.iter().filter(|part| is_meant(part));
    let walls: Vec<Wall> = meant.filter(is_shut).map(InitialWall::wall).collect();
    let free = |(grain, _): &(usize, _)| scene.holder(start.kinds.materials[*grain]).is_none();
    let grains = start.positions.iter().zip(&start.radii).enumerate();
    for (grain, (place, radius)) in grains.filter(free) {
        let meets =
            |wall: &Wall| wall.facing(&layout.space, place).height < (1.0 - beyond) * radius;
        if walls.iter().any(meets) {
            let container = scene.container;
            return Err(AssemblyError::Content {
                file: path.display().to_string(),
                reason: format!(
                    "grain {grain} (from 0), at x = {} and z = {}, reaches into the {container}; grains keep the places \
                     of the file in it",
                    place.x, place.z
                ),
            });
        }
    }
    Ok(())
}
