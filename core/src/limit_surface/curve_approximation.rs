//! A quick stand-in for the curve of a coupling, from which searches start.
//!
//! With h the smaller over the larger speed and x = h², the power D = M + h m is even in h and its
//! derivative is m. One polynomial in x therefore gives power, point and rate:
//!
//! ```text
//! m = 2h dD/dx,      M = D − h m,      dm/dh = 2 dD/dx + 4x d²D/dx²
//! ```
//!
//! The polynomial of degree 5 that has the coupling's m/h at the six points of Chebyshev is right to 1e-4 on the
//! uniform disk and to 5e-3 on a ring. Only the number of a search's steps depends on it.

use super::curve_point::{AlongNormal, CurvePoint, Equation, OnRay};
use crate::coupling::{DominantSpeed, DryReducedFriction};
use crate::lanes::Numbers;
use crate::real::Real;

/// Powers of x in m/h.
const TERMS: usize = 6;

/// Ratios at which m/h is taken: x = h² are the zeros of the polynomial of Chebyshev of degree 6 on [0, 1].
const RATIOS: [f64; TERMS] = [
    0.130_526_192_220_051_6,
    0.382_683_432_365_089_8,
    0.608_761_429_008_720_7,
    0.793_353_340_291_235_2,
    0.923_879_532_511_286_7,
    0.991_444_861_373_810_4,
];

/// Coefficients of powers of x by values there, the constant first: the inverse of Vandermonde's matrix, by mpmath.
#[rustfmt::skip]
const WEIGHTS: [[f64; TERMS]; TERMS] = [
    [1.265_959_018_787_525_1, -0.402_368_927_062_182_5, 0.217_204_228_806_867_63, -0.127_887_831_329_826_73, 0.069_035_593_728_849_18, -0.021_942_082_931_232_64],
    [-16.842_976_399_779_18, 26.223_015_852_770_71, -15.052_601_371_008_365, 9.004_736_857_858_703, -4.889_682_519_437_379, 1.557_507_579_595_507],
    [74.798_982_256_079_37, -158.927_945_990_524_42, 141.833_667_262_799_17, -93.119_136_082_982_85, 52.261_279_323_857_764, -16.846_846_769_229_025],
    [-146.834_915_837_597_58, 356.862_337_308_967_6, -395.736_502_815_262_3, 310.403_169_481_929, -186.195_670_642_300_9, 61.501_582_504_264_256],
    [131.762_792_577_075_52, -344.365_559_972_926_9, 433.461_685_883_335_8, -390.795_022_216_669_1, 259.032_226_639_593_6, -89.096_125_910_408_86],
    [-44.171_783_697_496_88, 120.679_557_322_504_11, -164.851_341_020_001, 164.851_341_020_001, -120.679_557_322_504_11, 44.171_783_697_496_88],
];

/// A step along the approximation that another one follows: the square of a shorter one is the approximation's own
/// error.
const LONG: f64 = 0.01;

/// The polynomials where one of the speeds leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CurveApproximation<R> {
    /// M at the pole.
    top: R,
    /// m/h and (top − M)/x by powers of x.
    terms: [[R; 2]; TERMS],
    /// M and m at equal speeds.
    equal: [R; 2],
}

impl<R: Real> CurveApproximation<R> {
    /// From M at the pole, and M and m at equal speeds. *Cost*: six points, none where their powers are known.
    pub fn of(
        coupling: &impl DryReducedFriction<R>,
        lead: DominantSpeed,
        top: R,
        equal: [R; 2],
    ) -> Self {
        let powers = coupling.minor_powers(lead);
        let powers = powers.unwrap_or_else(|| fitted_powers(coupling, lead));
        let mut degree = R::ZERO;
        let terms = powers.map(|power| {
            // h m − ∫ m dh
            degree += R::TWO;
            [power, power * (degree - R::ONE) / degree]
        });
        Self { top, terms, equal }
    }
}

