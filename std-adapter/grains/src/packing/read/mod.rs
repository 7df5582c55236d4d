//! Reading spheres from the files and folders of runs and of other programs.

mod run;
mod vtp;

use super::assembly::{Assembly, KnownForces};
use crate::packing::{Stored, mixed};
use std::path::Path;
use tribos_base::exchange::configuration::{Configuration, Format, recognised};
use tribos_base::exchange::spheres::Spheres;
use tribos_base::exchange::text::TextError;
use tribos_base::exchange::{extended_xyz, lammps};
use tribos_base::record::{CheckpointError, RecordError, read_text};
use tribos_base::space::{AXES, PeriodicBox, SpaceError};

/// Largest size of a file in bytes: about ten million spheres as text.
const MOST_BYTES: u64 = 4 << 30;

/// Why spheres cannot be read.
///
/// ```
/// use tribos::measure::{Assembly, AssemblyError};
/// let atoms = "1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3\nAr 1 1 1\n";
/// let refused = Assembly::parse("argon.xyz", atoms).map(|_| ()).map_err(|error| error.to_string());
/// assert_eq!(
///     refused,
///     Err("argon.xyz: line 2: there are no radii; give a column radius:R:1".into())
/// );
/// ```
#[derive(Debug, thiserror::Error)]
pub enum AssemblyError {
    /// The file cannot be read.
    #[error("{file}: {cause}")]
    Read {
        /// Name of the file.
        file: String,
        /// The reason.
        #[source]
        cause: RecordError,
    },
    /// A line of the file is wrong.
    #[error("{file}: {cause}")]
    Text {
        /// Name of the file.
        file: String,
        /// The line, and what would be valid.
        #[source]
        cause: TextError,
    },
    /// A state or a checkpoint is damaged, or of another body.
    #[error("{file}: {reason}; give a state or a checkpoint of a powder or of grains")]
    State {
        /// Name of the file.
        file: String,
        /// The reason.
        reason: String,
    },
    /// Frames of a run cannot be read.
    #[error(transparent)]
    Frames(#[from] RecordError),
    /// The file has no radii.
    #[error("{file}: line {line}: there are no radii; {cure}")]
    NoRadii {
        /// Name of the file.
        file: String,
        /// Line that names the columns.
        line: usize,
        /// How to add them.
        cure: &'static str,
    },
    /// The box of the file is invalid, or its spheres do not fit the box.
    #[error("{file}: {cause}")]
    Space {
        /// Name of the file.
        file: String,
        /// The reason.
        #[source]
        cause: SpaceError,
    },
    /// Anything else that a file or folder lacks.
    #[error("{file}: {reason}")]
    Content {
        /// Name of the file or folder.
        file: String,
        /// What is wrong, and what would be valid.
        reason: String,
    },
}

impl Assembly {
    /// Reads the last state of a run's folder, or the spheres of a file: extended XYZ with a column `radius`,
    /// LAMMPS data (`atom_style sphere`) or text dump with `radius` or `diameter`, VTK PolyData (.vtp) with
    /// point data `radius`, or a state that a run wrote. If a file has several frames, the last.
    pub fn read(path: &Path) -> Result<Self, AssemblyError> {
        if path.is_dir() {
            return run::last_state(path);
        }
        Self::parse(&path.display().to_string(), &text(path)?)
    }

    /// As [`Assembly::read`], from text; `name` stands for the file in messages.
    pub fn parse(name: &str, text: &str) -> Result<Self, AssemblyError> {
        let empty = || AssemblyError::Content {
            file: name.into(),
            reason: "the file is empty".into(),
        };
        Self::parse_all(name, text)?.pop().ok_or_else(empty)
    }

    /// All kept states: the frames of a run's folder, or those of a file, in order with their numbers.
    pub fn read_all(path: &Path) -> Result<Vec<(u64, Self)>, AssemblyError> {
        if path.is_dir() {
            return run::frames(path);
        }
        let all = Self::parse_all(&path.display().to_string(), &text(path)?)?;
        Ok((0..).zip(all).collect())
    }

    fn parse_all(name: &str, text: &str) -> Result<Vec<Self>, AssemblyError> {
        let head = text.trim_start();
        if head.starts_with('{') {
            let stored = Stored::read(text).map_err(|cause| AssemblyError::State {
                file: name.into(),
                reason: match cause {
                    CheckpointError::Format(reason) => format!("it is damaged ({reason})"),
                    CheckpointError::Scene { kept, .. } => {
                        format!("it is a checkpoint of body = {kept}, without a state of forces")
                    }
                    other => other.to_string(),
                },
            })?;
            return Ok(vec![Self::of_stored(stored)]);
        }
        if head.starts_with('<') {
            return Ok(vec![vtp::read(name, text)?]);
        }
        let refused = |cause| AssemblyError::Text {
            file: name.into(),
            cause,
        };
        let mut all = Vec::new();
        match recognised(text).map_err(refused)? {
            Format::ExtendedXyz => {
                let mut frames = Vec::new();
                extended_xyz::each_frame(text, |atoms, spheres| frames.push((atoms, spheres)))
                    .map_err(refused)?;
                for (atoms, spheres) in frames {
                    all.push(assembly(name, atoms, spheres, "give a column radius:R:1")?);
                }
            }
            Format::Dump => {
                for frame in lammps::sphere_frames(text) {
                    let (atoms, spheres) = frame.map_err(refused)?;
                    let cure = "dump the column radius or diameter";
                    all.push(assembly(name, atoms, spheres, cure)?);
                }
            }
            Format::Data => {
                let (atoms, spheres) = lammps::read_spheres(text).map_err(refused)?;
                let cure = "write the file with atom_style sphere";
                all.push(assembly(name, atoms, spheres, cure)?);
            }
        }
        Ok(all)
    }

