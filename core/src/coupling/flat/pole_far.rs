//! Friction of a patch with straight edges that slides more than it turns: bars, and triangles of meshes.
//!
//! The sliding velocity of the centre of pressure, the origin, is the unit of speed; w is the spin. Let the
//! axes lie along the velocity and across it. An element has the velocity (g, w x) with g = 1 − w y and the
//! speed q. Since the pressure k of the whole has its centre at the origin,
//!
//! ```text
//! force along the velocity = −∫k g/q            = −∫k + w² ∫k x²/(q s),     s = q + g
//! force across             = −w ∫k x/q          = −w² ∫k x (y − w x²/s)/q
//! torque                   = −∫k (w x² − y g)/q = −w ∫k x² (1 + q)/(q s)
//! D″                       = ∫k (g², x g, x²)/q³   across and across, across and spin, spin and spin
//! ```
//!
//! The integrals over x have closed forms at every y in c = x/s, σ = w c (the tangent of half the
//! angle of the velocity) and one function P:
//!
//! ```text
//! ∫x²/(q s) = x c² P             ∫x²/q = x² c (1 + (1 − σ²) P/2)/2        ∫x/q = x c
//! ∫x³/(q s) = x² c²/2            ∫x³/q = x² c² (q + 2 g)/3
//! P(σ²) = (1 − (1 − σ²) atanh(σ)/σ)/σ² = 2/3 + σ² P₁(σ²)
//! ```
//!
//! Nothing cancels, no digit is lost as w → 0, and what is left is a smooth integral
//! along each edge, by Gauss' rule with as many points as the distance of the centre of rotation
//! asks for.

use super::pair_of_numbers::Pair2;
use super::{Hessian, Reduced};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use crate::special::legendre::{FEW_HALF, HALF, OF_4, OF_6, OF_10};
use nalgebra::Vector2;

/// P₁ for σ² ≤ 0.0295, from the constant term on: `chebyfit` of mpmath 1.3 for P with 7 terms, to 2e-17.
const P1: [f64; 6] = [
    0.133_333_333_333_266_2,
    0.057_142_857_179_222_02,
    0.031_746_024_367_753_08,
    0.020_202_731_754_960_66,
    0.013_950_909_975_489_176,
    0.011_107_954_969_641_478,
];
/// The same for σ² ≤ 0.072 with 4 terms, to 5e-9.
const P1_SINGLE: [f32; 3] = [0.133_335_42, 0.056_999_336, 0.034_867_745];

/// Pairs of terms first: a chain of products would have to wait for each other.
#[inline(always)]
fn p1<R: Real>(z: Pair2<R>) -> Pair2<R> {
    let pair = |low: R, high: R| Pair2::of(low) + Pair2::of(high) * z;
    let z_sq = z * z;
    if R::IS_SINGLE {
        let [a, b, c] = P1_SINGLE.map(|c| R::from_f64(f64::from(c)));
        pair(a, b) + Pair2::of(c) * z_sq
    } else {
        let [a, b, c, d, e, f] = P1.map(R::from_f64);
        pair(a, b) + z_sq * (pair(c, d) + z_sq * pair(e, f))
    }
}

/// A motion with the speed of the origin as unit: direction, and spin, at most 1/3 (f32: 1/2).
pub(super) struct TranslatingMotion<'a, R: Real> {
    pub(super) direction: &'a Vector2<R>,
    pub(super) spin: R,
}

/// Distances of the centre of rotation, in half lengths of the longest edge, below which 16, 10, 8 and 6
/// points are taken and not 4: for the wrench to 1e-15, for second derivatives to 3e-15. Zero is never.
pub(super) const FOR_WRENCH: [f64; 4] = [0.0, 5.0, 9.0, 75.0];
pub(super) const FOR_HESSIAN: [f64; 4] = [0.0, 6.0, 15.0, 300.0];
/// The same in single precision, to 1e-7.
const SINGLE: [f64; 4] = [0.0, 0.0, 0.0, 6.0];

/// A sum that Gauss' rule makes of the edges, with half of a rule's nodes and weights.
pub(super) trait EdgeQuadrature<R> {
    type Sum;
    fn sum(&self, half: &[[f64; 2]]) -> Self::Sum;
}

/// The sum by the rule that half the length of the longest edge asks for at this spin.
#[inline(always)]
pub(super) fn by_rule<R: Real, S: EdgeQuadrature<R>>(
    sum: &S,
    reach: R,
    double: [f64; 4],
) -> S::Sum {
    let [sixteen, ten, eight, six] = if R::IS_SINGLE { SINGLE } else { double };
    // A rule that is never taken is no part of a program.
    let is_below = |limit: f64| limit > 0.0 && reach * R::from_f64(limit) > R::ONE;
    let rule: &[[f64; 2]] = if is_below(sixteen) {
        &HALF
    } else if is_below(ten) {
        &OF_10
    } else if is_below(eight) {
        &FEW_HALF
    } else if is_below(six) {
        &OF_6
    } else {
        &OF_4
    };
    sum.sum(rule)
}

