//! Friction of a patch with straight edges that slides more than it turns.
//!
//! Let the first axis lie along the sliding velocity of the centre of pressure, which is the unit of
//! speed, and w be the spin. An element at (x, y) has the velocity (g, w x) with g = 1 − w y, and the
//! speed q with q² = g² + w² x². With 1 = g + w y, and since the pressure k has its centre at the
//! origin,
//!
//! ```text
//! force along velocity = −∫k g/q           = −∫k + w² ∫k x²/(q (q + g))
//! force across         = −w ∫k x/q         = −w² ∫k x (y − w x²/(q + g))/q
//! torque               = −∫k (w x² − y g)/q = −w ∫k x² (1 + q)/(q (q + g))
//! ```
//!
//! where nothing cancels and no digit is lost as w → 0. All integrals over x have closed forms in
//! q, g and the function B below, at every y; what is left is one smooth integral along each edge,
//! by Gauss' rule with as many points as the distance of the centre of rotation asks for:
//!
//! ```text
//! u = w x/g,    B(u) = (1 − asinh u/u)/u² = 1/6 − u² B₂(u²)
//! ```

use super::{Hessian, Reduced};
use crate::patch::outline::{Edge, FlatPressure};
use crate::real::Real;
use crate::special::legendre::pairs;
use nalgebra::Vector2;

/// B₂ for 0 ≤ u² ≤ 1/8, from the constant term on: Chebyshev's fit by mpmath 1.3,
/// `chebyfit(b2, [0, 1/8], 9)`, to 2.6e-16; B to 3.3e-17.
const B2: [f64; 9] = [
    0.074_999_999_999_999_741_6,
    -0.044_642_857_142_522_030_6,
    0.030_381_944_372_708_109_5,
    -0.022_372_153_160_162_588_7,
    0.017_352_517_800_189_999_3,
    -0.013_959_047_842_159_941_9,
    0.011_470_967_549_811_185_8,
    -0.009_091_323_086_027_231_54,
    0.005_244_404_319_017_212_47,
];
/// The same for 0 ≤ u² ≤ 1/3 by `chebyfit(b2, [0, 1/3], 5)`, to 5.9e-8; B to 2e-8.
const B2_SINGLE: [f32; 5] = [
    0.074_999_94,
    -0.044_633_774,
    0.030_157_71,
    -0.020_367_672,
    0.009_468_25,
];

#[inline(always)]
fn b2<R: Real>(u_sq: R) -> R {
    let mut sum = R::ZERO;
    if R::IS_SINGLE {
        for &c in B2_SINGLE.iter().rev() {
            sum = sum * u_sq + R::from_f64(f64::from(c));
        }
    } else {
        for &c in B2.iter().rev() {
            sum = sum * u_sq + R::from_f64(c);
        }
    }
    sum
}

/// Sums of line integrals along y.
#[derive(Clone, Copy)]
struct Sums<R> {
    /// What is missing of the force along the velocity, of the force across it, and the torque.
    missing: R,
    across: R,
    torque: R,
    /// ∫k g²/q³, ∫k x g/q³ and ∫k x²/q³.
    yy: R,
    yn: R,
    nn: R,
}

/// Pressure and spin in the frame of the sliding velocity.
struct Frame<R> {
    spin: R,
    at_centre: R,
    slope_x: R,
    slope_y: R,
}

impl<R: Real> Frame<R> {
    /// Adds what one point of an edge at (x, y) stands for, whose part along y is `weight`.
    #[inline(always)]
    fn add<const LINEAR: bool, const HESSIAN: bool>(
        &self,
        sums: &mut Sums<R>,
        [x, y]: [R; 2],
        weight: R,
    ) {
        let w = self.spin;
        let g = R::ONE - w * y;
        let wx = w * x;
        let q = (g * g + wx * wx).sqrt();
        let inv_g = R::ONE / g;
        let inv_sum = R::ONE / (q + g);
        let u = wx * inv_g;
        let u_sq = u * u;
        let b2 = b2(u_sq);
        let b = R::from_f64(1.0 / 6.0) - u_sq * b2;
        let x_sq = x * x;
        let x_cube = x_sq * x;
        // 1/(1 + q/g)
        let share = g * inv_sum;
        // ∫x²/(q(q+g)), ∫x³/(q(q+g)), ∫x²/q and ∫x/q over x.
        let p2 = x_cube * b * (inv_g * inv_g);
        let p3 = R::HALF * (x_sq * inv_sum) * (x_sq * inv_sum);
        let c2 = R::HALF * x_cube * (share + b) * inv_g;
        let c1 = x_sq * inv_sum;
        let here = if LINEAR {
            self.at_centre + self.slope_y * y
        } else {
            R::ONE
        };
        let mut missing = here * p2;
        let mut across = here * (y * c1 - w * p3);
        let mut torque = here * (c2 + w * y * p2);
        if LINEAR {
            // ∫x⁴/(q(q+g)) and ∫x³/q.
            let quarter = R::HALF * R::HALF;
            let p4 = x_cube * x_sq * (inv_g * inv_g) * (quarter * share * share + R::HALF * b2);
            let c3 = c1 * c1 * (q + R::TWO * g) * R::from_f64(1.0 / 3.0);
            missing += self.slope_x * p3;
            across += self.slope_x * (y * c2 - w * p4);
            torque += self.slope_x * (c3 + w * y * p3);
        }
        sums.missing += weight * missing;
        sums.across += weight * across;
        sums.torque += weight * torque;
        if HESSIAN {
            let inv_q = R::ONE / q;
            // ∫g²/q³, ∫x g/q³ and ∫x²/q³ over x; g/(q (1 + q/g)) − B is φ of the last one.
            let mut yy = x * inv_q;
            let mut yn = x_sq * inv_q * inv_sum;
            let phi = g * inv_q * share - b;
            let mut nn = x_cube * phi * (inv_g * inv_g * inv_g);
            if LINEAR {
                let next = (g * yn, x_cube * phi * (inv_g * inv_g), c1 * c1 * inv_q);
                yy = here * yy + self.slope_x * next.0;
                yn = here * yn + self.slope_x * next.1;
                nn = here * nn + self.slope_x * next.2;
            }
            sums.yy += weight * yy;
            sums.yn += weight * yn;
            sums.nn += weight * nn;
        }
    }
}

