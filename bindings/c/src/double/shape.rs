//! Patches of any shape: disks and ellipses under four pressures, polygons, each with one or two coefficients.
//!
//! A shape is prepared once. Twists and wrenches refer to the origin of its coordinates. A shape of a polygon
//! does not contain its edges: their memory must stay valid and unchanged for as long as the shape or a copy is
//! used.

use super::nodes::tribos_point_f64;
use super::polygon::{Patch, tribos_polygon_f64};
use super::surface::{projected, tribos_projection_f64};
use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::choice::pressure_of;
use crate::memory::{answer, read, slice};
use crate::status::tribos_status;
use crate::table::{build, held, lent};
use nalgebra::Vector2;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch};
use tribos_core::coupling::flat::{Hessian, Motion, PatchShape, Reduced, ShapeFriction};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::affine_image::{AffineImage, AffineMap};
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::outline::Edge;
use tribos_core::patch::round::RoundPatch;

/// A patch of any shape, built by one of the functions tribos_shape_. Its content is opaque. It may be copied
/// and moved, but not to a program with another version of the library.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_shape_f64 {
    /// Internal data.
    pub opaque: [u64; 24],
    /// Marker of a completed build.
    pub built: u32,
}

lent! {
    tribos_shape_f64 for Shape;
}

/// Edges in memory of the caller.
#[derive(Clone, Copy)]
pub(crate) struct Edges {
    first: *mut Edge<f64>,
    count: usize,
}

impl AsRef<[Edge<f64>]> for Edges {
    #[inline(always)]
    fn as_ref(&self) -> &[Edge<f64>] {
        // SAFETY: the contract of a shape keeps the edges valid.
        unsafe { core::slice::from_raw_parts(self.first, self.count) }
    }
}

impl AsMut<[Edge<f64>]> for Edges {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [Edge<f64>] {
        // SAFETY: as above; only the build of two coefficients writes.
        unsafe { core::slice::from_raw_parts_mut(self.first, self.count) }
    }
}

/// A patch under friction that is alike in all directions.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    Disk(RoundPatch<f64, CoulombDisk>),
    Hertz(RoundPatch<f64, CoulombHertz>),
    Punch(RoundPatch<f64, CoulombPunch>),
    Paraboloid(RoundPatch<f64, CoulombParaboloid>),
    Ellipse(Ellipse<f64>),
    Polygon(Patch<Edges>),
}

/// What is built in the caller's memory.
#[derive(Clone, Copy)]
pub(crate) enum Shape {
    Alike(Kind),
    Axes(AnisotropicPatch<f64, Kind>),
}

/// A patch whose kind is known at run time.
macro_rules! by_kind {
    ($enumeration:ty, $($kind:ident)*) => {
        impl PatchShape<f64> for $enumeration {
            #[inline(always)]
            fn centre(&self) -> Vector2<f64> {
                match self { $(Self::$kind(patch) => PatchShape::centre(patch),)* }
            }
            #[inline(always)]
            fn radius(&self) -> f64 {
                match self { $(Self::$kind(patch) => PatchShape::radius(patch),)* }
            }
            fn rounding(&self) -> f64 {
                match self { $(Self::$kind(patch) => patch.rounding(),)* }
            }
            fn reduced(&self, motion: &Motion<f64>) -> Reduced<f64> {
                match self { $(Self::$kind(patch) => patch.reduced(motion),)* }
            }
            fn reduced_with_hessian(&self, motion: &Motion<f64>) -> (Reduced<f64>, Hessian<f64>) {
                match self { $(Self::$kind(patch) => patch.reduced_with_hessian(motion),)* }
            }
        }
    };
}

by_kind!(Kind, Disk Hertz Punch Paraboloid Ellipse Polygon);
by_kind!(Shape, Alike Axes);

