//! Presliding in large numbers: random paths, a long hold, a creeping law beside one that holds.
//!
//! `cargo run --release -p tribos-tests --example presliding [PATHS] [STEPS]`; prints the worst it saw,
//! by default of 10⁶ paths and 10⁸ steps.

use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::planar::{ElasticState, PlanarBody};
use tribos_core::presliding::{Anchor, MicroslipPresliding, Pose, Presliding};
use tribos_core::twist::{Displacement, Twist, Wrench};
use tribos_tests::sweep::Lcg;

const LIMIT: f64 = 5.0;
const RADIUS: f64 = 0.05;
const STIFFNESS: f64 = 1e4;
const REACH: f64 = LIMIT / STIFFNESS;
/// Steps of a path.
const LENGTH: u32 = 10;

fn main() {
    let mut given = std::env::args()
        .skip(1)
        .filter_map(|text| text.parse().ok());
    let (paths, steps) = (
        given.next().unwrap_or(1_000_000),
        given.next().unwrap_or(100_000_000),
    );
    let set = RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect("in range");
    let bonds = Presliding::new(STIFFNESS, 0.5 * STIFFNESS * RADIUS * RADIUS).expect("positive");
    random_paths(&set, &bonds, paths);
    long_hold(&set, &bonds, steps);
    creep(&set, &bonds);
}

/// Least heat, and the worst energy balance, of random paths.
fn random_paths(set: &RoundLimitSurface<f64, CoulombDisk>, bonds: &Presliding<f64>, paths: u64) {
    let mut rng = Lcg::new(1);
    let (mut least, mut worst, mut outside) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    for _ in 0..paths {
        let mut pose = Pose::new(rng.unit(), rng.unit(), 6.0 * rng.unit());
        let (mut anchor, size) = (Anchor::at(pose), REACH * rng.log_between(0.05, 20.0));
        for _ in 0..LENGTH {
            let mut part = || size * (2.0 * rng.unit() - 1.0);
            let moved = Displacement::new(part(), part(), part() / RADIUS);
            let next = pose.moved(&moved);
            let step = bonds.step(set, &anchor, &next);
            let change = step.anchor.deflection(&next) - anchor.deflection(&pose);
            let numerical = 0.5
                * change.work(&Wrench {
                    force: change.shift * bonds.stiffness(),
                    torque: change.turn * bonds.torsional_stiffness(),
                });
            let stored =
                bonds.stored_energy(&step.anchor, &next) - bonds.stored_energy(&anchor, &pose);
            let work = -next.since(&pose).work(&step.friction);
            let off =
                (work - stored - step.dissipated - numerical).abs() / (LIMIT * (size + REACH));
            (least, worst) = (least.min(step.dissipated), worst.max(off));
            outside = outside.max(set.gauge(&step.friction) - 1.0);
            (pose, anchor) = (next, step.anchor);
        }
    }
    println!(
        "{paths} paths of {LENGTH} steps: least heat {least:e} J, energy off by {worst:.1e} of the scale,"
    );
    println!("    gauge above 1 by {outside:.1e}");
}

/// A body under a push of 95 % of the limit for many steps.
fn long_hold(set: &RoundLimitSurface<f64, CoulombDisk>, bonds: &Presliding<f64>, steps: u64) {
    let body = PlanarBody::new(0.8, 7e-4).expect("positive");
    let dt = TimeStep::new(1e-3).expect("positive");
    let push = set.scale_to_surface(&Wrench::new(1.0, 0.5, 0.03)) * 0.95;
    let damped = bonds.with_damping(60.0, 0.05).expect("in range");
    let mut state = ElasticState::at_rest(Pose::new(0.7, -0.3, 1.0));
    for _ in 0..5000 {
        state = body.step_elastic(&damped, set, &state, &push, dt).state;
    }
    let frozen = state;
    let mut changed = 0_u64;
    for _ in 0..steps {
        let next = body.step_elastic(&damped, set, &state, &push, dt).state;
        changed += u64::from(next != state);
        state = next;
    }
    let drift = state.pose.since(&frozen.pose);
    println!("{steps} steps under 95 % of the limit: {changed} changed any bit, drift {drift:?}");
    assert_eq!(state.twist, Twist::ZERO);
}

/// Drift of a body that is pushed with half of the limit and shaken by ±10 % of it, in 60 s.
fn creep(set: &RoundLimitSurface<f64, CoulombDisk>, bonds: &Presliding<f64>) {
    let body = PlanarBody::new(0.8, 7e-4).expect("positive");
    let (dt, mass) = (1e-4, body.mass());
    for breakaway in [0.0, 0.7] {
        let law = MicroslipPresliding::new(*bonds, breakaway, 1.0).expect("in range");
        let mut pose = Pose::new(0.0, 0.0, 0.0);
        let (mut anchor, mut speed, mut after_one) = (Anchor::at(pose), 0.0, 0.0);
        for n in 0..=600_000_u32 {
            let phase = std::f64::consts::TAU * 50.0 * f64::from(n) * dt;
            let push = LIMIT * (0.5 * (f64::from(n) * dt).min(1.0) + 0.1 * phase.sin());
            // Explicit, with the damping of a calm support.
            let next = pose.moved(&Displacement::new(speed * dt, 0.0, 0.0));
            let step = law.step(set, &anchor, [&pose, &next]);
            speed += dt / mass * (push + step.friction.force.x - 60.0 * speed);
            (pose, anchor) = (next, step.anchor);
            if n == 100_000 {
                after_one = pose.position.x;
            }
        }
        let drift = pose.position.x - after_one;
        println!(
            "break-away share {breakaway}: {:.3e} m in 50 s of vibration",
            drift
        );
    }
}
