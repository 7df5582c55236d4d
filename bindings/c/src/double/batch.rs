//! Many wrenches at once on the limit surface of a round patch, and many bodies on a disk.
//!
//! Each wrench or body comes with its load: its force limit is that of the surface times the load, on the other
//! patches coefficient x load. The results have the bits of single calls with that force limit, in less than half of
//! the time where the processor has vectors. Elements of the arrays belong together; the arrays must not overlap.

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

/// Loads and wrenches to project, a length of 0 for the radius, and memory for the projections.
struct Projections {
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
}

impl Projections {
    #[inline(always)]
    unsafe fn onto<C: DryReducedFriction<f64>>(
        self,
        set: &RoundLimitSurface<f64, C>,
    ) -> Result<(), tribos_status> {
        let length = if self.length == f64::ZERO {
            set.radius()
        } else {
            self.length
        };
        let loads = pieces(slice(self.loads, self.count)?);
        let wrenches = pieces(slice(self.wrenches, self.count)?);
        let projections = pieces_mut(slice_mut(self.projections, self.count)?);
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
    }

    /// Onto the surface of another round patch.
    #[inline(always)]
    unsafe fn onto_patch<C: DryReducedFriction<f64> + Copy>(
        self,
        coupling: C,
        patch: *const tribos_round_f64,
    ) -> Result<(), tribos_status> {
        self.onto(&round(coupling, patch, f64::ONE)?)
    }
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
    let all = Projections {
        loads,
        wrenches,
        count,
        length,
        projections,
    };
    status(|| all.onto(&read(surface)?.set()?))
}

/// Projections of `count` wrenches onto the surface of an annulus, as tribos_annulus_project_f64.
/// Special values: NaN for a load that is negative or NaN.
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
    let all = Projections {
        loads,
        wrenches,
        count,
        length,
        projections,
    };
    status(|| {
        // Null is told before any other refusal.
        read(patch)?;
        all.onto_patch(Annulus::new(CoulombDisk, inner_ratio)?, patch)
    })
}

/// Projections of `count` wrenches onto the surface of a Hertz contact, as tribos_hertz_project_f64.
/// Special values: NaN for a load that is negative or NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_hertz_project_batch_f64(
    patch: *const tribos_round_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    let all = Projections {
        loads,
        wrenches,
        count,
        length,
        projections,
    };
    status(|| all.onto_patch(CoulombHertz, patch))
}

/// Projections of `count` wrenches onto the surface of a ring, as tribos_ring_project_f64.
/// Special values: NaN for a load that is negative or NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ring_project_batch_f64(
    patch: *const tribos_round_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    let all = Projections {
        loads,
        wrenches,
        count,
        length,
        projections,
    };
    status(|| all.onto_patch(CoulombRing, patch))
}

/// Projections of `count` wrenches onto the surface of a rigid flat punch, as tribos_punch_project_f64.
/// Special values: NaN for a load that is negative or NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_punch_project_batch_f64(
    patch: *const tribos_round_f64,
    loads: *const f64,
    wrenches: *const tribos_wrench_f64,
    count: usize,
    length: f64,
    projections: *mut tribos_projection_f64,
) -> tribos_status {
    let all = Projections {
        loads,
        wrenches,
        count,
        length,
        projections,
    };
    status(|| all.onto_patch(CoulombPunch, patch))
}

/// Steps of `count` bodies alike, each with its load, motion and push, as tribos_planar_disk_step_f64.
/// Special values: as there; NaN for a load that is negative or NaN, unless the body rests without push.
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
        let loads = pieces(slice(loads, count)?);
        let twists = pieces(slice(twists, count)?);
        let pushes = pieces(slice(pushes, count)?);
        let steps = pieces_mut(slice_mut(steps, count)?);
        let mut motions = [Twist::ZERO; CHUNK];
        let mut ends = [PlanarStep {
            twist: Twist::ZERO,
            friction: Wrench::ZERO,
            is_at_rest: false,
        }; CHUNK];
        for (((loads, twists), pushes), steps) in loads.zip(twists).zip(pushes).zip(steps) {
            for (to, from) in motions.iter_mut().zip(twists) {
                *to = (*from).into();
            }
            let pushes = converted(pushes);
            body.step_batch_under_loads(&set, loads, &motions, &pushes, dt, &mut ends);
            for (to, from) in steps.iter_mut().zip(&ends) {
                *to = from.into();
            }
        }
        Ok(())
    })
}
