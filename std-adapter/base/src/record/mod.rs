//! Output of runs: numbers as text, files written atomically.

mod atomic;
mod cells;
#[doc(hidden)]
pub mod checkpoint;
mod dialect;
mod encoding;
mod error;
#[doc(hidden)]
pub mod frames;
mod heading;
mod lines;
mod log;
mod number;
mod read;
mod seal;
mod series;
mod sheet;
mod snapshot;
mod table;
mod target;
#[doc(hidden)]
pub mod trajectory;
mod units;
mod vtk;
mod xyz;

pub(crate) use atomic::AtomicFile;
#[doc(hidden)]
pub use atomic::{is_unfinished, write_atomically, write_atomically_there, write_atomically_with};
pub use checkpoint::CheckpointError;
pub use error::RecordError;
#[doc(hidden)]
pub use log::{
    ColumnChoice, ColumnChoices, DropReason, Log, LogOptionError, LogOptions, LogPreview, LogRole,
    LookColumn, UnitChoices, log_of_columns, look, look_from, read_log, read_log_from,
    used_columns,
};
#[doc(hidden)]
pub use number::brief;
#[doc(hidden)]
pub use number::{json_number, number, significant};
#[doc(hidden)]
pub use read::{read_bytes, read_text};
pub(crate) use seal::with_number;
#[doc(hidden)]
pub use seal::{digest, verified, with_digest};
#[doc(hidden)]
pub use series::{series_csv, write_series};
#[doc(hidden)]
pub use snapshot::{ContactRow, Partner, Snapshot, SnapshotError};
#[doc(hidden)]
pub use table::{OtherColumns, Rows, TableError};
#[doc(hidden)]
pub use units::Dimension;
#[doc(hidden)]
pub use vtk::{contacts_vtp, particles_vtp};
#[doc(hidden)]
pub use xyz::{cell_keys, extended_xyz};
