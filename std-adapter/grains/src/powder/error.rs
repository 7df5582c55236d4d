//! Errors of a compaction.

use super::deposit::DepositError;
use crate::packing::PackingRunError;

/// Why a compaction cannot start or continue.
///
/// ```
/// use tribos::powder::{PowderSimulation, CompactionError};
/// use tribos::record::CheckpointError;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// let refused = PowderSimulation::resume(&scene, "{}");
/// assert!(matches!(refused, Err(CompactionError::Checkpoint(CheckpointError::Format(_)))));
/// ```
pub type CompactionError = PackingRunError<DepositError>;

impl From<DepositError> for CompactionError {
    fn from(error: DepositError) -> Self {
        Self::Placement(error)
    }
}
