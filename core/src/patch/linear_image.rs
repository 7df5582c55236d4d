//! Images of patches under linear maps of the plane: shape and pressure are carried along.

use super::bar::Bar;
use super::mesh::Mesh;
use super::nodes::{Node, NodePatch, Nodes};
use super::outline::{Edge, Polygon, PressureField};
use super::points::PointPatch;
use super::triangle::Triangle;
use crate::coupling::flat::PatchShape;
use crate::real::Real;
use nalgebra::Vector2;

/// A linear map of the plane that keeps the sense of rotation, by its rows.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearMap<R: Real> {
    /// What makes the first and the second coordinate of an image.
    pub rows: [Vector2<R>; 2],
}

impl<R: Real> LinearMap<R> {
    /// The image of a place.
    #[inline(always)]
    pub fn of(&self, place: &Vector2<R>) -> Vector2<R> {
        let [first, second] = &self.rows;
        Vector2::new(
            first.x * place.x + first.y * place.y,
            second.x * place.x + second.y * place.y,
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

/// A patch that has an image under every linear map.
///
/// Friction that differs along two axes is uniform in all directions on such an image
/// ([`super::anisotropic`]).
pub trait LinearImage<R: Real>: PatchShape<R> + Sized {
    /// The image about the origin of the patch's coordinates.
    #[doc(hidden)]
    fn image(self, map: &LinearMap<R>) -> Self;
}

impl<R: Real, S, K> LinearImage<R> for Polygon<R, S, K>
where
    S: AsRef<[Edge<R>]> + AsMut<[Edge<R>]>,
    K: PressureField<R>,
{
    fn image(mut self, map: &LinearMap<R>) -> Self {
        let mut reach = R::ZERO;
        for edge in self.edges() {
            let corner = map.of(&edge.start());
            let distance = corner.x.hypot(corner.y);
            if distance > reach {
                reach = distance;
            }
        }
        let count = self.count;
        let (mut longest, unit) = (R::ZERO, R::ONE / reach);
        for edge in self.edges.as_mut().iter_mut().take(count) {
            *edge = Edge::new(map.of(&edge.start()) * unit, map.of(&edge.end()) * unit);
            if edge.length() > longest {
                longest = edge.length();
            }
        }
        let [x, y] = map.slope_of(self.pressure.slope());
        Self {
            pressure: K::of_piece(self.pressure.at_centre(), [x * reach, y * reach]),
            centre: map.of(&self.centre),
            radius: self.radius * reach,
            reduced_area: self.reduced_area * map.determinant() * (unit * unit),
            longest_half: R::HALF * longest,
            ..self
        }
    }
}

impl<R: Real> LinearImage<R> for Bar<R> {
    fn image(self, map: &LinearMap<R>) -> Self {
        self.moved(map)
    }
}

impl<R: Real, S: AsRef<[Triangle<R>]> + AsMut<[Triangle<R>]>> LinearImage<R> for Mesh<R, S> {
    fn image(self, map: &LinearMap<R>) -> Self {
        self.moved(map)
    }
}

impl<R: Real, const N: usize> LinearImage<R> for PointPatch<R, Nodes<R, N>> {
    fn image(self, map: &LinearMap<R>) -> Self {
        self.moved(map, |nodes| nodes.moved(|node| image_of(map, node)))
    }
}

/// A node at the image of its place.
#[doc(hidden)]
pub fn image_of<R: Real>(map: &LinearMap<R>, node: &Node<R>) -> Node<R> {
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
    pub fn moved(self, map: &LinearMap<R>, nodes: impl FnOnce(P) -> P) -> Self {
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
