//! Bits of bodies on their patches: steps in the plane, feet of many points, nodes in lent memory.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, signed, triples_of_ends, twist, unit};
use nalgebra::Vector3;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::closed::CoulombRing;
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch, NodeSink, NodeSlice};
use tribos_core::planar::{PlanarBody, PlanarStep, PointContacts};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Points of the feet.
const POINTS: usize = 9;
/// Steps of each motion.
const STEPS: usize = 120;

/// Digest of planar steps, f64 and f32.
pub fn holding() -> u64 {
    in_both(held::<f64>, held::<f32>)
}

fn held<R: Real>(hash: &mut Fnv) {
    let [mass, inertia, limit, radius] = [0.5, 0.015625, 0.75, 0.25].map(R::from_f64);
    let body = PlanarBody::new(mass, inertia).expect("positive");
    hash.numbers([body.mass(), body.inertia(), body.gyration()]);
    sliding(
        hash,
        &body,
        &RoundLimitSurface::new(CoulombDisk, limit, radius).expect("in range"),
    );
    sliding(
        hash,
        &body,
        &RoundLimitSurface::new(CoulombRing, limit, radius).expect("in range"),
    );
    standing(hash, &body, limit);
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&PlanarBody::new(x, y));
    }
}

/// A motion to rest under a push that then grows until it moves the body.
fn sliding<R: Real>(hash: &mut Fnv, body: &PlanarBody<R>, set: &impl FrictionSet<R>) {
    let dt = TimeStep::new(R::from_f64(1.0 / 64.0)).expect("positive");
    let mut moving = Twist::new(R::ONE, R::HALF, R::from_f64(7.0));
    for n in 0..STEPS {
        let step = body.step(set, &moving, &growing(n), dt);
        moving = step.twist;
        outcome(hash, &step);
    }
    for [x, y, n] in triples_of_ends(61) {
        let push = Wrench::new(y, R::ZERO, x);
        outcome(hash, &body.step(set, &Twist::new(x, y, n), &push, dt));
    }
}

fn standing<R: Real>(hash: &mut Fnv, body: &PlanarBody<R>, limit: R) {
    let mut rng = Lcg::new(211);
    let mut memory = [Node {
        x: R::ZERO,
        y: R::ZERO,
        weight: R::ZERO,
    }; POINTS];
    let mut points = NodeBuffer::new(&mut memory);
    while points.nodes().len() < POINTS {
        let [x, y] = [(); 2].map(|()| unit::<R>(&mut rng) - R::HALF);
        let weight = unit(&mut rng);
        hash.verdict(&points.push(Node { x, y, weight }));
    }
    hash.verdict(&points.push(Node {
        x: R::ONE,
        y: R::ONE,
        weight: R::ONE,
    }));
    hash.number(points.total_weight());
    let points = NodeSlice::new(points.nodes()).expect("loaded");
    hash.numbers([points.total_weight()]);
    let mut foot: PointContacts<R, _, POINTS> = PointContacts::new(points, limit).expect("it fits");
    let dt = TimeStep::new(R::from_f64(1.0 / 64.0)).expect("positive");
    let mut moving = Twist::new(R::ONE, -R::HALF, R::from_f64(3.0));
    for n in 0..STEPS {
        let step = body.step_on_points(&mut foot, &moving, &growing(n), dt);
        moving = step.twist;
        outcome(hash, &step);
    }
    foot.release();
    for _ in 0..8 {
        let wanted = Wrench::from(Vector3::new(
            signed(&mut rng),
            signed(&mut rng),
            signed(&mut rng),
        ));
        hash.wrench(&foot.nearest(&wanted, R::HALF));
    }
    for given in ends() {
        hash.verdict(&foot.set_force_limit(given));
        hash.numbers([foot.force_limit(), foot.patch().total_weight()]);
        let Twist {
            velocity: force,
            spin: torque,
        } = twist(&mut rng);
        hash.wrench(&foot.nearest(&Wrench { force, torque }, given));
    }
}

/// A push that friction holds for most of the way.
fn growing<R: Real>(n: usize) -> Wrench<R> {
    let size = R::from_f64(n as f64 / 128.0);
    Wrench::new(R::ZERO, size, size * R::from_f64(0.0625))
}

fn outcome<R: Real>(hash: &mut Fnv, step: &PlanarStep<R>) {
    hash.twist(&step.twist);
    hash.wrench(&step.friction);
    hash.feed(u64::from(step.is_at_rest));
}
