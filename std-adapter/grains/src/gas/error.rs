//! Errors of a gas.

use crate::packing::PackingRunError;
use tribos_contacts::event::{EventError, ImpactError};

/// Why a gas cannot start or continue.
///
/// ```
/// use tribos::gas::{GasSimulation, GasError};
/// use tribos::scene::GasScene;
/// let crowd = GasScene { packing_fraction: 0.9, ..GasScene::default() };
/// assert!(matches!(GasSimulation::new(&crowd), Err(GasError::Scene(_))));
/// ```
pub type GasError = PackingRunError<GasStartError>;

/// Why the spheres of a gas cannot be placed or mixed.
#[derive(Debug, thiserror::Error)]
pub enum GasStartError {
    /// The cube has no room for the spheres.
    #[error("the spheres find no place in the cube; take a smaller packing fraction")]
    Room,
    /// The law of collisions is refused.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// The spheres are refused.
    #[error(transparent)]
    Events(#[from] EventError),
    /// The caller stopped the start.
    #[error("stopped while the spheres were mixed")]
    Stopped,
}

impl<E: Into<GasStartError>> From<E> for GasError {
    fn from(error: E) -> Self {
        Self::Placement(error.into())
    }
}
