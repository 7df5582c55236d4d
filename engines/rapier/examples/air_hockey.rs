//! Air hockey: a puck on nearly no friction, cushions, and a mallet that strikes.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example air_hockey [PICTURE.svg]`

mod picture;

use picture::{COLOURS, Picture};
use rapier3d::prelude::*;
use std::error::Error;
use tribos_rapier::{Patch, PatchContacts};

const MU: f32 = 0.02;
/// Half the length and half the width of the table, in metres.
const TABLE: [f32; 2] = [1.1, 0.6];
const HALF_HEIGHT: f32 = 0.01;
const PUCK: f32 = 0.041;
const MALLET: f32 = 0.05;
const STEPS_A_SECOND: f32 = 240.0;
const SECONDS: f32 = 6.0;

struct Rink {
    world: PhysicsWorld,
    patches: PatchContacts,
    puck: RigidBodyHandle,
    mallet: RigidBodyHandle,
}

fn rink(with_patch: bool) -> Result<Rink, Box<dyn Error>> {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.dt = STEPS_A_SECOND.recip();
    let [length, width] = TABLE;
    let top = ColliderBuilder::cuboid(length, 0.1, width)
        .translation(Vector::new(0.0, -0.1, 0.0))
        .friction(MU);
    let top = world.insert_collider(top, None);
    for (x, z) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let half = Vector::new(
            0.05 + length * f32::abs(z),
            0.05,
            0.05 + width * f32::abs(x),
        );
        let cushion = ColliderBuilder::cuboid(half.x, half.y, half.z)
            .translation(Vector::new(x * (length + 0.05), 0.0, z * (width + 0.05)))
            .friction(0.1)
            .restitution(0.9);
        world.insert_collider(cushion, None);
    }
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(-0.4, HALF_HEIGHT, 0.1))
        .angvel(Vector::new(0.0, 40.0, 0.0))
        .allow_fast_rotation(true)
        .can_sleep(false);
    let shape = ColliderBuilder::cylinder(HALF_HEIGHT, PUCK)
        .friction(MU)
        .restitution(0.9);
    let (puck, foot) = world.insert(body, shape);
    let body = RigidBodyBuilder::kinematic_velocity_based().translation(Vector::new(
        -0.8,
        2.0 * HALF_HEIGHT,
        0.11,
    ));
    let (mallet, _) = world.insert(body, ColliderBuilder::cylinder(HALF_HEIGHT, MALLET));
    let mut patches = PatchContacts::new();
    if with_patch {
        let patch = Patch::disk(MU, PUCK)?;
        patches.insert(foot, top, patch, &world.bodies, &mut world.colliders)?;
    }
    Ok(Rink {
        world,
        patches,
        puck,
        mallet,
    })
}

/// Path, and speed and spin after every second.
fn played(mut rink: Rink) -> (Vec<[f32; 2]>, Vec<[f32; 2]>) {
    let (mut path, mut seconds) = (Vec::new(), Vec::new());
    for step in 1..=(SECONDS * STEPS_A_SECOND) as usize {
        // The mallet strikes once, there and back.
        let time = step as f32 / STEPS_A_SECOND;
        let stroke = match time {
            ..0.25 => 1.6,
            ..0.5 => -1.6,
            _ => 0.0,
        };
        rink.world.bodies[rink.mallet].set_linvel(Vector::new(stroke, 0.0, 0.0), true);
        rink.patches.step(&mut rink.world);
        let puck = &rink.world.bodies[rink.puck];
        path.push([puck.translation().x, puck.translation().z]);
        if step % STEPS_A_SECOND as usize == 0 {
            seconds.push([puck.linvel().length(), puck.angvel().y]);
        }
    }
    (path, seconds)
}

fn main() -> Result<(), Box<dyn Error>> {
    picture::asked_for()?;
    println!("A struck puck, mu {MU}; {STEPS_A_SECOND} steps a second. Speed and spin:\n");
    let [length, width] = TABLE;
    let mut picture = Picture::new([[-length, -width], [length, width]]);
    println!(
        "| after, s | Rapier alone: m/s | rad/s | with the patch: m/s | rad/s |\n|---|---|---|---|---|"
    );
    let mut rows = Vec::new();
    for (i, name) in ["Rapier alone", "with the patch"].into_iter().enumerate() {
        let (path, seconds) = played(rink(i == 1)?);
        picture.path(COLOURS[i], &path);
        if let Some(&end) = path.last() {
            picture.circle(COLOURS[i], end, PUCK);
        }
        picture.text(
            COLOURS[i],
            [-length + 0.05, -width + 0.08 + 0.08 * i as f32],
            name,
        );
        rows.push(seconds);
    }
    for (second, (alone, with)) in rows[0].iter().zip(&rows[1]).enumerate() {
        println!(
            "| {} | {:.3} | {:.2} | {:.3} | {:.2} |",
            second + 1,
            alone[0],
            alone[1],
            with[0],
            with[1]
        );
    }
    picture.save_where_asked()
}
