//! The flat face on which a shape stands.

use rapier3d::parry::shape::ConvexPolyhedron;
use rapier3d::prelude::*;
use tribos_feet::Footprint;

/// Least cosine of the angle between the contact's normal and that of a face that lies on the ground: 2.6°.
const FLAT: f32 = 0.999;

/// A face of a shape.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Face<'a> {
    /// Outward normal in the shape's frame.
    pub(crate) normal: Vector,
    outline: Outline<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Outline<'a> {
    /// A disk around the axis.
    Disk { radius: f32 },
    /// A rectangle around the normal: half sides of the box.
    Rectangle { half: Vector },
    /// A face of a hull, by its number.
    Polygon {
        hull: &'a ConvexPolyhedron,
        face: usize,
    },
}

/// The face of a shape that lies flat on a ground to which `down` points, in the shape's frame. `None` for
/// shapes that stand on a point or an edge, for round ones, and for those of several parts.
pub(crate) fn face<'a>(shape: &'a dyn Shape, down: Vector) -> Option<Face<'a>> {
    let axis = Vector::Y * down.y.signum();
    let disk = |radius: f32| (axis, Outline::Disk { radius });
    let rectangle = |half: Vector| {
        let size = down.abs();
        let axis = match size.max_element() {
            most if most == size.x => Vector::X * down.x.signum(),
            most if most == size.y => axis,
            _ => Vector::Z * down.z.signum(),
        };
        (axis, Outline::Rectangle { half })
    };
    let polygon = |hull: &'a ConvexPolyhedron| {
        let faces = hull.faces().iter().enumerate();
        let mut lying = faces.filter(|(_, face)| face.normal.dot(down) > FLAT);
        let (face, found) = lying.next()?;
        Some((found.normal, Outline::Polygon { hull, face }))
    };
    let (normal, outline) = match shape.as_typed_shape() {
        TypedShape::Cylinder(cylinder) => disk(cylinder.radius),
        TypedShape::RoundCylinder(round) => disk(round.inner_shape.radius),
        TypedShape::Cone(cone) => (
            Vector::NEG_Y,
            Outline::Disk {
                radius: cone.radius,
            },
        ),
        TypedShape::Cuboid(cuboid) => rectangle(cuboid.half_extents),
        TypedShape::RoundCuboid(round) => rectangle(round.inner_shape.half_extents),
        TypedShape::ConvexPolyhedron(hull) => polygon(hull)?,
        TypedShape::RoundConvexPolyhedron(round) => polygon(&round.inner_shape)?,
        _ => return None,
    };
    (normal.dot(down) > FLAT).then_some(Face { normal, outline })
}

/// The area of a face.
pub(crate) struct FlatFace {
    pub(crate) footprint: Footprint,
    /// Its middle in the shape's frame.
    pub(crate) center: Vector,
    /// Direction of its x axis.
    pub(crate) along: Vector,
}

impl Face<'_> {
    /// `None` for a face without area.
    pub(crate) fn sole(&self) -> Option<FlatFace> {
        // Seen from above the foot: x, the second axis and the normal from the ground are right-handed.
        let along = self.normal.any_orthonormal_vector();
        let across = along.cross(self.normal);
        let plane = |point: Vector| [point.dot(along), point.dot(across)];
        let (footprint, [x, y]) = match self.outline {
            Outline::Disk { radius } => (Footprint::disk(radius).ok()?, [0.0; 2]),
            Outline::Rectangle { half } => {
                let [a, b] = [along, across].map(|axis| axis.abs().dot(half));
                let corners = [[-a, -b], [a, -b], [a, b], [-a, b]];
                Footprint::convex(&corners).ok()?
            }
            Outline::Polygon { hull, face } => {
                let face = hull.faces().get(face)?;
                let first = face.first_vertex_or_edge as usize;
                let count = face.num_vertices_or_edges as usize;
                let corners = hull.vertices_adj_to_face().get(first..first + count)?;
                let corner = |&at: &u32| hull.points().get(at as usize).copied().map(plane);
                let corners: Vec<_> = corners.iter().map(corner).collect::<Option<_>>()?;
                Footprint::convex(&corners).ok()?
            }
        };
        Some(FlatFace {
            footprint,
            center: along * x + across * y,
            along,
        })
    }
}
