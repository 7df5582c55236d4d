//! Powers of a fixed exponent: look-ups lane by lane, the arithmetic in lanes.

use super::Lanes;
use crate::lanes::{Eight as _, GROUP, Lanes as _, Numbers};
use crate::power::{FixedPower, Parts};
use crate::real::Real;

/// `x`^α; None where the table does not reach.
#[inline(always)]
fn inside<R: Real>(power: &FixedPower<R>, x: Lanes<R>) -> Option<Lanes<R>> {
    let mut parts = [Parts::default(); GROUP];
    for (parts, x) in parts.iter_mut().zip(x.to_array()) {
        *parts = power.parts(x)?;
    }
    let together = |part: fn(&Parts<R>) -> R| Lanes::<R>::new(parts.each_ref().map(part));
    let parts = Parts {
        head: together(|of| of.head),
        tail: together(|of| of.tail),
        inverse: together(|of| of.inverse),
        octave: [together(|of| of.octave[0]), together(|of| of.octave[1])],
        cell: [together(|of| of.cell[0]), together(|of| of.cell[1])],
    };
    let terms = power.terms().map(Lanes::<R>::repeat);
    let found = parts.joined(&terms, Numbers::repeat(R::ONE), R::IS_SINGLE);
    Lanes::<R>::all(found.equal(found)).then_some(found)
}

/// [`FixedPower::of`]
#[inline(always)]
pub fn of<R: Real>(power: &FixedPower<R>, x: Lanes<R>) -> Option<Lanes<R>> {
    if power.alpha() == R::ZERO {
        return Some(Numbers::repeat(R::ONE));
    }
    inside(power, x)
}

/// [`FixedPower::rate`]
#[inline(always)]
pub fn rate<R: Real>(power: &FixedPower<R>, x: Lanes<R>) -> Option<Lanes<R>> {
    if power.alpha() == R::ZERO {
        return Some(Lanes::<R>::repeat(R::ONE) / x);
    }
    Some(inside(power, x)? / x)
}
