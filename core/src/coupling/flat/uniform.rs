//! Friction of a patch with straight edges under uniform pressure: one form for every motion.
//!
//! With the quantities of [`super::moving_edge`] the divergence theorem gives
//!
//! ```text
//! force = −(v + w Σ τ β/area),     torque = −w [2 + Σ (H β − 2 (v·τ) β″)/area]/3
//! ```
//!
//! *Second derivatives* of the power follow from the integrals of 1/q along the edges, in which
//! κ̄ = 2 (ᾱ² − p̄ + w ᾱ p̄)/S and λ = l (κ̄ + 2 l² g/S³):
//!
//! ```text
//! D_vv = Σ τ ⊗ [(l (H − η ᾱ) + w η λ) τ − Δp n]/area,     Δp = (2 l/S) [v·n (ᾱ + w p̄) + x̄·τ]
//! D_vw = −w v − Σ τ ε/area,         ε = 2 l³ g η (v·τ)/S³ − 2 l (p̄ + w² (ᾱ² − p̄ + w ᾱ p̄))/S
//! D_ww = v² + Σ (v·τ) χ/area,       w χ = ε + ∫((v·x)² − 1) dl/2
//! ```
//!
//! with the middle x̄ of an edge. Nothing is divided by a speed or a spin.

use super::motion::Motion;
use super::moving_edge::{Corner, MovingEdge, Sides, UnitMotion, splat};
use super::{Hessian, Reduced};
use crate::lanes::{FOUR, Summed};
use crate::patch::outline::Edge;
use crate::real::Real;
use nalgebra::Vector2;

/// Reduced friction of a patch with this area.
#[inline]
pub(super) fn friction<R: Real>(edges: &[Edge<R>], area: R, motion: &Motion<R>) -> Reduced<R> {
    let (motion, _) = UnitMotion::of(motion);
    let sums = summed::<R, R::Several, 3>(edges, &motion, MovingEdge::wrench);
    reduced(sums, &motion, R::ONE / area)
}

/// Sums over the edges, four of which are formed side by side.
#[inline(always)]
pub(super) fn summed<R: Real, L: Summed<Real = R>, const N: usize>(
    edges: &[Edge<R>],
    motion: &UnitMotion<R>,
    of: impl Fn(&MovingEdge<L>) -> [L; N],
) -> [R; N] {
    let motion = motion.repeated();
    let mut sums = [L::none(); N];
    let mut last = None;
    for four in edges.chunks(FOUR) {
        for (first, group) in four.chunks(L::COUNT).enumerate() {
            let sides = Sides::of(group);
            // One by one, a corner that two edges share is computed once.
            let from = match (&last, group) {
                (Some((end, corner)), [edge]) if L::COUNT == 1 && *end == edge.start() => *corner,
                _ => Corner::new(&motion, sides.from),
            };
            let to = Corner::new(&motion, sides.to);
            last = group.last().map(|edge| (edge.end(), to));
            let parts = of(&MovingEdge::new(&motion, sides, [&from, &to]));
            for (sum, part) in sums.iter_mut().zip(parts) {
                part.add_to(sum, first);
            }
        }
    }
    let mut totals = [R::ZERO; N];
    for (total, sum) in totals.iter_mut().zip(&sums) {
        *total = L::total(sum);
    }
    totals
}

/// Friction of the sums of [`MovingEdge::wrench`].
#[inline(always)]
pub(super) fn reduced<R: Real>(
    [x, y, turn]: [R; 3],
    motion: &UnitMotion<R>,
    share: R,
) -> Reduced<R> {
    let w = motion.spin;
    let by = w * share;
    let third = R::from_f64(1.0 / 3.0);
    Reduced {
        force: Vector2::new(-(motion.x + by * x), -(motion.y + by * y)),
        torque: -(third * w * (R::TWO + share * turn)),
    }
}

/// The same, and second derivatives of the dissipated power.
pub(super) fn friction_and_hessian<R: Real>(
    edges: &[Edge<R>],
    area: R,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let (motion, rate) = UnitMotion::of(motion);
    let sums = summed::<R, R::Several, 9>(edges, &motion, MovingEdge::wrench_and_hessian);
    reduced_and_hessian(sums, (motion, rate), R::ONE / area)
}

/// Friction and second derivatives of the sums of [`MovingEdge::wrench_and_hessian`].
#[inline(always)]
pub(super) fn reduced_and_hessian<R: Real>(
    [fx, fy, turn, xx, xy, yy, xn, yn, nn]: [R; 9],
    (motion, rate): (UnitMotion<R>, R),
    share: R,
) -> (Reduced<R>, Hessian<R>) {
    let (x, y, w) = (motion.x, motion.y, motion.spin);
    let hessian = Hessian {
        xx: share * xx,
        xy: share * xy,
        yy: share * yy,
        xn: share * xn - w * x,
        yn: share * yn - w * y,
        nn: share * nn + (x * x + y * y),
    };
    let hessian = hessian.across([x, y, w]).scaled(rate);
    (reduced([fx, fy, turn], &motion, share), hessian)
}

