//! Patches with straight edges: any polygon, with holes, under uniform or linear pressure.
//!
//! Force, torque and limit surface of dry friction, exact to rounding. The edges are prepared once, in
//! memory of the caller; the origin of the corners' coordinates is the reference point of all twists and
//! wrenches.

use super::nodes::tribos_point_f64;
use super::surface::{projected, tribos_projection_f64};
use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{answer, read, slice, slice_mut};
use crate::status::tribos_status;
use nalgebra::Vector2;
use tribos_core::coupling::flat::{Hessian, Motion, PatchShape, Reduced, ShapeFriction};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::affine_image::{AffineImage, AffineMap};
use tribos_core::patch::outline::{
    Edge, LinearPressure, Parts, Polygon, PressureField, UniformPressure,
};
use tribos_core::real::Real;

/// Memory for one edge of a polygon. Its content is opaque.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_edge_f64 {
    /// Internal data.
    pub opaque: [f64; 7],
}

/// A polygon under uniform or linear pressure, written by tribos_polygon_new_f64. It does not contain
/// its edges: their memory must stay valid and unchanged for as long as the polygon or a copy is used.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_polygon_f64 {
    /// The edges, in the memory given to tribos_polygon_new_f64.
    pub edges: *mut tribos_edge_f64,
    /// Number of edges.
    pub count: usize,
    /// Centre of pressure: the centroid of the area under uniform pressure.
    pub centre: tribos_point_f64,
    /// Distance of the farthest corner from the centre of pressure.
    pub radius: f64,
    /// Area over radius^2.
    pub reduced_area: f64,
    /// Half the length of the longest edge over the radius.
    pub longest_half: f64,
    /// Pressure at the centre of pressure over the mean pressure: 1 if uniform.
    pub pressure: f64,
    /// Slope of the pressure times radius over the mean pressure, first component: 0 if uniform.
    pub slope_x: f64,
    /// Second component of the slope.
    pub slope_y: f64,
}

// The kernel's edges have the same layout: seven numbers.
const _: () = {
    assert!(size_of::<Edge<f64>>() == size_of::<tribos_edge_f64>());
    assert!(align_of::<Edge<f64>>() == align_of::<tribos_edge_f64>());
};

impl tribos_polygon_f64 {
    #[inline(always)]
    fn is_uniform(&self) -> bool {
        self.slope_x == f64::ZERO && self.slope_y == f64::ZERO
    }

    /// What the kernel's polygon consists of besides its edges.
    #[inline(always)]
    fn parts<K>(&self, pressure: K) -> Parts<f64, K> {
        Parts {
            pressure,
            centre: [self.centre.x, self.centre.y],
            radius: self.radius,
            reduced_area: self.reduced_area,
            longest_half: self.longest_half,
        }
    }

    /// A polygon of `count` edges in this memory.
    #[inline(always)]
    pub(super) fn of<K: PressureField<f64>>(
        edges: *mut tribos_edge_f64,
        count: usize,
        parts: &Parts<f64, K>,
    ) -> Self {
        let ([x, y], [slope_x, slope_y]) = (parts.centre, parts.pressure.slope());
        Self {
            edges,
            count,
            centre: tribos_point_f64 { x, y },
            radius: parts.radius,
            reduced_area: parts.reduced_area,
            longest_half: parts.longest_half,
            pressure: parts.pressure.at_centre(),
            slope_x,
            slope_y,
        }
    }
}

/// A patch whose kind of pressure is known at run time. Uniform pressure runs no code of linear one.
#[derive(Clone, Copy)]
pub(crate) enum Patch<S> {
    Uniform(Polygon<f64, S>),
    Leaning(Polygon<f64, S, LinearPressure<f64>>),
}

/// What the polygon of either kind gives.
macro_rules! either {
    ($patch:ident => $answer:expr, $given:expr) => {
        match $given {
            Patch::Uniform($patch) => $answer,
            Patch::Leaning($patch) => $answer,
        }
    };
}

