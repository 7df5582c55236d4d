//! Friction that is larger at the back of the band.

use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;
use tribos_core::Real;
use tribos_core::internals::{LeaningWrench, leaning_wrench};
use tribos_friction::AnyFriction;

/// Friction that is larger at the back of the band than at the front by a given factor, whatever the
/// cause (melt water, evaporation, debris).
///
/// *Formula*: friction × (1 + l x), x in band radii along the velocity, l = −(r−1)/(r+1) with r
/// the ratio of the rearmost to the foremost element. The mean ratio of the two halves of a ring
/// is (1 + 2|l|/π)/(1 − 2|l|/π), which stays below 4.5. *Source*: the front–back asymmetry that
/// Penner (Am. J. Phys. 69 (2001) 332) examined, in the linear form of eq. 3.37 of the thesis; his
/// profile around the band is not known to us. *Confidence*: the sign and the proportionality to the spin
/// are certain; the cause and the size are not, and Penner's experiment excludes ratios as large as needed.
///
/// ```
/// use tribos::slide::curling::{BackHeavy, CurlingModel, CurlingRock, IceLaw};
/// let side = |back_to_front: f64| {
///     let model = BackHeavy { ice: IceLaw::PENNER, back_to_front };
///     let body = model.resistance(&CurlingRock::STANDARD)?;
///     Ok::<_, tribos::slide::MotionError>(-body.deceleration([2.0, 0.0, 0.1])[1]) // to the left
/// };
/// assert!(side(1.0)?.abs() < 1e-15); // evenly rough: straight
/// assert!(side(10.0)? > side(2.0)? && side(2.0)? > 0.0);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackHeavy {
    /// Law of the ice.
    pub ice: IceLaw,
    /// Ratio r ≥ 1 of the friction at the rearmost to that at the foremost element; may be infinite.
    pub back_to_front: f64,
}

impl BackHeavy {
    /// Modulation l = −(r−1)/(r+1) = 2/(r+1) − 1.
    fn gradient(&self) -> f64 {
        2.0 / (self.back_to_front + 1.0) - 1.0
    }
}

impl CurlingModel for BackHeavy {
    fn name(&self) -> &'static str {
        "back-heavy"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(AsymmetricBand {
            foot: rock.friction(self.ice)?,
            strength: self.ice.coefficient * rock.gravity,
            gradient: self.gradient(),
            radius: rock.band_radius,
            inertia_ratio: rock.inertia_ratio,
        }))
    }
}

/// A band whose friction varies linearly along the velocity.
#[derive(Debug)]
struct AsymmetricBand {
    foot: AnyFriction,
    strength: f64,
    gradient: f64,
    radius: f64,
    inertia_ratio: f64,
}

impl Resistance for AsymmetricBand {
    fn deceleration(&self, [x, y, rim]: [f64; 3]) -> [f64; 3] {
        let speed = Real::hypot(x, y);
        let LeaningWrench {
            force,
            lateral,
            torque,
        } = leaning_wrench(&self.foot, [speed, rim.abs()], [self.gradient, 0.0]);
        let sense = Real::copysign(1.0, rim);
        let (cos, sin) = if speed == 0.0 {
            (1.0, 0.0)
        } else {
            (x / speed, y / speed)
        };
        let (back, side) = (self.strength * force, self.strength * lateral * sense);
        [
            back * cos - side * sin,
            back * sin + side * cos,
            self.strength * torque * sense / self.inertia_ratio,
        ]
    }

    fn exponent(&self) -> f64 {
        self.foot.exponent_at_rest()
    }
    fn inertia_ratio(&self) -> f64 {
        self.inertia_ratio
    }
    fn radius(&self) -> f64 {
        self.radius
    }
}