impl AffineImage<f64> for Kind {
    fn image(self, map: &AffineMap<f64>) -> Option<Self> {
        let (place, pressure) = match self {
            Self::Ellipse(patch) => return patch.image(map).map(Self::Ellipse),
            Self::Polygon(patch) => return patch.image(map).map(Self::Polygon),
            Self::Disk(patch) => ((patch.centre(), patch.radius()), EllipsePressure::Uniform),
            Self::Hertz(patch) => ((patch.centre(), patch.radius()), EllipsePressure::Hertz),
            Self::Punch(patch) => ((patch.centre(), patch.radius()), EllipsePressure::FlatPunch),
            Self::Paraboloid(patch) => (
                (patch.centre(), patch.radius()),
                EllipsePressure::Paraboloid,
            ),
        };
        let [first, second] = map.rows;
        let (centre, radius) = place;
        // Turned, moved and scaled it stays round; stretched it is an ellipse.
        if first.x == second.y && first.y == -second.x {
            let scale = tribos_core::real::Real::hypot(first.x, first.y);
            return round(pressure, map.of(&centre).into(), radius * scale).ok();
        }
        let ellipse = Ellipse::new(centre.into(), [radius; 2], pressure).ok()?;
        ellipse.image(map).map(Self::Ellipse)
    }
}

fn round(pressure: EllipsePressure, centre: [f64; 2], radius: f64) -> Result<Kind, tribos_status> {
    Ok(match pressure {
        EllipsePressure::Uniform => Kind::Disk(RoundPatch::new(CoulombDisk, centre, radius)?),
        EllipsePressure::Hertz => Kind::Hertz(RoundPatch::new(CoulombHertz, centre, radius)?),
        EllipsePressure::FlatPunch => Kind::Punch(RoundPatch::new(CoulombPunch, centre, radius)?),
        EllipsePressure::Paraboloid => {
            Kind::Paraboloid(RoundPatch::new(CoulombParaboloid, centre, radius)?)
        }
    })
}

#[inline(always)]
unsafe fn place(point: *const tribos_point_f64) -> Result<[f64; 2], tribos_status> {
    let tribos_point_f64 { x, y } = read(point)?;
    Ok([x, y])
}

/// The limit surface of a shape.
#[inline(always)]
pub(super) unsafe fn surface_of<'a>(
    shape: *const tribos_shape_f64,
    force_limit: f64,
) -> Result<ShapeLimitSurface<f64, &'a Shape>, tribos_status> {
    Ok(ShapeLimitSurface::new(held(shape)?, force_limit)?)
}

/// A disk about any centre under one of the pressures, a tribos_pressure. Domain: a finite centre;
/// 0 < radius < inf. Alone and centred in the origin tribos_disk_wrench_f64 is quicker.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_disk_f64(
    pressure: u32,
    centre: *const tribos_point_f64,
    radius: f64,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let kind = round(pressure_of(pressure)?, place(centre)?, radius)?;
        Ok::<_, tribos_status>(Shape::Alike(kind))
    })
}

/// An ellipse about any centre with semi-axes along x and y under one of the pressures, a tribos_pressure.
/// Domain: a finite centre; positive, finite semi-axes whose quotient is at most 1e6.
/// Accuracy, of coefficient x load, and x radius: 1e-14 (f32: 1e-6) for aspect ratios up to 1e3; Jacobian 1e-12
/// (f32: 1e-5) of its largest entry.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_ellipse_f64(
    pressure: u32,
    centre: *const tribos_point_f64,
    semi_axes: *const tribos_point_f64,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let ellipse = Ellipse::new(place(centre)?, place(semi_axes)?, pressure_of(pressure)?)?;
        Ok::<_, tribos_status>(Shape::Alike(Kind::Ellipse(ellipse)))
    })
}