impl<S: AsRef<[Edge<f64>]>> PatchShape<f64> for Patch<S> {
    #[inline(always)]
    fn centre(&self) -> Vector2<f64> {
        either!(patch => patch.centre(), self)
    }
    #[inline(always)]
    fn radius(&self) -> f64 {
        either!(patch => patch.radius(), self)
    }
    fn rounding(&self) -> f64 {
        either!(patch => patch.rounding(), self)
    }
    fn reduced(&self, motion: &Motion<f64>) -> Reduced<f64> {
        either!(patch => patch.reduced(motion), self)
    }
    fn reduced_with_hessian(&self, motion: &Motion<f64>) -> (Reduced<f64>, Hessian<f64>) {
        either!(patch => patch.reduced_with_hessian(motion), self)
    }
}

impl<S: AsRef<[Edge<f64>]> + AsMut<[Edge<f64>]>> AffineImage<f64> for Patch<S> {
    fn image(self, map: &AffineMap<f64>) -> Option<Self> {
        Some(match self {
            Self::Uniform(patch) => Self::Uniform(patch.image(map)?),
            Self::Leaning(patch) => Self::Leaning(patch.image(map)?),
        })
    }
}

impl tribos_polygon_f64 {
    /// The kernel's polygon of these edges.
    #[inline(always)]
    pub(super) fn patch<S: AsRef<[Edge<f64>]>>(&self, edges: S) -> Patch<S> {
        if self.is_uniform() {
            Patch::Uniform(Polygon::of_parts(edges, &self.parts(UniformPressure)))
        } else {
            let pressure = LinearPressure::new(self.pressure, [self.slope_x, self.slope_y]);
            Patch::Leaning(Polygon::of_parts(edges, &self.parts(pressure)))
        }
    }
}

/// A patch whose edges are in the caller's memory.
pub(super) type LentEdges<'a> = Patch<&'a [Edge<f64>]>;

#[inline(always)]
pub(super) unsafe fn patch_of<'a>(
    polygon: *const tribos_polygon_f64,
) -> Result<LentEdges<'a>, tribos_status> {
    let given = read(polygon)?;
    let edges = slice(given.edges.cast_const().cast::<Edge<f64>>(), given.count)?;
    Ok(given.patch(edges))
}

#[inline(always)]
unsafe fn friction_of<'a>(
    polygon: *const tribos_polygon_f64,
    coefficient: f64,
) -> Result<ShapeFriction<f64, LentEdges<'a>>, tribos_status> {
    Ok(ShapeFriction::new(patch_of(polygon)?, coefficient)?)
}

#[inline(always)]
unsafe fn surface_of<'a>(
    polygon: *const tribos_polygon_f64,
    force_limit: f64,
) -> Result<ShapeLimitSurface<f64, LentEdges<'a>>, tribos_status> {
    Ok(ShapeLimitSurface::new(patch_of(polygon)?, force_limit)?)
}

/// Prepares a polygon, convex or not, under uniform pressure. `corners` holds the corners of `loops` loops
/// one after another, `counts` how many each has: first the outer loop, then holes inside of it and outside
/// of each other, clockwise or counterclockwise. `memory` has room for `room` edges, one a corner is needed.
/// Domain: 3 or more finite corners a loop; edges meet only at the corners that they share.
/// Cost: the number of corners squared. After a refusal the content of `memory` is undefined.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_new_f64(
    corners: *const tribos_point_f64,
    counts: *const usize,
    loops: usize,
    memory: *mut tribos_edge_f64,
    room: usize,
    polygon: *mut tribos_polygon_f64,
) -> tribos_status {
    answer(polygon, || {
        let counts = slice(counts, loops)?;
        let total = counts
            .iter()
            .try_fold(0_usize, |sum, &count| sum.checked_add(count))
            .ok_or(tribos_status::Count)?;
        let corners = slice(corners.cast::<[f64; 2]>(), total)?;
        let edges = slice_mut(memory.cast::<Edge<f64>>(), room)?;
        let made = Polygon::with_counts(corners, counts, edges)?;
        Ok(tribos_polygon_f64::of(memory, total, &made.parts()))
    })
}

