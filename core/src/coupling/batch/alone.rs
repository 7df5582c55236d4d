//! Targets without such vectors: every speed goes to the scalar function.

use crate::coupling::{ReducedFriction, SmoothProfile};
use crate::lanes::Group;
use crate::real::Real;
use crate::twist::{Twist, WrenchJacobian};

/// A profile; here without lanes.
pub trait LaneProfile<R: Real>: SmoothProfile<R> {}

impl<R: Real, P: SmoothProfile<R>> LaneProfile<R> for P {}

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
pub fn patch_wrenches<R: Real, C: ReducedFriction<R>>(
    _: &C,
    _: [R; 2],
    _: [&Group<R>; 3],
) -> Option<[Group<R>; 3]> {
    None
}

#[inline]
pub fn patch_jacobians<R: Real, C: ReducedFriction<R>>(
    _: &C,
    _: [R; 2],
    _: &Group<Twist<R>>,
) -> Option<Group<WrenchJacobian<R>>> {
    None
}
