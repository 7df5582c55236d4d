//! The curve of the limit surface of a fitted form, of ratios alone or side by side.
//!
//! A search along it asks for the components M, m and the rate dm/dh where one speed leads. With Θ = (Φ/2 + zΦ')/n they are
//!
//! ```text
//! sliding leads:     M = Φ,              m = hΘ,     dm/dh = −2Φ'
//! spinning leads:    M = zΦ/n + h²Θ,     m = hΦ,     dm/dh = Φ + 2h²Φ'
//! ```

use super::super::pressure_family::moment;
use super::terms::{DISK_POWERS, DISK_ROUGH};
use super::{DominantSpeed, Fitted, order, sums};
use crate::lanes::{Numbers, even_and_odd};
use crate::real::Real;
use crate::special::log_part;

/// m/h by powers of h².
#[inline]
pub(super) fn minor_powers<R: Real>(lead: DominantSpeed) -> [R; 6] {
    let [theta, phi] = &DISK_POWERS;
    match lead {
        DominantSpeed::Sliding => theta.map(R::from_f64),
        DominantSpeed::Spinning => phi.map(R::from_f64),
    }
}

/// P, Q, R and S of the same terms in every lane.
#[inline(always)]
fn abreast<L: Numbers, const TERMS: usize>(
    term: impl Fn(usize, usize) -> f64,
    argument: L,
) -> [L; 4] {
    // One after the other: a mapped array would call a function for each.
    let sum = |sum| even_and_odd::<_, TERMS>(|n| L::constant(term(n, sum)), argument);
    [sum(0), sum(1), sum(2), sum(3)]
}

/// P, Q, R and S. Numbers side by side that share their terms are computed together, else each with its own.
#[inline(always)]
fn all_sums<F: Fitted, R: Real, L: Numbers<Real = R>>(slides: L::Mask, argument: L) -> [L; 4] {
    let arguments = argument.to_array();
    if F::IS_ONE_SIDED && arguments.as_ref().len() > 1 {
        return if R::IS_SINGLE {
            let [terms, _] = F::SINGLE;
            abreast::<L, 6>(|n, sum| f64::from(terms[n][sum]), argument)
        } else {
            let [terms, _] = F::DOUBLE;
            abreast::<L, 12>(|n, sum| terms[n][sum], argument)
        };
    }
    let leads = L::select(slides, L::splat(1.0), L::splat(0.0)).to_array();
    let mut found = [arguments; 4];
    let [p, q, r, s] = found.each_mut().map(AsMut::as_mut);
    let lanes = p.iter_mut().zip(q).zip(r.iter_mut().zip(s));
    let given = leads.as_ref().iter().zip(arguments.as_ref());
    for (((p, q), (r, s)), (leads, argument)) in lanes.zip(given) {
        [*p, *q, *r, *s] = sums::<F, R>(*leads > R::ZERO, *argument);
    }
    found.map(L::new)
}

/// Φ and Φ' at z, as [`super::force_and_slope`].
#[inline(always)]
fn force_and_slope<F: Fitted, R: Real, L: Numbers<Real = R>>(slides: L::Mask, z: L) -> [L; 2] {
    if F::HAS_ROOTS {
        let u = z.sqrt() - L::splat(0.5);
        let [p, q, r, s] = all_sums::<F, R, L>(slides, u * u);
        return [p + u * q, r + u * s];
    }
    hooked(F::TWICE_POWER, z, all_sums::<F, R, L>(slides, z))
}

/// Φ and Φ' at z from P, Q, R and S.
#[inline(always)]
fn hooked<R: Real, L: Numbers<Real = R>>(twice_power: u32, z: L, [p, q, r, s]: [L; 4]) -> [L; 2] {
    let positive = L::repeat(R::MIN_POSITIVE).larger(z);
    let log = log_part(positive, positive.octaves(), L::repeat);
    match twice_power {
        0 => {
            let none = L::splat(0.0);
            let end = none - s * L::repeat(R::INFINITY);
            let slope = L::select(z.abs().at_most(none), end, r + log * s);
            [p + z * log * q, slope]
        }
        2 => [p + z * (z * log) * q, r + z * log * s],
        _ => [p + z * z * (z * log) * q, r + z * (z * log) * s],
    }
}

/// M, m and dm/dh; sliding leads where `slides`.
#[inline(always)]
fn components<R: Real, L: Numbers<Real = R>>(
    inv_n: R,
    slides: L::Mask,
    [ratio, z]: [L; 2],
    [phi, slope]: [L; 2],
) -> [L; 3] {
    let (none, two, inv_n) = (L::splat(0.0), L::splat(2.0), L::repeat(inv_n));
    // The slope's singularity is weaker than 1/z.
    let z_slope = L::select(z.abs().at_most(none), none, z * slope);
    let theta = inv_n * (L::splat(0.5) * phi + z_slope);
    let x = ratio * ratio;
    [
        L::select(slides, phi, inv_n * z * phi + x * theta),
        ratio * L::select(slides, theta, phi),
        L::select(slides, -(two * slope), phi + two * x * slope),
    ]
}

/// 1 − h². Where Φ has a slope everywhere, half a rounding of it does not matter near z = 0, and there is one at z = 1.
#[inline(always)]
fn complement<F: Fitted, L: Numbers>(ratio: L) -> L {
    let one = L::splat(1.0);
    if F::PRESSURE.order() < 0.0 {
        (one - ratio) * (one + ratio)
    } else {
        one - ratio * ratio
    }
}

/// The point in the digits of the precision.
#[inline(always)]
pub(super) fn point<F: Fitted, R: Real, L: Numbers<Real = R>>(slides: L::Mask, ratio: L) -> [L; 3] {
    let z = complement::<F, L>(ratio);
    let inv_n = R::ONE / moment(order::<F, R>(), R::ZERO);
    let force = force_and_slope::<F, R, L>(slides, z);
    components(inv_n, slides, [ratio, z], force)
}

/// The disk's point in half of the digits; nothing where all of them cost no more.
#[inline(always)]
pub(super) fn rough_point<F: Fitted, R: Real, L: Numbers<Real = R>>(
    slides: L::Mask,
    ratio: L,
) -> Option<[L; 3]> {
    if R::IS_SINGLE || !F::IS_ONE_SIDED {
        return None;
    }
    let z = complement::<F, L>(ratio);
    let inv_n = R::ONE / moment(order::<F, R>(), R::ZERO);
    let force = hooked(
        F::TWICE_POWER,
        z,
        abreast::<L, 6>(|n, sum| DISK_ROUGH[n][sum], z),
    );
    Some(components(inv_n, slides, [ratio, z], force))
}

/// [`point`] of a ratio.
#[inline]
pub(super) fn point_alone<F: Fitted, R: Real>(lead: DominantSpeed, ratio: R) -> [R; 3] {
    let slides = lead == DominantSpeed::Sliding;
    numbers(point::<F, R, R::Alone>(slides, R::Alone::repeat(ratio)))
}

/// [`rough_point`] of a ratio.
#[inline]
pub(super) fn rough_point_alone<F: Fitted, R: Real>(
    lead: DominantSpeed,
    ratio: R,
) -> Option<[R; 3]> {
    let slides = lead == DominantSpeed::Sliding;
    rough_point::<F, R, R::Alone>(slides, R::Alone::repeat(ratio)).map(numbers)
}

#[inline(always)]
fn numbers<R: Real>(parts: [R::Alone; 3]) -> [R; 3] {
    let [[major], [minor], [rate]] = parts.map(Numbers::to_array);
    [major, minor, rate]
}
