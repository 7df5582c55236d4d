//! Friction of a bar: the line integrals themselves.
//!
//! About a centre of rotation with ρ = h n + t τ (see [`super::pole_near`])
//!
//! ```text
//! ∫ρ/r dt = h L n + (r₁ − r₀) τ,     ∫r dt = I,     ∫ρρ/r³ dt = nn [t/r] − (nτ + τn) h [1/r] + ττ (L − [t/r])
//! ```
//!
//! and for a bar that slides more than it turns, with the velocity (g, w x) of a point as in
//! [`super::pole_far`], Gauss' rule on
//!
//! ```text
//! force along e = −1 + w² ⟨x²/(q s)⟩,   across −w² ⟨x (y − w x²/s)/q⟩,   torque −w ⟨x² (1 + q)/(q s)⟩
//! D″ = ⟨(g², x g, x²)/q³⟩
//! ```
//!
//! with means along the bar. Second derivatives are infinite where the centre lies on the bar: a large
//! number stands for them.

use super::motion::{Motion, SplitMotion};
use super::pair_of_numbers::Pair2;
use super::pole_far::{EdgePairs, FOR_HESSIAN, FOR_WRENCH, TranslatingMotion, by_rule};
use super::pole_near::EdgeFromPole;
use super::sums::{self, slid};
use super::{Hessian, PatchShape, Reduced};
use crate::patch::bar::Bar;
use crate::real::Real;
use nalgebra::Vector2;

impl<R: Real> PatchShape<R> for Bar<R> {
    fn centre(&self) -> Vector2<R> {
        Bar::centre(self)
    }

    fn radius(&self) -> R {
        Bar::radius(self)
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        match motion.split() {
            SplitMotion::Turns { centre, spin } => turning(self, &centre, R::ONE.copysign(spin)).0,
            SplitMotion::Slides {
                direction, turn, ..
            } => {
                let (direction, spin) = (&direction, turn);
                sliding(self, &TranslatingMotion { direction, spin })
            }
        }
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        match motion.split() {
            SplitMotion::Turns { centre, spin } => {
                let (reduced, hessian) = turning(self, &centre, R::ONE.copysign(spin));
                (reduced, hessian.scaled(R::ONE / spin.abs()))
            }
            SplitMotion::Slides {
                direction,
                turn,
                speed,
            } => {
                let (direction, spin) = (&direction, turn);
                let slide = TranslatingMotion { direction, spin };
                let hessian = bent(self, &slide).scaled(R::ONE / speed);
                (sliding(self, &slide), hessian)
            }
        }
    }
}

fn turning<R: Real>(bar: &Bar<R>, centre: &Vector2<R>, sense: R) -> (Reduced<R>, Hessian<R>) {
    let edge = bar.edge();
    let seen = EdgeFromPole::new(edge, centre);
    let (n, t, h) = (edge.normal(), edge.tangent(), seen.h);
    let share = R::ONE / edge.length();
    let pull = n * (h * seen.log) + t * seen.rise;
    let force = Vector2::new(sense * pull.y, -(sense * pull.x)) * share;
    let torque = centre.x * force.y - centre.y * force.x - sense * seen.integral * share;
    let inverse = |r: R| R::ONE / (r + R::MIN_POSITIVE);
    let (i0, i1) = (inverse(seen.r0), inverse(seen.r1));
    let nn = seen.t1 * i1 - seen.t0 * i0;
    let nt = -(h * i1 - h * i0);
    let tt = seen.log - nn;
    let both = R::TWO * nt;
    let xx = (nn * n.x * n.x + both * n.x * t.x + tt * t.x * t.x) * share;
    let yy = (nn * n.y * n.y + both * n.y * t.y + tt * t.y * t.y) * share;
    let xy = (nn * n.x * n.y + nt * (n.x * t.y + n.y * t.x) + tt * t.x * t.y) * share;
    (
        Reduced { force, torque },
        Hessian::about(centre, [xx, xy, yy]),
    )
}

fn sliding<R: Real>(bar: &Bar<R>, slide: &TranslatingMotion<'_, R>) -> Reduced<R> {
    let spin = slide.spin;
    let at = |at| slid(Pair2::of(spin), at);
    let [missing, across, torque] = mean(bar, slide, at, FOR_WRENCH);
    slide.reduced_of([missing, across, torque])
}

fn bent<R: Real>(bar: &Bar<R>, slide: &TranslatingMotion<'_, R>) -> Hessian<R> {
    let spin = slide.spin;
    let at = |at| sums::bent(Pair2::of(spin), at);
    let [yy, yn, nn] = mean(bar, slide, at, FOR_HESSIAN);
    slide.hessian_of([yy, yn, nn])
}

/// Means of functions of a point along the bar.
fn mean<R: Real>(
    bar: &Bar<R>,
    slide: &TranslatingMotion<'_, R>,
    at: impl Fn([Pair2<R>; 2]) -> [Pair2<R>; 3],
    thresholds: [f64; 4],
) -> [R; 3] {
    let edge = bar.edge();
    let along = R::ONE / edge.length();
    let sums = EdgePairs {
        slide,
        edges: core::slice::from_ref(edge),
        along: Some(along),
        at,
    };
    by_rule(&sums, slide.spin.abs(), thresholds)
}