/// Coefficients of m/h by powers of h².
fn fitted_powers<R: Real>(
    coupling: &impl DryReducedFriction<R>,
    lead: DominantSpeed,
) -> [R; TERMS] {
    let slopes = RATIOS.map(|ratio| {
        let ratio = R::from_f64(ratio);
        let [_, minor, _] = coupling.reduced_point(lead, ratio);
        minor / ratio
    });
    WEIGHTS.map(|weights| {
        let products = weights.iter().zip(slopes);
        products.fold(R::ZERO, |sum, (weight, slope)| {
            sum + R::from_f64(*weight) * slope
        })
    })
}

impl<L: Numbers> CurveApproximation<L> {
    /// In each lane the polynomials where its speed leads: sliding where `slides`.
    #[inline(always)]
    pub fn chosen<R: Real>(of: &[CurveApproximation<R>; 2], slides: L::Mask) -> Self
    where
        L: Numbers<Real = R>,
    {
        let [sliding, spinning] = of;
        let choose = |one: R, other: R| L::select(slides, L::repeat(one), L::repeat(other));
        let pair = |[a, b]: [R; 2], [c, d]: [R; 2]| [choose(a, c), choose(b, d)];
        let [a, b, c, d, e, f] = sliding.terms;
        let [p, q, r, s, t, u] = spinning.terms;
        Self {
            top: choose(sliding.top, spinning.top),
            terms: [
                pair(a, p),
                pair(b, q),
                pair(c, r),
                pair(d, s),
                pair(e, t),
                pair(f, u),
            ],
            equal: pair(sliding.equal, spinning.equal),
        }
    }

    /// h on the ray with m/M = `slope`: exact at both ends, and for an ellipse everywhere.
    #[inline(always)]
    fn on_ellipse(&self, slope: L) -> L {
        let [major, minor] = self.equal;
        let [[pole_rate, _], ..] = self.terms;
        let at_pole = pole_rate / self.top;
        slope / (at_pole + (L::splat(1.0) - at_pole * major / minor) * slope)
    }

    /// The point at a ratio of speeds.
    #[inline(always)]
    fn at(&self, ratio: L) -> CurvePoint<L> {
        let x = ratio * ratio;
        let [a, b, c, d, e, f] = self.terms;
        let (mut sums, mut slope) = (f, L::splat(0.0));
        for [minor, loss] in [e, d, c, b, a] {
            slope = slope * x + sums[0];
            sums = [sums[0] * x + minor, sums[1] * x + loss];
        }
        CurvePoint {
            major: self.top - x * sums[1],
            minor: ratio * sums[0],
            rate: sums[0] + L::splat(2.0) * x * slope,
        }
    }

    /// h on the ray of a point, whose larger component leads.
    #[inline(always)]
    pub fn on_ray(&self, equation: &OnRay<L>) -> L {
        let [major, minor] = equation.given;
        self.stepped(self.on_ellipse(minor / major), equation)
    }

    /// h of the normal through a point.
    #[inline(always)]
    pub fn nearest(&self, equation: &AlongNormal<L>) -> L {
        let AlongNormal {
            given: [major, minor],
            weight,
        } = *equation;
        let [equal_major, equal_minor] = self.equal;
        let [[pole_rate, _], ..] = self.terms;
        // A cubic h + h³ with the value and the slope at the pole and the value at equal speeds.
        let value = -(weight * minor);
        let linear = major - self.top + weight * pole_rate;
        let both = major - equal_major + weight * equal_minor;
        let cubic = both - linear;
        let chord = -(value / both);
        let bend = cubic * chord * chord;
        let first = (L::splat(2.0) * bend * chord - value) / (linear + L::splat(3.0) * bend);
        let first = kept(first, chord);
        let second = self.stepped(first, equation);
        let is_long = L::constant(LONG).below((second - first).abs());
        if !L::any(is_long) {
            return second;
        }
        L::select(is_long, self.stepped(second, equation), second)
    }

    /// The ratio after a Newton step on the approximation.
    #[inline(always)]
    fn stepped(&self, ratio: L, equation: &impl Equation<L>) -> L {
        let [value, rate] = equation.at(ratio, &self.at(ratio));
        kept(ratio - value / rate, ratio)
    }
}

/// `next` if it is a ratio of speeds.
#[inline(always)]
fn kept<L: Numbers>(next: L, before: L) -> L {
    L::select(next.is_within(L::splat(0.0), L::splat(1.0)), next, before)
}