/// Moves the centre of pressure of a uniform polygon to `centre`, by a pressure that is linear over the
/// area. Rewrites the polygon and the memory of its edges: copies of it are lost. TRIBOS_STATUS_NEGATIVE if
/// the patch would lift off, in a rectangle a x b beyond |dx|/a + |dy|/b = 1/6 from its middle, and
/// TRIBOS_STATUS_LEANS if the pressure is linear already; refusals leave polygon and edges as they were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_lean_f64(
    polygon: *mut tribos_polygon_f64,
    centre: *const tribos_point_f64,
) -> tribos_status {
    answer(polygon, || {
        let given = read(polygon.cast_const())?;
        let at = read(centre.cast::<[f64; 2]>())?;
        if !given.is_uniform() {
            return Err(tribos_status::Leans);
        }
        let edges = slice_mut(given.edges.cast::<Edge<f64>>(), given.count)?;
        let uniform = Polygon::of_parts(edges, &given.parts(UniformPressure));
        let leaning = uniform.with_centre_of_pressure(at)?.parts();
        Ok(tribos_polygon_f64::of(given.edges, given.count, &leaning))
    })
}

/// Wrench of Coulomb friction on a polygon, against its twist. Special values: zero at rest.
/// Accuracy: 6e-15 of coefficient x load, and x radius, about the centre of pressure, under linear pressure
/// 8e-15 (f32: 4e-6), for patches up to 10 times as long as wide.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_wrench_f64(
    polygon: *const tribos_polygon_f64,
    coefficient: f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        let friction = friction_of(polygon, coefficient)?;
        Ok(friction.wrench(load, &read(twist)?.into()).into())
    })
}

/// Wrench and Jacobian, which is symmetric. Special values: both zero at rest. Accuracy of the Jacobian,
/// of its largest entry with the radius as the unit of length: 5e-14
/// (f32: 1e-5).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_wrench_jacobian_f64(
    polygon: *const tribos_polygon_f64,
    coefficient: f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    if jacobian.is_null() {
        return tribos_status::NullPointer;
    }
    answer(wrench, || {
        let friction = friction_of(polygon, coefficient)?;
        let (met, rates) = friction.wrench_and_jacobian(load, &read(twist)?.into());
        jacobian.write(rates.into());
        Ok(met.into())
    })
}

/// The limit surface of a polygon with force_limit = coefficient x load: the smallest factor g >= 0 with
/// wrench/g in the set. Below 1 friction holds the patch, above 1 it slides. Special values: 0 for the zero
/// wrench, infinite for an infinite one. Accuracy: 1e-14 (f32: 1e-5) with the origin at most a few radii away.
/// Cost: about 6 wrenches with Jacobian, at most 13.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_gauge_f64(
    polygon: *const tribos_polygon_f64,
    force_limit: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || {
        let surface = surface_of(polygon, force_limit)?;
        Ok(surface.gauge(&read(wrench)?.into()))
    })
}

/// The motion caused by a push, scaled to |velocity|^2 + (spin length)^2 = 1, where length is the radius
/// plus the distance of the centre of pressure from the origin. Special values: zero for the zero wrench.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_motion_f64(
    polygon: *const tribos_polygon_f64,
    force_limit: f64,
    push: *const tribos_wrench_f64,
    twist: *mut tribos_twist_f64,
) -> tribos_status {
    answer(twist, || {
        let surface = surface_of(polygon, force_limit)?;
        Ok(surface.twist_normal_to(&read(push)?.into()).into())
    })
}

/// The nearest wrench of the set in the norm sqrt(|d force|^2 + (d torque/length)^2); a length of 0
/// represents that of tribos_polygon_motion_f64. Special values: NaN for a negative or infinite length.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_polygon_project_f64(
    polygon: *const tribos_polygon_f64,
    force_limit: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        let surface = surface_of(polygon, force_limit)?;
        Ok(projected(&surface, read(wrench)?, length))
    })
}
