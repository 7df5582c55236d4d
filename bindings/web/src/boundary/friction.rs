//! Friction of a patch at its motion.

use super::rows;
use crate::exchange::{answer, status};
use crate::friction::{jacobians as all_jacobians, nine, row_of, twist_of, wrenches as all};
use crate::patch::Patch;

/// Refuses a disk that is none.
#[unsafe(no_mangle)]
pub extern "C" fn check(patch: u32, radius: f64, mu: f64) -> u32 {
    let patch = patch_of(patch, radius, mu);
    status(patch.contact(|_| ()))
}

/// Force and torque.
#[unsafe(no_mangle)]
pub extern "C" fn wrench(
    patch: u32,
    radius: f64,
    mu: f64,
    load: f64,
    vx: f64,
    vy: f64,
    spin: f64,
) -> u32 {
    let twist = twist_of([vx, vy, spin]);
    let made = patch_of(patch, radius, mu).contact(|contact| row_of(&contact.wrench(load, &twist)));
    status(made.map(answer))
}

/// Their derivatives, row by row.
#[unsafe(no_mangle)]
pub extern "C" fn jacobian(
    patch: u32,
    radius: f64,
    mu: f64,
    load: f64,
    vx: f64,
    vy: f64,
    spin: f64,
) -> u32 {
    let twist = twist_of([vx, vy, spin]);
    let made = patch_of(patch, radius, mu).contact(|contact| nine(&contact.jacobian(load, &twist)));
    status(made.map(answer))
}

/// `count` twists become wrenches, in place, under one load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn wrenches(
    patch: u32,
    radius: f64,
    mu: f64,
    load: f64,
    twists: *mut [f64; 3],
    count: usize,
) -> u32 {
    let twists = rows(twists, count);
    status(patch_of(patch, radius, mu).contact(|contact| all(contact, load, twists)))
}

/// `count` twists become wrenches, in place, each under its own load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn wrenches_under_loads(
    patch: u32,
    radius: f64,
    mu: f64,
    loads: *mut [f64; 1],
    twists: *mut [f64; 3],
    count: usize,
) -> u32 {
    let (loads, twists) = (rows(loads, count), rows(twists, count));
    status(patch_of(patch, radius, mu).contact(|contact| {
        for (row, [load]) in twists.iter_mut().zip(loads) {
            *row = row_of(&contact.wrench(*load, &twist_of(*row)));
        }
    }))
}

/// The Jacobians of `count` twists under one load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn jacobians(
    patch: u32,
    radius: f64,
    mu: f64,
    load: f64,
    twists: *mut [f64; 3],
    out: *mut [f64; 9],
    count: usize,
) -> u32 {
    let (twists, out) = (rows(twists, count), rows(out, count));
    status(patch_of(patch, radius, mu).contact(|contact| all_jacobians(contact, load, twists, out)))
}

/// The Jacobians of `count` twists, each under its own load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn jacobians_under_loads(
    patch: u32,
    radius: f64,
    mu: f64,
    loads: *mut [f64; 1],
    twists: *mut [f64; 3],
    out: *mut [f64; 9],
    count: usize,
) -> u32 {
    let (loads, twists, out) = (rows(loads, count), rows(twists, count), rows(out, count));
    status(patch_of(patch, radius, mu).contact(|contact| {
        for ((out, twist), [load]) in out.iter_mut().zip(twists).zip(loads) {
            *out = nine(&contact.jacobian(*load, &twist_of(*twist)));
        }
    }))
}

/// A patch by its handle or its numbers.
pub(super) fn patch_of(handle: u32, radius: f64, mu: f64) -> Patch {
    Patch { handle, radius, mu }
}
