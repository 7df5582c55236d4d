//! Why a run of grains cannot start or continue.

use super::placement::PlacementError;
use crate::cd::WorldError;
use crate::measure::AssemblyError;
use crate::packing::PackingError;
use crate::record::CheckpointError;
use crate::scene::InvalidScene;
use crate::space::PeriodicBoxError;
use tribos_core::contact::TouchError;
use tribos_core::law::LawError;

/// Why grains cannot start or continue.
///
/// ```
/// use tribos::grains::{Grains, GrainsError};
/// use tribos::record::CheckpointError;
/// use tribos::scene::GrainsScene;
/// let refused = Grains::resume(&GrainsScene::default(), "{}");
/// assert!(matches!(refused, Err(GrainsError::Checkpoint(CheckpointError::Format(_)))));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum GrainsError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The grains cannot be placed.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// The grains that the scene starts from cannot be used.
    #[error("`start`: {0}")]
    Start(#[from] AssemblyError),
    /// A length of the box cannot be a period.
    #[error(transparent)]
    Space(#[from] PeriodicBoxError),
    /// The kernel refused a law.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused a set of sliding and torsion.
    #[error(transparent)]
    Surface(#[from] tribos_core::Error),
    /// The world cannot start or go on.
    #[error(transparent)]
    World(#[from] WorldError),
    /// The method cannot move walls or change gravity.
    #[error("the method of this scene cannot move walls or change gravity; choose another")]
    Driven,
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
        "after step {step}: `{column}` is {value:e}; the scene's loads, masses and lengths are too \
         far apart"
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

impl From<PackingError> for GrainsError {
    fn from(error: PackingError) -> Self {
        match error {
            PackingError::Law(error) => Self::Law(error),
            PackingError::Surface(error) => Self::Surface(error),
            PackingError::World(error) => Self::World(error),
        }
    }
}
