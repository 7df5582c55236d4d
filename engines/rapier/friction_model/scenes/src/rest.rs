//! What should stay at rest, or begin to slide.

use crate::world::*;
use rapier3d::prelude::*;

const RATE_HZ: f32 = 60.0;

/// Cube on a slope whose tangent is this multiple of the coefficient, after one second, for four more. It stands askew.
fn print_slope(model: FrictionModel, ratio: f32) {
    const MU: f32 = 0.5;
    const HALF: f32 = 0.1;
    let mut world = new_world(model, RATE_HZ, ratio * MU, MU);
    let shape = ColliderBuilder::cuboid(HALF, HALF, HALF);
    let cube = add_body(&mut world, shape, Vector::new(0.0, HALF, 0.0), 0.1, MU);
    step_for(&mut world, 1.0);
    let (start, before) = (world.bodies[cube].translation(), heading(&world, cube));
    step_for(&mut world, 4.0);
    let way = world.bodies[cube].translation() - start;
    println!("slope {ratio},travel_m,{:.6e}", way.x);
    println!("slope {ratio},left_m,{:.6e}", -way.z);
    println!("slope {ratio},yaw_rad,{:.6e}", heading(&world, cube) - before);
}

/// Ten cubes on each other, after one second, for ten more: each turned against the one below it, and shifted.
fn print_stack(model: FrictionModel, name: &str, turn_rad: f32, shift_m: f32) {
    const MU: f32 = 0.6;
    let mut world = new_world(model, RATE_HZ, 0.0, MU);
    let cubes: Vec<_> = (0..10)
        .map(|i| {
            let (x, z) = (2 * (i % 2), 3 * (i % 3));
            let at = Vector::new(shift_m * x as f32, 0.5 + i as f32, shift_m * z as f32);
            let shape = ColliderBuilder::cuboid(0.5, 0.5, 0.5);
            add_body(&mut world, shape, at, turn_rad * i as f32, MU)
        })
        .collect();
    step_for(&mut world, 1.0);
    let starts: Vec<_> = cubes
        .iter()
        .map(|&cube| (world.bodies[cube].translation(), heading(&world, cube)))
        .collect();
    step_for(&mut world, 10.0);
    let (mut drift, mut yaw, mut top) = (0.0_f32, 0.0_f32, 0.0);
    for (&cube, (start, before)) in cubes.iter().zip(starts) {
        let end = world.bodies[cube].translation();
        drift = drift.max((end.x - start.x).hypot(end.z - start.z));
        yaw = yaw.max(within_half_turn(heading(&world, cube) - before).abs());
        top = end.y;
    }
    println!("{name},drift_m,{drift:.6e}");
    println!("{name},yaw_rad,{yaw:.6e}");
    println!("{name},top_m,{top:.6e}");
}

pub fn print(model: FrictionModel) {
    println!("scene,quantity,value");
    for ratio in [0.95, 0.99, 1.01, 1.05] {
        print_slope(model, ratio);
    }
    print_stack(model, "stack", 0.0, 0.0);
    print_stack(model, "turned stack", 0.1, 0.01);
    let mut world = crate::cost::pile(model);
    step_for(&mut world, 10.0);
    let energy: f32 = world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum();
    println!("pile,energy_j,{energy:.6e}");
}
