//! Patches of any shape: disks and ellipses under four pressures, polygons, bars, points, each with one or two
//! coefficients; worn annuli; and several shapes as one.
//!
//! A shape is prepared once. Twists and wrenches refer to the origin of its coordinates. A shape does not contain
//! the edges of a polygon, its points or the shapes that it is made of: their memory must stay valid and unchanged
//! for as long as the shape or a copy is used.

use super::nodes::{tribos_node_f64, tribos_point_f64};
use super::polygon::{Patch, tribos_polygon_f64};
use super::surface::{projected, tribos_projection_f64};
use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::choice::pressure_of;
use crate::memory::{answer, read, slice};
use crate::status::tribos_status;
use crate::table::{build, held, lent};
use core::mem::offset_of;
use nalgebra::Vector2;
use tribos_core::coupling::WornAnnulus;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch};
use tribos_core::coupling::flat::{Hessian, Motion, PatchShape, PointLoad, Reduced, ShapeFriction};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::affine_image::{AffineImage, AffineMap, image_of};
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::feet::{CompoundPatch, PatchPart};
use tribos_core::patch::nodes::{Node, NodePatch, NodeSlice};
use tribos_core::patch::outline::{Edge, LinearPressure};
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::round::RoundPatch;
use tribos_core::real::Real;

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

/// One of several shapes under a body, and what it carries.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_part_f64 {
    /// Its patch, in the coordinates of the body.
    pub shape: *const tribos_shape_f64,
    /// Its coefficient, the larger one of two, times its load; not negative. Only ratios count.
    pub limit: f64,
}

/// A part of the kernel.
type Part = PatchPart<f64, &'static Shape>;

// The kernel's parts have the same layout, and a shape is built at the start of its memory.
const _: () = {
    assert!(size_of::<Part>() == size_of::<tribos_part_f64>());
    assert!(align_of::<Part>() == align_of::<tribos_part_f64>());
    assert!(offset_of!(Part, patch) == offset_of!(tribos_part_f64, shape));
    assert!(offset_of!(Part, load) == offset_of!(tribos_part_f64, limit));
};

/// Edges or points in memory of the caller.
#[derive(Clone, Copy)]
pub(crate) struct LentRows<T> {
    first: *mut T,
    count: usize,
}

impl<T> LentRows<T> {
    #[inline(always)]
    unsafe fn new(first: *mut T, count: usize) -> Result<Self, tribos_status> {
        slice(first.cast_const(), count)?;
        Ok(Self { first, count })
    }
}

impl<T> AsRef<[T]> for LentRows<T> {
    #[inline(always)]
    fn as_ref(&self) -> &[T] {
        // SAFETY: the contract of a shape keeps them valid.
        unsafe { core::slice::from_raw_parts(self.first, self.count) }
    }
}

impl<T> AsMut<[T]> for LentRows<T> {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [T] {
        // SAFETY: as above; only the build of two coefficients writes.
        unsafe { core::slice::from_raw_parts_mut(self.first, self.count) }
    }
}

/// Points and the sum of their weights.
#[derive(Clone, Copy)]
pub(crate) struct Points {
    nodes: LentRows<Node<f64>>,
    total_weight: f64,
}

impl NodePatch<f64> for Points {
    #[inline(always)]
    fn nodes(&self) -> &[Node<f64>] {
        self.nodes.as_ref()
    }
    #[inline(always)]
    fn total_weight(&self) -> f64 {
        self.total_weight
    }
}

/// A patch under friction that is alike in all directions.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    Disk(RoundPatch<f64, CoulombDisk>),
    Hertz(RoundPatch<f64, CoulombHertz>),
    Punch(RoundPatch<f64, CoulombPunch>),
    Paraboloid(RoundPatch<f64, CoulombParaboloid>),
    Worn(RoundPatch<f64, WornAnnulus<f64>>),
    Ellipse(Ellipse<f64>),
    Polygon(Patch<LentRows<Edge<f64>>>),
    Bar(Bar<f64>),
    LeaningBar(Bar<f64, LinearPressure<f64>>),
    Points(PointPatch<f64, Points>),
}

/// What is built in the caller's memory.
#[derive(Clone, Copy)]
pub(crate) enum Shape {
    Alike(Kind),
    Axes(AnisotropicPatch<f64, Kind>),
    Feet(CompoundPatch<'static, f64, &'static Self>),
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
            fn nearest_point(&self, place: &Vector2<f64>) -> Option<PointLoad<f64>> {
                match self { $(Self::$kind(patch) => patch.nearest_point(place),)* }
            }
        }
    };
}

by_kind!(Kind, Disk Hertz Punch Paraboloid Worn Ellipse Polygon Bar LeaningBar Points);
by_kind!(Shape, Alike Axes Feet);

