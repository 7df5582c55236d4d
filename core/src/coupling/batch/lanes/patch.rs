//! Contacts with their dimensions.

use super::Lanes;
use super::speeds::are_ordinary;
use crate::coupling::ReducedFriction;
use crate::lanes::{Eight as _, GROUP, Group, Lanes as _, Numbers};
use crate::real::Real;
use crate::twist::{Twist, WrenchJacobian};
use nalgebra::Matrix3;

/// The three components of the twists.
#[inline(always)]
fn components<R: Real>(twists: &Group<Twist<R>>) -> [Lanes<R>; 3] {
    [
        Numbers::new(twists.each_ref().map(|twist| twist.velocity.x)),
        Numbers::new(twists.each_ref().map(|twist| twist.velocity.y)),
        Numbers::new(twists.each_ref().map(|twist| twist.spin)),
    ]
}

/// `size` ≥ 0 with the sign of `sign`.
#[inline(always)]
fn signed<R: Real>(size: Lanes<R>, sign: Lanes<R>) -> Lanes<R> {
    size | (sign & Numbers::repeat(-R::ZERO))
}

/// Forces and torques of a patch with the given radius and coefficient × load at the components of
/// twists; nothing if a twist or a wrench is out of the ordinary.
#[inline(always)]
pub fn patch_wrenches<R: Real, C: ReducedFriction<R>>(
    coupling: &C,
    [strength, radius]: [R; 2],
    twists: [&Group<R>; 3],
) -> Option<[Group<R>; 3]> {
    let splat = Lanes::<R>::repeat;
    let [x, y, spin] = twists.map(|components| Lanes::<R>::new(*components));
    let rim = (spin * splat(radius)).abs();
    let square = x * x + y * y;
    let (least, most) = (R::LEAST_SPEED, R::ONE / R::LEAST_SPEED);
    let moves = square.above(splat(least * least)) & splat(most * most).above(square);
    let turns = rim.above(splat(least)) & splat(most).above(rim);
    if !Lanes::<R>::all(moves & (turns | rim.equal(splat(R::ZERO)))) {
        return None;
    }
    let [drag, torque] = coupling
        .reduced_drags(&square.to_array(), &rim.to_array())?
        .map(Lanes::<R>::new);
    let drag = splat(strength) * drag;
    if !Lanes::<R>::all(are_ordinary::<R>(drag)) {
        return None;
    }
    let torque = signed::<R>(splat(strength * radius) * torque, spin);
    Some([-(drag * x), -(drag * y), -torque].map(Numbers::to_array))
}

/// ∂wrench/∂twist.
#[inline(always)]
pub fn patch_jacobians<R: Real, C: ReducedFriction<R>>(
    coupling: &C,
    [strength, radius]: [R; 2],
    twists: &Group<Twist<R>>,
) -> Option<Group<WrenchJacobian<R>>> {
    let splat = Lanes::<R>::repeat;
    let [x, y, spin] = components(twists);
    let [none, one, infinite] = [R::ZERO, R::ONE, R::INFINITY].map(splat);
    let (large, small) = (x.abs().larger(y.abs()), x.abs().smaller(y.abs()));
    let finite = infinite.above(x.abs()) & infinite.above(y.abs());
    if !Lanes::<R>::all(finite & large.above(none)) {
        return None;
    }
    let quotient = small / large;
    let speed = large * (one + quotient * quotient).sqrt();
    let rim = spin * splat(radius);
    let [across, along, mixed, turn] = coupling
        .reduced_jacobians(&speed.to_array(), &rim.to_array())?
        .map(Lanes::<R>::new);
    let (cos, sin) = (x / speed, y / speed);
    let (along, across) = (splat(strength) * along, splat(strength) * across);
    let alike = along.equal(across);
    let (cc, ss) = (cos * cos, sin * sin);
    let xx = Lanes::<R>::select(alike, along, along * cc + across * ss);
    let xy = Lanes::<R>::select(alike, none, (along - across) * cos * sin);
    let yy = Lanes::<R>::select(alike, along, along * ss + across * cc);
    let mixed = splat(strength * radius) * mixed * signed::<R>(one, spin);
    let (xn, yn) = (mixed * cos, mixed * sin);
    let nn = splat(strength * radius * radius) * turn;
    let entries = [xx, xy, xn, yy, yn, nn].map(|entry| (-entry).to_array());
    let mut jacobians = [Matrix3::from_element(R::ZERO); GROUP];
    let [xx, xy, xn, yy, yn, nn] = entries.each_ref().map(|entry| entry.iter().copied());
    let columns = xx.zip(xy).zip(xn).zip(yy).zip(yn).zip(nn);
    for (jacobian, (((((xx, xy), xn), yy), yn), nn)) in jacobians.iter_mut().zip(columns) {
        *jacobian = Matrix3::new(xx, xy, xn, xy, yy, yn, xn, yn, nn);
    }
    Some(jacobians)
}
