//! One body that slides and spins to rest on a plane: a uniform disk under Coulomb friction.

use crate::fields::same_fields;
use crate::memory::{answer, read};
use crate::status::tribos_status;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// A sliding body; all parameters are positive and finite.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_slider_f64 {
    /// Deceleration of pure sliding, mu x gravity.
    pub deceleration: f64,
    /// Radius of the contact.
    pub radius: f64,
    /// Inertia ratio I/(M radius^2): 1/2 for a disk on its own face.
    pub inertia_ratio: f64,
}

/// The state of a slider, in units consistent with its deceleration and radius.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_motion_f64 {
    /// Time since the start.
    pub time: f64,
    /// Sliding speed, not negative.
    pub speed: f64,
    /// Spin, of either sign.
    pub spin: f64,
    /// Distance covered.
    pub distance: f64,
    /// Angle turned, in radians.
    pub angle: f64,
}

/// State of a slider at rest.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_rest_f64 {
    /// Time, distance and angle at rest; speeds zero.
    pub motion: tribos_motion_f64,
    /// Ratio of sliding to rim speed in the limit of rest.
    pub ratio: f64,
    /// Evaluations of the wrench.
    pub evaluations: u32,
}

/// State of a slider at the end of a step.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_advance_f64 {
    /// The motion at the end of the step.
    pub motion: tribos_motion_f64,
    /// Ratio of sliding to rim speed in the limit of rest; NaN if the body is still moving.
    pub ratio: f64,
    /// 1 if the body comes to rest in this step, else 0.
    pub came_to_rest: u32,
    /// Evaluations of the wrench.
    pub evaluations: u32,
}

same_fields!(tribos_motion_f64, SliderState<f64> { time, speed, spin, distance, angle });

#[inline(always)]
unsafe fn slider_of(
    slider: *const tribos_slider_f64,
) -> Result<Slider<f64, CoulombDisk>, tribos_status> {
    let s = read(slider)?;
    Ok(Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: s.deceleration,
            radius: s.radius,
            inertia_ratio: s.inertia_ratio,
        },
    )?)
}

/// One velocity-Verlet step of size duration > 0, in place. Friction stops a motion and never reverses
/// it. Accuracy: second order in motion, first order at the stop. Cost: two wrenches.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_slider_verlet_step_f64(
    slider: *const tribos_slider_f64,
    motion: *mut tribos_motion_f64,
    duration: f64,
) -> tribos_status {
    answer(motion, || {
        let start = read(motion)?.into();
        Ok(slider_of(slider)?.verlet_step(&start, duration).into())
    })
}

/// Advances the motion by duration >= 0, also past rest. Accuracy: as tribos_slider_to_rest_f64.
/// Cost: 8 evaluations of the wrench if the speeds change by less than a few thousandths, 12 up to
/// a few hundredths; otherwise about 50 to 250.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_slider_advance_f64(
    slider: *const tribos_slider_f64,
    motion: *const tribos_motion_f64,
    duration: f64,
    advance: *mut tribos_advance_f64,
) -> tribos_status {
    answer(advance, || {
        let start = read(motion)?.into();
        let end = slider_of(slider)?.advance(&start, duration);
        Ok(tribos_advance_f64 {
            motion: end.motion.into(),
            ratio: end.rest.map_or(f64::NAN, |rest| rest.ratio),
            came_to_rest: end.rest.is_some().into(),
            evaluations: end.evaluations,
        })
    })
}

/// Advances the motion to rest; TRIBOS_STATUS_NO_REST if it is not finite. Accuracy: 1e-13
/// relative in each of time, distance and angle (f32: 5e-6), whichever motion ends first. Cost: about
/// 150 evaluations of the wrench, rarely more than 500.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_slider_to_rest_f64(
    slider: *const tribos_slider_f64,
    motion: *const tribos_motion_f64,
    rest: *mut tribos_rest_f64,
) -> tribos_status {
    answer(rest, || {
        let start = read(motion)?.into();
        let end = slider_of(slider)?.to_rest(&start);
        let end = end.ok_or(tribos_status::NoRest)?;
        Ok(tribos_rest_f64 {
            motion: end.motion.into(),
            ratio: end.ratio,
            evaluations: end.evaluations,
        })
    })
}

/// Kinetic energy per mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_slider_energy_f64(
    slider: *const tribos_slider_f64,
    motion: *const tribos_motion_f64,
    energy_per_mass: *mut f64,
) -> tribos_status {
    answer(energy_per_mass, || {
        Ok(slider_of(slider)?.energy_per_mass(&read(motion)?.into()))
    })
}

/// Power dissipated by friction, per mass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_slider_dissipation_f64(
    slider: *const tribos_slider_f64,
    motion: *const tribos_motion_f64,
    power_per_mass: *mut f64,
) -> tribos_status {
    answer(power_per_mass, || {
        let motion = read(motion)?.into();
        Ok(slider_of(slider)?.dissipation_per_mass(&motion))
    })
}
