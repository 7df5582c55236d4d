//! Golden files: results of scenes, pinned to the bit, to be checked later and on other machines.

use crate::run::PackingRunError;
use crate::scene::Scene;
use crate::slide::MotionError;
use crate::tip::TipError;
pub use tribos_base::golden::{
    Difference, Digest, FORMAT, Golden, GoldenError, Measurement, Pinned, Quantity,
    SeriesDifference, SummaryDifference, Verdict, canonical_bits,
};

/// A scene could not be run to its end.
///
/// ```
/// use tribos::golden::{MeasureError, measure};
/// use tribos::scene::CylinderScene;
/// use tribos::slide::MotionError;
/// let tower = CylinderScene { radius: 0.08, height: 1.0, ..CylinderScene::default() };
/// let tipped = measure(&tower.into(), || ());
/// assert!(matches!(tipped, Err(MeasureError::Motion(MotionError::Tips { .. }))));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    /// A body that slides, or holds and slips.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A powder, grains in a box or a gas.
    #[error(transparent)]
    Packing(#[from] PackingRunError),
    /// A tip.
    #[error(transparent)]
    Tip(#[from] TipError),
}

/// Runs the scene to its end; `watch` is called after every step.
pub fn measure(scene: &Scene, mut watch: impl FnMut()) -> Result<Measurement, MeasureError> {
    scene.measured(&mut watch)
}
