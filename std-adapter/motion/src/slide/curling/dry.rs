//! A dry rock.

use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;

/// Coulomb friction under a rock that leans forward, as under a cylinder on a table.
///
/// *Formula*: pressure p (1 + l·r) with l = −2 h F/(N R), friction μ against each element's
/// velocity. *Source*: eqs. 3.37 and 3.38 of the thesis. *Confidence*: established physics, and correct for
/// a cylinder; refuted for ice, where rocks curl in the opposite direction.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, Dry};
/// let rock = CurlingRock::STANDARD;
/// let body = Dry { coefficient: 0.0071 }.resistance(&rock)?;
/// let [back, ..] = body.deceleration([2.0, 0.0, 0.0]); // m/s; no spin
/// assert!((back - 0.0071 * rock.gravity).abs() < 1e-14); // mu g, wherever the pressure is
/// let [_, right, _] = body.deceleration([2.0, 0.0, 0.1]); // counterclockwise
/// assert!(right > 0.0);
/// let [_, right, _] = Dry { coefficient: 0.0071 }
///     .resistance(&CurlingRock { height: 0.0, ..rock })?
///     .deceleration([2.0, 0.0, 0.1]);
/// assert_eq!(right, 0.0); // a flat rock does not lean
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dry {
    /// Friction coefficient μ.
    pub coefficient: f64,
}

impl CurlingModel for Dry {
    fn name(&self) -> &'static str {
        "dry"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        let ice = IceLaw {
            coefficient: self.coefficient,
            alpha: 0.0,
        };
        Ok(Box::new(rock.body(ice, rock.height)?))
    }
}
