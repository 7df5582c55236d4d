//! Bodies thrown at 1 m/s and spun, until they are at rest.

use crate::world::*;
use rapier3d::prelude::*;

const SPINS_RAD_S: [f32; 5] = [0.0, 5.0, 12.5, 25.0, 50.0];
const RATES_HZ: [f32; 2] = [60.0, 240.0];

struct ThrowResult {
    name: &'static str,
    shape: fn() -> ColliderBuilder,
    half_height: f32,
    mu: f32,
}

/// Coefficient of friction of the plates: a deceleration of 3 m/s².
const PLATE_MU: f32 = 3.0 / GRAVITY;

const BODIES: [ThrowResult; 5] = [
    ThrowResult {
        name: "box",
        shape: || ColliderBuilder::cuboid(0.05, 0.005, 0.05),
        half_height: 0.005,
        mu: PLATE_MU,
    },
    ThrowResult {
        name: "plank",
        shape: || ColliderBuilder::cuboid(0.1, 0.005, 0.025),
        half_height: 0.005,
        mu: PLATE_MU,
    },
    ThrowResult {
        name: "triangle",
        shape: triangle,
        half_height: 0.005,
        mu: PLATE_MU,
    },
    ThrowResult {
        name: "puck",
        shape: || ColliderBuilder::cylinder(0.01, 0.08),
        half_height: 0.01,
        mu: 0.3,
    },
    ThrowResult {
        name: "tall",
        shape: || ColliderBuilder::cylinder(0.08, 0.08),
        half_height: 0.08,
        mu: 0.2,
    },
];

/// A triangular prism about its centroid, with a corner ahead.
fn triangle() -> ColliderBuilder {
    let corner = |k: usize| {
        let angle = std::f32::consts::TAU / 3.0 * (k % 3) as f32;
        let y = if k < 3 { -0.005 } else { 0.005 };
        Vector::new(0.08 * angle.cos(), y, -0.08 * angle.sin())
    };
    ColliderBuilder::convex_hull(&[0, 1, 2, 3, 4, 5].map(corner)).expect("a prism")
}

fn print_throw(model: FrictionModel, thrown: &ThrowResult, rate_hz: f32, spin_rad_s: f32) {
    let mut world = new_world(model, rate_hz, 0.0, thrown.mu);
    let at = Vector::new(0.0, thrown.half_height, 0.0);
    let body = add_body(&mut world, (thrown.shape)(), at, 0.0, thrown.mu);
    step_for(&mut world, 1.0);
    let start = world.bodies[body].translation();
    throw(&mut world, body, Vector::X, spin_rad_s);
    let (mut turn, mut last) = (0.0, heading(&world, body));
    for _ in 0..(4.0 * rate_hz) as usize {
        world.step();
        let now = heading(&world, body);
        turn += within_half_turn(now - last);
        last = now;
    }
    let way = world.bodies[body].translation() - start;
    let (name, left) = (thrown.name, -way.z);
    println!("{name},{rate_hz},{spin_rad_s},{:.6},{left:.6},{turn:.5}", way.x);
}

pub fn print(model: FrictionModel) {
    println!("body,rate_hz,spin_rad_s,travel_m,left_m,turn_rad");
    for thrown in &BODIES {
        for rate_hz in RATES_HZ {
            for spin_rad_s in SPINS_RAD_S {
                print_throw(model, thrown, rate_hz, spin_rad_s);
            }
        }
    }
}
