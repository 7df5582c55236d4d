//! Reading spheres from the files and folders of runs and of other programs.

mod columns;
mod error;
mod format;
mod found;
mod mercury;
mod periods;
mod programs;
mod run;
mod table;
mod vtk;

pub(crate) use columns::{COLUMNS, COLUMNS_ALONE};
pub use columns::{PackingColumns, PackingColumnsError};
pub use error::AssemblyError;
pub use format::PackingFormat;

use super::assembly::{Assembly, KnownForces};
use crate::packing::{Stored, mixed};
use nalgebra::Vector3;
use std::cell::Cell;
use std::path::Path;
use tribos_base::exchange::configuration::Configuration;
use tribos_base::exchange::sphere_columns::SphereColumn;
use tribos_base::exchange::spheres::Spheres;
use tribos_base::exchange::text::TextError;
use tribos_base::exchange::{extended_xyz, lammps};
use tribos_base::record::{CheckpointError, RecordError, read_bytes};
use tribos_base::space::PeriodicBox;

/// Largest size of a file in bytes: about ten million spheres as text.
const MOST_BYTES: u64 = 4 << 30;

/// A file that is read, and what the user says of it.
struct Source<'a> {
    name: &'a str,
    columns: Option<&'a PackingColumns>,
    /// Whether only the last state of several is kept.
    is_last: bool,
    /// States so far.
    states: Cell<usize>,
}

impl Source<'_> {
    /// Keeps a state.
    fn keep(&self, all: &mut Vec<Assembly>, state: Assembly) {
        self.states.set(self.states.get() + 1);
        if self.is_last {
            all.clear();
        }
        all.push(state);
    }

    fn has_places(&self) -> bool {
        self.columns.is_some_and(PackingColumns::has_places)
    }

    /// Whether the user says the size of all spheres.
    fn says_radii(&self) -> bool {
        let sizes = [SphereColumn::Radius, SphereColumn::Diameter];
        let is_said =
            |columns: &PackingColumns| sizes.iter().any(|size| columns.of_all(*size).is_some());
        self.columns.is_some_and(is_said)
    }

    fn text_error(&self, cause: TextError) -> AssemblyError {
        AssemblyError::Text {
            file: self.name.into(),
            cause,
        }
    }

    fn content(&self, reason: String) -> AssemblyError {
        AssemblyError::Content {
            file: self.name.into(),
            reason,
        }
    }

    fn error(&self, line: usize, reason: &str) -> AssemblyError {
        self.content(format!("line {line}: {reason}"))
    }

    /// The refusal of a line that was understood only in part.
    fn refused(&self, line: usize, what: &str, cells: &[&str], cure: &str) -> AssemblyError {
        let shown = cells
            .iter()
            .take(SHOWN)
            .copied()
            .collect::<Vec<_>>()
            .join(" ");
        let more = if cells.len() > SHOWN { " …" } else { "" };
        self.error(line, &format!("{what}, `{shown}{more}`: {cure}"))
    }
}

/// Cells of a row that a message shows.
const SHOWN: usize = 8;

impl Assembly {
    /// Reads the last state of a run's folder, or the spheres of a file in one of the formats of
    /// [`PackingFormat`], which is known by its content; packed by gzip or not. If a file has several frames, the last.
    pub fn read(path: &Path) -> Result<Self, AssemblyError> {
        Self::read_as(path, None)
    }

    /// As [`Assembly::read`], with what the columns of a table or the arrays of a file of VTK are.
    pub fn read_as(path: &Path, columns: Option<&PackingColumns>) -> Result<Self, AssemblyError> {
        if path.is_dir() {
            return match columns {
                Some(columns) => Err(idle(
                    &path.display().to_string(),
                    "the folder of a run",
                    columns,
                )),
                None => run::last_state(path),
            };
        }
        Self::parse_as(&path.display().to_string(), &bytes(path)?, columns)
    }

    /// As [`Assembly::read`], from text; `name` stands for the file in messages.
    pub fn parse(name: &str, text: &str) -> Result<Self, AssemblyError> {
        Self::parse_as(name, text.as_bytes(), None)
    }

