//! States in the folder of a run.

use super::{Assembly, AssemblyError, bytes};
use crate::packing::assembly::KnownForces;
use crate::packing::{STATE, mixed, scene};
use nalgebra::Vector3;
use serde_json::Value;
use std::path::Path;
use tribos_base::record::frames::{Bodies, Frame, FrameContact, FrameFolder, Kind};
use tribos_base::record::{ContactRow, Partner};
use tribos_base::run::{CHECKPOINT, FRAMES};
use tribos_base::space::PeriodicBox;

/// The spheres at the end of a gas, which keeps no state with forces.
const SPHERES: &str = "final.xyz";

/// The state at the end of a run, or at the last checkpoint of one that goes on.
pub(super) fn last_state(folder: &Path) -> Result<Assembly, AssemblyError> {
    for name in [STATE, CHECKPOINT, SPHERES] {
        let file = folder.join(name);
        if file.exists() {
            return Assembly::parse_as(&file.display().to_string(), &bytes(&file)?, None);
        }
    }
    Err(AssemblyError::Content {
        file: folder.display().to_string(),
        reason: format!(
            "there is none of {STATE}, {CHECKPOINT} and {SPHERES}; run a scene of spheres with `tribos run SCENE --out {}`",
            folder.display()
        ),
    })
}

/// The frames of a run: positions to a 130,000th of the box, velocities and forces to 2⁻⁸ of each component.
pub(super) fn frames(folder: &Path) -> Result<Vec<(u64, Assembly)>, AssemblyError> {
    let path = folder.join(FRAMES);
    let missing = |reason: &str| AssemblyError::Content {
        file: path.display().to_string(),
        reason: reason.into(),
    };
    let bodies = FrameFolder::bodies(&path)?
        .ok_or_else(|| missing("there are no frames; run the scene without `--frames 0`"))?;
    if bodies.kind == Kind::Tip {
        return Err(missing(
            "the frames are of atoms, not of spheres in contact",
        ));
    }
    let mut all = Vec::new();
    for step in FrameFolder::steps(&path)? {
        let frame = FrameFolder::read(&path, &bodies, step)?;
        all.push((step, of_frame(&bodies, &frame)));
    }
    Ok(all)
}

fn of_frame(bodies: &Bodies, frame: &Frame) -> Assembly {
    let periods = [0, 1, 2].map(|axis| frame.period(bodies, axis));
    let space = PeriodicBox::new(periods).unwrap_or_default();
    let space = space.sheared(frame.tilt);
    let mut assembly = Assembly::new(space, frame.places.clone(), bodies.radii.clone());
    for axis in 0..3 {
        if space.lengths()[axis].is_none() {
            assembly.bounds[axis] = frame.corners.map(|corner| f64::from(corner[axis]));
        }
    }
    if bodies.kind == Kind::Powder {
        assembly.bounds[2] = [0.0, frame.height];
    }
    assembly.scene = scene(&bodies.scene);
    let walls = walls(bodies.kind, &assembly.scene);
    let known = frame.tangential.iter().copied().map(Some);
    let across = known.chain(std::iter::repeat(None));
    let row = |(contact, across)| row(&assembly, &walls, contact, across);
    assembly.contacts = frame.contacts.iter().zip(across).filter_map(row).collect();
    assembly.time = Some(frame.time);
    assembly.forces = KnownForces::Normal;
    if !frame.velocities.is_empty() {
        assembly.velocities = Some(frame.velocities.iter().map(|v| v.cast()).collect());
        assembly.forces = KnownForces::Rounded;
    }
    let known = |all: &Vec<f64>| !all.is_empty();
    assembly.densities = Some(bodies.densities.clone()).filter(known);
    assembly.materials = mixed(&bodies.materials).then(|| bodies.materials.clone());
    assembly
}

/// Axis of each wall, and whether it is at the high end: above and below, then at the sides.
fn walls(kind: Kind, scene: &Value) -> Vec<(usize, bool)> {
    let both = |axis: usize| [(axis, false), (axis, true)];
    if kind == Kind::Powder {
        return both(2).to_vec();
    }
    let is_drum = scene["container"] == "drum";
    let mut walls = match scene["boundary_z"].as_str() {
        // Facets stand in place of floor and sides.
        _ if is_drum => Vec::new(),
        Some("floor") => vec![(2, false)],
        Some("walls") => both(2).to_vec(),
        _ => Vec::new(),
    };
    for (axis, key) in ["boundary_x", "boundary_y"].into_iter().enumerate() {
        if scene[key] == "walls" {
            walls.extend(both(axis));
        }
    }
    walls
}

/// A contact with its geometry.
fn row(
    assembly: &Assembly,
    walls: &[(usize, bool)],
    contact: &FrameContact,
    across: Option<Vector3<f32>>,
) -> Option<ContactRow> {
    let (a, radii) = (contact.a as usize, &assembly.radii);
    let from = assembly.positions[a];
    let (way, other) = match contact.b {
        Partner::Particle(b) => {
            let way = assembly
                .space
                .displacement(&from, &assembly.positions[b as usize]);
            (way, radii[b as usize])
        }
        Partner::Wall(wall) => {
            let &(axis, is_high) = walls.get(wall as usize)?;
            let mut way = Vector3::zeros();
            way[axis] = assembly.bounds[axis][usize::from(is_high)] - from[axis];
            (way, 0.0)
        }
    };
    let normal = way.normalize();
    Some(ContactRow {
        a: contact.a,
        b: contact.b,
        normal,
        gap: way.norm() - radii[a] - other,
        force: normal * f64::from(contact.normal_force) + across.unwrap_or_default().cast(),
        torque: Vector3::zeros(),
    })
}
