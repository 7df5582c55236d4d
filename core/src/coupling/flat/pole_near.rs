//! Friction of a patch with straight edges under linear pressure whose centre of rotation is on the patch or not far away.
//!
//! With the centre c, ρ = x − c and r = |ρ| the divergences div(ρ r) = 3 r and div(r) = ρ/r turn the
//! area integrals into integrals along the edges. An edge with tangent τ and outward normal n lies
//! h = ρ·n away from c and reaches from t₀ to t₁ = t₀ + l, at the distances r₀ and r₁:
//!
//! ```text
//! L = ∫dt/r = ln((r₀ + r₁ + l)/(r₀ + r₁ − l))
//! I = ∫r dt = l/4 [r₀ + r₁ + (t₀ + t₁)²/(r₀ + r₁)] + h² L/2
//!
//! ∫r dA = Σ h I/3,     ∫ρ/r dA = Σ n I,     ∫(1 − ρρ/r²)/r dA = Σ (h L n + (r₁ − r₀) τ) n
//! ```
//!
//! No term of I cancels another one. r₀ + r₁ − l is the sum of r + t at the first corner and r − t at
//! the second one, of which the one that cancels is h²/(r + |t|). Where h = 0 only h L occurs, which
//! is 0. A linear pressure adds moments of one order more; all of them are homogeneous in ρ, so that
//! the same theorem applies.

use super::{Hessian, Reduced};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use crate::special::log_quotient;
use nalgebra::Vector2;

/// One edge seen from the centre of rotation.
pub(super) struct EdgeFromPole<R> {
    /// Distance of the edge's line, positive where the patch lies on this side of it.
    pub(super) h: R,
    pub(super) t0: R,
    pub(super) t1: R,
    pub(super) r0: R,
    pub(super) r1: R,
    /// r₁ − r₀
    pub(super) rise: R,
    /// L, or a large number where it is infinite.
    pub(super) log: R,
    /// I
    pub(super) integral: R,
}

impl<R: Real> EdgeFromPole<R> {
    #[inline(always)]
    pub(super) fn new(edge: &Edge<R>, centre: &Vector2<R>) -> Self {
        let (tangent, normal, length) = (edge.tangent(), edge.normal(), edge.length());
        let h = edge.offset() - (centre.x * normal.x + centre.y * normal.y);
        let t0 = edge.along() - (centre.x * tangent.x + centre.y * tangent.y);
        let t1 = t0 + length;
        let h_sq = h * h;
        let ends = [t0, t1].map(|t| (h_sq + t * t).sqrt());
        Self::between(h, [t0, t1], ends, length)
    }

    /// An edge at the distance `h` from `t0` to `t1`, whose ends are as far away as `ends` says.
    #[inline(always)]
    pub(super) fn between(h: R, [t0, t1]: [R; 2], ends: [R; 2], length: R) -> Self {
        let (h_sq, [r0, r1]) = (h * h, ends);
        let (sum, middle) = (r0 + r1, t0 + t1);
        // r + t at the first corner and r − t at the second one without cancellation, as quotients.
        let (a0, a1) = (r0 + t0.abs(), r1 + t1.abs());
        let (n0, d0) = if t0 > R::ZERO {
            (a0, R::ONE)
        } else {
            (h_sq, a0)
        };
        let (n1, d1) = if t1 < R::ZERO {
            (a1, R::ONE)
        } else {
            (h_sq, a1)
        };
        let gap = n0 * d1 + n1 * d0 + R::MIN_POSITIVE * R::from_f64(LEAST_GAP);
        let log = log_quotient(R::TWO * length * (d0 * d1), gap);
        let mean = middle / sum;
        let quarter = R::HALF * R::HALF;
        Self {
            h,
            t0,
            t1,
            r0,
            r1,
            rise: length * mean,
            log,
            integral: quarter * length * (sum + middle * mean) + R::HALF * h_sq * log,
        }
    }
}

/// Smallest gap, where the centre lies on the edge, in smallest normal numbers.
const LEAST_GAP: f64 = 8.0;

/// Reduced friction about the centre of pressure for the spin `sense` (±1) about `centre`.
#[inline]
pub(super) fn friction<R: Real, K: PressureField<R>>(
    edges: &[Edge<R>],
    pressure: &K,
    centre: &Vector2<R>,
    sense: R,
) -> Reduced<R> {
    let mut sums = AreaIntegrals::new();
    for edge in edges {
        sums.add(edge, &EdgeFromPole::new(edge, centre));
    }
    sums.friction(pressure, centre, sense)
}

/// The same, and second derivatives of the dissipated power at a rim speed of 1.
pub(super) fn friction_and_hessian<R: Real, K: PressureField<R>>(
    edges: &[Edge<R>],
    pressure: &K,
    centre: &Vector2<R>,
    sense: R,
) -> (Reduced<R>, Hessian<R>) {
    let mut sums = AreaIntegrals::new();
    let mut across = HessianIntegrals::new();
    for edge in edges {
        let seen = EdgeFromPole::new(edge, centre);
        sums.add(edge, &seen);
        across.add(edge, pressure, &seen);
    }
    let reduced = sums.friction(pressure, centre, sense);
    (reduced, across.hessian(pressure, centre))
}

/// Integrals over the patch: of r and ρ/r, and of ρ r and ρρ/r for a linear pressure.
struct AreaIntegrals<R: Real> {
    /// Σ τ I
    along: Vector2<R>,
    /// ∫r dA
    distance: R,
    /// ∫ρ r dA
    moment: Vector2<R>,
    /// Σ b n: xx, xy, yy, with b = h I n + Q τ and Q = ∫t r dt.
    spread: [R; 3],
}

