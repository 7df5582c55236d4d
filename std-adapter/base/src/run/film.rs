//! Frames of a run, kept while it runs.

use super::long_run::{LongRun, RunError};
use crate::record::RecordError;
use crate::record::frames::FrameFolder;
use crate::record::verified;
use std::path::Path;

/// Name of the folder of frames in the folder of their run.
pub const FRAMES: &str = "frames";
/// Default number of frames.
const USUAL: u64 = 100;

/// Keeps frames of a run, or none.
#[derive(Debug)]
pub(super) struct FrameRecorder(Option<FrameFolder>);

impl FrameRecorder {
    /// Starts keeping at most `limit` frames in a folder, or continues after a checkpoint with the limit of the run's
    /// start; frames of an earlier run are removed.
    pub fn of<R: LongRun>(
        run: &R,
        folder: &Path,
        checkpoint: Option<&str>,
        limit: Option<u64>,
    ) -> Result<Self, RunError<R::Error>> {
        if let Some(text) = checkpoint {
            let said = verified(text).and_then(|value| value[FRAMES].as_u64());
            return Self::resume(folder, run.steps(), said, limit).map_err(RunError::Frames);
        }
        let begun = match limit.unwrap_or(USUAL) {
            0 => FrameFolder::clear(folder).map(|()| None),
            limit => FrameFolder::begin(folder, &run.bodies(limit)).map(Some),
        };
        Ok(Self(begun.map_err(RunError::Recording)?))
    }

    /// The limit must be that of the run's start: another would give a different set of frames. Where the checkpoint
    /// has `said` that frames are kept, there are some.
    fn resume(
        folder: &Path,
        steps: u64,
        said: Option<u64>,
        limit: Option<u64>,
    ) -> Result<Self, RecordError> {
        let there = FrameFolder::resume(folder, steps)?;
        if there.is_none() && said.is_some_and(|kept| kept > 0) {
            return Err(RecordError::Missing(folder.to_owned()));
        }
        let kept = there.as_ref().map_or(0, FrameFolder::limit);
        match limit {
            Some(given) if given != kept => {
                let path = folder.to_owned();
                Err(RecordError::Limit { path, kept, given })
            }
            _ => Ok(Self(there)),
        }
    }

    /// Largest number of frames; 0 if none are kept.
    pub fn limit(&self) -> u64 {
        self.0.as_ref().map_or(0, FrameFolder::limit)
    }

    /// Call this for the first state and after every step.
    pub fn offer_frame<R: LongRun>(&mut self, run: &R) {
        match &mut self.0 {
            Some(folder) if folder.wants(run.steps()) => folder.add(&run.frame()),
            _ => {}
        }
    }

    /// Writes the frames so far.
    pub fn save<E: std::error::Error>(&mut self) -> Result<(), RunError<E>> {
        let saved = self.0.as_mut().map_or(Ok(()), FrameFolder::save);
        saved.map_err(RunError::Recording)
    }

    /// Adds the last state.
    pub fn end<R: LongRun>(self, run: &R) -> Result<(), RunError<R::Error>> {
        let ended = self.0.map_or(Ok(()), |folder| folder.finish(&run.frame()));
        ended.map_err(RunError::Recording)
    }
}
