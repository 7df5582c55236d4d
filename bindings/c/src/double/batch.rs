//! Many wrenches at once on the limit surface of a disk.
//!
//! Each wrench comes with its load: its force limit is that of the surface times the load. The results have the
//! bits of single calls with that force limit, in about 40 % of the time where the processor has vectors.
//! Elements of the three arrays belong together; the arrays must not overlap.

use super::surface::{Set, tribos_disk_surface_f64, tribos_projection_f64};
use super::vectors::{tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{CHUNK, pieces, pieces_mut, read, slice, slice_mut, status};
use crate::status::tribos_status;
use tribos_core::limit_surface::{FrictionSet, Projection, Region};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// The kernel's structures of up to `CHUNK` wrenches.
#[inline(always)]
fn converted(from: &[tribos_wrench_f64]) -> [Wrench<f64>; CHUNK] {
    let mut wrenches = [Wrench::ZERO; CHUNK];
    for (to, from) in wrenches.iter_mut().zip(from) {
        *to = (*from).into();
    }
    wrenches
}

/// Gauges of `count` wrenches, as tribos_disk_surface_gauge_f64.
/// Special values: NaN for a load that is negative or NaN.
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
        let loads = pieces(slice(loads, count)?);
        let wrenches = pieces(slice(wrenches, count)?);
        let gauges = pieces_mut(slice_mut(gauges, count)?);
        for ((loads, wrenches), gauges) in loads.zip(wrenches).zip(gauges) {
            set.gauge_batch(loads, &converted(wrenches), gauges);
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
        let pushes = pieces(slice(pushes, count)?);
        let twists = pieces_mut(slice_mut(twists, count)?);
        let mut motions = [Twist::ZERO; CHUNK];
        for (pushes, twists) in pushes.zip(twists) {
            set.twist_normal_to_batch(&converted(pushes), &mut motions);
            for (to, from) in twists.iter_mut().zip(motions) {
                *to = from.into();
            }
        }
        Ok(())
    })
}

/// Projections of `count` wrenches, as tribos_disk_surface_project_f64; a length of 0 represents the radius.
/// Special values: NaN for a load that is negative or NaN.
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
        let length = if length == f64::ZERO {
            set.radius()
        } else {
            length
        };
        let loads = pieces(slice(loads, count)?);
        let wrenches = pieces(slice(wrenches, count)?);
        let projections = pieces_mut(slice_mut(projections, count)?);
        let blank = Projection {
            wrench: Wrench::ZERO,
            region: Region::Inside,
        };
        let mut nearest = [blank; CHUNK];
        for ((loads, wrenches), projections) in loads.zip(wrenches).zip(projections) {
            set.project_batch(length, loads, &converted(wrenches), &mut nearest);
            for (to, from) in projections.iter_mut().zip(nearest) {
                *to = from.into();
            }
        }
        Ok(())
    })
}
