//! Pivoting about points on the slow side.

use super::side_force::{Mechanism, RockWithSideForce};
use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;
use tribos_core::Real;

/// A lateral force that represents the sum of many short pivots, after Leaney (2020).
///
/// *Formula*: friction [`IceLaw`] on the upright rock; force a γ w^α N towards the slow side (left
/// for counterclockwise spin), w = |ω|R, and a torque of that force times R against the spin. This torque
/// would stop the spin before the slide ends; below 0.02 rad/s, where the public code ends the
/// spin, force and torque decrease in proportion to w.
/// *Source*: S. Leaney, Curling rock physics and smartphone rotation data, GeoConvention 2020,
/// eqs. 1–5 with a = 0.014, in the form used by public code; the paper itself was not
/// available. The pivot–slide theory of Shegelski & Lozowski (Cold Reg. Sci. Technol. 2016) has a
/// formula of its own, which we have not found. *Confidence*: a fit, not a theory; the force *grows*
/// as the spin falls, so that fast spin curls less than half as much as slow spin. It is kept as an
/// example of a model that matches the size of the curl and misses its trend.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, IceLaw, PivotSlide};
/// let (rock, ice, weight) = (CurlingRock::STANDARD, IceLaw::PENNER, PivotSlide::WEIGHT);
/// let body = PivotSlide { ice, weight }.resistance(&rock)?;
/// let left = |rim: f64| -body.deceleration([2.0, 0.0, rim])[1];
/// let pull = weight * ice.coefficient * 0.1_f64.powf(ice.alpha) * rock.gravity;
/// assert!((left(0.1) - pull).abs() < 1e-3 * pull); // 0.1 m/s is far above the fading
/// assert!((left(0.4) - 0.5 * left(0.1)).abs() < 1e-3 * pull); // faster spin pulls less
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PivotSlide {
    /// Law of the ice.
    pub ice: IceLaw,
    /// Strength a of the lateral force.
    pub weight: f64,
}

/// Spin below which the pivots fade, in rad/s.
const FADING_SPIN: f64 = 0.02;

impl PivotSlide {
    /// Leaney's value of a.
    pub const WEIGHT: f64 = 0.014;
}

impl CurlingModel for PivotSlide {
    fn name(&self) -> &'static str {
        "pivot-slide"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(RockWithSideForce {
            body: rock.body(self.ice, 0.0)?,
            mechanism: Pivots {
                pull: self.weight * self.ice.coefficient * rock.gravity,
                alpha: self.ice.alpha,
                fading: FADING_SPIN * rock.band_radius,
                inertia_ratio: rock.inertia_ratio,
            },
        }))
    }
}

#[derive(Debug)]
struct Pivots {
    pull: f64,
    alpha: f64,
    /// Rim speed below which the pivots fade.
    fading: f64,
    inertia_ratio: f64,
}

impl Mechanism for Pivots {
    fn added(&self, _slide: f64, rim: f64) -> [f64; 2] {
        let regular = Real::pow(Real::hypot(rim, self.fading), self.alpha - 1.0);
        let pull = self.pull * rim * regular;
        [pull, pull / self.inertia_ratio]
    }
}
