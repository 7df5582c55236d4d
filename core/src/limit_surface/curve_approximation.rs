//! A quick stand-in for the curve of a coupling, from which searches start.
//!
//! With h the smaller over the larger speed and x = h², the power D = M + h m is even in h and its
//! derivative is m. One polynomial in x therefore gives power, point and rate:
//!
//! ```text
//! m = 2h dD/dx,      M = D − h m,      dm/dh = 2 dD/dx + 4x d²D/dx²
//! ```
//!
//! The quintic that has the coupling's D and dD/dx at x = 0, ½ and 1 is right to 2e-4 on the uniform
//! disk and to 5e-3 on a ring. Only the number of a search's steps depends on it.

use super::curve_point::CurvePoint;
use crate::coupling::{DominantSpeed, DryReducedFriction};
use crate::real::Real;

/// Powers of x in m/h.
const TERMS: usize = 5;

/// The polynomials where one of the speeds leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CurveApproximation<R> {
    /// M at the pole.
    top: R,
    /// m/h and (top − M)/x by powers of x.
    terms: [[R; 2]; TERMS],
    /// M and m at equal speeds.
    equal: [R; 2],
    /// The curve is an ellipse, as far as the sketch can tell.
    is_ellipse: bool,
}

/// Rounding errors of a point that lies on an ellipse.
const ELLIPSE_ULPS: f64 = 16.0;

impl<R: Real> CurveApproximation<R> {
    /// *Cost*: three wrenches and Jacobians.
    pub fn of(coupling: &impl DryReducedFriction<R>, lead: DominantSpeed) -> Self {
        let root = R::HALF.sqrt();
        let [pole, middle, equal] =
            [R::ZERO, root, R::ONE].map(|ratio| CurvePoint::of(coupling, lead, ratio));
        let powers = [
            pole.major,
            middle.major + root * middle.minor,
            equal.major + equal.minor,
        ];
        // m/h = 2 dD/dx
        let slopes = [pole.rate, middle.minor / root, equal.minor].map(|m| R::HALF * m);
        let mut terms = hermite(powers, slopes).map(|d| [d, d]);
        let mut degree = R::TWO;
        for [minor, loss] in &mut terms {
            *minor *= degree;
            *loss *= degree - R::ONE;
            degree += R::TWO;
        }
        let mut sketch = Self {
            top: pole.major,
            terms,
            equal: [equal.major, equal.minor],
            is_ellipse: false,
        };
        let off = sketch.on_ellipse(middle.minor / middle.major) - root;
        sketch.is_ellipse = off.abs() <= R::from_f64(ELLIPSE_ULPS) * R::EPSILON;
        sketch
    }

    /// h on the ray with m/M = `slope`: exact at both ends, and for an ellipse everywhere.
    #[inline]
    fn on_ellipse(&self, slope: R) -> R {
        let [major, minor] = self.equal;
        let [[pole_rate, _], ..] = self.terms;
        let at_pole = pole_rate / self.top;
        slope / (at_pole + (R::ONE - at_pole * major / minor) * slope)
    }

    /// The point at a ratio of speeds.
    #[inline]
    fn at(&self, ratio: R) -> CurvePoint<R> {
        let x = ratio * ratio;
        let (mut sums, mut slope) = ([R::ZERO; 2], R::ZERO);
        for [minor, loss] in self.terms.iter().rev() {
            slope = slope * x + sums[0];
            sums = [sums[0] * x + *minor, sums[1] * x + *loss];
        }
        CurvePoint {
            major: self.top - x * sums[1],
            minor: ratio * sums[0],
            rate: sums[0] + R::TWO * x * slope,
        }
    }

    /// h on the ray with m/M = `slope`.
    #[inline]
    pub fn on_ray(&self, slope: R) -> R {
        let first = self.on_ellipse(slope);
        if self.is_ellipse {
            return first;
        }
        let at = self.at(first);
        let [value, rise] = at.across_ray(first, [R::ONE, slope]);
        kept(first - value / rise, first)
    }

    /// h of the normal through a point (`major`, `minor`) outside, with the weight of
    /// [`CurvePoint::beside_normal`].
    #[inline]
    pub fn nearest(&self, point: [R; 2], weight: R) -> R {
        let [major, minor] = point;
        let [equal_major, equal_minor] = self.equal;
        let [[pole_rate, _], ..] = self.terms;
        // A cubic h + h³ with the value and the slope at the pole and the value at equal speeds.
        let value = -weight * minor;
        let linear = major - self.top + weight * pole_rate;
        let both = major - equal_major + weight * equal_minor;
        let cubic = both - linear;
        let chord = -value / both;
        let bend = cubic * chord * chord;
        let first = kept(
            (R::TWO * bend * chord - value) / (linear + (R::ONE + R::TWO) * bend),
            chord,
        );
        let [value, rise] = self.at(first).beside_normal(first, point, weight);
        kept(first - value / rise, first)
    }
}

/// `next` if it is a ratio of speeds.
#[inline]
fn kept<R: Real>(next: R, before: R) -> R {
    if next >= R::ZERO && next <= R::ONE {
        next
    } else {
        before
    }
}

/// The coefficients, but for the constant, of the quintic with the given values and slopes at 0, ½ and 1:
/// Newton's form, multiplied out.
fn hermite<R: Real>([low, middle, high]: [R; 3], [a, b, c]: [R; 3]) -> [R; TERMS] {
    let two = R::TWO;
    let quarter = R::HALF * R::HALF;
    let (left, right) = (two * (middle - low), two * (high - middle));
    let [d, e, f, g] = [left - a, b - left, right - b, c - right].map(|x| two * x);
    let [h, i, j] = [two * (e - d), f - e, two * (g - f)];
    let [k, l] = [i - h, j - i];
    let m = l - k;
    // x² {d + (x − ½) [h + (x − ½) (k + (x − 1) m)]}
    [
        a,
        d - R::HALF * h + quarter * (k - m),
        h - k + (R::ONE + quarter) * m,
        k - two * m,
        m,
    ]
}