    /// The spheres of a stored state.
    fn of_stored(stored: Stored) -> Self {
        let motions = stored.frozen.motions.iter();
        let (velocities, spins) = motions.map(|[velocity, spin]| (*velocity, *spin)).unzip();
        let shape = stored.shape;
        // The images of a sheared box are where they were.
        let space = shape.space.sheared(stored.frozen.shear_offset);
        let mut assembly = Self {
            materials: shape.kinds.mixed().map(<[u8]>::to_vec),
            densities: Some(shape.kinds.densities),
            velocities: Some(velocities),
            spins: Some(spins),
            contacts: shape.contacts,
            forces: KnownForces::Complete,
            scene: stored.scene,
            ..Self::new(space, stored.frozen.positions.clone(), shape.radii)
        };
        // The outermost walls across an open axis bound the box: a hopper has a lid in it.
        let mut walls = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for (outward, (place, _)) in shape.outward.iter().zip(&stored.frozen.walls) {
            for (axis, [low, high]) in walls.iter_mut().enumerate() {
                if outward[axis] == 1.0 {
                    *low = low.min(*place);
                } else if outward[axis] == -1.0 {
                    *high = high.max(-*place);
                }
            }
        }
        for (bounds, walls) in assembly
            .bounds
            .iter_mut()
            .flatten()
            .zip(walls.as_flattened())
        {
            if walls.is_finite() {
                *bounds = *walls;
            }
        }
        assembly.has_box = true;
        assembly.outward = shape.outward;
        assembly.frozen = Some(stored.frozen);
        assembly
    }
}

/// The text of a file.
fn text(path: &Path) -> Result<String, AssemblyError> {
    read_text(path, MOST_BYTES).map_err(|cause| AssemblyError::Read {
        file: path.display().to_string(),
        cause,
    })
}

/// Spheres from what the readers of atoms found, in a box that begins at 0 along periodic axes.
fn assembly(
    file: &str,
    atoms: Configuration,
    spheres: Spheres,
    cure: &'static str,
) -> Result<Assembly, AssemblyError> {
    let radii = spheres.radii.ok_or_else(|| AssemblyError::NoRadii {
        file: file.into(),
        line: spheres.line,
        cure,
    })?;
    let space = atoms.space().map_err(|cause| AssemblyError::Space {
        file: file.into(),
        cause,
    })?;
    let mut positions = atoms.atoms.positions;
    let mut bounds = atoms.bounds;
    for (axis, [low, high]) in bounds.iter_mut().enumerate() {
        if space.lengths()[axis].is_some() && *low != 0.0 {
            positions.iter_mut().for_each(|place| place[axis] -= *low);
            *high -= *low;
            *low = 0.0;
        }
    }
    // A column of materials, or several species.
    let species = || {
        atoms
            .atoms
            .species
            .iter()
            .map(|species| species + 1)
            .collect()
    };
    let materials: Vec<u8> = spheres.materials.unwrap_or_else(species);
    let space = space.sheared(spheres.tilt);
    let mut assembly = Assembly {
        materials: mixed(&materials).then_some(materials),
        densities: spheres.densities,
        is_assumed: spheres.is_silent,
        velocities: Some(atoms.atoms.velocities),
        spins: spheres.spins,
        ..Assembly::new(space, positions, radii)
    };
    if atoms.has_box {
        (assembly.bounds, assembly.has_box) = (bounds, true);
    }
    Ok(assembly)
}

impl Assembly {
    /// Sets the periods, `None` for an open axis, where the file does not say them. *Domain*: periods finite and
    /// positive, no sphere out of its period; those that the file says.
    pub fn with_periods(
        mut self,
        file: &str,
        periods: [Option<f64>; 3],
    ) -> Result<Self, AssemblyError> {
        for (axis, name) in AXES.iter().enumerate() {
            let old = self.space.lengths()[axis];
            let outside = |length: &f64| {
                let mut places = self.positions.iter();
                places.position(|place| !(0.0..=*length).contains(&place[axis]))
            };
            let reason = match (old, periods[axis]) {
                (Some(old), None) if !self.is_assumed => {
                    format!(
                        "it says that it repeats along {name} after {old}; give {old} in place of -"
                    )
                }
                (Some(old), Some(given)) if old != given => {
                    format!("its period along {name} is {old}, not {given}")
                }
                (None, Some(given)) => match outside(&given) {
                    Some(sphere) => format!(
                        "sphere {sphere} is at {name} = {}, beyond the period from 0 to {given}",
                        self.positions[sphere][axis]
                    ),
                    None => continue,
                },
                _ => continue,
            };
            return Err(AssemblyError::Content {
                file: file.into(),
                reason,
            });
        }
        self.set_periods(file, periods)?;
        Ok(self)
    }

    /// Sets the periods; a new one begins at 0. An axis that is opened keeps the ends of its box.
    pub(crate) fn set_periods(
        &mut self,
        file: &str,
        periods: [Option<f64>; 3],
    ) -> Result<(), AssemblyError> {
        let before = self.space;
        let leans = periods[0].is_some() && periods[2].is_some();
        let space = PeriodicBox::new(periods).map_err(|cause| AssemblyError::Space {
            file: file.into(),
            cause,
        })?;
        self.space = space.sheared(if leans { before.offset() } else { 0.0 });
        for (axis, bounds) in self.bounds.iter_mut().enumerate() {
            if let (None, Some(length)) = (before.lengths()[axis], periods[axis]) {
                *bounds = [0.0, length];
            }
        }
        Ok(())
    }
}