/// Integrals along the edges of `N` functions, at two points at once.
pub(super) struct EdgePairs<'a, R: Real, F, const N: usize> {
    pub(super) slide: &'a TranslatingMotion<'a, R>,
    pub(super) edges: &'a [Edge<R>],
    /// What a length along an edge counts; `None` counts its part along y.
    pub(super) along: Option<R>,
    pub(super) at: F,
}

impl<R: Real, F, const N: usize> EdgeQuadrature<R> for EdgePairs<'_, R, F, N>
where
    F: Fn([Pair2<R>; 2]) -> [Pair2<R>; N],
{
    type Sum = [R; N];

    #[inline(always)]
    fn sum(&self, rule: &[[f64; 2]]) -> [R; N] {
        let mut sums = [Pair2::of(R::ZERO); N];
        for edge in self.edges {
            let half = R::HALF * edge.length();
            let [tx, ty] = self.slide.turned(&edge.tangent());
            let [x, y] = self.slide.turned(&edge.start());
            let (dx, dy) = (half * tx, half * ty);
            let middle = [Pair2::of(x + dx), Pair2::of(y + dy)];
            let unit = self.along.map_or(dy, |along| along * half);
            for &[node, weight] in rule {
                let (by_x, by_y) = (R::from_f64(node) * dx, R::from_f64(node) * dy);
                let weight = Pair2::of(R::from_f64(weight) * unit);
                let parts = (self.at)([
                    middle[0] + Pair2([by_x, -by_x]),
                    middle[1] + Pair2([by_y, -by_y]),
                ]);
                for (sum, part) in sums.iter_mut().zip(parts) {
                    *sum = *sum + weight * part;
                }
            }
        }
        sums.map(Pair2::sum)
    }
}

