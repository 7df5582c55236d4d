//! Wrench and Jacobian for speeds whose ratio or power leaves the number range: the same formulas in
//! [`ExtendedRange`].
//!
//! Every result is m^n hᵖ (a + b h²) with n = α or α − 1, p = 0 or 1, and with a and b from Φ, Φ'
//! and Χ, which are of order 1. Neither m^n nor h need be a number of the type for the result to be
//! one: v = 1e-200 and w = 1e150 have h = 1e-350, but under α = 1 the force is v.

use super::extended_range::ExtendedRange;
use super::lateral::twice_z_slope;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::real::Real;

/// hᵖ (a + b h²)
struct JacobianEntry<R> {
    power: Power,
    at_zero: R,
    bend: R,
}

/// p
#[derive(Clone, Copy, PartialEq)]
enum Power {
    Even,
    Odd,
}

fn even<R: Real>(at_zero: R, bend: R) -> JacobianEntry<R> {
    let power = Power::Even;
    JacobianEntry {
        power,
        at_zero,
        bend,
    }
}

fn odd<R: Real>(at_zero: R, bend: R) -> JacobianEntry<R> {
    let power = Power::Odd;
    JacobianEntry {
        power,
        at_zero,
        bend,
    }
}

/// m^n and h.
struct Scales<R> {
    scale: ExtendedRange<R>,
    ratio: ExtendedRange<R>,
}

impl<R: Real> Scales<R> {
    fn new(exponent: R, slide: R, rim: R) -> Self {
        let (slide, rim) = (slide.abs(), rim.abs());
        let (major, minor) = if slide > rim {
            (slide, rim)
        } else {
            (rim, slide)
        };
        Self {
            scale: ExtendedRange::power(major, exponent),
            ratio: ExtendedRange::new(minor).over(ExtendedRange::new(major)),
        }
    }

    fn value(&self, entry: JacobianEntry<R>) -> R {
        let square = self.ratio.times(self.ratio);
        let sum =
            ExtendedRange::new(entry.at_zero).plus(square.times(ExtendedRange::new(entry.bend)));
        let product = match entry.power {
            Power::Even => sum,
            Power::Odd => self.ratio.times(sum),
        };
        if product.is_number() {
            product.times(self.scale).value()
        } else {
            // Zero stays zero and an infinite slope infinite, however small or large m^n is.
            product.value()
        }
    }
}

/// The entries times m^n; for an infinite speed or NaN times the power as it is.
#[inline]
fn all<R: Real, const N: usize>(
    exponent: R,
    at: &Speeds<R>,
    [slide, rim]: [R; 2],
    entries: [JacobianEntry<R>; N],
) -> [R; N] {
    if !at.major.is_finite() {
        let scale = at.major.pow(exponent);
        let h = at.ratio();
        return entries.map(|entry| match entry.power {
            Power::Even => scale * entry.at_zero,
            Power::Odd => scale * (h * entry.at_zero),
        });
    }
    let scales = Scales::new(exponent, slide, rim);
    entries.map(|entry| scales.value(entry))
}

/// F and T.
#[cold]
pub(super) fn wrench<R: Real, P: PowerLawFriction<R>>(
    profile: &P,
    at: &Speeds<R>,
    slide: R,
    rim: R,
) -> [R; 2] {
    let [phi, chi] = profile.factors(at);
    let entries = match at.lead() {
        DominantSpeed::Sliding => [even(phi, R::ZERO), odd(chi, R::ZERO)],
        DominantSpeed::Spinning => [odd(phi, R::ZERO), even(chi, R::ZERO)],
    };
    all(profile.exponent(), at, [slide, rim], entries)
}

/// F/v, ∂F/∂v, ∂F/∂w and ∂T/∂w; NaN for an infinite speed.
#[cold]
#[inline(never)]
pub(super) fn jacobian<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    at: &Speeds<R>,
    speeds: [R; 2],
) -> [R; 4] {
    if !at.major.is_finite() {
        return [R::NAN; 4];
    }
    let [phi, slope, chi] = profile.factors_and_slope(at);
    let alpha = profile.exponent();
    let (bend, beta) = (R::TWO * slope, R::ONE - alpha);
    let drag = even(phi, R::ZERO);
    let entries = match at.lead() {
        DominantSpeed::Sliding => [
            drag,
            even(alpha * phi, -bend),
            odd(bend, R::ZERO),
            even(alpha * chi - bend, R::ZERO),
        ],
        DominantSpeed::Spinning => {
            let h = at.ratio();
            [
                drag,
                even(phi, bend),
                odd(-(beta * phi), -bend),
                even(alpha * chi, beta * phi + h * h * bend),
            ]
        }
    };
    all(alpha - R::ONE, at, speeds, entries)
}

/// G, from (Φ + Χ)/(2(n+1)).
#[cold]
pub(super) fn lateral<R: Real>(alpha: R, sum: R, at: &Speeds<R>, speeds: [R; 2]) -> R {
    let entry = match at.lead() {
        DominantSpeed::Sliding => odd(sum, R::ZERO),
        DominantSpeed::Spinning => even(sum, R::ZERO),
    };
    let [g] = all(alpha, at, speeds, [entry]);
    g
}

/// The gradient of vG.
#[cold]
pub(super) fn lateral_jacobian<R: Real>(
    alpha: R,
    [phi, slope, chi]: [R; 3],
    divisor: R,
    at: &Speeds<R>,
    speeds: [R; 2],
) -> [R; 2] {
    let (_, z) = at.square_and_complement();
    let (bend, beta) = (twice_z_slope(z, slope), R::ONE - alpha);
    let entries = match at.lead() {
        DominantSpeed::Sliding => [
            odd(alpha * phi + bend + chi, R::ZERO),
            even(phi + alpha * chi - bend, R::ZERO),
        ],
        DominantSpeed::Spinning => [
            even(phi + chi, bend - beta * phi),
            odd(alpha * (phi + chi), beta * phi - bend),
        ],
    };
    let entries = entries.map(|entry| JacobianEntry {
        at_zero: entry.at_zero / divisor,
        bend: entry.bend / divisor,
        ..entry
    });
    all(alpha, at, speeds, entries)
}
