//! Frames of a run, kept while it runs.

use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::record::frames::{Bodies, Frame, FrameError, FrameFolder};

use super::long::Start;

/// Frames kept where nobody says how many.
const USUAL: u64 = 100;

/// A run of which frames can be kept.
pub(super) trait Filmed {
    /// What all frames have in common.
    fn bodies(&self, limit: u64) -> Bodies;
    /// Steps so far.
    fn steps(&self) -> u64;
    /// The present state.
    fn frame(&self) -> Frame;
}

/// Keeps frames of a run, or none.
#[derive(Debug)]
pub(super) struct Film(Option<FrameFolder>);

/// Where the frames of a run are.
pub fn folder(out: &Path) -> PathBuf {
    out.join("frames")
}

impl Film {
    /// Begins to keep at most `limit` frames, or goes on as the run began; frames of an earlier run
    /// are removed.
    pub fn of(
        run: &impl Filmed,
        out: &Path,
        start: Start,
        limit: Option<u64>,
    ) -> Result<Self, Failure> {
        let path = folder(out);
        if start == Start::Resume {
            return Self::resume(path, limit);
        }
        Ok(Self(match limit.unwrap_or(USUAL) {
            0 => {
                FrameFolder::clear(&path).map_err(written)?;
                None
            }
            limit => Some(FrameFolder::begin(&path, &run.bodies(limit)).map_err(written)?),
        }))
    }

    /// The number of frames is that of the run's start: others would not be the same set.
    fn resume(path: PathBuf, limit: Option<u64>) -> Result<Self, Failure> {
        let kept = FrameFolder::resume(&path)?;
        let there = kept.as_ref().map_or(0, FrameFolder::limit);
        match limit {
            Some(given) if given != there => {
                let kept = there;
                Err(FrameError::Limit { path, kept, given }.into())
            }
            _ => Ok(Self(kept)),
        }
    }

    /// Sees the first state and every one after a step.
    pub fn look(&mut self, run: &impl Filmed) {
        match &mut self.0 {
            Some(folder) if folder.wants(run.steps()) => folder.add(&run.frame()),
            _ => {}
        }
    }

    /// Before a checkpoint, which stands only beside all frames before it.
    pub fn save(&mut self) -> Result<(), Failure> {
        match &mut self.0 {
            Some(folder) => folder.save().map_err(written),
            None => Ok(()),
        }
    }

    /// Sees the last state.
    pub fn end(self, run: &impl Filmed) -> Result<(), Failure> {
        match self.0 {
            Some(folder) => folder.finish(&run.frame()).map_err(written),
            None => Ok(()),
        }
    }
}

/// Of a run's own frames: a folder that went away under it is no bad input.
fn written(error: FrameError) -> Failure {
    match error {
        FrameError::Access { .. } => Failure::run(error),
        error => error.into(),
    }
}

/// A number of frames that can be kept.
pub(super) fn number(text: &str) -> Result<u64, String> {
    match text.trim().parse::<u64>() {
        Ok(1) | Err(_) => Err("give 0 for none, or a whole number from 2 up".into()),
        Ok(number) => Ok(number),
    }
}

impl From<FrameError> for Failure {
    fn from(error: FrameError) -> Self {
        match error {
            FrameError::Write(error) => error.into(),
            // What is there cannot be used, or is asked for what it is not.
            _ => Self::input(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Error, ErrorKind};
    use tribos::record::WriteError;

    #[test]
    fn a_frame_that_finds_no_room_says_so_and_a_lost_folder_is_no_bad_input() {
        let path = PathBuf::from("out/frames/000000000007.frame");
        let cause = Error::from(ErrorKind::StorageFull);
        let full = written(WriteError { path, cause }.into());
        assert!(matches!(&full, Failure::NoRoom(told) if told.contains("Make room")));
        let path = PathBuf::from("out/frames");
        let cause = Error::from(ErrorKind::NotFound);
        let lost = written(FrameError::Access { path, cause });
        assert!(matches!(lost, Failure::Run(_)));
    }
}
