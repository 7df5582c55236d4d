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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::DiskScene;

    #[test]
    fn a_pin_from_before_a_key_holds_while_the_key_has_its_default() {
        let compared = |scene: DiskScene| {
            let now = measure(&scene.into(), || ()).unwrap();
            let mut then = now.clone();
            then.parameters.remove("samples").unwrap();
            let pinned = Pinned::new("disk.toml".into(), vec![], &then);
            pinned.compare(&now)
        };
        let usual = DiskScene::default();
        assert_eq!(compared(usual), Verdict::Same);
        let fewer = DiskScene {
            samples: usual.samples / 2,
            ..usual
        };
        assert!(matches!(compared(fewer), Verdict::SceneChanged(_)));
    }
}