    /// As [`Assembly::read_as`], from bytes that are not packed by gzip.
    pub fn parse_as(
        name: &str,
        bytes: &[u8],
        columns: Option<&PackingColumns>,
    ) -> Result<Self, AssemblyError> {
        let source = Source {
            name,
            columns,
            is_last: true,
            states: Cell::new(0),
        };
        let empty = || source.content("the file is empty".into());
        parse_all(&source, bytes)?.pop().ok_or_else(empty)
    }

    /// All kept states: the frames of a run's folder, or those of a file, in order with their numbers.
    pub fn read_all(path: &Path) -> Result<Vec<(u64, Self)>, AssemblyError> {
        Self::read_all_as(path, None)
    }

    /// As [`Assembly::read_all`], with what the columns of a table are.
    pub fn read_all_as(
        path: &Path,
        columns: Option<&PackingColumns>,
    ) -> Result<Vec<(u64, Self)>, AssemblyError> {
        if path.is_dir() {
            return run::frames(path);
        }
        let name = &path.display().to_string();
        let source = Source {
            name,
            columns,
            is_last: false,
            states: Cell::new(0),
        };
        Ok((0..).zip(parse_all(&source, &bytes(path)?)?).collect())
    }
}

/// The states of a file.
fn parse_all(source: &Source<'_>, bytes: &[u8]) -> Result<Vec<Assembly>, AssemblyError> {
    let format = PackingFormat::of(bytes);
    if let Some(columns) = source.columns
        && !format.takes_columns()
        && let Some(named) = columns.of_file()
    {
        return Err(source.content(format!(
            "it is {} and says itself what its columns are; leave out {named} of --columns (key `columns`), or give such as radius=all:0.5",
            format.name()
        )));
    }
    if matches!(format, PackingFormat::VtkXml | PackingFormat::VtkLegacy) {
        let one = vtk::read(source, bytes)?;
        return Ok(vec![one.of_format(format)]);
    }
    let text = std::str::from_utf8(bytes).map_err(|error| AssemblyError::Read {
        file: source.name.into(),
        cause: RecordError::NotText {
            at: error.valid_up_to() as u64,
        },
    })?;
    let refused = |cause| source.text_error(cause);
    let mut all = match format {
        PackingFormat::State => vec![state(source, text)?],
        PackingFormat::ExtendedXyz => {
            let mut frames = Vec::new();
            extended_xyz::each_frame(text, |atoms, spheres| {
                source.states.set(source.states.get() + 1);
                if source.is_last {
                    frames.clear();
                }
                frames.push((atoms, spheres));
            })
            .map_err(refused)?;
            let read =
                |(atoms, spheres)| assembly(source, atoms, spheres, "give a column radius:R:1");
            frames.into_iter().map(read).collect::<Result<_, _>>()?
        }
        PackingFormat::LammpsDump => {
            let mut all = Vec::new();
            for frame in lammps::sphere_frames(text) {
                let (atoms, spheres) = frame.map_err(refused)?;
                source.keep(
                    &mut all,
                    assembly(source, atoms, spheres, "dump the column radius or diameter")?,
                );
            }
            all
        }
        PackingFormat::LammpsData => {
            let (atoms, spheres) = lammps::read_spheres(text).map_err(refused)?;
            vec![assembly(
                source,
                atoms,
                spheres,
                "write the file with atom_style sphere",
            )?]
        }
        PackingFormat::PlainXyz | PackingFormat::Table | PackingFormat::Csv => {
            table::read(source, text, format)?
        }
        PackingFormat::MercuryData => mercury::read_data(source, text)?,
        PackingFormat::MercuryRestart => vec![mercury::read_restart(source, text)?],
        PackingFormat::LsmGeometry => vec![programs::read_geometry(source, text)?],
        PackingFormat::KratosModelPart => vec![programs::read_model_part(source, text)?],
        PackingFormat::MusenText => vec![programs::read_export(source, text)?],
        PackingFormat::VtkXml | PackingFormat::VtkLegacy => Vec::new(),
    };
    let states = source.states.get();
    for one in &mut all {
        one.format = Some(format);
        if source.is_last && states > 1 {
            one.notes.push(format!("the last of {states} states"));
        }
    }
    Ok(all)
}

