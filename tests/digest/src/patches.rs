//! Bits of contact patches: their nodes and shares.

use crate::hash::{Fnv, in_both};
use crate::inputs::{ends, pairs_of_ends};
use tribos_core::internals::tripod_shares;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch, Nodes};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// Nodes of the lists.
const ROOM: usize = 96;

/// Digest of all patches, f64 and f32.
pub fn patches() -> u64 {
    let mut hash = Fnv::new();
    rules::<f64>(&mut hash);
    rules::<f32>(&mut hash);
    points::<f64>(&mut hash);
    points::<f32>(&mut hash);
    pressures(&mut hash);
    hash.0
}

/// Digest of the standard rule, f64 and f32.
pub fn standard_rule() -> u64 {
    in_both(standard_rule_of::<f64>, standard_rule_of::<f32>)
}

fn standard_rule_of<R: Real>(hash: &mut Fnv) {
    let rule = PolarQuadrature::standard(R::HALF).expect("a rule");
    let nodes: NodeList<R, 512> = rule.nodes().expect("room");
    listed(hash, &nodes);
}

fn listed<R: Real>(hash: &mut Fnv, patch: &dyn NodePatch<R>) {
    for node in patch.nodes() {
        hash.numbers([node.x, node.y, node.weight]);
    }
    hash.number(patch.total_weight());
}

fn rules<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    for (rings, angles, rim) in [(3, 5, 0.5), (6, 12, -0.5), (1, 1, 0.0)] {
        let rule = PolarQuadrature::new(real(0.75), rings, angles).expect("a rule");
        let rule = rule.with_rim_exponent(real(rim)).expect("in range");
        let nodes: NodeList<R, ROOM> = rule.nodes().expect("room");
        listed(hash, &nodes);
        let nodes: NodeList<R, ROOM> = rule.nodes_tilted(real(0.125), real(-0.25)).expect("room");
        listed(hash, &nodes);
        let shaped = rule.nodes_shaped(|x: R, y: R| R::ONE + x * x + y * y * y * y);
        let nodes: NodeList<R, ROOM> = shaped.expect("room");
        listed(hash, &nodes);
    }
    let rim: NodeList<R, ROOM> = NodeList::ring(real(2.0), 17).expect("room");
    listed(hash, &rim);
    for x in ends::<R>() {
        hash.verdict(&PolarQuadrature::new(x, 3, 4));
        hash.verdict(&NodeList::<R, 8>::ring(x, 5));
        let rule = PolarQuadrature::new(R::ONE, 2, 3).expect("a rule");
        hash.verdict(&rule.with_rim_exponent(x));
        let tilted: Result<NodeList<R, 8>, _> = rule.nodes_tilted(x, R::ZERO);
        hash.verdict(&tilted);
    }
}

fn points<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let feet = [[0.0, 0.0], [1.0, 0.125], [0.5, 0.75]].map(|foot: [f64; 2]| foot.map(real));
    let hexagon = [
        [2.0, 0.0],
        [1.0, 1.5],
        [-1.0, 1.75],
        [-2.0, 0.25],
        [-1.0, -1.5],
        [1.25, -1.5],
    ];
    for divisions in [1, 2] {
        let plate: NodeList<R, 112> =
            NodeList::polygon(&hexagon.map(|c| c.map(real)), divisions).expect("a convex polygon");
        listed(hash, &plate);
    }
    let stool = Nodes::tripod(feet, [real(0.5), real(0.25)]).expect("upright");
    listed(hash, &stool);
    let mut list = NodeList::<R, 4>::default();
    for (x, y) in pairs_of_ends::<R>() {
        let shares = tripod_shares(feet, [x, y]);
        hash.verdict(&shares);
        hash.numbers(shares.into_iter().flatten());
        let weight = x;
        hash.verdict(&Nodes::new([Node { x: y, y, weight }]));
        hash.verdict(&list.push(Node { x, y: x, weight: y }));
        hash.number(list.total_weight());
        hash.verdict(&NodeList::<R, 32>::polygon(&[[x, y], feet[1], feet[2]], 1));
        if list.nodes().len() == 3 {
            list.clear();
        }
    }
    listed(hash, &NodeList::<R, 2>::new());
}

fn pressures(hash: &mut Fnv) {
    for order in ends() {
        let pressure = PowerPressure::new(order);
        hash.verdict(&pressure);
        hash.maybe(pressure.ok().map(|p| p.order()));
        hash.maybe(pressure.ok().map(|p| p.mean_square_radius()));
        let mixed = PolynomialPressure::new([1.0, order, 0.25]);
        hash.verdict(&mixed);
        if let Ok(mixed) = mixed {
            hash.numbers(*mixed.shares());
            hash.number(mixed.mean_square_radius());
        }
    }
}
