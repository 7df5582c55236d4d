//! Polygons cut along the border between two surfaces.

use super::nodes::tribos_point_f64;
use super::polygon::{Patch, patch_of, tribos_edge_f64, tribos_polygon_f64};
use crate::memory::{answer, read, slice_mut};
use crate::status::tribos_status;
use tribos_core::patch::outline::{Edge, Polygon, PressureField};
use tribos_core::patch::piece::HalfPlane;
use tribos_core::real::Real;

/// The piece of one polygon, and its share of the load.
#[inline(always)]
unsafe fn piece_of<K: PressureField<f64>>(
    polygon: &Polygon<f64, &[Edge<f64>], K>,
    side: &HalfPlane<f64>,
    memory: *mut tribos_edge_f64,
    room: usize,
) -> Result<Option<(tribos_polygon_f64, f64)>, tribos_status> {
    let edges = slice_mut(memory.cast::<Edge<f64>>(), room)?;
    let piece = polygon.within(side, edges)?;
    Ok(piece.map(|piece| {
        let count = piece.patch.edge_count();
        let made = tribos_polygon_f64::of(memory, count, &piece.patch.parts());
        (made, piece.share)
    }))
}

/// What of a polygon lies to the left of the line through `point` along `direction`, under the same pressure:
/// the part of a patch on one of two surfaces. `share` is its part of the load; where it is 0 nothing lies
/// there, and no piece is written. `memory` has room for `room` edges, other than those of the polygon: twice as
/// many are always enough. Accuracy: both pieces of a patch have its friction together to rounding.
/// TRIBOS_STATUS_NODE_POSITION for a point that is not finite, TRIBOS_STATUS_OUTLINE for no direction,
/// TRIBOS_STATUS_FULL for too little room.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_within_f64(
    polygon: *const tribos_polygon_f64,
    point: *const tribos_point_f64,
    direction: *const tribos_point_f64,
    memory: *mut tribos_edge_f64,
    room: usize,
    piece: *mut tribos_polygon_f64,
    share: *mut f64,
) -> tribos_status {
    if piece.is_null() {
        return tribos_status::NullPointer;
    }
    answer(share, || {
        let patch = patch_of(polygon)?;
        let (point, direction) = (read(point)?, read(direction)?);
        let side = HalfPlane::new([point.x, point.y], [direction.x, direction.y])?;
        let found = match &patch {
            Patch::Uniform(patch) => piece_of(patch, &side, memory, room),
            Patch::Leaning(patch) => piece_of(patch, &side, memory, room),
        };
        Ok(found?.map_or(f64::ZERO, |(made, share)| {
            piece.write(made);
            share
        }))
    })
}
