//! A contact at a number of points, each with a share of the load.
//!
//! The points may be real (the feet of a tripod, the spikes of a shoe) or the nodes of a quadrature
//! rule that represents a continuous pressure ([`super::polar`], [`super::polygon`]).

pub use super::node_storage::{NodeBuffer, NodeSlice};

use super::PatchError;
use crate::real::Real;

/// One point of a contact.
///
/// *Units*: length; the weight is a share of the load in any unit, because only ratios of
/// weights count.
/// *Layout*: that of a C structure of these three numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Node<R> {
    /// First coordinate in the contact plane, from the point that twist and wrench refer to.
    pub x: R,
    /// Second coordinate.
    pub y: R,
    /// Share of the load: a normal number or zero, because subnormal ones lose digits.
    pub weight: R,
}

/// A set of valid nodes: finite positions, finite weights ≥ 0 with a finite sum.
///
/// ```
/// use tribos_core::patch::nodes::{Node, NodePatch, Nodes};
/// /// Where along x the load acts.
/// fn centre_of_pressure(patch: &impl NodePatch<f64>) -> f64 {
///     let moment: f64 = patch.nodes().iter().map(|node| node.weight * node.x).sum();
///     moment / patch.total_weight()
/// }
/// let heel = Node { x: 0.0, y: 0.0, weight: 300.0 }; // m, N
/// let toe = Node { x: 0.2, y: 0.0, weight: 100.0 };
/// assert!((centre_of_pressure(&Nodes::new([heel, toe])?) - 0.05).abs() < 1e-16);
/// # Ok::<(), tribos_core::patch::PatchError>(())
/// ```
pub trait NodePatch<R: Real> {
    /// All nodes, in the order in which they are summed.
    fn nodes(&self) -> &[Node<R>];

    /// Sum of the weights.
    fn total_weight(&self) -> R;
}

impl<R: Real, P: NodePatch<R> + ?Sized> NodePatch<R> for &P {
    #[inline]
    fn nodes(&self) -> &[Node<R>] {
        (**self).nodes()
    }
    #[inline]
    fn total_weight(&self) -> R {
        (**self).total_weight()
    }
}

/// A list to which nodes are added one by one.
///
/// ```
/// use tribos_core::patch::PatchError;
/// use tribos_core::patch::nodes::{Node, NodeBuffer, NodeList, NodePatch, NodeSink};
/// /// The four feet of a table, 1 m by 2 m.
/// fn table(feet: &mut impl NodeSink<f64>) -> Result<(), PatchError> {
///     for (x, y) in [(0.5, 1.0), (-0.5, 1.0), (0.5, -1.0), (-0.5, -1.0)] {
///         feet.push(Node { x, y, weight: 1.0 })?;
///     }
///     Ok(())
/// }
/// let (mut owned, mut memory) = (NodeList::<f64, 4>::new(), [Node::default(); 4]);
/// let mut lent = NodeBuffer::new(&mut memory);
/// table(&mut owned)?;
/// table(&mut lent)?;
/// assert_eq!(owned.nodes(), lent.nodes());
/// # Ok::<(), PatchError>(())
/// ```
pub trait NodeSink<R: Real>: NodePatch<R> {
    /// Adds one node; a refused node leaves the others as they were.
    ///
    /// *Domain*: finite position, weight ≥ 0, finite sum of weights, room for one more.
    fn push(&mut self, node: Node<R>) -> Result<(), PatchError>;
}

/// A fixed number of nodes.
///
/// ```
/// use tribos_core::patch::nodes::{Node, Nodes};
/// // A foot with its heel at the origin: the heel carries twice what the toe carries.
/// let foot = Nodes::new([
///     Node { x: 0.0, y: 0.0, weight: 2.0 },
///     Node { x: 0.2, y: 0.0, weight: 1.0 },
/// ]);
/// assert!(foot.is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nodes<R, const N: usize> {
    nodes: [Node<R>; N],
    total_weight: R,
}

