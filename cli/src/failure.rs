//! Why a command ended without its result, and the exit code that tells.

use std::error::Error;
use std::path::Path;
use tribos::friction::FrictionError;
use tribos::golden::MeasureError;
use tribos::push::PushError;
use tribos::record::{RecordError, TableError};
use tribos::run::{PackingRunError, RunError};
use tribos::slide::MotionError;
use tribos::tip::TipError;
use tribos_report::figure::FigureError;
use tribos_report::image::ImageError;
use tribos_report::runs::FilmError;

/// Exit code of an interrupted command, as shells have it for SIGINT.
pub(crate) const INTERRUPTED: u8 = 130;
/// Exit code of a run that failed.
const RUN_FAILED: u8 = 1;
/// Exit code of bad usage or input; clap uses the same.
const BAD_INPUT: u8 = 2;
/// Exit code of results that differ from those pinned.
const MISMATCH: u8 = 3;
/// Exit code of contact problems that did not converge.
const UNSOLVED: u8 = 4;

/// A failed command.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Failure {
    /// What the user gave cannot be used; the message names the cure.
    #[error("{0}")]
    Input(String),
    /// The work itself failed.
    #[error("{0}")]
    Run(String),
    /// No room is left for a file; what was written before is whole and still there.
    #[error("{0}")]
    NoRoom(String),
    /// The work was done and its results differ from those pinned.
    #[error("{0}")]
    Mismatch(String),
    /// A solver ended above its tolerance; its best point is kept.
    #[error("{0}")]
    Unsolved(String),
    /// The user asked the command to end; what it has done is kept as the message says.
    #[error("{0}")]
    Interrupted(String),
}

impl Failure {
    /// Bad input, from anything that explains itself.
    pub fn input(message: impl ToString) -> Self {
        Self::Input(message.to_string())
    }

    /// A failed run, from anything that explains itself.
    pub fn run(message: impl ToString) -> Self {
        Self::Run(message.to_string())
    }

    /// The end of a run whose checkpoint and frames are in its folder.
    pub(crate) fn ended(out: &Path, told: &str) -> Self {
        Self::Interrupted(format!(
            "{told}; its results so far are in {}\n  Continue with the same command and --resume.",
            out.display()
        ))
    }

    /// The end of a command of which there was nothing to keep yet.
    pub(crate) fn ended_early(what: &str) -> Self {
        Self::Interrupted(format!(
            "interrupted while {what}; what was finished is kept\n  Give the same command again."
        ))
    }

    /// The same failure with where it happened before it.
    pub fn within(self, place: &str) -> Self {
        self.with_message(|message| format!("{place}: {message}"))
    }

    /// If there was no room for a file: how to go on once there is.
    pub fn resume_hint(self, how: &str) -> Self {
        match self {
            Self::NoRoom(message) => Self::NoRoom(format!("{message}\n  {how}")),
            other => other,
        }
    }

    fn with_message(self, word: impl FnOnce(String) -> String) -> Self {
        match self {
            Self::Input(message) => Self::Input(word(message)),
            Self::Run(message) => Self::Run(word(message)),
            Self::NoRoom(message) => Self::NoRoom(word(message)),
            Self::Mismatch(message) => Self::Mismatch(word(message)),
            Self::Unsolved(message) => Self::Unsolved(word(message)),
            Self::Interrupted(message) => Self::Interrupted(word(message)),
        }
    }

    /// 2 for bad input, 1 for a failed run, 3 for results that differ from those pinned,
    /// 4 for what has no solution or was not solved, 130 for an interrupted command.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Input(_) => BAD_INPUT,
            Self::Run(_) | Self::NoRoom(_) => RUN_FAILED,
            Self::Mismatch(_) => MISMATCH,
            Self::Unsolved(_) => UNSOLVED,
            Self::Interrupted(_) => INTERRUPTED,
        }
    }
}