/// Half lengths of an edge between it and the centre of rotation, from which on a rule serves.
const NEAREST_OF_8: f64 = 6.0;
const NEAREST_OF_6: f64 = 15.0;
const NEAREST_OF_4: f64 = 300.0;

/// Reduced friction, and second derivatives of the power, for a velocity of length 1 along
/// `direction` and the spin `spin`, at most 1/3 (f32: 1/2).
#[inline]
pub(super) fn friction<R: Real, K: FlatPressure<R>, const HESSIAN: bool>(
    edges: &[Edge<R>],
    pressure: &K,
    direction: &Vector2<R>,
    spin: R,
    load: R,
) -> (Reduced<R>, Hessian<R>) {
    let e = direction;
    let turned = |v: &Vector2<R>| [v.x * e.x + v.y * e.y, v.y * e.x - v.x * e.y];
    let [slope_x, slope_y] = {
        let [x, y] = pressure.slope();
        turned(&Vector2::new(x, y))
    };
    let frame = Frame {
        spin,
        at_centre: pressure.at_centre(),
        slope_x,
        slope_y,
    };
    let mut sums = Sums {
        missing: R::ZERO,
        across: R::ZERO,
        torque: R::ZERO,
        yy: R::ZERO,
        yn: R::ZERO,
        nn: R::ZERO,
    };
    let distance = R::ONE / spin.abs();
    for edge in edges {
        let half = R::HALF * edge.length();
        let [x, y] = turned(&edge.start());
        let [tx, ty] = turned(&edge.tangent());
        let (dx, dy) = (half * tx, half * ty);
        let (x, y) = (x + dx, y + dy);
        let reach = distance / half;
        let rule = if R::IS_SINGLE {
            if reach < R::from_f64(NEAREST_OF_8) {
                pairs(6)
            } else {
                pairs(4)
            }
        } else if reach < R::from_f64(NEAREST_OF_8) {
            pairs(10)
        } else if reach < R::from_f64(NEAREST_OF_6) {
            pairs(8)
        } else if reach < R::from_f64(NEAREST_OF_4) {
            pairs(6)
        } else {
            pairs(4)
        };
        for &[node, weight] in rule {
            let (node, weight) = (R::from_f64(node), R::from_f64(weight) * dy);
            let (by_x, by_y) = (node * dx, node * dy);
            for at in [[x + by_x, y + by_y], [x - by_x, y - by_y]] {
                if K::IS_LINEAR {
                    frame.add::<true, HESSIAN>(&mut sums, at, weight);
                } else {
                    frame.add::<false, HESSIAN>(&mut sums, at, weight);
                }
            }
        }
    }
    let along = spin * spin * sums.missing - load;
    let across = -(spin * spin * sums.across);
    let reduced = Reduced {
        force: Vector2::new(along * e.x - across * e.y, along * e.y + across * e.x),
        torque: -(spin * sums.torque),
    };
    // D″ times the twist (1, 0, spin) is 0.
    let (yy, yn, nn) = (sums.yy, sums.yn, sums.nn);
    let (xx, xy, xn) = (spin * spin * nn, -(spin * yn), -(spin * nn));
    let (c, s) = (e.x, e.y);
    let hessian = Hessian {
        xx: c * c * xx - R::TWO * c * s * xy + s * s * yy,
        xy: c * s * (xx - yy) + (c * c - s * s) * xy,
        yy: s * s * xx + R::TWO * c * s * xy + c * c * yy,
        xn: c * xn - s * yn,
        yn: s * xn + c * yn,
        nn,
    };
    (reduced, hessian)
}