impl<R: Real, const N: usize> Nodes<R, N> {
    /// *Domain*: finite positions, weights ≥ 0 of which at least one is positive, finite sum.
    pub fn new(nodes: [Node<R>; N]) -> Result<Self, PatchError> {
        let total_weight = validated_total(&nodes)?;
        Ok(Self {
            nodes,
            total_weight,
        })
    }
}

impl<R: Real, const N: usize> Nodes<R, N> {
    /// The same weights elsewhere.
    pub(super) fn moved(self, image: impl Fn(&Node<R>) -> Node<R>) -> Self {
        Self {
            nodes: self.nodes.map(|node| image(&node)),
            ..self
        }
    }
}

impl<R: Real, const N: usize> NodePatch<R> for Nodes<R, N> {
    #[inline]
    fn nodes(&self) -> &[Node<R>] {
        &self.nodes
    }
    #[inline]
    fn total_weight(&self) -> R {
        self.total_weight
    }
}

/// A list of up to `CAPACITY` nodes, filled at run time, without an allocator.
///
/// *Size*: 24 bytes a node (f32: 12).
///
/// ```
/// use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
/// let mut touching = NodeList::<f32, 4>::new();
/// touching.push(Node { x: 0.1, y: 0.0, weight: 9.81 })?;
/// assert_eq!(touching.total_weight(), 9.81);
/// touching.clear(); // lifted
/// assert!(touching.nodes().is_empty());
/// # Ok::<(), tribos_core::patch::PatchError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NodeList<R, const CAPACITY: usize> {
    nodes: heapless::Vec<Node<R>, CAPACITY>,
    total_weight: R,
}

impl<R: Real, const CAPACITY: usize> NodeList<R, CAPACITY> {
    /// An empty list, without friction.
    pub fn new() -> Self {
        Self {
            nodes: heapless::Vec::new(),
            total_weight: R::ZERO,
        }
    }

    /// Adds one node; a refused node leaves the list as it was.
    ///
    /// *Domain*: finite position, weight ≥ 0, finite sum of weights, room for one more.
    pub fn push(&mut self, node: Node<R>) -> Result<(), PatchError> {
        let total_weight = total_with(self.total_weight, self.nodes.len(), &node)?;
        match self.nodes.push(node) {
            Ok(()) => {
                self.total_weight = total_weight;
                Ok(())
            }
            Err(_) => Err(PatchError::Full { capacity: CAPACITY }),
        }
    }

    /// Removes all nodes.
    pub fn clear(&mut self) {
        *self = Self::new();
    }
}

impl<R: Real, const CAPACITY: usize> Default for NodeList<R, CAPACITY> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real, const CAPACITY: usize> NodePatch<R> for NodeList<R, CAPACITY> {
    #[inline]
    fn nodes(&self) -> &[Node<R>] {
        &self.nodes
    }
    #[inline]
    fn total_weight(&self) -> R {
        self.total_weight
    }
}

impl<R: Real, const CAPACITY: usize> NodeSink<R> for NodeList<R, CAPACITY> {
    fn push(&mut self, node: Node<R>) -> Result<(), PatchError> {
        NodeList::push(self, node)
    }
}

/// The positive sum of the weights of valid nodes.
pub(super) fn validated_total<R: Real>(nodes: &[Node<R>]) -> Result<R, PatchError> {
    let mut total_weight = R::ZERO;
    for (index, node) in nodes.iter().enumerate() {
        total_weight = total_with(total_weight, index, node)?;
    }
    if total_weight > R::ZERO {
        Ok(total_weight)
    } else {
        Err(PatchError::Unloaded)
    }
}

/// The sum of weights after a valid `node`.
pub(super) fn total_with<R: Real>(total: R, index: usize, node: &Node<R>) -> Result<R, PatchError> {
    if !(node.x.is_finite() && node.y.is_finite()) {
        return Err(PatchError::NodePosition {
            index,
            given: [node.x.to_f64(), node.y.to_f64()],
        });
    }
    let sum = total + node.weight;
    if node.weight >= R::ZERO && sum.is_finite() {
        Ok(sum)
    } else {
        Err(PatchError::NodeWeight {
            index,
            given: node.weight.to_f64(),
        })
    }
}
