//! Friction of a patch with curved sides under uniform pressure, for every motion.
//!
//! The integrals of [`super::uniform`] are along the boundary, whatever its form: with its quantities at a point, a step
//! dx along the boundary adds
//!
//! ```text
//! force   p dx                             torque   p (x × dx) − 2 p″ v·dx
//! D_vv    dx ⊗ (z × x − û (α + w p))       D_vw     ε dx,   ε = −[p + w² (α² − p + w α p)]/q
//! D_ww    χ v·dx,   χ = [p₀ (α + w p) − p″ − w (α² − p + w α p)]/q,   p₀ = ((v·x)² − 1)/2
//! ```
//!
//! in which nothing is divided by a speed of the whole. On an arc x = m + (P (1−z²) + 2 Q z)/(1+z²) Gauss' rule serves, on
//! panels that keep clear of the places where q = 0: with vectors as complex numbers and the centre of rotation
//! c, w (m − c)(1+z²) + w P (1−z²) + 2 w Q z = 0. Straight sides keep their closed forms.

use super::motion::Motion;
use super::moving_edge::{MovingEdge, UnitMotion};
use super::panels::{Complex, Panels};
use super::{COMPACT, Hessian, PatchShape, Reduced, uniform};
use crate::patch::arcs::{Arc, ArcOutline, Side, SideCourse};
use crate::real::Real;
use nalgebra::Vector2;

impl<R: Real, S: AsRef<[Side<R>]>> PatchShape<R> for ArcOutline<R, S> {
    fn centre(&self) -> Vector2<R> {
        ArcOutline::centre(self)
    }

    fn radius(&self) -> R {
        ArcOutline::radius(self)
    }

    /// Integrals along opposite sides cancel each other but for the width between them.
    fn rounding(&self) -> R {
        let slender = R::from_f64(COMPACT) * self.boundary() / self.reduced_area();
        R::EPSILON * if slender > R::ONE { slender } else { R::ONE }
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        let (motion, _) = UnitMotion::of(motion);
        let mut sums = [R::ZERO; 3];
        for side in self.sides() {
            let parts = match &side.0 {
                SideCourse::Straight(edge) => {
                    let edge = core::slice::from_ref(edge);
                    uniform::summed::<R, R::Several, 3>(edge, &motion, MovingEdge::wrench)
                }
                SideCourse::Curved(arc) => along(arc, &motion, Passed::wrench),
            };
            add(&mut sums, parts);
        }
        uniform::reduced(sums, &motion, R::ONE / self.reduced_area())
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        let (motion, rate) = UnitMotion::of(motion);
        let mut sums = [R::ZERO; 9];
        for side in self.sides() {
            let parts = match &side.0 {
                SideCourse::Straight(edge) => {
                    let edge = core::slice::from_ref(edge);
                    uniform::summed::<R, R::Several, 9>(
                        edge,
                        &motion,
                        MovingEdge::wrench_and_hessian,
                    )
                }
                SideCourse::Curved(arc) => along(arc, &motion, Passed::wrench_and_hessian),
            };
            add(&mut sums, parts);
        }
        uniform::reduced_and_hessian(sums, (motion, rate), R::ONE / self.reduced_area())
    }
}

#[inline(always)]
fn add<R: Real, const N: usize>(sums: &mut [R; N], parts: [R; N]) {
    for (sum, part) in sums.iter_mut().zip(parts) {
        *sum += part;
    }
}

/// Shortest panel, in roots of a rounding error: about a point next to the boundary less is not seen.
const LEAST: f64 = 0.5;

/// Longest panel: a third of a turn, 2 tan(π/6), and some rounding errors.
const MOST: f64 = 1.154_8;

/// Sums along an arc.
fn along<R: Real, const N: usize>(
    arc: &Arc<R>,
    motion: &UnitMotion<R>,
    of: impl Fn(&Passed<R>) -> [R; N],
) -> [R; N] {
    let marks = places_at_rest(arc, motion);
    let end = arc.reach;
    // From the place next to the centre of rotation on.
    let [one, other] = marks;
    let nearest = if other.height() < one.height() {
        other
    } else {
        one
    }
    .re();
    let start = if nearest > end {
        end
    } else if nearest > -end {
        nearest
    } else {
        -end
    };
    let panels = Panels {
        end,
        start,
        least: R::from_f64(LEAST) * R::EPSILON.sqrt(),
        most: R::from_f64(MOST),
        marks,
    };
    let mut sums = [R::ZERO; N];
    panels.joined().each(&mut |z, _, weight| {
        let [at, slope] = arc.point_and_slope(z);
        add(&mut sums, of(&Passed::new(motion, at, slope * weight)));
    });
    sums
}

