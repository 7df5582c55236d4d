//! The case that sliding and rolling both slip: two angles instead of two vectors.
//!
//! In the contact plane, with the rolling torque turned by a right angle and both in units of their
//! thresholds, the equations of the contact are
//!
//! ```text
//! α p − κ₁ t = P,   β t − κ₂ p = T,   |p| = |t| = 1
//! ```
//!
//! with the multipliers α ≥ 1 and β ≥ 1 of the two circles. Their components across p and t,
//! p × (P + κ₁ t) = 0 and t × (T + κ₂ p) = 0, determine the two directions. Newton's method turns
//! these, without a square root. The problem is convex: a solution with such α and β is the only one.

use super::plane::{Planar, add_scaled, cross, dot, unit};
use crate::real::Real;

/// Newton steps at most; from a guess within 0.1 rad three bring nearly all contacts to rounding.
const MOST_STEPS: usize = 7;

/// The equations, in units of the thresholds.
pub(super) struct BothSlip<R> {
    /// P
    pub(super) sliding: Planar<R>,
    /// T
    pub(super) rolling: Planar<R>,
    /// κ₁ and κ₂
    pub(super) couplings: [R; 2],
}

impl<R: Real> BothSlip<R> {
    /// P + κ₁ t, along which the contact slides.
    #[inline(always)]
    pub(super) fn pull(&self, t: Planar<R>) -> Planar<R> {
        add_scaled(self.sliding, self.couplings[0], t)
    }

    /// T + κ₂ p, along which it rolls.
    #[inline(always)]
    pub(super) fn twist(&self, p: Planar<R>) -> Planar<R> {
        add_scaled(self.rolling, self.couplings[1], p)
    }

    /// Directions nearer to the solution than [p, t]: each under the other.
    #[inline(always)]
    pub(super) fn nearer(&self, [p, t]: [Planar<R>; 2]) -> [Planar<R>; 2] {
        [unit(self.pull(t)), unit(self.twist(p))]
    }

    /// The directions p and t, from a guess.
    ///
    /// `None` where not both slip, and where Newton's method does not find them.
    #[inline(always)]
    pub(super) fn solve(&self, [mut p, mut t]: [Planar<R>; 2]) -> Option<[Planar<R>; 2]> {
        let [to_sliding, to_rolling] = self.couplings;
        let shared = to_sliding * to_rolling;
        for _ in 0..MOST_STEPS {
            let (pull, twist) = (self.pull(t), self.twist(p));
            let (alpha, beta, cosine) = (dot(p, pull), dot(t, twist), dot(p, t));
            let (across_p, across_t) = (cross(p, pull), cross(t, twist));
            let inverse = R::ONE / (alpha * beta - shared * (cosine * cosine));
            let angle_p = (across_p * beta + across_t * (to_sliding * cosine)) * inverse;
            let angle_t = (across_t * alpha + across_p * (to_rolling * cosine)) * inverse;
            let convex = alpha > R::ZERO && inverse > R::ZERO;
            if !convex {
                return None;
            }
            // The next error is the square of this one.
            if angle_p * angle_p + angle_t * angle_t <= R::EPSILON {
                (p, t) = (turned_little(p, angle_p), turned_little(t, angle_t));
                let slips = dot(p, self.pull(t)) >= R::ONE && dot(t, self.twist(p)) >= R::ONE;
                return slips.then_some([p, t]);
            }
            (p, t) = (turned(p, angle_p), turned(t, angle_t));
        }
        None
    }
}

/// A unit vector turned by an angle, to the third order; its length stays.
#[inline(always)]
fn turned<R: Real>([x, y]: Planar<R>, angle: R) -> Planar<R> {
    let half = R::HALF * angle;
    let inverse = R::ONE / (R::ONE + half * half);
    let (cos, sin) = ((R::ONE - half * half) * inverse, angle * inverse);
    [x * cos - y * sin, y * cos + x * sin]
}

/// A vector near unit length turned by an angle whose third power is below rounding, and brought to
/// unit length.
#[inline(always)]
fn turned_little<R: Real>([x, y]: Planar<R>, angle: R) -> Planar<R> {
    let less = R::HALF * (angle * angle + (dot([x, y], [x, y]) - R::ONE));
    [x - (y * angle + x * less), y + (x * angle - y * less)]
}
