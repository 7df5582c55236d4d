//! A run that can be saved and resumed, where it starts, and why it ends without its result.

use super::Simulation;
use crate::record::RecordError;
use crate::record::frames::{Bodies, Frame};
use std::error::Error;
use std::ops::ControlFlow;

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

/// Why a run ended without its result.
#[derive(Debug, thiserror::Error)]
pub enum RunError<E: Error + 'static> {
    /// The scene cannot be run, or a number left its range on the way: the same every time.
    #[error(transparent)]
    Scene(E),
    /// The checkpoint cannot be used.
    #[error(transparent)]
    Checkpoint(E),
    /// There is no checkpoint that can be read, or the folder or a file of it cannot be used, or was lost while the
    /// run worked in it.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The existing frames cannot be continued.
    #[error(transparent)]
    Frames(RecordError),
    /// A frame cannot be kept.
    #[error(transparent)]
    Recording(RecordError),
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
        matches!(self, Self::Record(error) | Self::Recording(error) if error.is_out_of_room())
    }

    /// Whether a run from the beginning would avoid this error.
    pub(super) fn is_of_earlier_run(&self) -> bool {
        matches!(
            self,
            Self::Checkpoint(_) | Self::Record(RecordError::NoCheckpoint { .. }) | Self::Frames(_)
        )
    }
}
