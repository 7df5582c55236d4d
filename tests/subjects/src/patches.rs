//! Patches: every accepted patch is usable.

use super::planes::{dissipates, parts, twist};
use crate::{Input, Stop, Verdict};
use tribos_core::coupling::LoadedFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::internals::tripod_shares;
use tribos_core::patch::elastic::{
    AdhesiveSphere, Elasticity, HertzEllipse, HertzSphere, LoadedRadius, SoftFinger,
    effective_modulus, relative_curvatures,
};
use tribos_core::patch::nodes::{
    Node, NodeBuffer, NodeList, NodePatch, NodeSink, NodeSlice, Nodes,
};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// One patch.
pub fn patches<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(12) {
        0 | 1 => {
            let nodes = [(); 4].map(|()| node::<R>(input));
            let nodes = input.taken(Nodes::new(nodes))?;
            sound(input, &nodes)
        }
        2 | 3 => {
            let feet = [(); 3].map(|()| [input.number::<R>(), input.number()]);
            let centre = [input.number(), input.number()];
            if let Ok(shares) = input.taken(tripod_shares(feet, centre)) {
                let is_share = |share: &R| *share >= R::ZERO && *share <= R::TWO;
                let are_all = shares.iter().all(is_share);
                input.holds(are_all, "shares from 0 to 1", &shares)?;
            }
            let stool = input.taken(Nodes::tripod(feet, centre))?;
            sound(input, &stool)
        }
        4 | 5 => {
            let corners = [(); 5].map(|()| [input.number::<R>(), input.number()]);
            let (count, divisions) = (input.below(6), input.below(4) as u32);
            let plate = NodeList::<R, 64>::polygon(&corners[..count], divisions);
            let plate = input.taken(plate)?;
            sound(input, &plate)
        }
        6 => memory::<R>(input),
        7 => rules::<R>(input),
        8 | 9 => elastic::<R>(input),
        10 => ellipse::<R>(input),
        _ => pressures(input),
    }
}

/// Nodes in lists and in memory of the caller.
fn memory<R: Real>(input: &mut Input<'_>) -> Verdict {
    let mut list = NodeList::<R, 4>::default();
    let mut room = [Node {
        x: R::ZERO,
        y: R::ZERO,
        weight: R::ZERO,
    }; 3];
    let mut buffer = NodeBuffer::new(&mut room);
    for _ in 0..6 {
        let node = node(input);
        let _ = input.taken(list.push(node));
        let _ = input.taken(buffer.push(node));
    }
    let full = buffer.nodes().len() <= 3 && list.nodes().len() <= 4;
    input.holds(full, "no more than there is room", &[R::ONE])?;
    sound(input, &list)?;
    sound(input, &buffer)?;
    list.clear();
    let none = list.nodes().len() + NodeList::<R, 2>::new().nodes().len();
    input.holds(none == 0, "a list is cleared", &[R::ONE])?;
    let slice = input.taken(NodeSlice::new(buffer.nodes()))?;
    sound(input, &slice)
}

pub fn node<R: Real>(input: &mut Input<'_>) -> Node<R> {
    Node {
        x: input.number(),
        y: input.number(),
        weight: input.size(),
    }
}

fn rules<R: Real>(input: &mut Input<'_>) -> Verdict {
    let radius = input.positive::<R>();
    let rim = NodeList::<R, 16>::ring(radius, input.below(18) as u32);
    if let Ok(rim) = input.taken(rim) {
        sound(input, &rim)?;
    }
    let rule = PolarQuadrature::new(radius, input.below(5) as u32, input.below(8) as u32);
    let rule = input.taken(rule)?;
    let rule = rule.with_rim_exponent(input.number());
    let rule = input.taken(rule)?;
    if input.one_in(8) {
        let standard = input.taken(PolarQuadrature::standard(radius))?;
        let nodes = input.taken(standard.nodes::<512>())?;
        return sound(input, &nodes);
    }
    if let Ok(nodes) = input.taken(rule.nodes::<32>()) {
        sound(input, &nodes)?;
    }
    let tilted = rule.nodes_tilted::<32>(input.number(), input.number());
    if let Ok(nodes) = input.taken(tilted) {
        sound(input, &nodes)?;
    }
    let (a, b) = (input.number::<R>(), input.number::<R>());
    let shaped: Result<NodeList<R, 32>, _> = rule.nodes_shaped(|x: R, y: R| a + b * (x + y));
    let nodes = input.taken(shaped)?;
    sound(input, &nodes)
}

