//! Several surfaces under a patch, several feet, and two coefficients.

use super::friction::patch_of;
use super::prepared::{keep_area, loops_of};
use super::rows;
use crate::all::floor::{self, FOOT};
use crate::all::store::{self, Item, OTHER};
use crate::exchange::{Refused, answer, status};
use crate::friction::{nine, row_of, twist_of};
use alloc::format;
use alloc::vec::Vec;
use tribos_friction::{Area, Floor};

/// A patch with two coefficients, along an axis and across it: as other patches.
#[unsafe(no_mangle)]
pub extern "C" fn make_two_coefficients(
    patch: u32,
    radius: f64,
    mu: f64,
    along: f64,
    across: f64,
    angle: f64,
) -> u32 {
    let area = floor::two_coefficients(&patch_of(patch, radius, mu), [along, across], angle);
    keep_area(area, &format!("coulomb:mu={}", along.max(across)))
}

/// A patch on surfaces, by the corners of each in a row, their numbers, and the twists: handle, limit, number of feet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_floor(
    patch: u32,
    radius: f64,
    mu: f64,
    load: f64,
    corners: *mut [f64; 2],
    corner_count: usize,
    counts: *mut [f64; 1],
    twists: *mut [f64; 3],
    count: usize,
) -> u32 {
    let loops = loops_of(rows(corners, corner_count), rows(counts, count));
    let surfaces = loops.iter().zip(rows(twists, count));
    let surfaces = surfaces.map(|(corners, twist)| floor::surface(corners, *twist));
    let made = surfaces.collect::<Result<Vec<_>, Refused>>();
    let patch = patch_of(patch, radius, mu);
    keep(made.and_then(|surfaces| floor::under(&patch, load, &surfaces)))
}

/// A body on feet in rows: handle, limit, number of feet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_feet(feet: *mut [f64; FOOT], count: usize) -> u32 {
    keep(floor::feet(rows(feet, count)))
}

fn keep(floor: Result<Floor, Refused>) -> u32 {
    status(floor.map(|floor| {
        let (limit, count) = (floor.limit(), floor.parts().len());
        answer([store::keep(Item::Floor(floor)).into(), limit, count as f64]);
    }))
}

/// Force and torque on the body.
#[unsafe(no_mangle)]
pub extern "C" fn floor_wrench(floor: u32, vx: f64, vy: f64, spin: f64) -> u32 {
    let twist = twist_of([vx, vy, spin]);
    status(with(floor, |floor| Ok(row_of(&floor.wrench(&twist)))).map(answer))
}

/// Their derivatives, row by row.
#[unsafe(no_mangle)]
pub extern "C" fn floor_jacobian(floor: u32, vx: f64, vy: f64, spin: f64) -> u32 {
    let twist = twist_of([vx, vy, spin]);
    status(with(floor, |floor| Ok(nine(&floor.wrench_jacobian(&twist)))).map(answer))
}

/// Twist, friction, the foot that rests or −1, and evaluations of the motion in which friction balances a push.
#[unsafe(no_mangle)]
pub extern "C" fn floor_steady_motion(floor: u32, fx: f64, fy: f64, torque: f64) -> u32 {
    status(with(floor, |floor| floor::steady(floor, [fx, fy, torque])).map(answer))
}

/// Twist, friction, the foot that rests or −1, and imbalance after a time step of a body.
#[unsafe(no_mangle)]
pub extern "C" fn floor_step(
    floor: u32,
    mass: f64,
    inertia: f64,
    dt: f64,
    vx: f64,
    vy: f64,
    spin: f64,
    fx: f64,
    fy: f64,
    torque: f64,
) -> u32 {
    let (twist, push) = ([vx, vy, spin], [fx, fy, torque]);
    status(
        with(floor, |floor| {
            floor::step(floor, [mass, inertia, dt], twist, push)
        })
        .map(answer),
    )
}

/// All feet as one patch with the coefficient 1 under the load that is their limit: as other patches.
#[unsafe(no_mangle)]
pub extern "C" fn floor_patch(floor: u32) -> u32 {
    let area = with(floor, |floor| Ok(Area::Flat(floor.area()?)));
    keep_area(area, "coulomb:mu=1")
}

fn with<T>(handle: u32, work: impl FnOnce(&Floor) -> Result<T, Refused>) -> Result<T, Refused> {
    match &*store::item(handle)? {
        Item::Floor(floor) => work(floor),
        _ => Err(OTHER),
    }
}
