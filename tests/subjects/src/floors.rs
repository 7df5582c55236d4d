//! Patches cut along borders, two coefficients, feet on surfaces that move.

use super::planes::{dissipates, parts, rates, twist, wrench};
use super::polygons::{borne, near, placed, rubs};
use crate::{Input, Verdict};
use nalgebra::Vector2;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::floor::{Feet, Foot, SteadyState};
use tribos_core::patch::affine_image::{AffineImage, AffineMap, image_of};
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::mesh::{Mesh, Vertex};
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::patch::piece::HalfPlane;
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::round::RoundPatch;
use tribos_core::planar::PlanarBody;
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Room for the edges of a quadrangle's pieces.
const ROOM: usize = 8;

/// Rounding errors of a twist that count in the friction next to the motion of a surface.
const ROUGH_ULPS: f64 = 1024.0;
/// Ratio of coefficients up to which a stretched quadrangle keeps the promises of compact patches.
const MOST_STRETCHED: f64 = 4.0;

type Quadrangle<R> = Polygon<R, [Edge<R>; ROOM]>;

pub fn floors<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(7) {
        0 => pieces::<R>(input),
        1 => directions::<R>(input),
        2 => round::<R>(input),
        3 => blades::<R>(input),
        4 => images::<R>(input),
        _ => feet::<R>(input),
    }
}

/// A quadrangle of ordinary size near a place, whose corners lie in the four quadrants about its middle.
fn quadrangle<R: Real>(input: &mut Input<'_>, size: R) -> Verdict<Quadrangle<R>> {
    let [x, y] = near(input, size);
    let corners = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(|[along, across]| {
        let far = size * R::from_f64(0.25 + input.unit::<f64>());
        [x + far * R::from_f64(along), y + far * R::from_f64(across)]
    });
    input.taken(Polygon::with_holes(&[&corners], [Edge::default(); ROOM]))
}

/// Both pieces of a patch share its load and its friction.
fn pieces<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let patch = quadrangle(input, size)?;
    let sides = patch.edge_count();
    input.holds(sides == 4, "four edges", &[size])?;
    let direction = [(); 2].map(|()| input.number::<R>());
    let side = HalfPlane::new(near(input, size), direction);
    let side = input.taken(side)?;
    let motion = twist::<R>(input);
    let whole = input.taken(ShapeFriction::new(patch, R::ONE))?;
    let (mut share, mut force) = (R::ZERO, Vector2::new(R::ZERO, R::ZERO));
    for side in [side, side.other_side()] {
        let piece = input.taken(patch.within(&side, [Edge::default(); ROOM]))?;
        let Some(piece) = piece else { continue };
        placed(input, &piece.patch.centre(), piece.patch.radius())?;
        share += piece.share;
        let friction = input.taken(ShapeFriction::new(piece.patch, R::ONE))?;
        force += friction.wrench(piece.share, &motion).force;
    }
    input.accurate("shares of pieces", (share - R::ONE).abs(), R::ZERO, R::ONE)?;
    let at = [near(input, size), near(input, size)];
    let (sides, met) = (at.map(|place| side.contains(place)), side.crossing(at));
    let is_crossed = sides[0] != sides[1];
    input.holds(met.is_some() == is_crossed, "a border is crossed", &[share])?;
    let whole = whole.wrench(R::ONE, &motion).force;
    input.give([force.x, force.y, whole.x, whole.y]);
    if input.is_mild() {
        let apart = (force.x - whole.x).abs() + (force.y - whole.y).abs();
        // Slivers have their own place to the rounding of the whole.
        input.at_most("friction of pieces", apart, R::EPSILON.sqrt(), R::ZERO)?;
    }
    Ok(())
}

/// Friction that differs along two axes.
fn directions<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let patch = quadrangle(input, size)?;
    let (mu, axis) = (
        [input.size(), input.size()],
        [input.number(), input.number()],
    );
    let coefficients = input.taken(AxisCoefficients::new(mu, axis))?;
    let largest = coefficients.largest();
    input.give(coefficients.mu());
    input.holds(largest >= mu[0] && largest >= mu[1], "the larger one", &mu)?;
    let made = input.taken(AnisotropicPatch::new(patch, coefficients))?;
    placed(input, &PatchShape::centre(&made), PatchShape::radius(&made))?;
    let least = if mu[0] < mu[1] { mu[0] } else { mu[1] };
    if !input.is_mild() || least * R::from_f64(MOST_STRETCHED) < largest {
        return Ok(());
    }
    let side = HalfPlane::new(near(input, size), [R::ONE, R::ZERO]);
    let side = made.stretched_side(&input.taken(side)?);
    let piece = input.taken(made.stretched().within(&side, [Edge::default(); ROOM]))?;
    if let Some(piece) = piece {
        let part = made.with_stretched(piece.patch);
        placed(input, &PatchShape::centre(&part), PatchShape::radius(&part))?;
    }
    let turn = AffineMap::placed([R::ZERO, R::ONE], near(input, size));
    let moved = input.present("the patch elsewhere", made.placed(&turn))?;
    borne(input, &moved)
}

