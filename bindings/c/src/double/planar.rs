//! Implicit time steps of a body on its patch, with exact sticking.
//!
//! Friction that balances the push within its limit surface holds the body, to the last bit. Otherwise it
//! opposes the motion at half time, and takes power from it.

use super::shape::{surface_of, tribos_shape_f64};
use super::surface::{Set, tribos_disk_surface_f64, tribos_ellipsoid_f64};
use super::vectors::{tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{answer, read};
use crate::status::tribos_status;
use tribos_core::contact::TimeStep;
use tribos_core::law::LawError;
use tribos_core::planar::{PlanarBody, PlanarStep};

/// A body on a patch that is centred below its centre of mass.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_planar_body_f64 {
    /// Mass, positive and finite.
    pub mass: f64,
    /// Moment of inertia about the normal, positive and finite. Units: mass x length^2.
    pub inertia: f64,
}

/// The end of a time step.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_planar_step_f64 {
    /// The motion after the step.
    pub twist: tribos_twist_f64,
    /// Friction on the body, as its mean over the step.
    pub friction: tribos_wrench_f64,
    /// 1 if friction holds the body: the motion is zero, to the last bit. 0 else.
    pub is_at_rest: u32,
}

impl tribos_planar_body_f64 {
    #[inline(always)]
    pub(super) fn body(self) -> Result<PlanarBody<f64>, LawError> {
        PlanarBody::new(self.mass, self.inertia)
    }
}

impl From<&PlanarStep<f64>> for tribos_planar_step_f64 {
    #[inline(always)]
    fn from(step: &PlanarStep<f64>) -> Self {
        Self {
            twist: step.twist.into(),
            friction: step.friction.into(),
            is_at_rest: step.is_at_rest.into(),
        }
    }
}

/// One step on a set.
#[inline(always)]
unsafe fn step_on<S: Set>(
    body: *const tribos_planar_body_f64,
    set: *const S,
    twist: *const tribos_twist_f64,
    push: *const tribos_wrench_f64,
    dt: f64,
) -> Result<tribos_planar_step_f64, tribos_status> {
    let (body, set) = (read(body)?.body()?, read(set)?.set()?);
    let (twist, push) = (read(twist)?.into(), read(push)?.into());
    Ok((&body.step(&set, &twist, &push, TimeStep::new(dt)?)).into())
}

/// The motion of a body after the time dt under a constant push and the friction of a disk.
/// Accuracy: second order in dt while the body slides; rest is exact.
/// Special values: NaN for NaN, and where momentum/dt overflows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_planar_disk_step_f64(
    body: *const tribos_planar_body_f64,
    surface: *const tribos_disk_surface_f64,
    twist: *const tribos_twist_f64,
    push: *const tribos_wrench_f64,
    dt: f64,
    step: *mut tribos_planar_step_f64,
) -> tribos_status {
    answer(step, || step_on(body, surface, twist, push, dt))
}

/// As tribos_planar_disk_step_f64, under the friction of an ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_planar_ellipsoid_step_f64(
    body: *const tribos_planar_body_f64,
    ellipsoid: *const tribos_ellipsoid_f64,
    twist: *const tribos_twist_f64,
    push: *const tribos_wrench_f64,
    dt: f64,
    step: *mut tribos_planar_step_f64,
) -> tribos_status {
    answer(step, || step_on(body, ellipsoid, twist, push, dt))
}

/// As tribos_planar_disk_step_f64 with friction that is `strength`, the static over the dynamic coefficient, times
/// that of the surface while the body rests. A body at rest, whose twist is exactly zero, keeps every bit of it
/// while the push lies in strength x surface; beyond, it slides under the surface in the same step. Domain:
/// 1 <= strength; less counts as 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_planar_disk_step_sticking_f64(
    body: *const tribos_planar_body_f64,
    surface: *const tribos_disk_surface_f64,
    strength: f64,
    twist: *const tribos_twist_f64,
    push: *const tribos_wrench_f64,
    dt: f64,
    step: *mut tribos_planar_step_f64,
) -> tribos_status {
    answer(step, || {
        let (body, set) = (read(body)?.body()?, read(surface)?.set()?);
        let (twist, push) = (read(twist)?.into(), read(push)?.into());
        let dt = TimeStep::new(dt)?;
        Ok((&body.step_sticking(&set, strength, &twist, &push, dt)).into())
    })
}

/// As tribos_planar_disk_step_sticking_f64, on a patch of any shape with force_limit = dynamic coefficient x load,
/// whose origin is the centre of mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_planar_shape_step_sticking_f64(
    body: *const tribos_planar_body_f64,
    shape: *const tribos_shape_f64,
    force_limit: f64,
    strength: f64,
    twist: *const tribos_twist_f64,
    push: *const tribos_wrench_f64,
    dt: f64,
    step: *mut tribos_planar_step_f64,
) -> tribos_status {
    answer(step, || {
        let (body, set) = (read(body)?.body()?, surface_of(shape, force_limit)?);
        let (twist, push) = (read(twist)?.into(), read(push)?.into());
        let dt = TimeStep::new(dt)?;
        Ok((&body.step_sticking(&set, strength, &twist, &push, dt)).into())
    })
}
