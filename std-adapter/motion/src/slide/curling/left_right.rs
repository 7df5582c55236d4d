//! Friction that differs between left and right.

use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;

/// γ v^α with α < 0 under a rock that does not lean: the slower left side of a counterclockwise
/// rock has the larger friction.
///
/// *Formula*: [`IceLaw`], uniform pressure. *Source*: section 3.5.2 of the thesis. *Confidence*:
/// certainly no curl, for every α: of two elements that mirror each other front to back, the lateral
/// forces are equal and opposite.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, IceLaw, LeftRight};
/// let body = LeftRight { ice: IceLaw::PENNER }.resistance(&CurlingRock::STANDARD)?;
/// let [back, side, spin_down] = body.deceleration([2.0, 0.0, 0.1]);
/// assert_eq!(side, 0.0);
/// // alpha = -1/2: a quarter of the speeds, twice the friction.
/// let slow = body.deceleration([0.5, 0.0, 0.025]);
/// assert!((slow[0] - 2.0 * back).abs() < 1e-14 && (slow[2] - 2.0 * spin_down).abs() < 1e-14);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftRight {
    /// Law of the ice.
    pub ice: IceLaw,
}

impl CurlingModel for LeftRight {
    fn name(&self) -> &'static str {
        "left-right"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(rock.body(self.ice, 0.0)?))
    }
}
