//! Runs of a sweep: how they start, and why one ends without a summary.

use crate::command::interrupt;
use crate::failure::Failure;
use std::error::Error;
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::run::{LongRun, RunError, Session, StartMode};
use tribos::slide::MotionError;

/// Why there is no result.
pub enum NoResult {
    /// The scene cannot be run: the same every time.
    Refused(Failure),
    /// Something other than the scene.
    Stopped(Failure),
}

impl<E: Error + Into<Failure>> From<RunError<E>> for NoResult {
    fn from(error: RunError<E>) -> Self {
        match error {
            RunError::Scene(error) => Self::Refused(error.into()),
            error => Self::Stopped(error.into()),
        }
    }
}

impl From<MotionError> for NoResult {
    fn from(error: MotionError) -> Self {
        if error.is_interruption() {
            return Self::Stopped(error.into());
        }
        Self::Refused(error.into())
    }
}

/// A run without frames, resumed if it can be.
pub fn session<R: LongRun>(lock: &Arc<Lock>) -> Session<'_, R> {
    Session::under(lock.clone(), lock.folder())
        .start(StartMode::ResumeIfPossible)
        .frames(0)
        .without_final_checkpoint()
        .cancel_when(interrupt::is_asked)
}
