//! The profile of a tall body under dry friction, with the effect of its lean on the final motion.

use super::load_transfer::{FullGradient, PressureGradient};
use super::{DryReducedFriction, LateralFriction, PowerLawFriction, Speeds};
use crate::patch::PatchError;
use crate::real::Real;

/// Φ and Χ of a dry foot that carries a tall body, with the pressure gradient in balance with
/// friction ([`FullGradient`]).
///
/// Under dry friction the gradient depends on the ratio of the speeds alone, so that the velocity
/// ratio obeys an autonomous equation as it does without lean: [`crate::modes::TerminalMotion`] of this
/// profile are the tall body's. The lateral force turns the path and does not enter. With λ the
/// lean, C(0) grows by the factor 1 + λ²G(0)² and C(∞) = χ falls to χ − λ²χ² (χ = 1/4 for the
/// uniform disk): a tall body settles at a larger ratio than a flat one.
///
/// *Domain*: |l| ≤ 1 is the caller's to keep: λ ≤ 1 is enough.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LeanProfile<R, P> {
    foot: P,
    lean: R,
}

/// A speed, of the larger one, so slow that C has reached its end: its square is below rounding.
const SLOW: f64 = 1.0 / (1u64 << 27) as f64;

impl<R: Real, P: PowerLawFriction<R> + DryReducedFriction<R> + LateralFriction<R>>
    LeanProfile<R, P>
{
    /// *Domain*: 0 ≤ `lean` < ∞, λ of [`super::tall`].
    pub fn new(foot: P, lean: R) -> Result<Self, PatchError> {
        if lean >= R::ZERO && lean.is_finite() {
            Ok(Self { foot, lean })
        } else {
            Err(PatchError::Lean {
                given: lean.to_f64(),
            })
        }
    }
}

impl<R: Real, P: PowerLawFriction<R> + DryReducedFriction<R> + LateralFriction<R>>
    PowerLawFriction<R> for LeanProfile<R, P>
{
    fn exponent(&self) -> R {
        R::ZERO
    }

    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        // F/v and T/w are even in both speeds: a slow one stands for none.
        let slow = R::from_f64(SLOW);
        let [slide, rim] = [at.slide, at.rim].map(|x| if x < slow { slow } else { x });
        let (wrench, _) = FullGradient::balance(&self.foot, [slide, rim], self.lean);
        [wrench.force / slide, wrench.torque / rim]
    }
}
