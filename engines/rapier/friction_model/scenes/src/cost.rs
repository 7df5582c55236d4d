//! Time of a step.

use crate::world::*;
use rapier3d::prelude::*;
use std::time::Instant;

const RATE_HZ: f32 = 60.0;

fn unit_box() -> ColliderBuilder {
    ColliderBuilder::cuboid(0.5, 0.5, 0.5)
}

/// Eight layers of 5 by 5 cubes, each shifted against the one below it.
pub fn pile(model: FrictionModel) -> PhysicsWorld {
    const MU: f32 = 0.5;
    let mut world = new_world(model, RATE_HZ, 0.0, MU);
    for i in 0..200 {
        let (layer, column, row) = (i / 25, (i % 5) as f32, (i % 25 / 5) as f32);
        let x = 1.1 * column - 2.2 + 0.1 * (layer % 3) as f32;
        let z = 1.1 * row - 2.2 + 0.07 * (layer % 2) as f32;
        let at = Vector::new(x, 0.6 + 1.15 * layer as f32, z);
        add_body(&mut world, unit_box(), at, 0.0, MU);
    }
    world
}

/// 196 cubes apart from each other: at rest, or all sliding and spinning.
fn field(model: FrictionModel, speed: f32) -> PhysicsWorld {
    const MU: f32 = 0.05;
    let mut world = new_world(model, RATE_HZ, 0.0, MU);
    let cubes: Vec<_> = (0..196)
        .map(|i| {
            let (x, z) = (6.0 * (i % 14) as f32 - 39.0, 6.0 * (i / 14) as f32 - 39.0);
            add_body(&mut world, unit_box(), Vector::new(x, 0.5, z), 0.0, MU)
        })
        .collect();
    step_for(&mut world, 0.5);
    for (i, cube) in cubes.into_iter().enumerate() {
        let (sine, cosine) = (i as f32).sin_cos();
        let velocity = Vector::new(speed * cosine, 0.0, speed * sine);
        if speed > 0.0 {
            throw(&mut world, cube, velocity, 3.0 + 0.01 * i as f32);
        }
    }
    world
}

/// Microseconds of the fastest step of so many.
fn fastest(world: &mut PhysicsWorld, steps: usize) -> f64 {
    let time = |_| {
        let start = Instant::now();
        world.step();
        1e6 * start.elapsed().as_secs_f64()
    };
    (0..steps).map(time).fold(f64::INFINITY, f64::min)
}

/// Rounds of both models in turn.
pub fn print(before: FrictionModel, after: FrictionModel) {
    const ROUNDS: usize = 9;
    type Scene = (&'static str, fn(FrictionModel) -> PhysicsWorld, f32, usize);
    let scenes: [Scene; 3] = [
        ("sliding", |model| field(model, 1.8), 0.0, 60),
        ("rest", |model| field(model, 0.0), 0.0, 60),
        ("pile", pile, 2.0, 60),
    ];
    println!("scene,before,after");
    for _ in 0..ROUNDS {
        for (name, world, seconds, steps) in scenes {
            let [before, after] = [before, after].map(|model| {
                let mut world = world(model);
                step_for(&mut world, seconds);
                fastest(&mut world, steps)
            });
            println!("{name},{before:.2},{after:.2}");
        }
    }
}
