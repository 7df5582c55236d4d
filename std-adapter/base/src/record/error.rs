//! Why a file or a folder of results cannot be read or written.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A file or a folder of a run that cannot be read or written.
///
/// ```
/// use std::io::{Error, ErrorKind};
/// use tribos::record::RecordError;
/// let full = RecordError::Write { path: "run.csv".into(), cause: Error::from(ErrorKind::StorageFull) };
/// assert!(full.is_out_of_room());
/// assert!(full.to_string().starts_with("cannot write run.csv: "));
/// // Texts have a largest size.
/// let error = RecordError::TooLarge { most: 3 << 20 };
/// assert_eq!(error.to_string(), "the file is larger than 3 MB, which is the most that is read");
/// let nowhere = tribos::record::read_text("nowhere.toml".as_ref(), 100);
/// assert!(nowhere.is_err_and(|error| error.is_missing()) && !error.is_missing());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Frames say which of them is missing or damaged:
///
/// ```
/// # use tribos::record::{RecordError, frames::{Bodies, FrameFolder, Kind}};
/// # let bodies = Bodies {
/// #     kind: Kind::Powder,
/// #     scene: serde_json::json!({}),
/// #     limit: 20,
/// #     stride: 1,
/// #     sides: [10.0; 2],
/// #     periods: [Some(10.0), Some(10.0), None],
/// #     radii: vec![1.0],
/// #     materials: Vec::new(),
/// #     densities: Vec::new(),
/// #     layers: Vec::new(),
/// #     parts: Vec::new(),
/// #     marked: Vec::new(),
/// # };
/// # let home = tempfile::tempdir()?;
/// # let path = home.path().join("frames");
/// FrameFolder::begin(&path, &bodies)?;
/// let missing = FrameFolder::read(&path, &bodies, 7);
/// assert!(matches!(missing, Err(RecordError::Access { .. })));
/// // A frame of which nothing but the first bytes is there.
/// std::fs::write(path.join("000000000007.frame"), "TrFr")?;
/// let short = FrameFolder::read(&path, &bodies, 7);
/// assert!(matches!(short, Err(RecordError::Damaged(_))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// A file cannot be written; an earlier file at its path is unchanged.
    #[error("cannot write {}: {cause}", path.display())]
    Write {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        #[source]
        cause: std::io::Error,
    },
    /// The file cannot be opened or read.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The file is larger than the limit.
    #[error("the file is larger than {} MB, which is the most that is read", most >> 20)]
    TooLarge {
        /// Largest number of bytes.
        most: u64,
    },
    /// The file is compressed.
    #[error("the file is compressed ({0}); unpack it first")]
    Compressed(&'static str),
    /// The file contains a zero byte or is not UTF-8.
    #[error("the file is not text: its byte {at} is zero or not UTF-8")]
    NotText {
        /// Offset of the first byte that is not text.
        at: u64,
    },
    /// A file or the folder cannot be read or removed.
    #[error("{}: {cause}", path.display())]
    Access {
        /// Path of the file or folder.
        path: PathBuf,
        /// Error of the operating system.
        #[source]
        cause: std::io::Error,
    },
    /// A file is damaged or of another run.
    #[error(
        "{} is damaged, of another run or of another version; run the scene again, with --anew if it was broken off",
        .0.display()
    )]
    Damaged(PathBuf),
    /// A required frame is missing.
    #[error("{} is missing; run the scene again, with --anew if it was broken off", .0.display())]
    Missing(PathBuf),
    /// The folder contains frames of another limit.
    #[error(
        "{}: {kept} frames are kept there, not {given}; give `--frames {kept}`, or start anew with --anew",
        path.display()
    )]
    Limit {
        /// The folder.
        path: PathBuf,
        /// Number of frames that the run keeps.
        kept: u64,
        /// Number of frames that was requested.
        given: u64,
    },
    /// There is no checkpoint that can be read.
    #[error("nothing to go on from: {}: {cause}; run without --resume", file.display())]
    NoCheckpoint {
        /// Path of the missing checkpoint.
        file: PathBuf,
        /// Why it cannot be read.
        #[source]
        cause: Box<RecordError>,
    },
    /// Existing files forbid the use of a folder; the message says which, and what to do.
    #[error("{0}")]
    Refused(String),
    /// The system refused access to a folder, or the folder was lost.
    #[error("{0}")]
    Lost(String),
}

impl RecordError {
    /// The system's refusal to `verb` something at a place.
    pub(crate) fn lost(verb: &str, place: &Path, error: std::io::Error) -> Self {
        Self::Lost(format!("cannot {verb} {}: {error}", place.display()))
    }

    /// Whether the file does not exist.
    pub fn is_missing(&self) -> bool {
        matches!(self, Self::Io(error) if error.kind() == ErrorKind::NotFound)
    }

    /// Whether the disk or the user's quota is full, or the file exceeds the allowed size.
    pub fn is_out_of_room(&self) -> bool {
        use ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
        matches!(
            self,
            Self::Write { cause, .. }
                if matches!(cause.kind(), StorageFull | QuotaExceeded | FileTooLarge)
        )
    }
}

impl From<RecordError> for std::io::Error {
    /// The error of the operating system, without the path.
    fn from(error: RecordError) -> Self {
        match error {
            RecordError::Write { cause, .. }
            | RecordError::Access { cause, .. }
            | RecordError::Io(cause) => cause,
            other => Self::other(other),
        }
    }
}
