//! A run that can be saved and resumed, where it starts, and why it ends without its result.

use super::Simulation;
use super::folder::FolderError;
use crate::record::frames::{Bodies, Frame, FrameError};
use crate::record::{ReadError, WriteError};
use std::error::Error;
use std::ops::ControlFlow;
use std::path::PathBuf;

/// A simulation that can be saved to a file and resumed from it to the same bits.
pub trait LongRun: Simulation<Error: Error> + Sized {
    /// Description from which a run starts.
    type Scene;

    /// A new run, or one resumed from the text of a checkpoint. `growing` receives the number of
    /// bodies placed so far and can stop the placement.
    fn begin(
        scene: &Self::Scene,
        checkpoint: Option<&str>,
        growing: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, Self::Error>;

    /// Why a run did not begin.
    fn cause(error: &Self::Error) -> Cause;

    /// The state as text, from which the run can be resumed.
    fn checkpoint(&self) -> String;

    /// Steps taken.
    fn steps(&self) -> u64;

    /// The data that all frames share, with at most `limit` frames.
    fn bodies(&self, limit: u64) -> Bodies;

    /// The current state as a frame.
    fn frame(&self) -> Frame;
}

/// Cause of a run's error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// The scene cannot be run, or a number left its range: every attempt fails alike.
    Scene,
    /// The checkpoint is damaged, or of another scene or version.
    Checkpoint,
    /// The caller stopped the growth of the bodies.
    Stopped,
}

/// Where a run starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartMode {
    /// At its beginning.
    Fresh,
    /// From its checkpoint.
    Resume,
    /// From its checkpoint, or at the beginning if there is no usable one of the same scene.
    ResumeIfPossible,
}

/// There is no checkpoint that can be read.
#[derive(Debug, thiserror::Error)]
#[error("nothing to go on from: {}: {cause}; run without --resume", file.display())]
pub struct NoCheckpoint {
    /// Path of the missing checkpoint.
    pub file: PathBuf,
    /// Description of the error.
    #[source]
    pub cause: ReadError,
}

/// Why a run ended without its result.
#[derive(Debug, thiserror::Error)]
pub enum RunError<E: Error + 'static> {
    /// The scene cannot be run, or a number left its range on the way: the same every time.
    #[error(transparent)]
    Scene(E),
    /// The checkpoint cannot be used.
    #[error(transparent)]
    Checkpoint(E),
    /// There is no checkpoint that can be read.
    #[error(transparent)]
    NoCheckpoint(#[from] NoCheckpoint),
    /// The folder cannot be used, or was lost while the run worked in it.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// The existing frames cannot be continued.
    #[error(transparent)]
    Frames(FrameError),
    /// A frame cannot be kept.
    #[error(transparent)]
    Recording(FrameError),
    /// The checkpoint cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The caller cancelled the run; its checkpoint and frames are written.
    #[error("cancelled after step {0}; resume it from its checkpoint")]
    Cancelled(u64),
    /// The caller cancelled the run before there was anything to save.
    #[error("cancelled while the bodies were placed; nothing is lost")]
    CancelledEarly,
}

impl<E: Error> RunError<E> {
    /// Whether the disk is full; files written before are complete.
    pub fn is_out_of_room(&self) -> bool {
        match self {
            Self::Write(error) | Self::Recording(FrameError::Write(error)) => {
                error.is_out_of_room()
            }
            Self::Folder(error) => error.is_out_of_room(),
            _ => false,
        }
    }

    /// Whether a run from the beginning would avoid this error.
    pub(super) fn is_of_earlier_run(&self) -> bool {
        matches!(
            self,
            Self::Checkpoint(_) | Self::NoCheckpoint(_) | Self::Frames(_)
        )
    }
}
