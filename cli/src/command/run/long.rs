//! What long runs share: a checkpoint in their folder, and lines that tell how far they are.

use super::size::Allowed;
use crate::command::interrupt;
use crate::failure::Failure;
use crate::folder::{Lock, remove_file};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribos::record::{WriteError, read_text};

/// Whether a run starts or goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// From the deposit.
    Fresh,
    /// From the checkpoint.
    Resume,
}

/// Who is told how far a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// The terminal, once a second.
    Told,
    /// Nobody.
    Silent,
}

/// How a long run goes.
#[derive(Clone, Copy, Debug)]
pub struct Course<'a> {
    /// What keeps others out of the folder.
    pub lock: &'a Lock,
    /// Where it starts.
    pub start: Start,
    /// Time from one checkpoint to the next.
    pub pause: Duration,
    /// Frames kept at most, 0 for none; if nothing is said, the usual number, or as many as when the
    /// run began.
    pub frames: Option<u64>,
    /// Who is told.
    pub progress: Progress,
    /// How large it may be.
    pub allowed: Allowed,
}

impl<'a> Course<'a> {
    /// One run of many, which nobody is told of; at most `frames` are kept of it.
    pub fn one_of_many(lock: &'a Lock, start: Start, pause: Duration, frames: u64) -> Self {
        Self {
            lock,
            start,
            pause,
            frames: Some(frames),
            progress: Progress::Silent,
            allowed: Allowed::Usual,
        }
    }
}

/// Why a long run ended without its result.
#[derive(Debug)]
pub enum Unfinished {
    /// Its scene cannot be run, or left the range of numbers on its way: the same every time.
    Refused(Failure),
    /// Something other than the scene: the folder, the disk, a signal, an unusable checkpoint.
    Stopped(Failure),
}

impl From<Failure> for Unfinished {
    fn from(failure: Failure) -> Self {
        Self::Stopped(failure)
    }
}

impl From<WriteError> for Unfinished {
    fn from(error: WriteError) -> Self {
        Self::Stopped(error.into())
    }
}

impl From<Unfinished> for Failure {
    fn from(unfinished: Unfinished) -> Self {
        match unfinished {
            Unfinished::Refused(failure) | Unfinished::Stopped(failure) => failure,
        }
    }
}

/// Bytes of a checkpoint at most: twenty million spheres take some 15 GB.
const MOST_BYTES: u64 = 1 << 36;

impl Course<'_> {
    /// Why a run ended: a folder that was lost explains every file that could not be written.
    pub(super) fn explained(&self, end: Unfinished) -> Unfinished {
        match (end, self.lock.check()) {
            (Unfinished::Stopped(Failure::Run(_) | Failure::Input(_)), Err(lost)) => {
                Unfinished::Stopped(lost)
            }
            (end, _) => end,
        }
    }

    /// The end of a run that was asked to end, its checkpoint and frames written; of one of many
    /// whoever has started them says how to go on.
    pub(super) fn ended(&self, out: &Path, at: &str) -> Failure {
        match self.progress {
            Progress::Told => interrupt::ended(out, at),
            Progress::Silent => Failure::Interrupted(format!("interrupted {at}")),
        }
    }
}

/// Name of a checkpoint.
pub const CHECKPOINT: &str = "checkpoint.json";

/// The checkpoint of a folder.
pub fn checkpoint(out: &Path) -> PathBuf {
    out.join(CHECKPOINT)
}

/// The text of a checkpoint.
pub(super) fn kept(file: &Path) -> Result<String, Failure> {
    read_text(file, MOST_BYTES).map_err(|error| {
        let name = file.display();
        Failure::input(format!(
            "nothing to go on from: {name}: {error}; run without --resume"
        ))
    })
}

/// A run on from its checkpoint, or from the start where there is none of the same scene.
pub fn resumed<R>(simulate: impl Fn(Start) -> Result<R, Unfinished>) -> Result<R, Unfinished> {
    match simulate(Start::Resume) {
        Err(Unfinished::Stopped(Failure::Input(_))) => simulate(Start::Fresh),
        other => other,
    }
}

/// What to do once a full disk has room: a long run loses what it did since its checkpoint.
pub(super) fn how_to_go_on(out: &Path) -> String {
    let file = checkpoint(out);
    if file.exists() {
        let name = file.display();
        format!("Then go on from {name}: the same command with --resume.")
    } else {
        "Then give the same command again: there is no checkpoint yet.".into()
    }
}

/// Takes away the checkpoint of a run that has left its results.
pub fn forget_checkpoint(out: &Path) -> Result<(), Failure> {
    remove_file(&checkpoint(out))
}
