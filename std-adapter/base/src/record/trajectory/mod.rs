//! Trajectories in formats of other programs, written state by state.
//!
//! | format | files | read by |
//! |---|---|---|
//! | [`Format::Vtk`] | `trajectory.pvd`, a collection of `trajectory/<step>.vtp` | ParaView, VTK |
//! | [`Format::Xyz`] | `trajectory.xyz`, extended XYZ of many frames | OVITO, ASE |
//! | [`Format::LammpsDump`] | `trajectory.dump`, a text dump | LAMMPS, OVITO |
//!
//! ```
//! use nalgebra::Vector3;
//! use tribos::record::trajectory::{Column, Format, Side, State, Trajectory, Values};
//! // A ball of radius 0.5 that falls from a height of 4 in a cell of 10 × 10.
//! let state = |step: u64| {
//!     let time = 0.01 * step as f64;
//!     State {
//!         step,
//!         time,
//!         sides: [Side::periodic(10.0), Side::periodic(10.0), Side::open(0.0, 5.0)],
//!         tilt: 0.0,
//!         places: vec![Vector3::new(5.0, 5.0, 4.0 - 0.5 * time * time)],
//!         columns: vec![
//!             Column::new("radius", Values::Numbers(vec![0.5])),
//!             Column::new("id", Values::Integers(vec![0])),
//!             Column::new("velocity", Values::Vectors(vec![Vector3::z() * -time])),
//!         ],
//!     }
//! };
//! # let home = tempfile::tempdir()?;
//! # let folder = home.path();
//! for format in [Format::Vtk, Format::Xyz, Format::LammpsDump] {
//!     let mut film = Trajectory::begin(folder, format)?;
//!     for step in [0, 50, 100] {
//!         film.add(&state(step))?;
//!     }
//!     assert_eq!((film.states(), film.finish()?), (3, folder.join(format.file())));
//! }
//! let frames = std::fs::read_to_string(folder.join("trajectory.xyz"))?;
//! assert_eq!(frames.lines().count(), 3 * 3); // a number, a header and a line each
//! assert!(folder.join("trajectory/000000000100.vtp").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod dump;
mod state;
mod vtp;
mod xyz;

pub use state::{Column, Side, State, Values};

use super::{AtomicFile, RecordError, write_atomically};
use std::path::{Path, PathBuf};

/// File formats of other programs.
///
/// ```
/// use tribos::record::trajectory::Format;
/// assert_eq!(Format::Vtk.file(), "trajectory.pvd");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A collection of VTK PolyData, one file per state.
    Vtk,
    /// Extended XYZ, all states in one file.
    Xyz,
    /// A text dump of LAMMPS, all states in one file.
    LammpsDump,
}

/// Folder of the states of a collection.
const STATES: &str = "trajectory";
/// Ending of a state's file.
const STATE: &str = "vtp";

impl Format {
    /// Name of the file to open.
    pub fn file(self) -> &'static str {
        match self {
            Self::Vtk => "trajectory.pvd",
            Self::Xyz => "trajectory.xyz",
            Self::LammpsDump => "trajectory.dump",
        }
    }
}

/// A trajectory that is being written: memory holds only one state, and the file to open exists
/// once all states have been written.
#[derive(Debug)]
pub struct Trajectory {
    folder: PathBuf,
    format: Format,
    file: AtomicFile,
    states: usize,
}

impl Trajectory {
    /// Begins the files in a folder, which is created if missing; files of an earlier export in the
    /// same format are replaced.
    pub fn begin(folder: &Path, format: Format) -> Result<Self, RecordError> {
        let mut file = AtomicFile::begin(&folder.join(format.file()))?;
        if format == Format::Vtk {
            remove_states(&folder.join(STATES))?;
            file.add(vtp::COLLECTION_BEGIN.as_bytes())?;
        }
        Ok(Self {
            folder: folder.to_path_buf(),
            format,
            file,
            states: 0,
        })
    }

    /// Writes a state.
    pub fn add(&mut self, state: &State) -> Result<(), RecordError> {
        self.states += 1;
        match self.format {
            Format::Xyz => self.file.add(xyz::frame(state).as_bytes()),
            Format::LammpsDump => self.file.add(dump::frame(state).as_bytes()),
            Format::Vtk => {
                let name = format!("{STATES}/{:012}.{STATE}", state.step);
                write_atomically(&self.folder.join(&name), vtp::file(state).as_bytes())?;
                self.file.add(vtp::entry(state.time, &name).as_bytes())
            }
        }
    }

    /// Number of states written so far.
    pub fn states(&self) -> usize {
        self.states
    }

    /// Completes the files; returns the one to open.
    pub fn finish(mut self) -> Result<PathBuf, RecordError> {
        if self.format == Format::Vtk {
            self.file.add(vtp::COLLECTION_END.as_bytes())?;
        }
        self.file.finish()?;
        Ok(self.folder.join(self.format.file()))
    }
}

/// Removes the states of an earlier collection, whose names are numbers.
fn remove_states(folder: &Path) -> Result<(), RecordError> {
    let fail = |cause| RecordError::Write {
        path: folder.to_path_buf(),
        cause,
    };
    let entries = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(()),
        entries => entries.map_err(fail)?,
    };
    for entry in entries {
        let path = entry.map_err(fail)?.path();
        if is_state(&path) {
            std::fs::remove_file(&path).map_err(|cause| RecordError::Write { path, cause })?;
        }
    }
    Ok(())
}

/// Whether a file has the name of a state.
fn is_state(path: &Path) -> bool {
    let step = path.file_stem().and_then(|stem| stem.to_str());
    let is_number = |step: &str| step.bytes().all(|byte| byte.is_ascii_digit());
    path.extension().is_some_and(|ending| ending == STATE) && step.is_some_and(is_number)
}