/// Where the speed vanishes, in the complex plane of z.
fn places_at_rest<R: Real>(arc: &Arc<R>, motion: &UnitMotion<R>) -> [Complex<R>; 2] {
    let w = motion.spin;
    let number = |v: Vector2<R>| Complex::new(w * v.x, w * v.y);
    let [p, q] = arc.half_diameters.map(number);
    let from_pole = number(arc.middle).plus(Complex::new(motion.y, -motion.x));
    // (M − P) z² + 2 Q z + (M + P) = 0
    let (square, whole) = (from_pole.plus(p.negative()), from_pole.plus(p));
    let root = q.times(q).plus(square.times(whole).negative()).sqrt();
    let [one, other] = [root, root.negative()].map(|root| root.plus(q.negative()));
    let large = if one.size_sq() > other.size_sq() {
        one
    } else {
        other
    };
    [large.times(square.inverse()), whole.times(large.inverse())]
}

/// A point of the boundary that is passed by a step.
struct Passed<R: Real> {
    motion: UnitMotion<R>,
    at: Vector2<R>,
    step: Vector2<R>,
    /// v·step
    ahead: R,
    /// Velocity.
    u: Vector2<R>,
    q: R,
    /// α
    arm: R,
    p: R,
    /// p″
    rest: R,
}

impl<R: Real> Passed<R> {
    #[inline(always)]
    fn new(motion: &UnitMotion<R>, at: Vector2<R>, step: Vector2<R>) -> Self {
        let UnitMotion { x, y, spin: w } = *motion;
        let u = Vector2::new(x - w * at.y, y + w * at.x);
        let q = (u.x * u.x + u.y * u.y).sqrt();
        let arm = y * at.x - x * at.y;
        let sq = at.x * at.x + at.y * at.y;
        let inverse = R::ONE / (q + R::ONE);
        let excess = sq - R::ONE;
        let p = (excess - arm * (arm + arm + w * excess) * inverse) * inverse;
        Self {
            motion: *motion,
            at,
            step,
            ahead: x * step.x + y * step.y,
            u,
            q,
            arm,
            p,
            rest: R::HALF * w * sq - p * (arm + R::HALF * w * p),
        }
    }

    #[inline(always)]
    fn wrench(&self) -> [R; 3] {
        let (at, step, p) = (&self.at, &self.step, self.p);
        let swept = at.x * step.y - at.y * step.x;
        let turn = p * swept - R::TWO * self.rest * self.ahead;
        [p * step.x, p * step.y, turn]
    }

    #[inline(always)]
    fn wrench_and_hessian(&self) -> [R; 9] {
        let [x, y, turn] = self.wrench();
        let UnitMotion {
            x: vx,
            y: vy,
            spin: w,
        } = self.motion;
        let Self {
            at, step, arm, p, ..
        } = self;
        let inverse = R::ONE / (self.q + R::MIN_POSITIVE);
        let gain = *arm + w * *p;
        let (kx, ky) = (
            -at.y - self.u.x * inverse * gain,
            at.x - self.u.y * inverse * gain,
        );
        let bent = *arm * *arm - *p + w * *arm * *p;
        let mixed = -(*p + w * w * bent) * inverse;
        let along = vx * at.x + vy * at.y;
        let free = R::HALF * (along * along - R::ONE);
        let chi = (free * gain - self.rest - w * bent) * inverse;
        [
            x,
            y,
            turn,
            step.x * kx,
            R::HALF * (step.x * ky + step.y * kx),
            step.y * ky,
            -(mixed * step.x),
            -(mixed * step.y),
            chi * self.ahead,
        ]
    }
}

#[cfg(test)]
#[path = "arcs_tests.rs"]
mod tests;
