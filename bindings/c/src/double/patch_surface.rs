//! Limit surfaces of the other patches: round ones under other pressures, and points.
//!
//! Each call builds the surface again, which takes about as long as a few wrenches of the patch. A batch builds it once.

use super::nodes::tribos_node_f64;
use super::patch::tribos_round_f64;
use super::surface::{projected, tribos_projection_f64};
use super::vectors::tribos_wrench_f64;
use crate::memory::{answer, read, slice};
use crate::status::tribos_status;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::{Annulus, DryReducedFriction, RoundFriction};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, ShapeLimitSurface};
use tribos_core::patch::nodes::{Node, NodeSlice};
use tribos_core::patch::points::PointPatch;

/// The surface of a round patch under a load.
#[inline(always)]
pub(super) unsafe fn round<C: DryReducedFriction<f64> + Copy>(
    coupling: C,
    patch: *const tribos_round_f64,
    load: f64,
) -> Result<RoundLimitSurface<f64, C>, tribos_status> {
    let patch = read(patch)?;
    RoundFriction::new(coupling, patch.coefficient, patch.radius)?;
    let limit = patch.coefficient * load;
    Ok(RoundLimitSurface::new(coupling, limit, patch.radius)?)
}

/// The surface of points.
#[inline(always)]
unsafe fn points<'a>(
    nodes: *const tribos_node_f64,
    count: usize,
    force_limit: f64,
) -> Result<ShapeLimitSurface<f64, PointPatch<f64, NodeSlice<'a, f64>>>, tribos_status> {
    let nodes = slice(nodes.cast::<Node<f64>>(), count)?;
    let points = PointPatch::new(NodeSlice::new(nodes)?)?;
    Ok(ShapeLimitSurface::new(points, force_limit)?)
}

#[inline(always)]
unsafe fn gauge_of<S: FrictionSet<f64>>(
    set: Result<S, tribos_status>,
    wrench: *const tribos_wrench_f64,
) -> Result<f64, tribos_status> {
    Ok(set?.gauge(&read(wrench)?.into()))
}

#[inline(always)]
unsafe fn nearest_of<S: FrictionSet<f64>>(
    set: Result<S, tribos_status>,
    wrench: *const tribos_wrench_f64,
    length: f64,
) -> Result<tribos_projection_f64, tribos_status> {
    Ok(projected(&set?, read(wrench)?, length))
}

/// Gauge of a wrench on an annulus under uniform pressure, as tribos_disk_surface_gauge_f64 with
/// force_limit = coefficient x load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_annulus_gauge_f64(
    patch: *const tribos_round_f64,
    inner_ratio: f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || {
        let coupling = Annulus::new(CoulombDisk, inner_ratio)?;
        gauge_of(round(coupling, patch, load), wrench)
    })
}

/// The nearest wrench that an annulus can carry, as tribos_disk_surface_project_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_annulus_project_f64(
    patch: *const tribos_round_f64,
    inner_ratio: f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        let coupling = Annulus::new(CoulombDisk, inner_ratio)?;
        nearest_of(round(coupling, patch, load), wrench, length)
    })
}

/// Gauge of a wrench under Hertz' pressure, as tribos_disk_surface_gauge_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_hertz_gauge_f64(
    patch: *const tribos_round_f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || gauge_of(round(CoulombHertz, patch, load), wrench))
}

/// The nearest wrench that a Hertz contact can carry, as tribos_disk_surface_project_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_hertz_project_f64(
    patch: *const tribos_round_f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        nearest_of(round(CoulombHertz, patch, load), wrench, length)
    })
}

/// Gauge of a wrench on a ring, as tribos_disk_surface_gauge_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ring_gauge_f64(
    patch: *const tribos_round_f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || gauge_of(round(CoulombRing, patch, load), wrench))
}

/// The nearest wrench that a ring can carry, as tribos_disk_surface_project_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ring_project_f64(
    patch: *const tribos_round_f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        nearest_of(round(CoulombRing, patch, load), wrench, length)
    })
}

/// Gauge of a wrench on a rigid flat punch, as tribos_disk_surface_gauge_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_punch_gauge_f64(
    patch: *const tribos_round_f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || gauge_of(round(CoulombPunch, patch, load), wrench))
}

/// The nearest wrench that a rigid flat punch can carry, as tribos_disk_surface_project_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_punch_project_f64(
    patch: *const tribos_round_f64,
    load: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        nearest_of(round(CoulombPunch, patch, load), wrench, length)
    })
}

/// Gauge of a wrench on `count` nodes, as tribos_polygon_gauge_f64. Two or more places carry load.
/// Cost: the number of nodes times a few.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_gauge_f64(
    nodes: *const tribos_node_f64,
    count: usize,
    force_limit: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || {
        gauge_of(points(nodes, count, force_limit), wrench)
    })
}

/// The nearest wrench that `count` nodes can carry, as tribos_polygon_project_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_nodes_project_f64(
    nodes: *const tribos_node_f64,
    count: usize,
    force_limit: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        nearest_of(points(nodes, count, force_limit), wrench, length)
    })
}
