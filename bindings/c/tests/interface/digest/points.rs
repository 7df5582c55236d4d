//! Contacts at points and the rules that make them.

use super::stream::{Precision, Range, Stream};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::{CoulombLaw, DryFriction, LocalLaw, PowerLaw, Stribeck, StribeckParameters};
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch, Nodes};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::real::Real;
use tribos_core::twist::Twist;

pub fn at_points<R: Precision>(s: &mut Stream) {
    let p: [R; 5] = s.draws(Range::Fit);
    let x: [R; 12] = s.draws(Range::Mild);
    let twist = s.twist(Range::Mild);
    let nodes = four_nodes(&x);
    let dry = DryFriction::new(p[0] + p[1], p[1]);
    let stribeck = dry.and_then(|dry| {
        Stribeck::new(StribeckParameters {
            dry,
            speed: p[2],
            exponent: p[3],
            viscous: p[4],
        })
    });
    feed(s, CoulombLaw::new(p[0]).ok(), &nodes, p[4], &twist);
    feed(
        s,
        PowerLaw::new(p[1] - R::HALF, p[2]).ok(),
        &nodes,
        p[4],
        &twist,
    );
    feed(s, stribeck.ok(), &nodes, p[4], &twist);
}

/// Four nodes of three numbers each.
pub fn four_nodes<R: Real>(x: &[R; 12]) -> Result<Nodes<R, 4>, PatchError> {
    Nodes::new([0, 3, 6, 9].map(|i| Node {
        x: x[i],
        y: x[i + 1],
        // -0 stays -0, as in C.
        weight: if x[i + 2] < R::ZERO {
            -x[i + 2]
        } else {
            x[i + 2]
        },
    }))
}

fn feed<R: Precision, L: LocalLaw<R>>(
    s: &mut Stream,
    law: Option<L>,
    nodes: &Result<Nodes<R, 4>, PatchError>,
    load: R,
    twist: &Twist<R>,
) {
    let both = law.zip(nodes.as_ref().ok());
    let friction = both.map(|(law, nodes)| NodeFriction::new(law, nodes));
    let friction = friction.as_ref().ok_or(());
    s.wrench_of(friction.map(|f| f.wrench(load, twist)));
    s.jacobian_of(friction.map(|f| f.wrench_jacobian(load, twist)));
}

pub fn rules<R: Precision>(s: &mut Stream) {
    let x: [R; 8] = s.draws(Range::Mild);
    let [radius, rim, tilt_x, tilt_y]: [R; 4] = s.draws(Range::Fit);
    let corners = [0, 2, 4, 6].map(|i| [x[i], x[i + 1]]);
    let area: Option<NodeList<R, 60>> = NodeList::polygon(&corners, 2).ok();
    feed_nodes(s, area);
    let rule =
        PolarQuadrature::new(radius, 4, 7).and_then(|rule| rule.with_rim_exponent(rim - R::ONE));
    let disk: Option<NodeList<R, 60>> = rule.ok().and_then(|rule| {
        let [x, y] = [tilt_x / R::TWO, -tilt_y / R::TWO];
        rule.nodes_tilted(x, y).ok()
    });
    feed_nodes(s, disk);
    let [a, b, c, centre] = corners;
    feed_nodes(s, Nodes::tripod([a, b, c], centre).ok());
}

fn feed_nodes<R: Real>(s: &mut Stream, list: Option<impl NodePatch<R>>) {
    if let Some(list) = s.ok(list.ok_or(())) {
        for node in list.nodes() {
            s.numbers([node.x, node.y, node.weight]);
        }
    }
}
