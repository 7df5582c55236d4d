//! The case that sliding and rolling both slip: two Lagrange multipliers instead of two motions.
//!
//! In the plane, with the rolling torque turned by a right angle (τ′ = n × τ), the two equations of
//! a contact whose sliding force has the length a and whose rolling torque has the length b are
//!
//! ```text
//! A p − k τ′ = P,   B τ′ − k p = T,   |p| = a,   |τ′| = b
//! ```
//!
//! with A ≥ 1/m and B ≥ 1/I, the multipliers of the two circles added to the inverse masses. For
//! given A and B they are linear; Newton's method finds A and B, on 1/|p| and 1/|τ′|, which are
//! nearly linear in them (Moré & Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553).

use super::vector::dot;
use crate::real::Real;
use nalgebra::Vector3;

/// Newton steps at most; four bring most contacts to rounding.
const MOST_STEPS: usize = 6;

/// The linear system.
pub(super) struct DualSlipSystem<R: Real> {
    pub(super) inv_mass: R,
    pub(super) inv_inertia: R,
    /// k
    pub(super) coupling: R,
    /// P and T
    pub(super) sliding: Vector3<R>,
    pub(super) rolling: Vector3<R>,
}

impl<R: Real> DualSlipSystem<R> {
    /// The turned rolling torque τ′, from a guess `[p, τ′]` whose lengths are a and b.
    ///
    /// `None` where Newton's method leaves the domain, and where squares leave the number range.
    #[inline(never)]
    pub(super) fn rolling(&self, [p, t]: [&Vector3<R>; 2]) -> Option<Vector3<R>> {
        let (k, a, b) = (self.coupling, length(p), length(t));
        let mut multiplier = [
            length(&(self.sliding + t * k)) / a,
            length(&(self.rolling + p * k)) / b,
        ];
        for _ in 0..MOST_STEPS {
            let [first, second] = multiplier;
            let inverse = R::ONE / (first * second - k * k);
            let p = (self.sliding * second + self.rolling * k) * inverse;
            let t = (self.rolling * first + self.sliding * k) * inverse;
            let (pp, tt, pt) = (length(&p), length(&t), dot(&p, &t));
            let [over_p, over_t] = [pp / a - R::ONE, tt / b - R::ONE];
            // −∂(|p|, |τ′|)/∂(A, B) and the lengths that are too many.
            let [xx, xy] = [second * pp * inverse, k * pt * inverse / pp];
            let [yx, yy] = [k * pt * inverse / tt, first * tt * inverse];
            let determinant = xx * yy - xy * yx;
            let [x, y] = [over_p * pp, over_t * tt];
            multiplier = [
                first + (x * yy - y * xy) / determinant,
                second + (y * xx - x * yx) / determinant,
            ];
            let admissible = multiplier[0] >= self.inv_mass && multiplier[1] >= self.inv_inertia;
            if !admissible {
                return None;
            }
            // The next error is the square of this one.
            if over_p * over_p + over_t * over_t <= R::EPSILON {
                let [first, second] = multiplier;
                let inverse = R::ONE / (first * second - k * k);
                return Some((self.rolling * first + self.sliding * k) * inverse);
            }
        }
        None
    }
}

/// |a|, if its square is in the number range.
#[inline(always)]
fn length<R: Real>(a: &Vector3<R>) -> R {
    dot(a, a).sqrt()
}