/// The ellipse centre + p cos t + q sin t with two half-diameters p and q, in any direction: semi-axes where they
/// are normal to each other. Otherwise as tribos_shape_ellipse_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_turned_ellipse_f64(
    pressure: u32,
    centre: *const tribos_point_f64,
    half_diameters: *const tribos_point_f64,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let [p, q] = *half_diameters
            .cast::<[[f64; 2]; 2]>()
            .as_ref()
            .ok_or(tribos_status::NullPointer)?;
        let pressure = pressure_of(pressure)?;
        let ellipse = Ellipse::with_half_diameters(place(centre)?, [p, q], pressure)?;
        Ok::<_, tribos_status>(Shape::Alike(Kind::Ellipse(ellipse)))
    })
}

/// A polygon under uniform or leaning pressure, whose edges stay where they are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_polygon_f64(
    polygon: *const tribos_polygon_f64,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let given = read(polygon)?;
        let first = given.edges.cast::<Edge<f64>>();
        slice(first.cast_const(), given.count)?;
        let edges = Edges {
            first,
            count: given.count,
        };
        Ok::<_, tribos_status>(Shape::Alike(Kind::Polygon(given.patch(edges))))
    })
}

/// Gives a shape the coefficients `along` an axis of it and `across` that axis: tread, skates, grooved or brushed
/// surfaces. The larger one is the coefficient, and the one in the force limit, of every call that follows.
/// Rewrites the edges of a polygon: the polygon itself and copies are lost. Domain: positive, finite coefficients;
/// an axis of any finite length but zero. TRIBOS_STATUS_AXES if the shape has two coefficients already;
/// TRIBOS_STATUS_SEMI_AXES for an ellipse, stretched by the coefficients, of more than 1e6 to 1;
/// TRIBOS_STATUS_RADIUS if the stretched patch vanishes in rounding, which loses the edges.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_two_coefficients_f64(
    shape: *mut tribos_shape_f64,
    along: f64,
    across: f64,
    axis: *const tribos_point_f64,
) -> tribos_status {
    build(shape, || {
        let coefficients = AxisCoefficients::new([along, across], place(axis)?)?;
        match *held(shape.cast_const())? {
            Shape::Alike(kind) => Ok(Shape::Axes(AnisotropicPatch::new(kind, coefficients)?)),
            Shape::Axes(_) => Err(tribos_status::Axes),
        }
    })
}

/// Wrench of Coulomb friction on a shape, against its twist. Special values: zero at rest.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_wrench_f64(
    shape: *const tribos_shape_f64,
    coefficient: f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        let friction = ShapeFriction::new(held(shape)?, coefficient)?;
        Ok(friction.wrench(load, &read(twist)?.into()).into())
    })
}

/// Wrench and Jacobian, which is symmetric. Special values: both zero at rest.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_wrench_jacobian_f64(
    shape: *const tribos_shape_f64,
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
        let friction = ShapeFriction::new(held(shape)?, coefficient)?;
        let (met, rates) = friction.wrench_and_jacobian(load, &read(twist)?.into());
        jacobian.write(rates.into());
        Ok(met.into())
    })
}

/// Gauge of a wrench on a shape, as tribos_polygon_gauge_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_gauge_f64(
    shape: *const tribos_shape_f64,
    force_limit: f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || {
        Ok(surface_of(shape, force_limit)?.gauge(&read(wrench)?.into()))
    })
}

/// The motion caused by a push, as tribos_polygon_motion_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_motion_f64(
    shape: *const tribos_shape_f64,
    force_limit: f64,
    push: *const tribos_wrench_f64,
    twist: *mut tribos_twist_f64,
) -> tribos_status {
    answer(twist, || {
        let surface = surface_of(shape, force_limit)?;
        Ok(surface.twist_normal_to(&read(push)?.into()).into())
    })
}

/// The nearest wrench that a shape can carry, as tribos_polygon_project_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_project_f64(
    shape: *const tribos_shape_f64,
    force_limit: f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        let surface = surface_of(shape, force_limit)?;
        Ok(projected(&surface, read(wrench)?, length))
    })
}
