//! Bits of presliding: patches and points on elastic bonds, bodies on them, sets that change.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, triples_of_ends, twist, unit};
use tribos_core::contact::TimeStep;
use tribos_core::coupling::closed::CoulombRing;
use tribos_core::holding::StictionBounds;
use tribos_core::law::StickSlip;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface, ScaledSet};
use tribos_core::patch::nodes::{Node, NodePatch, Nodes};
use tribos_core::planar::{ElasticState, PlanarBody};
use tribos_core::presliding::{
    Anchor, MicroslipPresliding, PointPresliding, Pose, Presliding, PreslidingStep, Settled,
};
use tribos_core::real::Real;
use tribos_core::twist::{Displacement, Wrench};

/// Steps of each path.
const STEPS: usize = 100;
/// Points of the foot.
const POINTS: usize = 3;

/// Digest of presliding, f64 and f32.
pub fn presliding() -> u64 {
    in_both(all::<f64>, all::<f32>)
}

fn all<R: Real>(hash: &mut Fnv) {
    let [force, radius, torque] = [0.75, 0.25, 0.625].map(R::from_f64);
    let ring = RoundLimitSurface::new(CoulombRing, force, radius).expect("in range");
    let usual = LimitEllipsoid::new(force, radius, torque).expect("in range");
    let bonds = Presliding::new(R::from_f64(64.0), R::from_f64(3.0)).expect("positive");
    paths(hash, &ring, &bonds);
    paths(hash, &usual, &bonds);
    vibrations(hash, &ring, &bonds);
    scaled(hash, &usual);
    points::<R>(hash);
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&Presliding::new(x, y));
        hash.verdict(&bonds.with_damping(x, y));
        hash.verdict(&MicroslipPresliding::new(bonds, x, y));
    }
}

/// Paths from patches at rest to ones that slip, with both laws and in both forms.
fn paths<R: Real>(hash: &mut Fnv, set: &impl FrictionSet<R>, bonds: &Presliding<R>) {
    let mut rng = Lcg::new(307);
    let gradual = MicroslipPresliding::new(*bonds, R::from_f64(0.25), R::TWO).expect("in range");
    hash.numbers([gradual.breakaway(), gradual.exponent()]);
    hash.number(gradual.bonds().stiffness());
    let mut pose = Pose::new(R::ONE, -R::ONE, R::HALF);
    let (mut sharp, mut soft, mut strain) =
        (Anchor::at(pose), Anchor::at(pose), Displacement::ZERO);
    for _ in 0..STEPS {
        let by = Displacement::along(&twist(&mut rng), R::from_f64(1.0 / 4096.0));
        let next = pose.moved(&by);
        let step = bonds.step(set, &sharp, &next);
        stepped(hash, &step);
        hash.numbers([bonds.stored_energy(&sharp, &next), by.work(&step.friction)]);
        sharp = step.anchor;
        let step = gradual.step(set, &soft, [&pose, &next]);
        stepped(hash, &step);
        soft = step.anchor;
        let end = bonds.advance(set, &strain, &by);
        settled(hash, &end);
        settled(hash, &gradual.advance(set, &strain, &by));
        strain = end.strain;
        displaced(
            hash,
            &Anchor::with_deflection(&next, &strain).deflection(&pose),
        );
        pose = next;
    }
    for [x, y, turn] in triples_of_ends(61) {
        stepped(hash, &bonds.step(set, &sharp, &Pose::new(x, y, turn)));
        let by = Displacement::new(y, turn, x);
        settled(hash, &gradual.advance(set, &strain, &by));
    }
}

/// A body that is set down, pushed until it slides, and let go.
fn vibrations<R: Real>(hash: &mut Fnv, set: &impl FrictionSet<R>, bonds: &Presliding<R>) {
    let body = PlanarBody::new(R::HALF, R::from_f64(0.015_625)).expect("positive");
    let dt = TimeStep::new(R::from_f64(1.0 / 64.0)).expect("positive");
    let damped = bonds
        .with_damping(R::HALF, R::from_f64(0.015_625))
        .expect("positive");
    hash.numbers(damped.damping());
    hash.numbers([damped.stiffness(), damped.torsional_stiffness()]);
    let start = ElasticState::at_rest(Pose::new(R::ONE, R::HALF, R::ONE));
    let mut state = start;
    for n in 0..2 * STEPS {
        let size = if n < STEPS { n as f64 / 64.0 } else { 0.0 };
        let push = Wrench::new(R::ZERO, R::from_f64(size), R::from_f64(size * 0.0625));
        let step = body.step_elastic(&damped, set, &state, &push, dt);
        state = step.state;
        hash.twist(&state.twist);
        hash.wrench(&step.friction);
        displaced(hash, &step.slip);
        displaced(hash, &state.pose.since(&start.pose));
        displaced(hash, &state.anchor.pose.since(&start.pose));
        hash.numbers([step.slip_heat, step.damping_heat, step.rule_loss]);
        hash.number(step.lost_energy());
        displaced(hash, &bonds.strain_under(&push));
    }
    for [x, y, n] in triples_of_ends(61) {
        let push = Wrench::new(x, n, y);
        let state = body.step_elastic(&damped, set, &start, &push, dt).state;
        hash.twist(&state.twist);
    }
}