impl AffineImage<f64> for Kind {
    fn image(self, map: &AffineMap<f64>) -> Option<Self> {
        let (place, pressure) = match self {
            Self::Ellipse(patch) => return patch.image(map).map(Self::Ellipse),
            Self::Polygon(patch) => return patch.image(map).map(Self::Polygon),
            Self::Bar(patch) => return patch.image(map).map(Self::Bar),
            Self::LeaningBar(patch) => return patch.image(map).map(Self::LeaningBar),
            Self::Points(patch) => {
                let moved = patch.moved(map, |mut points| {
                    for node in points.nodes.as_mut() {
                        *node = image_of(map, node);
                    }
                    points
                });
                return Some(Self::Points(moved));
            }
            Self::Worn(_) => return None,
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
            let scale = Real::hypot(first.x, first.y);
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
        let edges = LentRows::new(given.edges.cast::<Edge<f64>>(), given.count)?;
        Ok::<_, tribos_status>(Shape::Alike(Kind::Polygon(given.patch(edges))))
    })
}

/// An annulus about any centre under the pressure 1/r, as a clutch, a pivot or a thrust bearing that has worn in.
/// Domain: a finite centre; 0 <= inner_ratio <= 0.999999; 0 < radius < inf.
/// Accuracy, of coefficient x load, and x radius: 2e-15 (f32: 1e-6). Cost: 16 rings, at most 96.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_worn_annulus_f64(
    centre: *const tribos_point_f64,
    inner_ratio: f64,
    radius: f64,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let patch = RoundPatch::new(WornAnnulus::new(inner_ratio)?, place(centre)?, radius)?;
        Ok::<_, tribos_status>(Shape::Alike(Kind::Worn(patch)))
    })
}

/// A straight line that carries load: a blade, a skate, the edge of a box. The centre of pressure lies `lean` from
/// its middle towards `to`: 0 under uniform pressure, which is linear else. Domain: finite, different ends;
/// TRIBOS_STATUS_NEGATIVE beyond a sixth of the length, where the bar would lift off.
/// Accuracy, of coefficient x load, and x radius: 3e-14 (f32: 4e-6).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_bar_f64(
    from: *const tribos_point_f64,
    to: *const tribos_point_f64,
    lean: f64,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let bar = Bar::new(place(from)?, place(to)?)?;
        Ok::<_, tribos_status>(Shape::Alike(if lean == f64::ZERO {
            Kind::Bar(bar)
        } else {
            Kind::LeaningBar(bar.with_centre_of_pressure(lean)?)
        }))
    })
}

/// Points that stay where they are: feet, spikes, the nodes of a rule. Domain: that of tribos_nodes_gauge_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_points_f64(
    nodes: *mut tribos_node_f64,
    count: usize,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        let nodes = LentRows::new(nodes.cast::<Node<f64>>(), count)?;
        let total_weight = NodeSlice::new(nodes.as_ref())?.total_weight();
        let points = PointPatch::new(Points {
            nodes,
            total_weight,
        })?;
        Ok::<_, tribos_status>(Shape::Alike(Kind::Points(points)))
    })
}

/// Several shapes under one body as one, while all surfaces under them move alike: with coefficient x load or the
/// force limit of a call the sum of all limits. Parts and their shapes stay where they are. Domain: limits with a
/// finite, positive sum; TRIBOS_STATUS_CHOICE if a part is `shape` itself or several shapes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_shape_feet_f64(
    parts: *const tribos_part_f64,
    count: usize,
    shape: *mut tribos_shape_f64,
) -> tribos_status {
    build(shape, || {
        for part in slice(parts, count)? {
            let is_feet = matches!(held(part.shape)?, Shape::Feet(_));
            if is_feet || core::ptr::eq(part.shape, shape) {
                return Err(tribos_status::Choice);
            }
        }
        Ok(Shape::Feet(CompoundPatch::new(slice(
            parts.cast::<Part>(),
            count,
        )?)?))
    })
}

/// Gives a shape the coefficients `along` an axis of it and `across` that axis: tread, skates, grooved or brushed
/// surfaces. The larger one is the coefficient, and the one in the force limit, of every call that follows.
/// Rewrites the edges of a polygon and points: the polygon itself and copies are lost. Domain: positive, finite
/// coefficients; an axis of any finite length but zero. TRIBOS_STATUS_AXES if the shape has two coefficients already;
/// TRIBOS_STATUS_CHOICE for a worn annulus, and for several shapes, each of which takes its own;
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
            Shape::Alike(Kind::Worn(_)) | Shape::Feet(_) => Err(tribos_status::Choice),
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