/// A bar under linear pressure: an end, a piece.
fn blades<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let bar = Bar::new(near(input, size), near(input, size));
    let bar = input.taken(bar)?;
    let slope = R::from_f64(input.unit::<f64>()) / bar.radius();
    let bar = input.taken(bar.with_slope(slope))?;
    input.give(bar.ends().into_iter().flatten());
    let side = HalfPlane::new(near(input, size), [R::ONE, R::ZERO]);
    let side = input.taken(side)?;
    let at = near(input, size);
    input.give([side.distance_of(at)]);
    let mut share = R::ZERO;
    for side in [side, side.other_side()] {
        if let Some(piece) = bar.within(&side) {
            share += piece.share;
            placed(input, &piece.patch.centre(), piece.patch.radius())?;
        }
    }
    input.accurate("shares of pieces", (share - R::ONE).abs(), R::ZERO, R::ONE)
}

/// Patches of all kinds, turned and moved.
fn images<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let map = AffineMap::placed([R::ZERO, R::ONE], near(input, size));
    let ends = [near(input, size), near(input, size), near(input, size)];
    match input.below(4) {
        0 => {
            let bar = input.taken(Bar::new(ends[0], ends[1]))?;
            let image = input.present("a bar elsewhere", bar.image(&map))?;
            placed(input, &image.centre(), image.radius())
        }
        1 => {
            let axes = [input.positive(), input.positive()];
            let ellipse = input.taken(Ellipse::new(ends[0], axes, EllipsePressure::Hertz))?;
            let image = input.present("an ellipse elsewhere", ellipse.image(&map))?;
            placed(input, &image.centre(), image.radius())
        }
        2 => {
            let vertex = |[x, y]: [R; 2]| Vertex {
                x,
                y,
                pressure: R::ONE,
            };
            let mesh = input.taken(Mesh::new([ends.map(vertex)]))?;
            for corner in mesh.corners().flatten() {
                input.give([corner.x, corner.y, corner.pressure]);
            }
            let image = input.present("a mesh elsewhere", mesh.image(&map))?;
            placed(input, &image.centre(), image.radius())
        }
        _ => {
            let node = |[x, y]: [R; 2]| Node {
                x,
                y,
                weight: R::ONE,
            };
            let moved = image_of(&map, &node(ends[0]));
            input.give([moved.x, moved.y, moved.weight]);
            let nodes = input.taken(Nodes::new(ends.map(node)))?;
            let points = input.taken(PointPatch::new(nodes))?;
            let same = points.moved(&map, |nodes| nodes);
            input.give([same.radius()]);
            let image = input.present("points elsewhere", points.image(&map))?;
            placed(input, &image.centre(), image.radius())
        }
    }
}

/// A disk in a place of its own.
fn round<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let patch = RoundPatch::new(CoulombDisk, near(input, size), input.positive());
    let patch = input.taken(patch)?;
    input.give([PatchShape::rounding(&patch)]);
    let point = PatchShape::nearest_point(&patch, &Vector2::new(size, size));
    input.holds(point.is_none(), "a patch without points", &[size])?;
    let is_its_own = *patch.coupling() == CoulombDisk;
    input.holds(is_its_own, "its coupling", &[patch.radius()])?;
    placed(input, &patch.centre(), patch.radius())?;
    rubs(input, &patch)
}

/// A body on three feet.
fn feet<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let mut all = [None; 3];
    for foot in &mut all {
        *foot = Some(Foot {
            patch: quadrangle(input, size)?,
            limit: input.size(),
            surface: if input.one_in(3) {
                Twist::ZERO
            } else {
                twist(input)
            },
        });
    }
    let [Some(first), Some(second), Some(third)] = all else {
        return Ok(());
    };
    let all = [first, second, third];
    let feet = input.taken(Feet::new(&all))?;
    input.holds(feet.feet().len() == 3, "three feet", &[size])?;
    let motion = twist::<R>(input);
    let (met, jacobian) = feet.wrench_and_jacobian(&motion);
    let same = feet.wrench(&motion);
    input.give(parts(&met).into_iter().chain(jacobian.iter().copied()));
    input.give(parts(&same));
    if all.iter().all(|foot| foot.surface == Twist::ZERO) {
        dissipates(input, &met, &motion)?;
    }
    if !input.is_mild() {
        return Ok(());
    }
    input.finite("friction of feet", parts(&met))?;
    let push = wrench::<R>(input);
    let limit = all.iter().fold(R::ZERO, |sum, foot| sum + foot.limit);
    match feet.steady_motion(&push) {
        SteadyState::Balanced(found) => {
            input.finite("a steady motion", rates(&found.twist))?;
            let rest = found.friction.force + push.force;
            let left = rest.x.hypot(rest.y);
            // Next to the motion of a surface the sliding over it is lost in rounding.
            let extent = |twist: &Twist<R>| twist.speed() + twist.spin.abs() * size;
            let mut lost = R::TWO * R::EPSILON.sqrt();
            let slides = |foot: &&Foot<R, _>| foot.limit > R::ZERO && foot.surface != found.twist;
            for foot in all.iter().filter(slides) {
                let sizes = extent(&found.twist) + extent(&foot.surface);
                let apart = extent(&(found.twist - foot.surface));
                lost += R::from_f64(ROUGH_ULPS) * R::EPSILON * sizes / apart;
            }
            input.at_most("a balance", left, limit * lost, R::ZERO)?;
        }
        SteadyState::Accelerates => {}
        SteadyState::Missed(found) => input.finite("a motion", rates(&found.twist))?,
    }
    let body = PlanarBody::new(input.positive(), input.positive());
    let (body, dt) = (input.taken(body)?, TimeStep::new(input.positive()));
    let dt = input.taken(dt)?;
    let step = feet.step(&body, &motion, &push, dt);
    input.finite("a step on feet", rates(&step.twist))?;
    input.finite("its friction", parts(&step.friction))?;
    input.give([step.imbalance]);
    Ok(())
}
