//! What a run leaves behind: numbers as text, whole files or none.

mod atomic;
pub mod frames;
pub(crate) mod kept;
mod number;
mod series;
mod snapshot;
pub mod trajectory;
mod vtk;
mod xyz;

pub(crate) use atomic::AtomicFile;
pub use atomic::{WriteError, write_atomically};
pub use kept::CheckpointError;
pub use number::{json_number, number};
pub use series::series_csv;
pub use snapshot::{ContactRow, Partner, Snapshot, SnapshotError};
pub use vtk::{contacts_vtp, particles_vtp};
pub use xyz::extended_xyz;
