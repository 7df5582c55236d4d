//! Output of runs: numbers as text, files written atomically.

mod atomic;
pub mod frames;
pub(crate) mod kept;
mod number;
mod read;
mod seal;
mod series;
mod snapshot;
mod target;
pub mod trajectory;
mod vtk;
mod xyz;

pub(crate) use atomic::AtomicFile;
pub use atomic::{
    WriteError, is_unfinished, write_atomically, write_atomically_there, write_atomically_with,
};
pub use kept::CheckpointError;
pub use number::{json_number, number};
pub use read::{ReadError, read_text};
pub use seal::{digest, sealed, unsealed};
pub use series::{series_csv, write_series};
pub use snapshot::{ContactRow, Partner, Snapshot, SnapshotError};
pub use vtk::{contacts_vtp, particles_vtp};
pub use xyz::extended_xyz;
