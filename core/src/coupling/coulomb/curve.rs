//! The curve of the limit surface of a fitted form, of ratios alone or side by side.
//!
//! A search along it asks for the components M, m and the rate dm/dh where one speed leads:
//!
//! ```text
//! sliding leads:     M = Φ,     m = hΧ,     dm/dh = −2Φ'
//! spinning leads:    M = Χ,     m = hΦ,     dm/dh = Φ + 2h²Φ'
//! ```

use super::form::{self, numbers};
use super::terms::DISK_POWERS;
use super::{DominantSpeed, Fitted};
use crate::lanes::Numbers;
use crate::real::{Real, Sealed as _};

/// m/h by powers of h².
#[inline]
pub(super) fn minor_powers<R: Real>(lead: DominantSpeed) -> [R; 6] {
    let [theta, phi] = &DISK_POWERS;
    match lead {
        DominantSpeed::Sliding => theta.map(R::from_f64),
        DominantSpeed::Spinning => phi.map(R::from_f64),
    }
}

/// M, m and dm/dh; sliding leads where `slides`.
#[inline(always)]
fn components<F: Fitted, L: Numbers<Real: Real>>(
    slides: L::Mask,
    [ratio, z]: [L; 2],
    [phi, slope]: [L; 2],
) -> [L; 3] {
    let (two, x) = (L::splat(2.0), ratio * ratio);
    let chi = form::torque_of_slope::<F, L>(slides, [x, z], [phi, slope]);
    [
        L::select(slides, phi, chi),
        ratio * L::select(slides, chi, phi),
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
pub(super) fn point<F: Fitted, L: Numbers<Real: Real>>(slides: L::Mask, ratio: L) -> [L; 3] {
    let z = complement::<F, L>(ratio);
    let force = form::force_and_slope::<F, L>(slides, z);
    components::<F, L>(slides, [ratio, z], force)
}

/// The disk's point in half of the digits; nothing where all of them cost no more.
#[inline(always)]
pub(super) fn rough_point<F: Fitted, L: Numbers<Real: Real>>(
    slides: L::Mask,
    ratio: L,
) -> Option<[L; 3]> {
    if L::Real::IS_SINGLE || !F::IS_ONE_SIDED {
        return None;
    }
    let z = complement::<F, L>(ratio);
    let force = form::rough_force_and_slope::<F, L>(z);
    Some(components::<F, L>(slides, [ratio, z], force))
}

/// [`point`] of a ratio.
#[inline]
pub(super) fn point_alone<F: Fitted, R: Real>(lead: DominantSpeed, ratio: R) -> [R; 3] {
    let slides = lead == DominantSpeed::Sliding;
    numbers(point::<F, R::Alone>(slides, R::Alone::repeat(ratio)))
}

/// [`rough_point`] of a ratio.
#[inline]
pub(super) fn rough_point_alone<F: Fitted, R: Real>(
    lead: DominantSpeed,
    ratio: R,
) -> Option<[R; 3]> {
    let slides = lead == DominantSpeed::Sliding;
    rough_point::<F, R::Alone>(slides, R::Alone::repeat(ratio)).map(numbers)
}
