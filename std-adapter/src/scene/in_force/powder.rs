//! A powder's scene as its fields are.

use super::InForce;
use crate::cd::{Method, Order, Solver, Stop};
use crate::powder::deposit::Until;
use crate::record::json_number;
use crate::scene::PowderScene;
use crate::scene::powder::ORDER_SEED;
use crate::scene::powder_keys::*;
use serde_json::Value;

impl PowderScene {
    /// The scene with everything that was left to defaults, as JSON: what its fields say.
    pub fn json(&self) -> Value {
        let mut put = InForce::from_read(&self.values);
        deposit(&mut put, self);
        for (key, mu) in [SLIDING, ROLLING, TORSION].into_iter().zip(self.friction) {
            put.number(key, mu);
        }
        put.word(COUPLING, self.coupling as usize);
        put.number(PRESSURE, self.pressure);
        put.number(RANGE, self.cohesion_range);
        put.word(ATTRACTION, self.attraction as usize);
        put.number(RESTITUTION, self.restitution);
        put.word(WALL, self.wall as usize);
        put.number(MASS, self.piston_mass);
        solver(&mut put, &self.solver);
        put.number(MOTION, self.pace.motion);
        put.number(TIME_STEP, self.pace.longest);
        put.number(STILL, self.still_speed);
        put.word(BLOCKED, self.blocked as usize);
        put.count(STEPS, self.steps);
        put.optional(DURATION, self.duration);
        put.count(SAMPLES, self.samples);
        put.json()
    }
}

/// How the deposit grows, and where it ends.
fn deposit(put: &mut InForce, scene: &PowderScene) {
    let ballistic = &scene.ballistic;
    put.number(WIDTH, scene.width);
    put.number(CAPTURE, ballistic.capture_radius());
    put.count(SEED, scene.seed);
    let spread = put.value(SPREAD).unwrap_or(0.0);
    if ballistic.radii() != [1.0 - spread, 1.0 + spread] {
        put.optional(SPREAD, None);
        put.beside("radii", ballistic.radii().map(json_number).to_vec().into());
    }
    if ballistic.width() != scene.width {
        put.beside("deposit_width", json_number(ballistic.width()));
    }
    let (cut, count) = match scene.until {
        Until::Cut(height) => (Some(height), None),
        Until::Count(count) => (None, Some(count as u64)),
        Until::Height(height) => {
            put.beside("highest_point", json_number(height));
            (None, None)
        }
    };
    put.optional(HEIGHT, cut);
    match count {
        Some(count) => put.count(COUNT, count),
        None => put.optional(COUNT, None),
    }
}

/// The method and its rules; those of the other method stay as they were read.
fn solver(put: &mut InForce, solver: &Solver) {
    match solver.method {
        Method::Accelerated { tolerance } => {
            put.word(SOLVER, 0);
            put.number(TOLERANCE, tolerance);
        }
        Method::GaussSeidel { order, stop } => {
            put.word(SOLVER, 1);
            let order = match order {
                Order::Alternating => 0,
                Order::Fixed => 1,
                Order::Random { seed } => {
                    if seed != ORDER_SEED {
                        put.beside("order_seed", seed.into());
                    }
                    2
                }
            };
            put.word(ORDER, order);
            let (stop, tolerance) = match stop {
                Stop::Global(tolerance) => (0, Some(tolerance)),
                Stop::Local(tolerance) => (1, Some(tolerance)),
                Stop::Fixed => (2, None),
            };
            put.word(STOP, stop);
            if let Some(tolerance) = tolerance {
                put.number(TOLERANCE, tolerance);
            }
        }
    }
    put.count(SWEEPS, solver.most_sweeps as u64);
    put.word(WARM_START, usize::from(!solver.warm_start));
}
