//! Shapes and pressures.

use super::{Keeper, keep};
use tribos_core::Real;
use tribos_core::patch::nodes::{
    Node, NodeBuffer, NodeError, NodeList, NodePatch, NodeSink, NodeSlice, Nodes,
};
use tribos_core::patch::polar::{PolarError, PolarRule, ring};
use tribos_core::patch::polygon::{PolygonError, polygon, polygon_into};
use tribos_core::patch::tripod::{TripodError, tripod, tripod_shares};
use tribos_core::patch::{PolynomialPressure, PowerPressure};

/// Patches of one precision.
pub fn all<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Nodes::<R, 3>::new,
        NodeList::<R, 12>::new,
        NodeList::<R, 12>::push,
        NodeList::<R, 12>::clear,
        <NodeList<R, 12> as Default>::default,
        PolarRule::<R>::new,
        PolarRule::<R>::standard,
        PolarRule::<R>::with_rim_exponent,
        PolarRule::<R>::nodes::<12>,
        PolarRule::<R>::nodes_tilted::<12>,
        ring::<R, 12>,
        polygon::<R, 28>,
        tripod::<R>,
        tripod_shares::<R>,
    );
    keep!(keeper: PolarRule::<R>::nodes_shaped::<12>
        => fn(&PolarRule<R>, fn(R, R) -> R) -> Result<NodeList<R, 12>, NodeError>);
    node_patch::<R, Nodes<R, 3>>(keeper);
    node_patch::<R, NodeList<R, 12>>(keeper);
    node_patch::<R, &NodeList<R, 12>>(keeper);
    node_patch::<R, &Nodes<R, 3>>(keeper);
    node_patch::<R, NodeSlice<R>>(keeper);
    node_patch::<R, NodeBuffer<R>>(keeper);
    sink::<R, NodeBuffer<R>>(keeper);
    sink::<R, NodeList<R, 12>>(keeper);
    keep!(keeper: NodeSlice::<R>::new, NodeBuffer::<R>::new);
}

/// Receiver of the nodes of rules.
fn sink<R: Real, S: NodeSink<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: <S as NodeSink<R>>::push);
    keep!(keeper: polygon_into::<R> => fn(&mut S, &[[R; 2]], u32) -> Result<(), PolygonError>);
    keep!(keeper: PolarRule::<R>::nodes_into
        => fn(&PolarRule<R>, &mut S, fn(R, R) -> R) -> Result<(), NodeError>);
}

fn node_patch<R: Real, P: NodePatch<R>>(keeper: &mut impl Keeper) {
    let _: fn(&P) -> &[Node<R>] = P::nodes;
    keep!(keeper: <P as NodePatch<R>>::nodes, <P as NodePatch<R>>::total_weight);
}

/// Pressures and errors, which have f64 inside.
pub fn pressures(keeper: &mut impl Keeper) {
    keep!(keeper:
        PowerPressure::new,
        PowerPressure::order,
        PowerPressure::mean_square_radius,
        PolynomialPressure::<4>::new,
        PolynomialPressure::<4>::shares,
        PolynomialPressure::<4>::mean_square_radius,
        <PolarError as From<NodeError>>::from,
        <PolygonError as From<NodeError>>::from,
        <TripodError as From<NodeError>>::from,
    );
}
