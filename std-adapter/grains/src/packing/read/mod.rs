//! Reading spheres from the files and folders of runs and of other programs.

mod columns;
mod format;
mod found;
mod mercury;
mod programs;
mod run;
mod table;
mod vtk;

pub(crate) use columns::{COLUMNS, COLUMNS_ALONE};
pub use columns::{PackingColumns, PackingColumnsError};
pub use format::PackingFormat;

use super::SAME_PERIOD;
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
///     Err(
///         "argon.xyz: line 2: there are no radii; give a column radius:R:1, or one radius of all by --columns \
///          radius=all:VALUE (key `columns`)"
///             .into()
///     )
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
    #[error(
        "{file}: line {line}: there are no radii; {cure}, or one radius of all by --columns radius=all:VALUE (key `columns`)"
    )]
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

impl Assembly {
    /// Sets the periods, `None` for an open axis, where the file does not say them. *Domain*: periods finite and
    /// positive, no sphere out of its period; those that the file says.
    pub fn with_periods(
        mut self,
        file: &str,
        periods: [Option<f64>; 3],
    ) -> Result<Self, AssemblyError> {
        for (axis, name) in AXES.iter().enumerate() {
            self.begin_at_zero(axis, periods[axis]);
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

    /// Moves the spheres so that the box of a file, which does not say whether it repeats, begins at 0 along an axis
    /// whose period is its length.
    pub(crate) fn begin_at_zero(&mut self, axis: usize, period: Option<f64>) {
        let [low, high] = self.bounds[axis];
        let is_its =
            period.is_some_and(|period| ((high - low) / period - 1.0).abs() <= SAME_PERIOD);
        if is_its
            && self.has_box
            && self.is_assumed
            && self.space.lengths()[axis].is_none()
            && low != 0.0
        {
            self.positions
                .iter_mut()
                .for_each(|place| place[axis] -= low);
            self.bounds[axis] = [0.0, high - low];
        }
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
