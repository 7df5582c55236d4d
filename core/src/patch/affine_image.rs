//! Images of patches under affine maps of the plane: shape and pressure are carried along.

use super::bar::Bar;
use super::mesh::Mesh;
use super::nodes::{Node, NodePatch, Nodes};
use super::outline::{Edge, Polygon, PressureField};
use super::points::PointPatch;
use super::triangle::Triangle;
use crate::coupling::flat::PatchShape;
use crate::real::Real;
use nalgebra::Vector2;

/// An affine map of the plane that keeps the sense of rotation.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AffineMap<R: Real> {
    /// What makes the first and the second coordinate of an image.
    pub rows: [Vector2<R>; 2],
    /// The image of the origin.
    pub shift: Vector2<R>,
}

impl<R: Real> AffineMap<R> {
    /// Places turned by the angle whose cosine and sine these are, and then moved.
    pub fn placed([cos, sin]: [R; 2], [x, y]: [R; 2]) -> Self {
        Self {
            rows: [Vector2::new(cos, -sin), Vector2::new(sin, cos)],
            shift: Vector2::new(x, y),
        }
    }

    /// The image of a place.
    #[inline(always)]
    pub fn of(&self, place: &Vector2<R>) -> Vector2<R> {
        self.of_vector(place) + self.shift
    }

    /// The image of a difference of places.
    #[inline(always)]
    pub fn of_vector(&self, from: &Vector2<R>) -> Vector2<R> {
        let [first, second] = &self.rows;
        Vector2::new(
            first.x * from.x + first.y * from.y,
            second.x * from.x + second.y * from.y,
        )
    }

    /// By how much areas grow.
    pub(crate) fn determinant(&self) -> R {
        let [first, second] = &self.rows;
        first.x * second.y - first.y * second.x
    }

    /// The slope of a field on the image that has this slope on the patch.
    fn slope_of(&self, slope: [R; 2]) -> [R; 2] {
        let [first, second] = &self.rows;
        let [x, y] = slope;
        let inv = R::ONE / self.determinant();
        [
            inv * (second.y * x - second.x * y),
            inv * (first.x * y - first.y * x),
        ]
    }
}

/// A patch that has images under affine maps.
///
/// Friction that differs along two axes is the same in all directions on such an image
/// ([`super::anisotropic`]).
#[doc(hidden)]
pub trait AffineImage<R: Real>: PatchShape<R> + Sized {
    /// The image, which carries the same load; `None` if there is none of this kind.
    #[doc(hidden)]
    fn image(self, map: &AffineMap<R>) -> Option<Self>;
}

impl<R: Real, S, K> AffineImage<R> for Polygon<R, S, K>
where
    S: AsRef<[Edge<R>]> + AsMut<[Edge<R>]>,
    K: PressureField<R>,
{
    fn image(mut self, map: &AffineMap<R>) -> Option<Self> {
        let mut reach = R::ZERO;
        for edge in self.edges() {
            let corner = map.of_vector(&edge.start());
            let distance = corner.x.hypot(corner.y);
            if distance > reach {
                reach = distance;
            }
        }
        let count = self.count;
        let (mut longest, unit) = (R::ZERO, R::ONE / reach);
        for edge in self.edges.as_mut().iter_mut().take(count) {
            let ends = [edge.start(), edge.end()].map(|end| map.of_vector(&end) * unit);
            *edge = Edge::new(ends[0], ends[1]);
            if edge.length() > longest {
                longest = edge.length();
            }
        }
        let [x, y] = map.slope_of(self.pressure.slope());
        Some(Self {
            pressure: K::of_piece(self.pressure.at_centre(), [x * reach, y * reach]),
            centre: map.of(&self.centre),
            radius: self.radius * reach,
            reduced_area: self.reduced_area * map.determinant() * (unit * unit),
            longest_half: R::HALF * longest,
            ..self
        })
    }
}

impl<R: Real, K: PressureField<R>> AffineImage<R> for Bar<R, K> {
    fn image(self, map: &AffineMap<R>) -> Option<Self> {
        Some(self.moved(map))
    }
}

impl<R: Real, S: AsRef<[Triangle<R>]> + AsMut<[Triangle<R>]>> AffineImage<R> for Mesh<R, S> {
    fn image(self, map: &AffineMap<R>) -> Option<Self> {
        Some(self.moved(map))
    }
}

impl<R: Real, const N: usize> AffineImage<R> for PointPatch<R, Nodes<R, N>> {
    fn image(self, map: &AffineMap<R>) -> Option<Self> {
        Some(self.moved(map, |nodes| nodes.moved(|node| image_of(map, node))))
    }
}

/// A node at the image of its place.
#[doc(hidden)]
pub fn image_of<R: Real>(map: &AffineMap<R>, node: &Node<R>) -> Node<R> {
    let at = map.of(&Vector2::new(node.x, node.y));
    Node {
        x: at.x,
        y: at.y,
        weight: node.weight,
    }
}

impl<R: Real, P: NodePatch<R>> PointPatch<R, P> {
    /// The image of the patch, with nodes that are the images of its own.
    #[doc(hidden)]
    pub fn moved(self, map: &AffineMap<R>, nodes: impl FnOnce(P) -> P) -> Self {
        let (nodes, centre) = (nodes(self.nodes), map.of(&self.centre));
        let mut radius = R::ZERO;
        for node in nodes.nodes().iter().filter(|node| node.weight > R::ZERO) {
            let distance = (node.x - centre.x).hypot(node.y - centre.y);
            if distance > radius {
                radius = distance;
            }
        }
        Self {
            nodes,
            centre,
            radius,
        }
    }
}
