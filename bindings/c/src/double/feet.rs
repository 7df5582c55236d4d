//! A rigid body on several feet, each on a surface that moves by itself: belts, treads, turntables, the wheels of
//! a robot that turns in place.
//!
//! Each call validates all feet. Feet and wrenches refer to the origin of the body's coordinates.

use super::planar::tribos_planar_body_f64;
use super::shape::{Shape, tribos_shape_f64};
use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{answer, read, slice};
use crate::status::tribos_status;
use crate::table::held;
use core::mem::offset_of;
use tribos_core::contact::TimeStep;
use tribos_core::floor::{Feet, Foot, SteadyState};
use tribos_core::twist::Twist;

/// A foot, the friction that it carries, and how its surface moves. Under a wheel or tread that a body drives
/// backwards with the speed c the surface moves with (c, 0, 0).
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_foot_f64 {
    /// Its patch, in the coordinates of the body.
    pub shape: *const tribos_shape_f64,
    /// Its coefficient, the larger one of two, times its load; finite and not negative.
    pub limit: f64,
    /// Motion of the surface under it, about the origin of the body's coordinates; finite.
    pub surface: tribos_twist_f64,
}

/// A motion under which friction balances a push.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_steady_motion_f64 {
    /// Motion of the body.
    pub twist: tribos_twist_f64,
    /// Friction of all feet.
    pub friction: tribos_wrench_f64,
    /// The first foot of those that rest on their surface: the twist is that of the surface, to the last bit. The
    /// number of feet where all slide.
    pub carried_by: usize,
    /// How often friction of all feet was evaluated.
    pub evaluations: usize,
}

/// The end of a time step on feet.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_floor_step_f64 {
    /// The motion after the step.
    pub twist: tribos_twist_f64,
    /// Friction of all feet, as its mean over the step.
    pub friction: tribos_wrench_f64,
    /// As in tribos_steady_motion_f64, at the end of the step.
    pub carried_by: usize,
    /// What the search has left of the balance of momentum, over all limits: some rounding errors.
    pub imbalance: f64,
}

/// A foot of the kernel.
type Stands<'a> = Foot<f64, &'a Shape>;

// The kernel's feet have the same layout, and a shape is built at the start of its memory.
const _: () = {
    assert!(size_of::<Stands<'_>>() == size_of::<tribos_foot_f64>());
    assert!(align_of::<Stands<'_>>() == align_of::<tribos_foot_f64>());
    assert!(offset_of!(Stands<'_>, patch) == offset_of!(tribos_foot_f64, shape));
    assert!(offset_of!(Stands<'_>, limit) == offset_of!(tribos_foot_f64, limit));
    assert!(offset_of!(Stands<'_>, surface) == offset_of!(tribos_foot_f64, surface));
    assert!(offset_of!(Twist<f64>, velocity) == offset_of!(tribos_twist_f64, x));
    assert!(offset_of!(Twist<f64>, spin) == offset_of!(tribos_twist_f64, spin));
};

#[inline(always)]
unsafe fn feet_of<'a>(
    feet: *const tribos_foot_f64,
    count: usize,
) -> Result<Feet<'a, f64, &'a Shape>, tribos_status> {
    for foot in slice(feet, count)? {
        held(foot.shape)?;
    }
    Ok(Feet::new(slice(feet.cast::<Stands<'a>>(), count)?)?)
}

/// The wrench on a body that moves with `twist`. Special values: a foot that rests on its surface gives nothing.
/// TRIBOS_STATUS_UNLOADED if no foot has a limit above 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_feet_wrench_f64(
    feet: *const tribos_foot_f64,
    count: usize,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        Ok(feet_of(feet, count)?.wrench(&read(twist)?.into()).into())
    })
}

/// Wrench and Jacobian, which is symmetric.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_feet_wrench_jacobian_f64(
    feet: *const tribos_foot_f64,
    count: usize,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    if jacobian.is_null() {
        return tribos_status::NullPointer;
    }
    answer(wrench, || {
        let feet = feet_of(feet, count)?;
        let (met, rates) = feet.wrench_and_jacobian(&read(twist)?.into());
        jacobian.write(rates.into());
        Ok(met.into())
    })
}

/// The motion in which friction of the feet balances a push on the body: the one that a body comes to.
/// Accuracy: balanced to 1e-12 of all limits (f32: 5e-5). TRIBOS_STATUS_ACCELERATES if the push is more than all
/// feet carry together, TRIBOS_STATUS_MISSED if the search ended before the balance.
/// Cost: 8 to 24 evaluations with Jacobian, about 12.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_feet_steady_motion_f64(
    feet: *const tribos_foot_f64,
    count: usize,
    push: *const tribos_wrench_f64,
    motion: *mut tribos_steady_motion_f64,
) -> tribos_status {
    answer(motion, || {
        match feet_of(feet, count)?.steady_motion(&read(push)?.into()) {
            SteadyState::Balanced(found) => Ok(tribos_steady_motion_f64 {
                twist: found.twist.into(),
                friction: found.friction.into(),
                carried_by: found.carried_by.unwrap_or(count),
                evaluations: found.evaluations,
            }),
            SteadyState::Accelerates => Err(tribos_status::Accelerates),
            SteadyState::Missed(_) => Err(tribos_status::Missed),
        }
    })
}

/// The motion of a body after the time dt under a constant push and the friction of its feet, whose origin is the
/// centre of mass. Accuracy: second order in dt while all feet slide; feet that come to rest on their surface do
/// so in every bit. Special values: NaN for NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_feet_step_f64(
    body: *const tribos_planar_body_f64,
    feet: *const tribos_foot_f64,
    count: usize,
    twist: *const tribos_twist_f64,
    push: *const tribos_wrench_f64,
    dt: f64,
    step: *mut tribos_floor_step_f64,
) -> tribos_status {
    answer(step, || {
        let (body, feet) = (read(body)?.body()?, feet_of(feet, count)?);
        let (twist, push) = (read(twist)?.into(), read(push)?.into());
        let end = feet.step(&body, &twist, &push, TimeStep::new(dt)?);
        Ok(tribos_floor_step_f64 {
            twist: end.twist.into(),
            friction: end.friction.into(),
            carried_by: end.carried_by.unwrap_or(count),
            imbalance: end.imbalance,
        })
    })
}
