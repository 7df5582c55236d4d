//! Meshes of triangles with a pressure at each corner, linear in between: hydroelastic contact faces,
//! pressure maps.
//!
//! Lengths are stored in units of the *radius*, the distance of the farthest loaded corner from the
//! *centre*, which is the centre of pressure. [`crate::coupling::flat`] gives their friction.

pub use super::mesh_error::MeshError;
pub use super::triangle::Triangle;

use super::affine_image::AffineMap;
use super::triangle::cross;
use crate::real::Real;
use nalgebra::Vector2;

/// A place and the pressure there.
///
/// *Units*: length; the pressure in any unit, because only its ratios count for a given load.
/// *Layout*: that of a C structure of these three numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Vertex<R> {
    /// First coordinate in the contact plane.
    pub x: R,
    /// Second coordinate.
    pub y: R,
    /// The pressure, not negative.
    pub pressure: R,
}

/// A patch of triangles under a pressure that is linear in each of them.
///
/// Triangles may be given clockwise or counterclockwise, and need not touch; the pressure may jump
/// from one to the next. *Overlaps are not checked*: where triangles overlap their pressures add up.
/// Triangles without an area (beyond rounding) or without pressure carry nothing and are left out.
///
/// The storage `S` holds the triangles: an array, or memory of the caller.
///
/// *Accuracy* (f64) of [`crate::coupling::flat::ShapeFriction`], of μN and μN R: 2e-14, the Jacobian
/// 2.5e-13 of its largest entry, for triangles up to 5 times as long as wide (f32: 1e-5, 2e-5); however
/// small a triangle is beside the mesh, unless it carries a good part of the load and the centre of
/// rotation lies next to it, where a rounding error of the radius counts. *Cost*: a triangle takes about
/// 3.5 times as long as a table of the disk; alone or among few, at 5 to 50 radii, 8 to 12 times.
/// *Units*: length. *Size*: 16 numbers a triangle and 6 more.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::mesh::{Mesh, Vertex};
/// use tribos_core::twist::Twist;
/// // A wedge: no pressure at x = 0, 20 kPa at x = 0.1 m.
/// let at = |x: f64, y| Vertex { x, y, pressure: 2e5 * x };
/// let (a, b, c, d) = (at(0.0, 0.0), at(0.1, 0.0), at(0.1, 0.1), at(0.0, 0.1));
/// let wedge = Mesh::new([[a, b, c], [a, c, d]])?;
/// assert!((wedge.centre().x - 0.2 / 3.0).abs() < 1e-16);
/// let load = wedge.load(); // N, where lengths are in m and pressures in Pa
/// assert!((load - 1e4 * 0.01).abs() < 1e-13);
/// let friction = ShapeFriction::new(wedge, 0.5)?;
/// let wrench = friction.wrench(load, &Twist::new(0.3, 0.0, 0.0));
/// assert!((wrench.force.x + 0.5 * load).abs() < 1e-13);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh<R: Real, S> {
    triangles: S,
    count: usize,
    centre: Vector2<R>,
    radius: R,
    load: R,
}

impl<R: Real, const N: usize> Mesh<R, [Triangle<R>; N]> {
    /// The mesh of triangles with these corners.
    ///
    /// *Domain*: at least one triangle with an area and a pressure; finite places, finite pressures
    /// ≥ 0. The triangles that carry load are not so small that their extent is lost in rounding beside their
    /// distance from the first triangle under pressure, which may have no area.
    pub fn new(triangles: [[Vertex<R>; 3]; N]) -> Result<Self, MeshError> {
        Self::of(triangles.into_iter(), [Triangle::default(); N])
    }
}

impl<R: Real, S: AsRef<[Triangle<R>]> + AsMut<[Triangle<R>]>> Mesh<R, S> {
    /// The mesh of triangles that name their corners among `vertices`, counted from 0; `memory` has
    /// room for as many triangles.
    ///
    /// *Domain*: as in [`Mesh::new`]. Vertices that no triangle names may be anything.
    /// *Cost*: four passes over the triangles.
    ///
    /// ```
    /// use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
    /// let vertices = [[0.0_f64, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]]
    ///     .map(|[x, y]| Vertex { x, y, pressure: 1e4 }); // m, Pa
    /// let mut memory = [Triangle::default(); 2];
    /// let tile = Mesh::with_vertices(&vertices, &[[0, 1, 2], [0, 2, 3]], &mut memory[..])?;
    /// assert!((tile.load() - 100.0).abs() < 1e-13); // N
    /// # Ok::<(), tribos_core::patch::mesh::MeshError>(())
    /// ```
    pub fn with_vertices(
        vertices: &[Vertex<R>],
        triangles: &[[usize; 3]],
        memory: S,
    ) -> Result<Self, MeshError> {
        for (triangle, named) in triangles.iter().enumerate() {
            for &vertex in named {
                if vertex >= vertices.len() {
                    return Err(MeshError::Index {
                        triangle,
                        vertex,
                        vertices: vertices.len(),
                    });
                }
            }
        }
        let vertex = |&index: &usize| vertices.get(index).copied().unwrap_or_default();
        let corners = triangles.iter().map(|[a, b, c]| [a, b, c].map(vertex));
        Self::of(corners, memory)
    }

