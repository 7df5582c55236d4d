//! A quick stand-in for the curve of a coupling, from which searches start.
//!
//! With h the smaller over the larger speed and x = h², the power D = M + h m is even in h and its
//! derivative is m. One polynomial in x therefore gives power, point and rate:
//!
//! ```text
//! m = 2h dD/dx,      M = D − h m,      dm/dh = 2 dD/dx + 4x d²D/dx²
//! m = h Σ aₙ xⁿ      M = top − x Σ (2n + 1)/(2n + 2) aₙ xⁿ
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

/// A step along the approximation that another one follows: the cube of a shorter one is below the approximation's own
/// error. Where both components weigh the same none was longer than 0.029.
const LONG: f64 = 0.03;

/// (2n + 1)/(2n + 2): what a term of m/h is in the loss of M.
const SHARES: [f64; TERMS] = [
    1.0 / 2.0,
    3.0 / 4.0,
    5.0 / 6.0,
    7.0 / 8.0,
    9.0 / 10.0,
    11.0 / 12.0,
];

/// The polynomials where one of the speeds leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CurveApproximation<R> {
    /// M at the pole.
    pub(super) top: R,
    /// m/h by powers of x.
    pub(super) terms: [R; TERMS],
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
        Self {
            top,
            terms: powers.unwrap_or_else(|| fitted_powers(coupling, lead)),
            equal,
        }
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
        let [a, b, c, d, e, f] = sliding.terms;
        let [p, q, r, s, t, u] = spinning.terms;
        let [major, minor] = sliding.equal;
        let [other_major, other_minor] = spinning.equal;
        Self {
            top: choose(sliding.top, spinning.top),
            // One after the other: a mapped array would call a function for each.
            terms: [
                choose(a, p),
                choose(b, q),
                choose(c, r),
                choose(d, s),
                choose(e, t),
                choose(f, u),
            ],
            equal: [choose(major, other_major), choose(minor, other_minor)],
        }
    }

    /// h on the ray with m/M = `slope`: exact at both ends, and for an ellipse everywhere.
    #[inline(always)]
    fn on_ellipse(&self, slope: L) -> L {
        let [major, minor] = self.equal;
        let [pole_rate, ..] = self.terms;
        let at_pole = pole_rate / self.top;
        slope / (at_pole + (L::splat(1.0) - at_pole * major / minor) * slope)
    }

    /// The point at a ratio of speeds, and d²m/dh² there.
    #[inline(always)]
    fn at(&self, ratio: L) -> (CurvePoint<L>, L) {
        let (x, two) = (ratio * ratio, L::splat(2.0));
        let [a, b, c, d, e, f] = self.terms;
        // m/h with its first derivative and half of its second.
        let sum = f * x + e;
        let (mut bend, mut slope, mut sum) = (f, f * x + sum, sum * x + d);
        for term in [c, b, a] {
            bend = bend * x + slope;
            slope = slope * x + sum;
            sum = sum * x + term;
        }
        let [p, q, r, s, t, u] = SHARES;
        let mut loss = f * L::constant(u);
        for (term, share) in [(e, t), (d, s), (c, r), (b, q), (a, p)] {
            loss = loss * x + term * L::constant(share);
        }
        let turn = L::splat(6.0) * slope + L::splat(8.0) * x * bend;
        let point = CurvePoint {
            major: self.top - x * loss,
            minor: ratio * sum,
            rate: sum + two * x * slope,
        };
        (point, ratio * turn)
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
        let [pole_rate, ..] = self.terms;
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

    /// The ratio after a step of Chebyshev's on the approximation, which leaves the cube of what was missing.
    #[inline(always)]
    fn stepped(&self, ratio: L, equation: &impl Equation<L>) -> L {
        let (point, bend) = self.at(ratio);
        let [value, rate] = equation.at(ratio, &point);
        let per_rate = L::splat(1.0) / rate;
        let newton = value * per_rate;
        let bent = L::splat(0.5) * equation.bend(ratio, &point, bend) * per_rate;
        kept(ratio - newton * (L::splat(1.0) + newton * bent), ratio)
    }
}

/// `next` if it is a ratio of speeds.
#[inline(always)]
fn kept<L: Numbers>(next: L, before: L) -> L {
    L::select(next.is_within(L::splat(0.0), L::splat(1.0)), next, before)
}
