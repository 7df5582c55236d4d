//! Many wrenches at once on the limit surface of a round patch, and many bodies on a disk.
//!
//! Each wrench or body comes with its load: its force limit is that of the surface times the load, on the other
//! patches coefficient x load. The results have the bits of single calls with that force limit, in a fifth to three
//! quarters of the time where the processor has vectors. Elements of the arrays belong together; the arrays must not
//! overlap.

use super::patch::tribos_round_f64;
use super::patch_surface::round;
use super::planar::{tribos_planar_body_f64, tribos_planar_step_f64};
use super::surface::{Set, tribos_disk_surface_f64, tribos_projection_f64};
use super::vectors::{tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{CHUNK, pieces, pieces_mut, read, slice, slice_mut, status};
use crate::status::tribos_status;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::{Annulus, DryReducedFriction};
use tribos_core::limit_surface::{FrictionSet, Projection, Region, RoundLimitSurface};
use tribos_core::planar::PlanarStep;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Bodies that are converted at once: as many as the kernel steps together.
const BODIES: usize = 32;

/// The kernel's structures of up to N wrenches.
#[inline(always)]
fn converted<const N: usize>(from: &[tribos_wrench_f64]) -> [Wrench<f64>; N] {
    let mut wrenches = [Wrench::ZERO; N];
    for (to, from) in wrenches.iter_mut().zip(from) {
        *to = (*from).into();
    }
    wrenches
}

/// Gauges of `count` wrenches, as tribos_disk_surface_gauge_f64. Domain: 0 <= load < inf.
/// Special values: NaN for a negative or NaN load, unless the wrench is zero or infinite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_gauge_batch_f64(
    surface: *const tribos_disk_surface_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    gauges: *mut f64,
) -> tribos_status {
    status(|| {
        let set = read(surface)?.set()?;
        let loads = pieces::<CHUNK, _>(slice(loads, count)?);
        let wrenches = pieces::<CHUNK, _>(slice(wrenches, count)?);
        let gauges = pieces_mut::<CHUNK, _>(slice_mut(gauges, count)?);
        for ((loads, wrenches), gauges) in loads.zip(wrenches).zip(gauges) {
            set.gauge_batch(loads, &converted::<CHUNK>(wrenches), gauges);
        }
        Ok(())
    })
}

/// The motions caused by `count` pushes, as tribos_disk_surface_motion_f64; they do not depend on the load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_motion_batch_f64(
    surface: *const tribos_disk_surface_f64,
    pushes: *const tribos_wrench_f64,
    count: usize,
    twists: *mut tribos_twist_f64,
) -> tribos_status {
    status(|| {
        let set = read(surface)?.set()?;
        let pushes = pieces::<CHUNK, _>(slice(pushes, count)?);
        let twists = pieces_mut::<CHUNK, _>(slice_mut(twists, count)?);
        let mut motions = [Twist::ZERO; CHUNK];
        for (pushes, twists) in pushes.zip(twists) {
            set.twist_normal_to_batch(&converted::<CHUNK>(pushes), &mut motions);
            for (to, from) in twists.iter_mut().zip(motions) {
                *to = from.into();
            }
        }
        Ok(())
    })
}

/// Projections onto a surface under each load; a length of 0 represents the radius.
#[inline(always)]
unsafe fn project_all<C: DryReducedFriction<f64>>(
    set: &RoundLimitSurface<f64, C>,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> Result<(), tribos_status> {
    let length = if length == f64::ZERO {
        set.radius()
    } else {
        length
    };
    let loads = pieces::<CHUNK, _>(slice(loads, count)?);
    let wrenches = pieces::<CHUNK, _>(slice(wrenches, count)?);
    let projections = pieces_mut::<CHUNK, _>(slice_mut(projections, count)?);
    let blank = Projection {
        wrench: Wrench::ZERO,
        region: Region::Inside,
    };
    let mut nearest = [blank; CHUNK];
    for ((loads, wrenches), projections) in loads.zip(wrenches).zip(projections) {
        set.project_batch(length, loads, &converted::<CHUNK>(wrenches), &mut nearest);
        for (to, from) in projections.iter_mut().zip(nearest) {
            *to = from.into();
        }
    }
    Ok(())
}

/// Projections of `count` wrenches, as tribos_disk_surface_project_f64; a length of 0 represents the radius.
/// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_project_batch_f64(
    surface: *const tribos_disk_surface_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    status(|| {
        let set = read(surface)?.set()?;
        project_all(&set, loads, wrenches, count, length, projections)
    })
}

/// Projections of `count` wrenches onto the surface of an annulus, as tribos_annulus_project_f64.
/// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_annulus_project_batch_f64(
    patch: *const tribos_round_f64,
    inner_ratio: f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    status(|| {
        let set = round(Annulus::new(CoulombDisk, inner_ratio)?, patch, f64::ONE)?;
        project_all(&set, loads, wrenches, count, length, projections)
    })
}

/// Projections of `count` wrenches onto the surface of a Hertz contact, as tribos_hertz_project_f64.
/// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_hertz_project_batch_f64(
    patch: *const tribos_round_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    status(|| {
        let set = round(CoulombHertz, patch, f64::ONE)?;
        project_all(&set, loads, wrenches, count, length, projections)
    })
}

/// Projections of `count` wrenches onto the surface of a ring, as tribos_ring_project_f64.
/// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ring_project_batch_f64(
    patch: *const tribos_round_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    status(|| {
        let set = round(CoulombRing, patch, f64::ONE)?;
        project_all(&set, loads, wrenches, count, length, projections)
    })
}

/// Projections of `count` wrenches onto the surface of a rigid flat punch, as tribos_punch_project_f64.
/// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_punch_project_batch_f64(
    patch: *const tribos_round_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    status(|| {
        let set = round(CoulombPunch, patch, f64::ONE)?;
        project_all(&set, loads, wrenches, count, length, projections)
    })
}

/// Steps of `count` bodies alike, each with its load, motion and push, as tribos_planar_disk_step_f64.
/// Domain: 0 <= load < inf. Special values: as there; NaN for a negative or NaN load, unless the body rests
/// without push.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_planar_disk_step_batch_f64(
    body: *const tribos_planar_body_f64,
    surface: *const tribos_disk_surface_f64,
    loads: *const f64,
    twists: *const tribos_twist_f64,
    pushes: *const tribos_wrench_f64,
    count: usize,
    dt: f64,
    steps: *mut tribos_planar_step_f64,
) -> tribos_status {
    status(|| {
        let (body, set) = (read(body)?.body()?, read(surface)?.set()?);
        let dt = TimeStep::new(dt)?;
        let loads = pieces::<BODIES, _>(slice(loads, count)?);
        let twists = pieces::<BODIES, _>(slice(twists, count)?);
        let pushes = pieces::<BODIES, _>(slice(pushes, count)?);
        let steps = pieces_mut::<BODIES, _>(slice_mut(steps, count)?);
        let mut motions = [Twist::ZERO; BODIES];
        let mut ends = [PlanarStep {
            twist: Twist::ZERO,
            friction: Wrench::ZERO,
            is_at_rest: false,
        }; BODIES];
        for (((loads, twists), pushes), steps) in loads.zip(twists).zip(pushes).zip(steps) {
            for (to, from) in motions.iter_mut().zip(twists) {
                *to = (*from).into();
            }
            let pushes = converted::<BODIES>(pushes);
            body.step_batch_under_loads(&set, loads, &motions, &pushes, dt, &mut ends);
            for (to, from) in steps.iter_mut().zip(&ends) {
                *to = from.into();
            }
        }
        Ok(())
    })
}