/// Finite positions, weights that are not negative, and a finite sum.
fn sound<R: Real>(input: &mut Input<'_>, patch: &impl NodePatch<R>) -> Verdict {
    for node in patch.nodes() {
        let [x, y, weight] = [node.x, node.y, node.weight];
        let fine = x.is_finite() && y.is_finite() && weight >= R::ZERO && weight.is_finite();
        input.holds(fine, "sound nodes", &[x, y, weight])?;
    }
    let total = patch.total_weight();
    input.holds(
        total >= R::ZERO && total.is_finite(),
        "a finite sum of weights",
        &[total],
    )
}

/// Elastic modulus of two bodies.
fn modulus<R: Real>(input: &mut Input<'_>) -> Result<R, Stop> {
    let [first, second] = [(); 2].map(|()| Elasticity {
        young: input.positive::<R>(),
        poisson: R::HALF * input.unit::<R>(),
    });
    input.taken(effective_modulus(first, second))
}

/// Radii that follow the load, and friction on them.
fn elastic<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (modulus, radius) = (modulus::<R>(input)?, input.positive::<R>());
    match input.below(3) {
        0 => {
            let ball = input.taken(HertzSphere::new(modulus, radius))?;
            loaded(input, ball)
        }
        1 => {
            let ball = AdhesiveSphere::new(modulus, radius, input.positive());
            let ball = input.taken(ball)?;
            input.give([ball.pull_off()]);
            loaded(input, ball)
        }
        _ => {
            let exponent = input.unit::<R>() / R::from_f64(3.0);
            let finger = input.taken(SoftFinger::new(radius, exponent))?;
            loaded(input, finger)
        }
    }
}

fn loaded<R: Real, A: LoadedRadius<R>>(input: &mut Input<'_>, area: A) -> Verdict {
    let (load, motion) = (input.number::<R>(), twist::<R>(input));
    let all = [area.radius(load), area.slope(load), area.growth(load)];
    input.give([all[1], all[2]]);
    if load.is_nan() {
        return input.all_nan("radius under no number", all);
    }
    input.holds(
        all[0] >= R::ZERO && all[1] >= R::ZERO,
        "a patch grows",
        &all,
    )?;
    input.finite("radius", [all[0]])?;
    let friction = LoadedFriction::new(CoulombDisk, input.size::<R>(), area);
    let friction = input.taken(friction)?;
    let (wrench, slope) = (
        friction.wrench(load, &motion),
        friction.slope_by_load(load, &motion),
    );
    input.give(parts(&slope));
    input.give([friction.area().growth(load)]);
    if let Ok(fixed) = input.taken(friction.at(load)) {
        input.give([fixed.radius()]);
    }
    if load < R::ZERO {
        input.give(parts(&wrench));
        return Ok(());
    }
    dissipates(input, &wrench, &motion)
}

fn ellipse<R: Real>(input: &mut Input<'_>) -> Verdict {
    let modulus = modulus::<R>(input)?;
    let [a, b, c, d, angle] = [(); 5].map(|()| input.number::<R>());
    input.give(relative_curvatures([a, b], [c, d], angle));
    let curvatures = [input.positive::<R>(), input.positive()];
    let patch = input.taken(HertzEllipse::new(modulus, curvatures))?;
    let ratio = patch.axes_ratio();
    input.holds(ratio > R::ZERO && ratio <= R::ONE, "0 < b/a ≤ 1", &[ratio])?;
    let load = input.number::<R>();
    let (axes, slopes) = (patch.semi_axes(load), patch.slopes(load));
    input.give(slopes);
    input.give([patch.growth(load)]);
    input.finite("axes", axes)
}

fn pressures(input: &mut Input<'_>) -> Verdict {
    if let Ok(pressure) = PowerPressure::new(input.number()) {
        let (order, square) = (pressure.order(), pressure.mean_square_radius());
        let is_fine = square > 0.0 && square <= 1.0;
        input.holds(is_fine, "0 < mean square radius ≤ 1", &[order, square])?;
    }
    let mixed = PolynomialPressure::new([input.number(), input.number(), input.number()]);
    let mixed = input.taken(mixed)?;
    input.give(*mixed.shares());
    let square = mixed.mean_square_radius();
    let is_fine = (0.0..=1.0 + 1e-12).contains(&square);
    input.holds(is_fine, "mean square radius from 0 to 1", &[square])
}