/// The refusal of columns where nothing has any.
fn idle(file: &str, what: &str, columns: &PackingColumns) -> AssemblyError {
    let reason = format!(
        "it is {what}, which has no columns; leave out --columns {columns} (key `columns`)"
    );
    AssemblyError::Content {
        file: file.into(),
        reason,
    }
}

/// A state or a checkpoint of a run.
fn state(source: &Source<'_>, text: &str) -> Result<Assembly, AssemblyError> {
    if let Some(columns) = source.columns {
        return Err(idle(source.name, "the state of a run", columns));
    }
    let stored = Stored::read(text).map_err(|cause| AssemblyError::State {
        file: source.name.into(),
        reason: match cause {
            CheckpointError::Format(reason) => format!("it is damaged ({reason})"),
            CheckpointError::Scene { kept, .. } => {
                format!("it is a checkpoint of body = {kept}, without a state of forces")
            }
            other => other.to_string(),
        },
    })?;
    Ok(Assembly::of_stored(stored))
}

impl Assembly {
    fn of_format(mut self, format: PackingFormat) -> Self {
        self.format = Some(format);
        self
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

/// The bytes of a file, unpacked.
fn bytes(path: &Path) -> Result<Vec<u8>, AssemblyError> {
    read_bytes(path, MOST_BYTES).map_err(|cause| AssemblyError::Read {
        file: path.display().to_string(),
        cause,
    })
}

/// Moves places so that the box begins at 0 along periodic axes; its ends then.
fn at_zero(
    positions: &mut [Vector3<f64>],
    space: &PeriodicBox,
    mut bounds: [[f64; 2]; 3],
) -> [[f64; 2]; 3] {
    for (axis, [low, high]) in bounds.iter_mut().enumerate() {
        if space.lengths()[axis].is_some() && *low != 0.0 {
            positions.iter_mut().for_each(|place| place[axis] -= *low);
            *high -= *low;
            *low = 0.0;
        }
    }
    bounds
}

/// Spheres from what the readers of atoms found, in a box that begins at 0 along periodic axes.
fn assembly(
    source: &Source<'_>,
    atoms: Configuration,
    spheres: Spheres,
    cure: &'static str,
) -> Result<Assembly, AssemblyError> {
    let file = source.name;
    let count = atoms.atoms.positions.len();
    let of_all = |column| source.columns.and_then(|columns| columns.of_all(column));
    let size = of_all(SphereColumn::Radius)
        .or(of_all(SphereColumn::Diameter).map(|diameter| 0.5 * diameter));
    if let Some(size) = size.filter(|size| *size <= 0.0) {
        return Err(source.content(format!("the radius of all must be > 0, not {size}")));
    }
    let given = size.map(|radius| vec![radius; count]);
    let radii = given
        .or(spheres.radii)
        .ok_or_else(|| AssemblyError::NoRadii {
            file: file.into(),
            line: spheres.line,
            cure,
        })?;
    let densities = match of_all(SphereColumn::Density) {
        Some(density) if density <= 0.0 => {
            return Err(source.content(format!("the density of all must be > 0, not {density}")));
        }
        Some(density) => Some(vec![density; count]),
        None => spheres.densities,
    };
    let space = atoms.space().map_err(|cause| AssemblyError::Space {
        file: file.into(),
        cause,
    })?;
    let mut positions = atoms.atoms.positions;
    let bounds = at_zero(&mut positions, &space, atoms.bounds);
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
    // Atoms have a velocity in any case, 0 where the file has none.
    let velocities = atoms.atoms.velocities;
    let is_moving = velocities
        .iter()
        .flatten()
        .any(|component| *component != 0.0);
    let mut assembly = Assembly {
        materials: mixed(&materials).then_some(materials),
        densities,
        is_assumed: spheres.is_silent,
        velocities: is_moving.then_some(velocities),
        spins: spheres.spins,
        ..Assembly::new(space, positions, radii)
    };
    if atoms.has_box {
        (assembly.bounds, assembly.has_box) = (bounds, true);
    }
    Ok(assembly)
}