    fn of(
        faces: impl ExactSizeIterator<Item = [Vertex<R>; 3]> + Clone,
        memory: S,
    ) -> Result<Self, MeshError> {
        let mut triangles = memory;
        let (given, room) = (faces.len(), triangles.as_ref().len());
        if given > room {
            return Err(MeshError::Room { given, room });
        }
        let scale = MeshExtent::of(faces.clone())?;
        let loaded = faces.filter_map(|face| scale.loaded(&face));
        let Frame {
            centre,
            radius,
            load,
        } = Frame::of(loaded.clone())?;
        let mut slots = triangles.as_mut().iter_mut();
        let mut count = 0;
        let per_load = radius * radius / load;
        for (face, slot) in loaded.zip(&mut slots) {
            let reduced = |v: Vector2<R>| Vector2::new(v.x / radius, v.y / radius);
            let pressures = face.pressures.map(|pressure| pressure * per_load);
            let corner = reduced(face.corner - centre);
            *slot = Triangle::new(corner, face.sides.map(reduced), pressures);
            count += 1;
        }
        let MeshExtent { origin, unit, peak } = scale;
        let (centre, radius) = (origin + centre * unit, radius * unit);
        if !(centre.x + centre.y + radius).is_finite() {
            return Err(MeshError::Extent);
        }
        if radius == R::ZERO {
            return Err(MeshError::Unloaded);
        }
        Ok(Self {
            triangles,
            count,
            centre,
            radius,
            load: load * unit * unit * peak,
        })
    }
}

impl<R: Real, S: AsRef<[Triangle<R>]> + AsMut<[Triangle<R>]>> Mesh<R, S> {
    /// Its image under a linear map, which carries the same load.
    pub(super) fn moved(mut self, map: &AffineMap<R>) -> Self {
        let mut reach = R::ZERO;
        for triangle in self.triangles() {
            let (corner, [b, c]) = (triangle.corner(), triangle.sides());
            for place in [corner, corner + b, corner + c] {
                let at = map.of_vector(&place);
                let distance = at.x.hypot(at.y);
                if distance > reach {
                    reach = distance;
                }
            }
        }
        let (unit, count) = (R::ONE / reach, self.count);
        let per_load = reach * reach / map.determinant();
        for triangle in self.triangles.as_mut().iter_mut().take(count) {
            let corner = map.of_vector(&triangle.corner()) * unit;
            let sides = triangle.sides().map(|side| map.of_vector(&side) * unit);
            let pressures = triangle.pressures().map(|pressure| pressure * per_load);
            *triangle = Triangle::new(corner, sides, pressures);
        }
        Self {
            centre: map.of(&self.centre),
            radius: self.radius * reach,
            ..self
        }
    }
}

impl<R: Real, S: AsRef<[Triangle<R>]>> Mesh<R, S> {
    /// The triangles that carry load.
    #[inline(always)]
    pub(crate) fn triangles(&self) -> &[Triangle<R>] {
        let triangles = self.triangles.as_ref();
        triangles.get(..self.count).unwrap_or(triangles)
    }

    /// The corners of the triangles that carry load, with pressures such that all carry 1 per radius².
    #[doc(hidden)]
    pub fn corners(&self) -> impl Iterator<Item = [Vertex<R>; 3]> + '_ {
        self.triangles().iter().map(|triangle| {
            let (corner, [b, c], [p, q, r]) =
                (triangle.corner(), triangle.sides(), triangle.pressures());
            [(corner, p), (corner + b, q), (corner + c, r)].map(|(at, pressure)| {
                let place = self.centre + at * self.radius;
                Vertex {
                    x: place.x,
                    y: place.y,
                    pressure,
                }
            })
        })
    }

    /// The centre of pressure, in the vertices' coordinates.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance of the farthest loaded corner from the centre of pressure.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// The integral of the pressure. *Special values*: zero or infinite where it leaves the range of
    /// numbers.
    pub fn load(&self) -> R {
        self.load
    }
}

/// A triangle that carries load, in the units of a [`MeshExtent`].
struct Face<R: Real> {
    /// The first corner, and from there to the others.
    corner: Vector2<R>,
    sides: [Vector2<R>; 2],
    pressures: [R; 3],
}

/// Where the mesh lies, its extent and its largest pressure.
struct MeshExtent<R: Real> {
    origin: Vector2<R>,
    unit: R,
    peak: R,
}

