//! Patches cut along borders, two coefficients, feet on surfaces that move.

use super::planes::{dissipates, parts, rates, twist, wrench};
use super::polygons::{borne, near, placed, rubs};
use crate::{Input, Verdict};
use nalgebra::Vector2;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::floor::{Feet, Foot, SteadyState};
use tribos_core::patch::affine_image::AffineMap;
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::patch::piece::HalfPlane;
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
    match input.below(5) {
        0 => pieces::<R>(input),
        1 => directions::<R>(input),
        2 => round::<R>(input),
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
    input.holds(largest >= mu[0] && largest >= mu[1], "the larger one", &mu)?;
    let made = input.taken(AnisotropicPatch::new(patch, coefficients))?;
    placed(input, &PatchShape::centre(&made), PatchShape::radius(&made))?;
    let least = if mu[0] < mu[1] { mu[0] } else { mu[1] };
    if !input.is_mild() || least * R::from_f64(MOST_STRETCHED) < largest {
        return Ok(());
    }
    let turn = AffineMap::placed([R::ZERO, R::ONE], near(input, size));
    let moved = input.present("the patch elsewhere", made.placed(&turn))?;
    borne(input, &moved)
}

/// A disk in a place of its own.
fn round<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let patch = RoundPatch::new(CoulombDisk, near(input, size), input.positive());
    let patch = input.taken(patch)?;
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
