//! Points of contact as a patch under dry friction.

use super::PatchError;
use super::nodes::{Node, NodePatch};
use crate::real::Real;
use nalgebra::Vector2;

/// Nodes with their centre of pressure and extent: feet, spikes, or the nodes of a rule, under dry
/// friction with a limit surface.
///
/// Where the centre of rotation lies on a point, that point rests and its force is anything up to its
/// limit: the limit surface has a flat facet there for each sense of the rotation.
/// [`crate::limit_surface::ShapeLimitSurface`] serves facets exactly.
///
/// *Units*: length; weights as those of [`Node`].
///
/// ```
/// use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::patch::points::PointPatch;
/// use tribos_core::twist::Wrench;
/// let feet = [[-0.1_f64, 0.0], [0.1, 0.0]].map(|[x, y]| Node { x, y, weight: 0.5 }); // m
/// let table = ShapeLimitSurface::new(PointPatch::new(Nodes::new(feet)?)?, 10.0)?; // N
/// // Pushed at its end it turns about the foot at the other end, however hard that foot holds.
/// for push in [0.7, 0.8, 0.9] {
///     let motion = table.twist_normal_to(&Wrench::new(0.0, 1.0, 0.1 * push)); // N, N, N m
///     assert!((motion.velocity.y - 0.1 * motion.spin).abs() < 1e-15);
/// }
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointPatch<R: Real, P> {
    pub(super) nodes: P,
    pub(super) centre: Vector2<R>,
    pub(super) radius: R,
}

impl<R: Real, P: NodePatch<R>> PointPatch<R, P> {
    /// *Domain*: at least two places carry load, a finite distance apart.
    ///
    /// ```
    /// use tribos_core::patch::PatchError;
    /// use tribos_core::patch::nodes::{Node, Nodes};
    /// use tribos_core::patch::points::PointPatch;
    /// let tip = Nodes::new([Node { x: 0.1, y: 0.0, weight: 2.0_f64 }])?;
    /// assert_eq!(PointPatch::new(tip).err(), Some(PatchError::OnePlace));
    /// # Ok::<(), PatchError>(())
    /// ```
    pub fn new(nodes: P) -> Result<Self, PatchError> {
        let total = nodes.total_weight();
        if !(total > R::ZERO && total.is_finite()) {
            return Err(PatchError::Unloaded);
        }
        let loaded = || nodes.nodes().iter().filter(|node| node.weight > R::ZERO);
        let mut centre = Vector2::new(R::ZERO, R::ZERO);
        for Node { x, y, weight } in loaded() {
            let share = *weight / total;
            centre += Vector2::new(*x * share, *y * share);
        }
        let mut radius = R::ZERO;
        for node in loaded() {
            let distance = (node.x - centre.x).hypot(node.y - centre.y);
            if distance > radius || distance.is_nan() {
                radius = distance;
            }
        }
        let least = R::TWO * R::TWO * R::EPSILON * (centre.x.abs() + centre.y.abs());
        if radius > least && radius.is_finite() {
            Ok(Self {
                nodes,
                centre,
                radius,
            })
        } else {
            Err(PatchError::OnePlace)
        }
    }

    /// The nodes.
    pub fn nodes(&self) -> &P {
        &self.nodes
    }

    /// The centre of pressure, in the nodes' coordinates.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance of the farthest loaded point from the centre of pressure.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// Place of a node in radii about the centre, and its share of the load.
    #[inline(always)]
    pub(crate) fn reduced_node(&self, node: &Node<R>) -> ([R; 2], R) {
        let place = [
            (node.x - self.centre.x) / self.radius,
            (node.y - self.centre.y) / self.radius,
        ];
        (place, node.weight / self.nodes.total_weight())
    }
}
