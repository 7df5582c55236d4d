//! Why a run of a packing cannot start or continue.

use super::PlacementError;
use crate::packing::AssemblyError;
use tribos_base::record::CheckpointError;
use tribos_base::run::Cause;
use tribos_base::scene::InvalidScene;
use tribos_base::space::SpaceError;
use tribos_contacts::cd::WorldError;
use tribos_core::contact::ContactError;
use tribos_core::law::LawError;

/// Why a run of a packing cannot start or continue.
///
/// ```
/// use tribos::powder::PowderSimulation;
/// use tribos::record::CheckpointError;
/// use tribos::run::PackingRunError;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// let refused = PowderSimulation::resume(&scene, "{}");
/// assert!(matches!(refused, Err(PackingRunError::Checkpoint(CheckpointError::Format(_)))));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum PackingRunError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The spheres cannot be placed.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// The spheres that the scene starts from cannot be used.
    #[error("`initial_state`: {0}")]
    Start(#[from] AssemblyError),
    /// The triangles of a wall cannot be read.
    #[error("`mesh`: {file}: {reason}")]
    Mesh {
        /// Name of the file.
        file: String,
        /// What is wrong, and what would be valid.
        reason: String,
    },
    /// A length of the box cannot be a period.
    #[error(transparent)]
    Space(#[from] SpaceError),
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
        cause: ContactError,
    },
    /// A number of the series left the range of f64.
    #[error("after step {step}: `{column}` is {value:e}; the scene's scales are too far apart")]
    NotFinite {
        /// Number of the step.
        step: u64,
        /// Column of the series.
        column: &'static str,
        /// The value.
        value: f64,
    },
    /// Rigid spheres overlap as in no packing of rigid spheres.
    #[error(
        "after step {step}: rigid spheres overlap by {:.3} % of a radius, at a solid fraction of {solid_fraction:.4}; \
         more `max_iterations` or a shorter `max_time_step` help where there is still room, otherwise press with a pressure in \
         place of a velocity, end the run earlier, or take method = \"soft\"",
        100.0 * overlap
    )]
    Overlap {
        /// Number of the step.
        step: u64,
        /// The deepest overlap over the smaller radius.
        overlap: f64,
        /// Solid share of the volume.
        solid_fraction: f64,
    },
    /// The checkpoint cannot be used.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

impl PackingRunError {
    /// Whether the run failed on its course, after its scene had been accepted.
    ///
    /// ```
    /// use tribos::grains::GrainsSimulation;
    /// use tribos::scene::GrainsScene;
    /// let refused = GrainsSimulation::new(&GrainsScene { width: -1.0, ..Default::default() });
    /// assert!(refused.is_err_and(|error| !error.is_runtime_failure()));
    /// ```
    #[doc(hidden)]
    pub fn is_runtime_failure(&self) -> bool {
        matches!(
            self,
            Self::World(_) | Self::Touch { .. } | Self::NotFinite { .. } | Self::Overlap { .. }
        )
    }

    /// Cause for a long run.
    pub(crate) fn cause(&self) -> Cause {
        match self {
            Self::Checkpoint(_) => Cause::Checkpoint,
            Self::Placement(PlacementError::Stopped) => Cause::Stopped,
            _ => Cause::Scene,
        }
    }
}