impl<R: Real> MeshExtent<R> {
    /// The scale of triangles, whose places and pressures it checks.
    fn of(faces: impl Iterator<Item = [Vertex<R>; 3]> + Clone) -> Result<Self, MeshError> {
        if faces.clone().next().is_none() {
            return Err(MeshError::Empty);
        }
        let has_pressure = |face: &[Vertex<R>; 3]| face.iter().any(|v| v.pressure > R::ZERO);
        let first = faces.clone().find(has_pressure);
        let origin = first.map_or(Vector2::new(R::ZERO, R::ZERO), |[a, ..]| {
            Vector2::new(a.x, a.y)
        });
        let (mut unit, mut peak) = (R::ZERO, R::ZERO);
        for (triangle, face) in faces.enumerate() {
            let is_loaded = has_pressure(&face);
            for (corner, Vertex { x, y, pressure }) in face.into_iter().enumerate() {
                if !(x.is_finite() && y.is_finite()) {
                    return Err(MeshError::Position { triangle, corner });
                }
                if !(pressure >= R::ZERO && pressure.is_finite()) {
                    return Err(MeshError::Pressure {
                        triangle,
                        corner,
                        given: pressure.to_f64(),
                    });
                }
                if !is_loaded {
                    continue;
                }
                let [first, ..] = face;
                let distances = [x - origin.x, y - origin.y, x - first.x, y - first.y];
                for distance in distances.map(R::abs) {
                    if distance > unit {
                        unit = distance;
                    }
                }
                if pressure > peak {
                    peak = pressure;
                }
            }
        }
        if !unit.is_finite() {
            return Err(MeshError::Extent);
        }
        if unit == R::ZERO || peak == R::ZERO {
            return Err(MeshError::Unloaded);
        }
        Ok(Self { origin, unit, peak })
    }

    /// A triangle in these units, if it has an area and a pressure.
    fn loaded(&self, face: &[Vertex<R>; 3]) -> Option<Face<R>> {
        let Self { origin, unit, peak } = self;
        let pressures = face.map(|vertex| vertex.pressure / *peak);
        let [a, b, c] = face;
        // Differences of neighbours are exact, however far away the origin is.
        let from = |v: &Vertex<R>, x: R, y: R| Vector2::new((v.x - x) / *unit, (v.y - y) / *unit);
        let (corner, sides) = (
            from(a, origin.x, origin.y),
            [b, c].map(|v| from(v, a.x, a.y)),
        );
        let [second, third] = sides;
        let size = (second.x * third.y).abs() + (second.y * third.x).abs();
        let least = R::TWO * R::TWO * R::EPSILON * size + R::MIN_POSITIVE / R::EPSILON;
        let has_area = cross(&second, &third).abs() > least;
        let has_pressure = pressures.iter().any(|pressure| *pressure > R::ZERO);
        (has_area && has_pressure).then_some(Face {
            corner,
            sides,
            pressures,
        })
    }
}

/// Centre of pressure, distance of the farthest corner from it, and load, in units of a [`MeshExtent`].
struct Frame<R: Real> {
    centre: Vector2<R>,
    radius: R,
    load: R,
}

impl<R: Real> Frame<R> {
    fn of(faces: impl Iterator<Item = Face<R>> + Clone) -> Result<Self, MeshError> {
        let (mut load, four) = (R::ZERO, R::from_f64(4.0));
        let mut moment = Vector2::new(R::ZERO, R::ZERO);
        for face in faces.clone() {
            let (a, [b, c], [p, q, r]) = (face.corner, face.sides, face.pressures);
            let twice = cross(&b, &c).abs();
            let sum = p + q + r;
            // Two shares of corners integrate to 1/12 of the area, one share squared to twice that.
            load += twice * sum;
            moment += (a * (sum * four) + (b + c) * sum + b * q + c * r) * twice;
        }
        // Pressures may be lost in rounding beside the largest one.
        if load <= R::MIN_POSITIVE / R::EPSILON || load.is_nan() {
            return Err(MeshError::Unloaded);
        }
        let quarter = R::HALF * R::HALF / load;
        let centre = moment * quarter;
        let mut radius = R::ZERO;
        let corners = faces.flat_map(
            |Face {
                 corner,
                 sides: [b, c],
                 ..
             }| [corner, corner + b, corner + c],
        );
        for corner in corners {
            let from = corner - centre;
            let distance = from.x.hypot(from.y);
            if distance > radius {
                radius = distance;
            }
        }
        // What lies far from a triangle without area, or is very small beside it, has no extent beyond rounding.
        let by_place = four * R::EPSILON * (centre.x.abs() + centre.y.abs());
        if radius <= by_place + R::MIN_POSITIVE / R::EPSILON / load {
            return Err(MeshError::Unloaded);
        }
        Ok(Self {
            centre,
            radius,
            load: load * R::from_f64(1.0 / 6.0),
        })
    }
}
