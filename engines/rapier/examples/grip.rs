//! How far blocks creep in ten seconds that friction holds: by Rapier alone, and with their patch.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example grip`
//!
//! The blocks of `bindings/python/benches/hold.py`, which puts them into other engines.

use rapier3d::prelude::*;
use std::error::Error;
use tribos_rapier::{Patch, PatchContacts};

/// Half sides of the block in m; y is up.
const HALF: [f32; 3] = [0.05, 0.025, 0.05];
const MASS: f32 = 1.0;
const GRAVITY: f32 = 9.81;
const STEPS_A_SECOND: f32 = 500.0;
/// Time in which the block settles, in s.
const SETTLE: f32 = 1.0;
/// Time of the creep, in s.
const SECONDS: f32 = 10.0;

/// A block on a plane: friction, tangential and normal force in N, amplitude of a torque in N m.
#[derive(Clone, Copy, Debug)]
struct Block {
    mu: f32,
    push: f32,
    load: f32,
    torque: f32,
}

impl Block {
    /// On an incline with a share of the tangent at which it slides.
    fn on_incline(mu: f32, share: f32) -> Self {
        let angle = (share * mu).atan();
        let weight = MASS * GRAVITY;
        Self {
            mu,
            push: weight * angle.sin(),
            load: weight * angle.cos(),
            torque: 0.0,
        }
    }
}

fn cases() -> [(&'static str, Block); 5] {
    let weight = MASS * GRAVITY;
    let pressed = Block {
        mu: 1.0,
        push: weight,
        load: 20.0,
        torque: 0.0,
    };
    let turned = Block {
        mu: 0.5,
        push: 0.0,
        load: weight,
        torque: 0.9 * TORQUE_OF_SQUARE * 0.5 * weight * HALF[0],
    };
    [
        (
            "block on a shallow ramp",
            Block::on_incline(1.0, 2.0_f32.to_radians().tan()),
        ),
        ("cube pressed on a wall with 20 N", pressed),
        ("block at 99 % of its angle", Block::on_incline(0.5, 0.99)),
        (
            "block at 99.9 % of its angle",
            Block::on_incline(0.5, 0.999),
        ),
        ("block under a cyclic torque of 90 %", turned),
    ]
}

/// Mean distance from the middle of a square of half side 1, (√2 + ln(1 + √2))/3.
const TORQUE_OF_SQUARE: f32 = 0.765_195_7;

/// Creep in m, and in rad where a torque acts.
fn creep(block: &Block, with_patch: bool) -> Result<f32, Box<dyn Error>> {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(block.push / MASS, -block.load / MASS, 0.0);
    world.integration_parameters.dt = STEPS_A_SECOND.recip();
    let table = ColliderBuilder::cuboid(5.0, 0.1, 5.0).friction(block.mu);
    let (_, table) = world.insert(RigidBodyBuilder::fixed(), table);
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, 0.1 + HALF[1], 0.0))
        .can_sleep(false);
    let shape = ColliderBuilder::cuboid(HALF[0], HALF[1], HALF[2])
        .friction(block.mu)
        .mass(MASS);
    let (body, foot) = world.insert(body, shape);
    let mut patches = PatchContacts::new();
    if with_patch {
        let (a, b) = (HALF[0], HALF[2]);
        let square = Patch::polygon(block.mu, &[[-a, -b], [a, -b], [a, b], [-a, b]], 1)?;
        patches.insert(foot, table, square, &world.bodies, &mut world.colliders)?;
    }
    let mut start = [0.0; 3];
    let settle = (SETTLE * STEPS_A_SECOND) as u32;
    let steps = ((SETTLE + SECONDS) * STEPS_A_SECOND) as u32;
    for step in 0..steps {
        if step == settle {
            start = pose(&world, body);
        }
        let turn = block.torque * (core::f32::consts::TAU * step as f32 / STEPS_A_SECOND).sin();
        if let Some(body) = world.bodies.get_mut(body) {
            body.reset_torques(true);
            body.add_torque(Vector::new(0.0, turn, 0.0), true);
        }
        patches.step(&mut world);
    }
    let end = pose(&world, body);
    let [x, z, turn] = [0, 1, 2].map(|i| end[i] - start[i]);
    Ok(if block.torque == 0.0 {
        x.hypot(z)
    } else {
        turn.abs()
    })
}

/// Place on the plane and angle about its normal.
fn pose(world: &PhysicsWorld, body: RigidBodyHandle) -> [f32; 3] {
    let body = &world.bodies[body];
    let (place, turn) = (body.translation(), body.rotation());
    [place.x, place.z, 2.0 * turn.y.atan2(turn.w)]
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("Creep in µm/s (µrad/s under a torque); {STEPS_A_SECOND} steps a second.\n");
    println!("| case | Rapier alone | with the patch |\n|---|---|---|");
    for (name, block) in cases() {
        let [alone, with] = [false, true].map(|with| creep(&block, with));
        let [alone, with] = [alone?, with?].map(|creep| 1e6 * creep / SECONDS);
        println!("| {name} | {alone:.3} | {with:.3} |");
    }
    Ok(())
}