/// A set of changing strength, and what is said about pushes.
fn scaled<R: Real>(hash: &mut Fnv, set: &LimitEllipsoid<R>) {
    let mut rng = Lcg::new(311);
    for strength in ends::<R>() {
        hash.verdict(&ScaledSet::new(set, strength));
    }
    let weaker = ScaledSet::new(set, R::from_f64(0.375)).expect("positive");
    hash.numbers([weaker.strength(), weaker.force_limit(), weaker.radius()]);
    for _ in 0..STEPS {
        let motion = twist(&mut rng);
        let push = Wrench {
            force: motion.velocity,
            torque: motion.spin,
        };
        hash.numbers([weaker.support(&motion), weaker.gauge(&push)]);
        hash.wrench(&weaker.wrench(&motion));
        hash.twist(&weaker.twist_normal_to(&push));
        hash.twist(&weaker.twist_resisted_by(&push));
        hash.wrench(&weaker.scale_to_surface(&push));
        hash.wrench(&weaker.project(&push).wrench);
        let answer = StictionBounds::of(&weaker, set, &push);
        hash.feed(answer.stiction as u64);
        hash.numbers([answer.certain_scale(), answer.possible_scale()]);
    }
}

/// Points that let go one after the other.
fn points<R: Real>(hash: &mut Fnv) {
    let mut rng = Lcg::new(313);
    let place = [[0.25, 0.0], [-0.125, 0.25], [0.0, -0.5]].map(|at| at.map(R::from_f64));
    let nodes = Nodes::new(place.map(|[x, y]| Node {
        x,
        y,
        weight: x + R::ONE,
    }))
    .expect("loaded");
    let [stiffness, limit] = [64.0, 0.75].map(R::from_f64);
    let mut pose = Pose::new(R::ONE, R::ZERO, R::HALF);
    let bound: Result<PointPresliding<R, _, POINTS>, _> =
        PointPresliding::new(nodes, stiffness, limit, &pose);
    let mut bound = bound.expect("it fits");
    hash.numbers([
        bound.force_limit() / bound.stiffness(),
        bound.patch().total_weight(),
    ]);
    for _ in 0..STEPS {
        let step = Displacement::along(&twist(&mut rng), R::from_f64(1.0 / 4096.0));
        pose = pose.moved(&step);
        let step = bound.step(&pose);
        hash.wrench(&step.friction);
        hash.numbers([step.dissipated, bound.stored_energy(&pose)]);
        hash.feed(step.slipping as u64);
    }
    bound.anchor_at(&pose);
    for given in ends() {
        hash.verdict(&bound.set_force_limit(given));
        let away = Displacement::new(given, unit(&mut rng), R::ZERO);
        hash.wrench(&bound.step(&pose.moved(&away)).friction);
    }
}

fn displaced<R: Real>(hash: &mut Fnv, by: &Displacement<R>) {
    hash.numbers([by.shift.x, by.shift.y, by.turn]);
}

fn stepped<R: Real>(hash: &mut Fnv, step: &PreslidingStep<R>) {
    displaced(
        hash,
        &step
            .anchor
            .pose
            .since(&Pose::new(R::ZERO, R::ZERO, R::ZERO)),
    );
    displaced(hash, &step.slip);
    hash.wrench(&step.friction);
    hash.number(step.dissipated);
    hash.feed(u64::from(step.grip == StickSlip::Stick));
}

fn settled<R: Real>(hash: &mut Fnv, end: &Settled<R>) {
    displaced(hash, &end.strain);
    displaced(hash, &end.slip);
    hash.wrench(&end.friction);
    hash.number(end.dissipated);
    hash.feed(u64::from(end.grip == StickSlip::Stick));
}