impl<R: Real> TranslatingMotion<'_, R> {
    /// A vector along the direction and across it.
    #[inline(always)]
    pub(super) fn turned(&self, v: &Vector2<R>) -> [R; 2] {
        let e = self.direction;
        [v.x * e.x + v.y * e.y, v.y * e.x - v.x * e.y]
    }

    /// Integrals of x²/(q s), x (y − w x²/s)/q and x² (1 + q)/(q s) under a pressure, given the
    /// largest speed that half an edge turns with.
    #[inline]
    pub(super) fn linear<K: PressureField<R>>(
        &self,
        edges: &[Edge<R>],
        pressure: &K,
        reach: R,
    ) -> [R; 3] {
        let spin = self.spin;
        let pressure = RotatedPressure::new(self, pressure);
        let at = |[x, y]: [Pair2<R>; 2]| {
            let w = Pair2::of(spin);
            let at = Point::new(w, x, y);
            let (half, wy) = (Pair2::of(R::HALF), w * y);
            let (x_c, x_x) = (x * at.c, x * x);
            let c_sq = at.c * at.c;
            // ∫x²/(q s), ∫x³/(q s), ∫x⁴/(q s), ∫x²/q and ∫x³/q over x.
            let p2 = x * c_sq * at.p;
            let p3 = half * x_c * x_c;
            let bracket = Pair2::of(R::from_f64(5.0 / 12.0))
                - at.sigma_sq * Pair2::of(R::from_f64(1.0 / 12.0))
                - at.rest * at.rest * at.p1 * Pair2::of(R::from_f64(0.125));
            let p4 = x * x_x * c_sq * bracket;
            let c2 = half * x_x * at.c * (Pair2::of(R::ONE) + half * at.rest * at.p);
            let c3 = x_c * x_c * (at.q + at.g + at.g) * Pair2::of(R::from_f64(1.0 / 3.0));
            let (here, slope) = (pressure.at(y), pressure.slope_x);
            [
                here * p2 + slope * p3,
                here * (y * x_c - w * p3) + slope * (y * c2 - w * p4),
                here * (c2 + wy * p2) + slope * (c3 + wy * p3),
            ]
        };
        let sums = EdgePairs {
            slide: self,
            edges,
            along: None,
            at,
        };
        by_rule(&sums, reach, FOR_WRENCH)
    }

    /// Friction from such integrals over the whole patch, whose load is 1.
    #[inline(always)]
    pub(super) fn reduced_of(&self, [missing, across, torque]: [R; 3]) -> Reduced<R> {
        let (e, spin) = (self.direction, self.spin);
        let along = spin * spin * missing - R::ONE;
        let across = -(spin * spin * across);
        Reduced {
            force: Vector2::new(along * e.x - across * e.y, along * e.y + across * e.x),
            torque: -(spin * torque),
        }
    }

    /// Integrals of (g², x g, x²)/q³ under a pressure.
    #[inline]
    pub(super) fn bent<K: PressureField<R>>(
        &self,
        edges: &[Edge<R>],
        pressure: &K,
        reach: R,
    ) -> [R; 3] {
        let spin = self.spin;
        let pressure = RotatedPressure::new(self, pressure);
        let at = |[x, y]: [Pair2<R>; 2]| {
            let at = Point::new(Pair2::of(spin), x, y);
            let inv_q = at.q.inverse();
            let inv_g = (at.inv_s + at.inv_s) * at.rest.inverse();
            let x_c = x * at.c;
            // ∫g²/q³, ∫x g/q³, ∫x²/q³ g and ∫x²/q³ over x.
            let (yy, yn) = (x * inv_q, x_c * inv_q);
            let full = x * at.c * at.c * ((at.q + at.g) * inv_q - at.p);
            let nn = full * inv_g;
            let (here, slope) = (pressure.at(y), pressure.slope_x);
            [
                here * yy + slope * (at.g * yn),
                here * yn + slope * full,
                here * nn + slope * (x_c * x_c * inv_q),
            ]
        };
        let sums = EdgePairs {
            slide: self,
            edges,
            along: None,
            at,
        };
        by_rule(&sums, reach, FOR_HESSIAN)
    }

    /// All second derivatives from those across the direction and about the normal.
    pub(super) fn hessian_of(&self, [yy, yn, nn]: [R; 3]) -> Hessian<R> {
        let spin = self.spin;
        // D″ times the twist (1, 0, spin) is 0.
        let (xx, xy, xn) = (spin * spin * nn, -(spin * yn), -(spin * nn));
        self.turned_back(&Hessian {
            xx,
            xy,
            yy,
            xn,
            yn,
            nn,
        })
    }

    /// A matrix with axes along the direction and across it, in those of the patch.
    pub(super) fn turned_back(&self, matrix: &Hessian<R>) -> Hessian<R> {
        let Hessian {
            xx,
            xy,
            yy,
            xn,
            yn,
            nn,
        } = *matrix;
        let (c, s) = (self.direction.x, self.direction.y);
        Hessian {
            xx: c * c * xx - R::TWO * c * s * xy + s * s * yy,
            xy: c * s * (xx - yy) + (c * c - s * s) * xy,
            yy: s * s * xx + R::TWO * c * s * xy + c * c * yy,
            xn: c * xn - s * yn,
            yn: s * xn + c * yn,
            nn,
        }
    }
}

/// Pressure along the direction and across it.
pub(super) struct RotatedPressure<R> {
    at_centre: Pair2<R>,
    pub(super) slope_x: Pair2<R>,
    slope_y: Pair2<R>,
}

impl<R: Real> RotatedPressure<R> {
    #[inline(always)]
    pub(super) fn new(slide: &TranslatingMotion<'_, R>, pressure: &impl PressureField<R>) -> Self {
        let [x, y] = pressure.slope();
        let [x, y] = slide.turned(&Vector2::new(x, y));
        Self {
            at_centre: Pair2::of(pressure.at_centre()),
            slope_x: Pair2::of(x),
            slope_y: Pair2::of(y),
        }
    }

    /// Pressure on the second axis.
    #[inline(always)]
    pub(super) fn at(&self, y: Pair2<R>) -> Pair2<R> {
        self.at_centre + self.slope_y * y
    }
}

/// What the closed forms at two points are made of.
struct Point<R> {
    g: Pair2<R>,
    q: Pair2<R>,
    /// 1/s
    inv_s: Pair2<R>,
    c: Pair2<R>,
    sigma_sq: Pair2<R>,
    /// 1 − σ²
    rest: Pair2<R>,
    p1: Pair2<R>,
    p: Pair2<R>,
}

impl<R: Real> Point<R> {
    #[inline(always)]
    fn new(w: Pair2<R>, x: Pair2<R>, y: Pair2<R>) -> Self {
        let one = Pair2::of(R::ONE);
        let g = one - w * y;
        let wx = w * x;
        let q = (g * g + wx * wx).sqrt();
        let inv_s = (q + g).inverse();
        let c = x * inv_s;
        let sigma = w * c;
        let sigma_sq = sigma * sigma;
        let p1 = p1(sigma_sq);
        Self {
            g,
            q,
            inv_s,
            c,
            sigma_sq,
            rest: one - sigma_sq,
            p1,
            p: Pair2::of(R::from_f64(2.0 / 3.0)) + sigma_sq * p1,
        }
    }
}
