//! Why a folder for results cannot be used.

use crate::record::WriteError;
use crate::record::frames::FrameError;
use std::path::Path;

/// A folder for results that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum FolderError {
    /// Existing files forbid it; the message says which, and what to do.
    #[error("{0}")]
    Refused(String),
    /// The system refused access, or the folder was lost.
    #[error("{0}")]
    Access(String),
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// Frames in it cannot be removed.
    #[error(transparent)]
    Frames(#[from] FrameError),
}

impl FolderError {
    /// The system's refusal to `verb` something at a place.
    pub(crate) fn access(verb: &str, place: &Path, error: std::io::Error) -> Self {
        Self::Access(format!("cannot {verb} {}: {error}", place.display()))
    }

    /// Whether the disk is full.
    pub fn is_out_of_room(&self) -> bool {
        match self {
            Self::Write(error) | Self::Frames(FrameError::Write(error)) => error.is_out_of_room(),
            _ => false,
        }
    }
}
