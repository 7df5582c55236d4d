//! Nodes in memory owned by the caller.

use super::PatchError;
use super::nodes::{Node, NodePatch, NodeSink, total_with, validated_total};
use crate::real::Real;

/// Nodes in borrowed memory: in flash, or in memory of another language.
///
/// ```
/// use tribos_core::patch::nodes::{Node, NodeSlice};
/// let feet = [-0.1, 0.1].map(|x| Node { x, y: 0.0, weight: 0.5 });
/// assert!(NodeSlice::new(&feet).is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeSlice<'a, R> {
    nodes: &'a [Node<R>],
    total_weight: R,
}

impl<'a, R: Real> NodeSlice<'a, R> {
    /// *Domain*: finite positions, weights ≥ 0 of which at least one is positive, finite sum.
    /// *Cost*: one look at each node.
    pub fn new(nodes: &'a [Node<R>]) -> Result<Self, PatchError> {
        Ok(Self {
            nodes,
            total_weight: validated_total(nodes)?,
        })
    }
}

impl<R: Real> NodePatch<R> for NodeSlice<'_, R> {
    #[inline]
    fn nodes(&self) -> &[Node<R>] {
        self.nodes
    }
    #[inline]
    fn total_weight(&self) -> R {
        self.total_weight
    }
}

/// A list of nodes in caller-provided memory, filled from its start.
///
/// ```
/// use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch, NodeSink};
/// let mut memory = [Node::default(); 2];
/// let mut feet = NodeBuffer::new(&mut memory);
/// for x in [-0.1_f64, 0.1] {
///     feet.push(Node { x, y: 0.0, weight: 4.0 })?; // m, N
/// }
/// assert_eq!(feet.total_weight(), 8.0);
/// assert!(feet.push(feet.nodes()[0]).is_err()); // two have room
/// # Ok::<(), tribos_core::patch::PatchError>(())
/// ```
#[derive(Debug, PartialEq)]
pub struct NodeBuffer<'a, R> {
    memory: &'a mut [Node<R>],
    filled: usize,
    total_weight: R,
}

impl<'a, R: Real> NodeBuffer<'a, R> {
    /// An empty list with room for as many nodes as `memory` has; what it holds does not matter.
    pub fn new(memory: &'a mut [Node<R>]) -> Self {
        Self {
            memory,
            filled: 0,
            total_weight: R::ZERO,
        }
    }
}

impl<R: Real> NodePatch<R> for NodeBuffer<'_, R> {
    #[inline]
    fn nodes(&self) -> &[Node<R>] {
        self.memory.get(..self.filled).unwrap_or_default()
    }
    #[inline]
    fn total_weight(&self) -> R {
        self.total_weight
    }
}

impl<R: Real> NodeSink<R> for NodeBuffer<'_, R> {
    fn push(&mut self, node: Node<R>) -> Result<(), PatchError> {
        let total_weight = total_with(self.total_weight, self.filled, &node)?;
        let capacity = self.memory.len();
        let Some(place) = self.memory.get_mut(self.filled) else {
            return Err(PatchError::Full { capacity });
        };
        *place = node;
        self.filled += 1;
        self.total_weight = total_weight;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::patch::nodes::{NodeList, Nodes};
    use crate::patch::polar::PolarQuadrature;
    use crate::patch::polygon::polygon_into;

    const NOWHERE: Node<f64> = Node {
        x: f64::NAN,
        y: f64::NAN,
        weight: f64::NAN,
    };

    #[test]
    fn lent_memory_holds_the_same_nodes() {
        let corners = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.1], [0.0, 0.2]];
        let owned: NodeList<f64, 56> = NodeList::polygon(&corners, 2).unwrap();
        let mut memory = [NOWHERE; 60];
        let mut lent = NodeBuffer::new(&mut memory);
        polygon_into(&mut lent, &corners, 2).unwrap();
        assert_eq!(lent.nodes(), owned.nodes());
        assert_eq!(lent.total_weight(), owned.total_weight());

        let rule = PolarQuadrature::new(0.2, 3, 5).unwrap();
        let owned: NodeList<f64, 15> = rule.nodes_tilted(0.5, 0.0).unwrap();
        let mut lent = NodeBuffer::new(&mut memory);
        let tilt = |x: f64, _: f64| 1.0 + 0.5 * x / 0.2;
        rule.nodes_into(&mut lent, tilt).unwrap();
        assert_eq!(lent.nodes(), owned.nodes());
    }

    #[test]
    fn lent_memory_refuses_what_lists_refuse() {
        let mut memory = [NOWHERE; 20];
        let corners = [[0.0, 0.0], [0.3, 0.0], [0.0, 0.2]];
        let full = polygon_into(&mut NodeBuffer::new(&mut memory), &corners, 2);
        assert_eq!(full, Err(PatchError::Full { capacity: 20 }));
        let mut lent = NodeBuffer::new(&mut memory);
        assert!(lent.push(NOWHERE).is_err());
        assert!(lent.nodes().is_empty());
    }

    #[test]
    fn slices_are_judged_like_arrays() {
        let weighted = |weight| Node {
            x: 1.0,
            y: -1.0,
            weight,
        };
        for last in [weighted(1.0), weighted(0.0), weighted(-1.0), NOWHERE] {
            let nodes = [weighted(0.0), last];
            // Errors hold what was given, which may be NaN.
            let of_array = Nodes::new(nodes).map(|n| n.total_weight()).ok();
            let of_slice = NodeSlice::new(&nodes).map(|n| n.total_weight()).ok();
            assert_eq!(of_array, of_slice);
        }
        assert_eq!(NodeSlice::<f64>::new(&[]), Err(PatchError::Unloaded));
    }
}
