//! Errors of grains.

use super::placement::PlacementError;
use crate::packing::PackingRunError;

/// Why grains cannot start or continue.
///
/// ```
/// use tribos::grains::{GrainsSimulation, GrainsError};
/// use tribos::record::CheckpointError;
/// use tribos::scene::GrainsScene;
/// let refused = GrainsSimulation::resume(&GrainsScene::default(), "{}");
/// assert!(matches!(refused, Err(GrainsError::Checkpoint(CheckpointError::Format(_)))));
/// ```
pub type GrainsError = PackingRunError<PlacementError>;

impl From<PlacementError> for GrainsError {
    fn from(error: PlacementError) -> Self {
        Self::Placement(error)
    }
}
