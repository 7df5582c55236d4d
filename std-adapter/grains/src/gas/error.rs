//! Errors of a gas.

use crate::packing::PackingError;
use tribos_base::record::CheckpointError;
use tribos_base::scene::InvalidScene;
use tribos_base::space::PeriodicBoxError;
use tribos_contacts::cd::WorldError;
use tribos_contacts::event::{EventError, ImpactError};
use tribos_core::contact::ContactError;
use tribos_core::law::LawError;

/// Why a gas cannot start or continue.
///
/// ```
/// use tribos::gas::{GasSimulation, GasError};
/// use tribos::scene::GasScene;
/// let crowd = GasScene { packing_fraction: 0.9, ..GasScene::default() };
/// assert!(matches!(GasSimulation::new(&crowd), Err(GasError::Scene(_))));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum GasError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The cube has no room for the spheres.
    #[error("the spheres find no place in the cube; take a smaller packing fraction")]
    Room,
    /// The law of collisions is refused.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// The spheres are refused.
    #[error(transparent)]
    Events(#[from] EventError),
    /// The kernel refused a law.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused a set of sliding and torsion.
    #[error(transparent)]
    Surface(#[from] tribos_core::Error),
    /// The cube is refused.
    #[error(transparent)]
    Space(#[from] PeriodicBoxError),
    /// The world of contact dynamics cannot start or go on.
    #[error(transparent)]
    World(#[from] WorldError),
    /// Two spheres with the same centre have no normal.
    #[error("after step {step}: {cause}")]
    Touch {
        /// Number of the step.
        step: u64,
        /// The kernel's reason.
        #[source]
        cause: ContactError,
    },
    /// A number of the series left the range of f64.
    #[error("after step {step}: `{column}` is {value:e}")]
    NotFinite {
        /// Number of the step.
        step: u64,
        /// Column of the series.
        column: &'static str,
        /// The value.
        value: f64,
    },
    /// The caller stopped the start.
    #[error("stopped while the spheres were mixed")]
    Stopped,
    /// The checkpoint cannot be used.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

impl From<PackingError> for GasError {
    fn from(error: PackingError) -> Self {
        match error {
            PackingError::Law(error) => Self::Law(error),
            PackingError::Surface(error) => Self::Surface(error),
            PackingError::World(error) => Self::World(error),
        }
    }
}
