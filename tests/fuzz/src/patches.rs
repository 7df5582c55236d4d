//! Patches: every accepted patch is usable.

use super::check::holds;
use super::{Broken, Source};
use tribos_core::internals::tripod_shares;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch, Nodes};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// One patch in either precision.
pub fn patches(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(8) {
        return pressures(source);
    }
    if source.one_in(2) {
        of::<f64>(source)
    } else {
        of::<f32>(source)
    }
}

fn of<R: Real>(source: &mut Source) -> Result<(), Broken> {
    match source.below(4) {
        0 => {
            let nodes = [(); 4].map(|()| node::<R>(source));
            Nodes::new(nodes).map_or(Ok(()), |nodes| sound(&nodes))
        }
        1 => {
            let feet = [(); 3].map(|()| [source.number::<R>(), source.number()]);
            let centre = [source.number(), source.number()];
            if let Ok(shares) = tripod_shares(feet, centre) {
                let all = shares
                    .iter()
                    .all(|share| *share >= R::ZERO && *share <= R::TWO);
                holds(all, "shares from 0 to 1", &shares)?;
            }
            Nodes::tripod(feet, centre).map_or(Ok(()), |stool| sound(&stool))
        }
        2 => {
            let corners = [(); 5].map(|()| [source.number::<R>(), source.number()]);
            let count = source.below(6);
            let plate = NodeList::<R, 64>::polygon(&corners[..count], source.below(4) as u32);
            plate.map_or(Ok(()), |plate| sound(&plate))
        }
        _ => rules::<R>(source),
    }
}

pub fn node<R: Real>(source: &mut Source) -> Node<R> {
    Node {
        x: source.number(),
        y: source.number(),
        weight: source.size(),
    }
}

fn rules<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let radius = source.positive::<R>();
    if let Ok(rim) = NodeList::<R, 16>::ring(radius, source.below(18) as u32) {
        sound(&rim)?;
    }
    let Ok(rule) = PolarQuadrature::new(radius, source.below(5) as u32, source.below(8) as u32)
    else {
        return Ok(());
    };
    let Ok(rule) = rule.with_rim_exponent(source.number()) else {
        return Ok(());
    };
    let plain: Result<NodeList<R, 32>, _> = rule.nodes();
    plain.map_or(Ok(()), |nodes| sound(&nodes))?;
    let tilted: Result<NodeList<R, 32>, _> = rule.nodes_tilted(source.number(), source.number());
    tilted.map_or(Ok(()), |nodes| sound(&nodes))?;
    let (a, b) = (source.number::<R>(), source.number::<R>());
    let shaped: Result<NodeList<R, 32>, _> = rule.nodes_shaped(|x: R, y: R| a + b * (x + y));
    shaped.map_or(Ok(()), |nodes| sound(&nodes))
}

/// Finite positions, weights that are not negative, and a finite sum.
fn sound<R: Real>(patch: &impl NodePatch<R>) -> Result<(), Broken> {
    for node in patch.nodes() {
        let [x, y, weight] = [node.x, node.y, node.weight];
        let fine = x.is_finite() && y.is_finite() && weight >= R::ZERO && weight.is_finite();
        holds(fine, "sound nodes", &[x, y, weight])?;
    }
    let total = patch.total_weight();
    holds(
        total >= R::ZERO && total.is_finite(),
        "a finite sum of weights",
        &[total],
    )
}

fn pressures(source: &mut Source) -> Result<(), Broken> {
    if let Ok(pressure) = PowerPressure::new(source.number()) {
        let square = pressure.mean_square_radius();
        holds(
            square > 0.0 && square <= 1.0,
            "0 < mean square radius ≤ 1",
            &[pressure.order(), square],
        )?;
    }
    let Ok(mixed) = PolynomialPressure::new([source.number(), source.number(), source.number()])
    else {
        return Ok(());
    };
    let square = mixed.mean_square_radius();
    holds(
        (0.0..=1.0 + 1e-12).contains(&square),
        "mean square radius from 0 to 1",
        &[square],
    )
}
