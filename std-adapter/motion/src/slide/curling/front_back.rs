//! Ice friction under a rock that leans.

use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;

/// [`super::LeftRight`] with the pressure gradient caused by the rock's height.
///
/// *Formula*: as [`super::Dry`] with γ v^α in place of μ. *Source*: "for other friction than α = 0
/// the net lateral force is nonzero as well" (thesis, section 3.5.1). *Confidence*: the lean certainly
/// exists; alone it bends the path in the wrong direction.
///
/// *Domain*: γ v^α grows without bound towards rest. Where |l| would exceed 1 (below 1 mm/s) the
/// gradient is limited to 1.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, FrontBack, IceLaw};
/// let body = FrontBack { ice: IceLaw::PENNER }.resistance(&CurlingRock::STANDARD)?;
/// let [left_turning, right_turning] =
///     [0.1, -0.1].map(|rim| body.deceleration([2.0, 0.0, rim])[1]);
/// assert!(left_turning > 0.0); // counterclockwise spin bends to the right
/// assert_eq!(left_turning, -right_turning);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrontBack {
    /// Law of the ice.
    pub ice: IceLaw,
}

impl CurlingModel for FrontBack {
    fn name(&self) -> &'static str {
        "front-back"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(rock.body(self.ice, rock.height)?))
    }
}
