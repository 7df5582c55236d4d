//! Bodies in motion.

use super::friction::patch_of;
use super::rows;
use super::sets::surface_of;
use crate::exchange::{answer, counted, status};
use crate::planar::{Stepper, Trajectory, to_rest};
use crate::slide::LaunchedBody;
use tribos_core::slider::SliderParameters;

/// Refuses a body that is none.
#[unsafe(no_mangle)]
pub extern "C" fn check_body(mass: f64, inertia: f64) -> u32 {
    status(Stepper::new(mass, inertia, 1.0).map(|_| ()))
}

/// One implicit time step with static friction that is `strength` times kinetic friction, which `tribos/all` alone
/// heeds: twist, friction, and 1 at rest.
#[unsafe(no_mangle)]
pub extern "C" fn step(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    mass: f64,
    inertia: f64,
    strength: f64,
    dt: f64,
    angle: f64,
    vx: f64,
    vy: f64,
    spin: f64,
    fx: f64,
    fy: f64,
    torque: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let done = Stepper::new(mass, inertia, dt).and_then(|stepper| {
        surface.with(|set| {
            stepper
                .sticking(strength)
                .step(set, angle, [vx, vy, spin], [fx, fy, torque])
                .row()
        })
    });
    status(done.map(answer))
}

/// Steps under one push: at most `count` rows of time, pose and twist, the first for the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rollout(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    mass: f64,
    inertia: f64,
    strength: f64,
    dt: f64,
    vx: f64,
    vy: f64,
    spin: f64,
    fx: f64,
    fy: f64,
    torque: f64,
    x: f64,
    y: f64,
    angle: f64,
    out: *mut [f64; 7],
    count: usize,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let out = rows(out, count);
    let course = Trajectory {
        twist: [vx, vy, spin],
        pose: [x, y, angle],
        push: [fx, fy, torque],
        turns: surface.patch.turns(),
    };
    let made = Stepper::new(mass, inertia, dt)
        .map(|stepper| stepper.sticking(strength))
        .and_then(|stepper| surface.with(|set| course.follow(set, &stepper, out)));
    counted(made)
}

/// A free motion to rest in about `steps` steps: at most `count` such rows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rollout_to_rest(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    mass: f64,
    inertia: f64,
    vx: f64,
    vy: f64,
    spin: f64,
    steps: usize,
    out: *mut [f64; 7],
    count: usize,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let out = rows(out, count);
    let body = [mass, inertia];
    counted(to_rest(&surface, body, [vx, vy, spin], steps, out))
}

/// Time, distance, x, y, angle and last ratio of a free motion at rest, on a round patch.
#[unsafe(no_mangle)]
pub extern "C" fn slide_to_rest(
    patch: u32,
    deceleration: f64,
    radius: f64,
    inertia_ratio: f64,
    vx: f64,
    vy: f64,
    spin: f64,
) -> u32 {
    let thrown = thrown(deceleration, radius, inertia_ratio, [vx, vy, spin]);
    let rest = patch_of(patch, radius, 1.0).glides(|patch| thrown.rest(patch));
    status(rest.map(answer))
}

/// Time, pose and twist of a free motion after a time, and 1 at rest, on a round patch.
#[unsafe(no_mangle)]
pub extern "C" fn advance(
    patch: u32,
    deceleration: f64,
    radius: f64,
    inertia_ratio: f64,
    vx: f64,
    vy: f64,
    spin: f64,
    time: f64,
) -> u32 {
    let thrown = thrown(deceleration, radius, inertia_ratio, [vx, vy, spin]);
    let after = patch_of(patch, radius, 1.0).glides(|patch| thrown.after(patch, time));
    status(after.map(answer))
}

/// Rows of time, pose and twist at `count` even times from the launch to rest, on a round patch.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slide_path(
    patch: u32,
    deceleration: f64,
    radius: f64,
    inertia_ratio: f64,
    vx: f64,
    vy: f64,
    spin: f64,
    out: *mut [f64; 7],
    count: usize,
) -> u32 {
    let thrown = thrown(deceleration, radius, inertia_ratio, [vx, vy, spin]);
    let rows = rows(out, count);
    status(patch_of(patch, radius, 1.0).glides(|patch| thrown.path(patch, rows)))
}

/// Interval of the inertia ratio, stabilities, ratios and last ratio of the final motion on a round patch.
/// `initial_ratio` is NaN if it is not known.
#[unsafe(no_mangle)]
pub extern "C" fn modes(patch: u32, inertia_ratio: f64, initial_ratio: f64) -> u32 {
    let patch = patch_of(patch, 1.0, 1.0);
    let made = patch.glides(|patch| patch.modes(inertia_ratio, initial_ratio));
    status(made.map(|made| answer(made.row())))
}

fn thrown(deceleration: f64, radius: f64, inertia_ratio: f64, twist: [f64; 3]) -> LaunchedBody {
    LaunchedBody {
        parameters: SliderParameters {
            deceleration,
            radius,
            inertia_ratio,
        },
        twist,
    }
}
