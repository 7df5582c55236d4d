//! Targets without such vectors: every speed goes to the scalar function.

use super::Group;
use crate::coupling::{Coupling, Profile};
use crate::real::Real;
use crate::twist::{Twist, Wrench, WrenchJacobian};

/// A precision; here without lanes.
pub trait Laned {}

impl Laned for f32 {}
impl Laned for f64 {}

/// A profile; here without lanes.
pub trait LaneProfile<R: Real> {}

impl<R: Real, P: Profile<R>> LaneProfile<R> for P {}

#[inline]
pub fn drags<R: Real, P: LaneProfile<R>>(
    _: &P,
    _: &Group<R>,
    _: &Group<R>,
) -> Option<[Group<R>; 2]> {
    None
}

#[inline]
pub fn wrenches<R: Real, P: LaneProfile<R>>(
    _: &P,
    _: &Group<R>,
    _: &Group<R>,
) -> Option<[Group<R>; 2]> {
    None
}

#[inline]
pub fn jacobians<R: Real, P: LaneProfile<R>>(
    _: &P,
    _: &Group<R>,
    _: &Group<R>,
) -> Option<[Group<R>; 4]> {
    None
}

#[inline]
pub fn patch_wrenches<R: Real, C: Coupling<R>>(
    _: &C,
    _: [R; 2],
    _: &Group<Twist<R>>,
) -> Option<Group<Wrench<R>>> {
    None
}

#[inline]
pub fn patch_jacobians<R: Real, C: Coupling<R>>(
    _: &C,
    _: [R; 2],
    _: &Group<Twist<R>>,
) -> Option<Group<WrenchJacobian<R>>> {
    None
}