impl<R: Real> AreaIntegrals<R> {
    fn new() -> Self {
        let zero = Vector2::new(R::ZERO, R::ZERO);
        Self {
            along: zero,
            distance: R::ZERO,
            moment: zero,
            spread: [R::ZERO; 3],
        }
    }

    #[inline(always)]
    fn add(&mut self, edge: &Edge<R>, seen: &EdgeFromPole<R>) {
        let third = R::ONE / R::from_f64(3.0);
        let (tangent, integral) = (edge.tangent(), seen.integral);
        self.along += tangent * integral;
        let normal = edge.normal();
        let moment =
            seen.rise * (seen.r1 * seen.r1 + seen.r1 * seen.r0 + seen.r0 * seen.r0) * third;
        let b = normal * (seen.h * integral) + tangent * moment;
        self.distance += seen.h * integral * third;
        self.moment += b * (R::HALF * R::HALF * seen.h);
        let parts = [
            b.x * normal.x,
            R::HALF * (b.x * normal.y + b.y * normal.x),
            b.y * normal.y,
        ];
        for (sum, part) in self.spread.iter_mut().zip(parts) {
            *sum += part;
        }
    }

    #[inline(always)]
    fn friction<K: PressureField<R>>(
        &self,
        pressure: &K,
        centre: &Vector2<R>,
        sense: R,
    ) -> Reduced<R> {
        let ([slope_x, slope_y], here) = (pressure.slope(), at(pressure, centre));
        let [xx, xy, yy] = self.spread;
        let (xx, yy) = (xx - self.distance, yy - self.distance);
        // ∫k ρ/r, of which Σ n I is the part of the pressure at the centre of rotation; n = −z × τ.
        let pull = Vector2::new(
            here * self.along.y + slope_x * xx + slope_y * xy,
            -here * self.along.x + slope_x * xy + slope_y * yy,
        );
        let force = Vector2::new(sense * pull.y, -(sense * pull.x));
        let torque = here * self.distance + slope_x * self.moment.x + slope_y * self.moment.y;
        Reduced {
            force,
            torque: centre.x * force.y - centre.y * force.x - sense * torque,
        }
    }
}

/// Pressure at a place.
#[inline(always)]
fn at<R: Real, K: PressureField<R>>(pressure: &K, place: &Vector2<R>) -> R {
    let [x, y] = pressure.slope();
    pressure.at_centre() + x * place.x + y * place.y
}

/// ∫(1 − ρρ/r²)/r dA and ∫(slope·ρ) ρρ/r³ dA.
struct HessianIntegrals<R: Real> {
    /// xx, xy, yy
    uniform: [R; 3],
    linear: [R; 3],
}

impl<R: Real> HessianIntegrals<R> {
    fn new() -> Self {
        Self {
            uniform: [R::ZERO; 3],
            linear: [R::ZERO; 3],
        }
    }

    #[inline(always)]
    fn add<K: PressureField<R>>(&mut self, edge: &Edge<R>, pressure: &K, seen: &EdgeFromPole<R>) {
        let (tangent, normal, h) = (edge.tangent(), edge.normal(), seen.h);
        let b = normal * (h * seen.log) + tangent * seen.rise;
        let parts = [
            b.x * normal.x,
            R::HALF * (b.x * normal.y + b.y * normal.x),
            b.y * normal.y,
        ];
        for (sum, part) in self.uniform.iter_mut().zip(parts) {
            *sum += part;
        }
        let [x, y] = pressure.slope();
        let (out, on) = (x * normal.x + y * normal.y, x * tangent.x + y * tangent.y);
        // h^(4−j) ∫t^j/r³ dt for j = 0 … 3; no corner's r is below |h|.
        let inverse = |r: R| R::ONE / (r + R::MIN_POSITIVE);
        let (i0, i1) = (inverse(seen.r0), inverse(seen.r1));
        let turn = seen.t1 * i1 - seen.t0 * i0;
        let fall = (h * i1) * h - (h * i0) * h;
        let m0 = h * h * turn;
        let m1 = -h * fall;
        let m2 = h * (h * seen.log) - h * h * turn;
        let m3 = h * (seen.rise + fall);
        let nn = out * m0 + on * m1;
        let nt = out * m1 + on * m2;
        let tt = out * m2 + on * m3;
        let parts = [
            normal.x * normal.x * nn
                + R::TWO * normal.x * tangent.x * nt
                + tangent.x * tangent.x * tt,
            normal.x * normal.y * nn
                + (normal.x * tangent.y + normal.y * tangent.x) * nt
                + tangent.x * tangent.y * tt,
            normal.y * normal.y * nn
                + R::TWO * normal.y * tangent.y * nt
                + tangent.y * tangent.y * tt,
        ];
        for (sum, part) in self.linear.iter_mut().zip(parts) {
            *sum += R::HALF * part;
        }
    }

    /// D″ of the power: only the part of a change of velocity across ρ counts.
    fn hessian<K: PressureField<R>>(&self, pressure: &K, centre: &Vector2<R>) -> Hessian<R> {
        let [xx, xy, yy] = self.uniform;
        let here = at(pressure, centre);
        let [lxx, lxy, lyy] = self.linear;
        let kxy = lxy - here * xy;
        Hessian::about(centre, [here * yy + lxx, kxy, here * xx + lyy])
    }
}