impl From<PackingRunError> for Failure {
    fn from(error: PackingRunError) -> Self {
        if error.is_runtime_failure() {
            Self::run(error)
        } else {
            // The scene, its placement, the laws or the checkpoint cannot be used.
            Self::input(error)
        }
    }
}

impl From<RecordError> for Failure {
    fn from(error: RecordError) -> Self {
        match error {
            error if error.is_out_of_room() => Self::NoRoom(format!(
                "{error}\n  Files written before it are whole and kept, also one of this name. Make room."
            )),
            RecordError::Write { .. } | RecordError::Lost(_) => Self::run(error),
            // What is there cannot be used, or is asked for what it is not.
            _ => Self::input(error),
        }
    }
}

impl From<TableError> for Failure {
    fn from(error: TableError) -> Self {
        Self::input(error)
    }
}

impl<E: Error + Into<Failure>> From<RunError<E>> for Failure {
    fn from(error: RunError<E>) -> Self {
        match error {
            RunError::Scene(error) | RunError::Checkpoint(error) => error.into(),
            RunError::Record(error) => error.into(),
            RunError::Frames(error) => error.into(),
            // A folder of frames that went away under its run is no bad input.
            RunError::Recording(RecordError::Access { .. }) => Self::run(error),
            RunError::Recording(error) => error.into(),
            RunError::Cancelled(step) => {
                Self::Interrupted(format!("interrupted after step {step}"))
            }
            RunError::CancelledEarly => Self::ended_early("the start was prepared"),
        }
    }
}

impl From<MotionError> for Failure {
    fn from(error: MotionError) -> Self {
        match error {
            MotionError::NotFinite { .. }
            | MotionError::NotFiniteAt { .. }
            | MotionError::TooManyStepsAt { .. }
            | MotionError::TooStiff { .. }
            | MotionError::TooSlow { .. }
            | MotionError::Unbalanced { .. } => Self::run(error),
            error if error.is_interruption() => Self::Interrupted(error.to_string()),
            // The kernel or the planning refused a number of the scene.
            _ => Self::input(error),
        }
    }
}

impl From<TipError> for Failure {
    fn from(error: TipError) -> Self {
        match error {
            TipError::System(_) => Self::run(error),
            // The scene or the checkpoint cannot be used.
            _ => Self::input(error),
        }
    }
}

impl From<PushError> for Failure {
    fn from(error: PushError) -> Self {
        match error {
            PushError::Steps { .. } | PushError::NotFound { .. } => Self::run(error),
            PushError::Refusal(refusal) => refusal.into(),
            _ => Self::input(error),
        }
    }
}

impl From<MeasureError> for Failure {
    fn from(error: MeasureError) -> Self {
        match error {
            MeasureError::Motion(error) => error.into(),
            MeasureError::Packing(error) => error.into(),
            MeasureError::Tip(error) => error.into(),
        }
    }
}

impl From<FigureError> for Failure {
    fn from(error: FigureError) -> Self {
        Self::run(error)
    }
}

impl From<ImageError> for Failure {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::Figure(error) => error.into(),
            ImageError::Write(error) => error.into(),
            ImageError::Ending(_) => Self::input(error),
        }
    }
}

impl From<FilmError> for Failure {
    fn from(error: FilmError) -> Self {
        match error {
            FilmError::Frames(error) => error.into(),
            FilmError::Missing(_) => Self::input(error),
            FilmError::Movie(_) => Self::run(error),
        }
    }
}

impl From<FrictionError> for Failure {
    /// A refused choice of friction, with the options that cure it.
    fn from(refusal: FrictionError) -> Self {
        Self::Input(match refusal {
            FrictionError::Tier { tier, reason, cure } => {
                let cure = cure.map_or("leave out --tier".into(), |cure| {
                    format!("use --tier {cure}")
                });
                format!("--tier {tier} {reason}; {cure}")
            }
            FrictionError::SinglePrecision => {
                "polynomial patches need --precision f64, or --tier quadrature".into()
            }
            other => other.to_string(),
        })
    }
}
