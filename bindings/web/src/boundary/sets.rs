//! Limit surfaces. `model` is 0 for the exact one, 1 for the ellipsoid and 2 for separate limits; `lever` and
//! `spin_torque` describe an approximation.

use super::friction::patch_of;
use super::rows;
use crate::exchange::{answer, status};
use crate::friction::{row_of, row_of_twist, twist_of, wrench_of};
use crate::surface::{Surface, meridian as curve, projected, shape};
use tribos_core::limit_surface::FrictionSet;

/// Lever, and largest torque over force limit and lever: what an approximation needs.
#[unsafe(no_mangle)]
pub extern "C" fn surface_shape(patch: u32, radius: f64) -> u32 {
    status(shape(patch_of(patch, radius, 0.0)).map(answer))
}

/// Refuses a surface that is none; leaves its radius and its largest torque.
#[unsafe(no_mangle)]
pub extern "C" fn surface(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let limits = surface.with(|set| [set.radius(), set.support(&twist_of([0.0, 0.0, 1.0]))]);
    status(limits.map(answer))
}

/// The factor by which the set must grow to hold a wrench.
#[unsafe(no_mangle)]
pub extern "C" fn gauge(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    fx: f64,
    fy: f64,
    torque: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let wrench = wrench_of([fx, fy, torque]);
    row(&surface, |set| [set.gauge(&wrench)])
}

/// 1 if friction can carry a wrench, else 0.
#[unsafe(no_mangle)]
pub extern "C" fn contains(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    fx: f64,
    fy: f64,
    torque: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let wrench = wrench_of([fx, fy, torque]);
    row(&surface, |set| [u32::from(set.contains(&wrench)).into()])
}

/// The motion that a push causes.
#[unsafe(no_mangle)]
pub extern "C" fn normal(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    fx: f64,
    fy: f64,
    torque: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let push = wrench_of([fx, fy, torque]);
    row(&surface, |set| row_of_twist(&set.twist_normal_to(&push)))
}

/// The wrench on the surface along a ray.
#[unsafe(no_mangle)]
pub extern "C" fn scale_to_surface(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    fx: f64,
    fy: f64,
    torque: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let wrench = wrench_of([fx, fy, torque]);
    row(&surface, |set| row_of(&set.scale_to_surface(&wrench)))
}

/// The nearest wrench, the normal there, and 1 if it is on the surface. A `length` of 0 stands for the radius
/// of the set.
#[unsafe(no_mangle)]
pub extern "C" fn project(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    fx: f64,
    fy: f64,
    torque: f64,
    length: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let wrench = wrench_of([fx, fy, torque]);
    row(&surface, |set| {
        let length = if length == 0.0 { set.radius() } else { length };
        projected(&set.project_with_length(&wrench, length))
    })
}

/// The power that friction takes from a motion.
#[unsafe(no_mangle)]
pub extern "C" fn support(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    vx: f64,
    vy: f64,
    spin: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let twist = twist_of([vx, vy, spin]);
    row(&surface, |set| [set.support(&twist)])
}

/// Friction at a motion.
#[unsafe(no_mangle)]
pub extern "C" fn surface_wrench(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    vx: f64,
    vy: f64,
    spin: f64,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let twist = twist_of([vx, vy, spin]);
    row(&surface, |set| row_of(&set.wrench(&twist)))
}

/// Gauges of `count` wrenches.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gauges(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    wrenches: *mut [f64; 3],
    out: *mut [f64; 1],
    count: usize,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let (wrenches, out) = (rows(wrenches, count), rows(out, count));
    status(surface.with(|set| {
        for (out, wrench) in out.iter_mut().zip(wrenches) {
            *out = [set.gauge(&wrench_of(*wrench))];
        }
    }))
}

/// `count` twists become friction, in place.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn surface_wrenches(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    twists: *mut [f64; 3],
    count: usize,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let twists = rows(twists, count);
    status(surface.with(|set| {
        for row in twists {
            *row = row_of(&set.wrench(&twist_of(*row)));
        }
    }))
}

/// `count` pushes of a curve from one pure spin to the other.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn meridian(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
    direction: f64,
    out: *mut [f64; 3],
    count: usize,
) -> u32 {
    let surface = surface_of(patch, radius, force_limit, model, lever, spin_torque);
    let out = rows(out, count);
    status(surface.with(|set| curve(set, direction, out)))
}

/// A surface by its numbers.
pub(super) fn surface_of(
    patch: u32,
    radius: f64,
    force_limit: f64,
    model: u32,
    lever: f64,
    spin_torque: f64,
) -> Surface {
    Surface {
        patch: patch_of(patch, radius, 0.0),
        force_limit,
        model,
        lever,
        spin_torque,
    }
}

/// Leaves what `of` gives.
fn row<const N: usize>(
    surface: &Surface,
    of: impl FnOnce(&dyn FrictionSet<f64>) -> [f64; N],
) -> u32 {
    status(surface.with(of).map(answer))
}