impl<R: Real> Hessian<R> {
    /// The part across a twist of length 1, along which dry friction does not change.
    pub(super) fn across(&self, [x, y, n]: [R; 3]) -> Self {
        let to_x = self.xx * x + self.xy * y + self.xn * n;
        let to_y = self.xy * x + self.yy * y + self.yn * n;
        let to_n = self.xn * x + self.yn * y + self.nn * n;
        let half = R::HALF * (to_x * x + to_y * y + to_n * n);
        let (to_x, to_y, to_n) = (to_x - half * x, to_y - half * y, to_n - half * n);
        Self {
            xx: self.xx - (to_x * x + to_x * x),
            xy: self.xy - (to_x * y + to_y * x),
            yy: self.yy - (to_y * y + to_y * y),
            xn: self.xn - (to_x * n + to_n * x),
            yn: self.yn - (to_y * n + to_n * y),
            nn: self.nn - (to_n * n + to_n * n),
        }
    }
}

impl<L: Summed<Real: Real>> MovingEdge<L> {
    /// τ β and H β − 2 (v·τ) β″
    #[inline(always)]
    pub(super) fn wrench(&self) -> [L; 3] {
        let (beta, [x, y]) = (self.beta(), self.sides.tangent);
        let rest = self.along * self.beta_rest();
        [x * beta, y * beta, self.sides.offset * beta - (rest + rest)]
    }

    #[inline(always)]
    pub(super) fn wrench_and_hessian(&self) -> [L; 9] {
        let ([a, b, c], [d, e, f, g, h, i]) = (self.wrench(), self.hessian());
        [a, b, c, d, e, f, g, h, i]
    }

    /// What the edge contributes to the second derivatives xx, xy, yy, xn, yn and nn, of the area.
    #[inline(always)]
    fn hessian(&self) -> [L; 6] {
        let Self {
            spin: w,
            along,
            eta,
            p,
            arm,
            reach_sq,
            sigma,
            log,
            ..
        } = *self;
        let Sides {
            tangent: [x, y],
            length,
            offset,
            ..
        } = self.sides;
        let (half, two, twice) = (L::splat(0.5), L::splat(2.0), self.inv_sum + self.inv_sum);
        // κ̄ S/2
        let kappa = arm * arm - p + w * arm * p;
        // Velocities.
        let lambda = twice * (kappa + reach_sq * log);
        let lengthwise = length * (offset - eta * arm + w * eta * lambda);
        let rise = length * twice * (self.across * sigma + self.sides.middle());
        let xx = lengthwise * x * x - rise * x * y;
        let xy = lengthwise * x * y - half * rise * (y * y - x * x);
        let yy = lengthwise * y * y + rise * x * y;
        // Velocities and spin: ε.
        let mixed = length * twice * (reach_sq * log * eta * along - (p + w * w * kappa));
        // Spin: χ.
        let sum = two + two * w * sigma;
        let spread = splat::<L>(1.0 / 6.0) * sigma * (L::splat(4.0) + sum * (two + sum));
        let left = splat::<L>(2.0 / 3.0) * offset - along * spread;
        let turned = left + two * w * reach_sq * self.bend * eta;
        let chi = arm * p - self.rest - w * twice * kappa * (L::splat(1.0) + p)
            + reach_sq * self.inv_sum * along * turned;
        [
            xx,
            xy,
            yy,
            -(mixed * x),
            -(mixed * y),
            along * (length * chi),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Edges of any place and length, and any motion.
    fn edges_and_motion<R: Real>(seed: u32, edges: &mut [Edge<R>]) -> UnitMotion<R> {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            R::from_f64(f64::from(state >> 8) / f64::from(1 << 23) - 1.0)
        };
        for edge in edges {
            let [from, to] = [(); 2].map(|()| Vector2::new(next(), next()));
            *edge = Edge::new(from, to);
        }
        let (velocity, rim) = (Vector2::new(next(), next()), next());
        UnitMotion::of(&Motion { velocity, rim }).0
    }

    fn bits_agree<R: Real, L: Summed<Real = R>>() {
        for seed in 0..2000 {
            let mut memory = [Edge::<R>::default(); 9];
            let (edges, _) = memory.split_at_mut(1 + seed as usize % 9);
            let motion = edges_and_motion(seed, edges);
            let of_one = summed::<R, L, 9>(edges, &motion, MovingEdge::wrench_and_hessian);
            let of_four =
                summed::<R, R::Several, 9>(edges, &motion, MovingEdge::wrench_and_hessian);
            assert_eq!(of_one, of_four, "{seed}");
        }
    }

    #[test]
    fn edges_side_by_side_give_the_bits_of_one_by_one() {
        bits_agree::<f64, f64>();
        bits_agree::<f32, f32>();
    }
}
