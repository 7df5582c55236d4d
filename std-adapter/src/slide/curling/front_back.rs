//! Ice friction under a rock that leans.

use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::SlideError;
use crate::slide::planar::Resistance;

/// [`super::LeftRight`] with the pressure gradient that the rock's height brings.
///
/// *Formula*: as [`super::Dry`] with γ v^α in place of μ. *Source*: "for other friction than α = 0
/// the net lateral force is nonzero as well" (thesis, section 3.5.1). *How sure*: the lean is
/// certainly there; alone it bends the path the wrong way.
///
/// *Domain*: γ v^α exceeds every bound towards rest. Where |l| would pass 1 (below 1 mm/s) the
/// gradient is held there.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, FrontBack, IceLaw};
/// let body = FrontBack { ice: IceLaw::PENNER }.resistance(&CurlingRock::STANDARD)?;
/// let [left_turning, right_turning] =
///     [0.1, -0.1].map(|rim| body.deceleration([2.0, 0.0, rim])[1]);
/// assert!(left_turning > 0.0); // counterclockwise spin bends to the right
/// assert_eq!(left_turning, -right_turning);
/// # Ok::<(), tribos::slide::SlideError>(())
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

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, SlideError> {
        Ok(Box::new(rock.body(self.ice, rock.height)?))
    }
}
