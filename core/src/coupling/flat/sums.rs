//! Sums over points that each carry a share of the load, two points at a time.
//!
//! Real points, or those of a rule on a triangle. The forms are those of [`super::pole_near`] and
//! [`super::pole_far`]: about a centre of rotation with ρ the place relative to it
//!
//! ```text
//! Σ k ρ/r,   Σ k r,   and for D″  Σ k ρρ/r³
//! ```
//!
//! and for a patch that slides more than it turns, in which nothing is lost as w → 0,
//!
//! ```text
//! Σ k x²/(q s),   Σ k x (y − w x²/s)/q,   Σ k x² (1 + q)/(q s),   and for D″  Σ k (g², x g, x²)/q³
//! ```

use super::pair_of_numbers::Pair2;
use super::{Hessian, Reduced};
use crate::real::Real;
use nalgebra::Vector2;

/// Three sums of the friction and three of the second derivatives.
pub(super) struct WrenchSums<R>([Pair2<R>; 6]);

impl<R: Real> WrenchSums<R> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self([Pair2::of(R::ZERO); 6])
    }

    #[inline(always)]
    fn add<const N: usize>(&mut self, parts: [Pair2<R>; N]) {
        let Self(sums) = self;
        for (sum, part) in sums.iter_mut().zip(parts) {
            *sum = *sum + part;
        }
    }

    /// Sums that another form has found, of which the second half may be missing.
    #[inline(always)]
    pub(super) fn add_found<const N: usize>(&mut self, found: [R; N]) {
        self.add(found.map(|part| Pair2([part, R::ZERO])));
    }

    /// Two points about the centre of rotation, which lies on neither of them.
    #[inline(always)]
    pub(super) fn turn<const WITH_HESSIAN: bool>(
        &mut self,
        [x, y]: [Pair2<R>; 2],
        share: Pair2<R>,
    ) {
        let r = (x * x + y * y).sqrt();
        let inv = r.inverse();
        let rate = share * inv;
        let (pull_x, pull_y) = (rate * x, rate * y);
        if WITH_HESSIAN {
            let inv_sq = inv * inv;
            let (x, y) = (x * inv_sq, y * inv_sq);
            self.add([
                pull_x,
                pull_y,
                share * r,
                pull_x * x,
                pull_x * y,
                pull_y * y,
            ]);
        } else {
            self.add([pull_x, pull_y, share * r]);
        }
    }

    /// Two points that slide along x.
    #[inline(always)]
    pub(super) fn slide<const WITH_HESSIAN: bool>(
        &mut self,
        w: Pair2<R>,
        at: [Pair2<R>; 2],
        share: Pair2<R>,
    ) {
        let [a, b, c] = slid(w, at).map(|part| share * part);
        if WITH_HESSIAN {
            let [d, e, f] = bent(w, at).map(|part| share * part);
            self.add([a, b, c, d, e, f]);
        } else {
            self.add([a, b, c]);
        }
    }

    /// Friction and second derivatives about a centre of rotation.
    pub(super) fn turned(&self, centre: &Vector2<R>, spin: R) -> (Reduced<R>, Hessian<R>) {
        let Self(sums) = self;
        let [x, y, turn, xx, xy, yy] = sums.map(Pair2::sum);
        let sense = R::ONE.copysign(spin);
        let force = Vector2::new(sense * y, -(sense * x));
        let torque = centre.x * force.y - centre.y * force.x - sense * turn;
        let hessian = Hessian::about(centre, [xx, xy, yy]);
        (
            Reduced { force, torque },
            hessian.scaled(R::ONE / spin.abs()),
        )
    }

    /// Friction and second derivatives of a patch that slides.
    pub(super) fn slid(
        &self,
        slide: &super::pole_far::TranslatingMotion<'_, R>,
        speed: R,
    ) -> (Reduced<R>, Hessian<R>) {
        let Self(sums) = self;
        let [missing, across, torque, yy, yn, nn] = sums.map(Pair2::sum);
        let hessian = slide.hessian_of([yy, yn, nn]);
        (
            slide.reduced_of([missing, across, torque]),
            hessian.scaled(R::ONE / speed),
        )
    }
}

/// x²/(q s), x (y − w x²/s)/q and x² (1 + q)/(q s) at two points.
#[inline(always)]
pub(super) fn slid<R: Real>(w: Pair2<R>, [x, y]: [Pair2<R>; 2]) -> [Pair2<R>; 3] {
    let one = Pair2::of(R::ONE);
    let (g, wx) = (one - w * y, w * x);
    let q = (g * g + wx * wx).sqrt();
    let (inv_q, inv_s) = (q.inverse(), (q + g).inverse());
    let missing = x * x * inv_q * inv_s;
    let across = x * (y - wx * x * inv_s) * inv_q;
    [missing, across, missing * (one + q)]
}

/// (g², x g, x²)/q³ at two points.
#[inline(always)]
pub(super) fn bent<R: Real>(w: Pair2<R>, [x, y]: [Pair2<R>; 2]) -> [Pair2<R>; 3] {
    let (g, wx) = (Pair2::of(R::ONE) - w * y, w * x);
    let q_sq = g * g + wx * wx;
    let inv_cube = (q_sq * q_sq.sqrt()).inverse();
    [g * g * inv_cube, x * g * inv_cube, x * x * inv_cube]
}
