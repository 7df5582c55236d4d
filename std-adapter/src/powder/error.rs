//! Errors of a compaction.

use super::deposit::DepositError;
use crate::cd::WorldError;
use crate::measure::AssemblyError;
use crate::packing::PackingError;
use crate::record::CheckpointError;
use crate::scene::InvalidScene;
use tribos_core::contact::TouchError;
use tribos_core::law::LawError;

/// Why a compaction cannot start or continue.
///
/// ```
/// use tribos::powder::{Compaction, CompactionError};
/// use tribos::record::CheckpointError;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// let refused = Compaction::resume(&scene, "{}");
/// assert!(matches!(refused, Err(CompactionError::Checkpoint(CheckpointError::Format(_)))));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum CompactionError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The deposit cannot be grown.
    #[error(transparent)]
    Deposit(#[from] DepositError),
    /// The spheres that the scene starts from cannot be used.
    #[error("`start`: {0}")]
    Start(#[from] AssemblyError),
    /// The kernel refused a law.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused a set of sliding and torsion.
    #[error(transparent)]
    Surface(#[from] tribos_core::Error),
    /// The world cannot start or go on.
    #[error(transparent)]
    World(#[from] WorldError),
    /// A contact of two bodies has no normal.
    #[error("after step {step}: {cause}")]
    Touch {
        /// Number of the step.
        step: u64,
        /// The kernel's reason.
        #[source]
        cause: TouchError,
    },
    /// A number of the series left the range of f64.
    #[error(
        "after step {step}: `{column}` is {value:e}; the scene's pressure, masses and lengths are \
         too far apart"
    )]
    NotFinite {
        /// Number of the step.
        step: u64,
        /// Column of the series.
        column: &'static str,
        /// The value.
        value: f64,
    },
    /// The checkpoint cannot be used.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

impl From<PackingError> for CompactionError {
    fn from(error: PackingError) -> Self {
        match error {
            PackingError::Law(error) => Self::Law(error),
            PackingError::Surface(error) => Self::Surface(error),
            PackingError::World(error) => Self::World(error),
        }
    }
}
