//! States in the folder of a run.

use super::{Assembly, AssemblyError, text};
use crate::measure::Forces;
use crate::packing::STATE;
use crate::record::frames::{Bodies, Frame, FrameContact, FrameFolder, Kind};
use crate::record::{ContactRow, Partner};
use crate::run::{CHECKPOINT, FRAMES};
use crate::space::PeriodicBox;
use nalgebra::Vector3;
use std::path::Path;

/// The state at the end of a run, or at the last checkpoint of one that goes on.
pub(super) fn last_state(folder: &Path) -> Result<Assembly, AssemblyError> {
    for name in [STATE, CHECKPOINT] {
        let file = folder.join(name);
        if file.exists() {
            return Assembly::parse(&file.display().to_string(), &text(&file)?);
        }
    }
    Err(AssemblyError::Content {
        file: folder.display().to_string(),
        reason: format!(
            "there is neither {STATE} nor {CHECKPOINT}; run a scene of spheres with `tribos run SCENE --out {}`",
            folder.display()
        ),
    })
}

/// The frames of a run: positions to a 130,000th of the box, normal forces to 2⁻⁸ of each.
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
    let [x, y] = bodies.periods;
    let space = PeriodicBox::new([Some(x), Some(y), None]).unwrap_or_default();
    let mut assembly = Assembly::new(space, frame.places.clone(), bodies.radii.clone());
    assembly.bounds[2] = [f64::from(frame.corners[0][2]), frame.height];
    let row = |contact: &FrameContact| row(&assembly, contact);
    assembly.contacts = frame.contacts.iter().map(row).collect();
    assembly.forces = Forces::Normal;
    assembly.scene = bodies.scene.clone();
    assembly
}

/// A contact with its geometry; wall 0 is below and any other above.
fn row(assembly: &Assembly, contact: &FrameContact) -> ContactRow {
    let (a, radii) = (contact.a as usize, &assembly.radii);
    let from = assembly.positions[a];
    let [low, high] = assembly.bounds[2];
    let (way, other) = match contact.b {
        Partner::Particle(b) => {
            let way = assembly
                .space
                .displacement(&from, &assembly.positions[b as usize]);
            (way, radii[b as usize])
        }
        Partner::Wall(0) => (Vector3::z() * (low - from.z), 0.0),
        Partner::Wall(_) => (Vector3::z() * (high - from.z), 0.0),
    };
    let normal = way.normalize();
    ContactRow {
        a: contact.a,
        b: contact.b,
        normal,
        gap: way.norm() - radii[a] - other,
        force: normal * f64::from(contact.normal_force),
        torque: Vector3::zeros(),
    }
}
