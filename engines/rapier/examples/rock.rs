//! A curling stone on its ring: spin-coupled stop, and what sweeping adds.
//!
//! The stone does not curl here: Coulomb friction that is even along the ring does not bend a path.
//! What curls is told by the models of `docs/curling.md`.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example rock [PICTURE.svg]`

mod picture;

use picture::{COLOURS, Picture};
use rapier3d::prelude::*;
use std::error::Error;
use tribos_rapier::{Patch, PatchContacts};

const MU: f32 = 0.012;
/// Swept ice.
const MU_SWEPT: f32 = 0.010;
/// Where sweepers work, in metres from the release.
const SWEPT: [f32; 2] = [12.0, 24.0];
/// Running band.
const BAND: f32 = 0.065;
const STONE: f32 = 0.14;
const HALF_HEIGHT: f32 = 0.057;
const MASS: f32 = 19.0;
const SPEED: f32 = 2.4;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Ice {
    Alone,
    Patch,
    Swept,
}

/// Distance, time and turns at rest, and the path.
struct End {
    distance: f32,
    time: f32,
    turns: f32,
    path: Vec<[f32; 2]>,
}

fn slide(ice: Ice, spin: f32) -> Result<End, Box<dyn Error>> {
    let mut world = PhysicsWorld::new();
    let sheet = ColliderBuilder::cuboid(60.0, 0.1, 2.5)
        .translation(Vector::new(0.0, -0.1, 0.0))
        .friction(MU);
    let sheet = world.insert_collider(sheet, None);
    let stone = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, HALF_HEIGHT, 0.0))
        .linvel(Vector::new(SPEED, 0.0, 0.0))
        .angvel(Vector::new(0.0, spin, 0.0))
        .can_sleep(false);
    let foot = ColliderBuilder::cylinder(HALF_HEIGHT, STONE)
        .mass(MASS)
        .friction(MU);
    let (stone, foot) = world.insert(stone, foot);
    let mut patches = PatchContacts::new();
    let mut mu = if ice == Ice::Alone { f32::NAN } else { 0.0 };
    let (mut turns, mut time, mut path) = (0.0, 0.0, Vec::new());
    for _ in 0..3600 {
        let place = world.bodies[stone].translation();
        path.push([place.x, place.z]);
        let is_swept = ice == Ice::Swept && (SWEPT[0]..SWEPT[1]).contains(&place.x);
        let below = if is_swept { MU_SWEPT } else { MU };
        if below != mu && ice != Ice::Alone {
            mu = below;
            let patch = Patch::ring(mu, BAND)?;
            patches.insert(foot, sheet, patch, &world.bodies, &mut world.colliders)?;
        }
        patches.step(&mut world);
        let body = &world.bodies[stone];
        if body.linvel().length() < 1e-3 && body.angvel().length() < 1e-3 {
            break;
        }
        time += world.integration_parameters.dt;
        turns += body.angvel().y * world.integration_parameters.dt / core::f32::consts::TAU;
    }
    let distance = world.bodies[stone].translation().x;
    Ok(End {
        distance,
        time,
        turns,
        path,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    picture::asked_for()?;
    println!(
        "A stone at {SPEED} m/s, mu {MU}, swept {MU_SWEPT} from {} to {} m.\n",
        SWEPT[0], SWEPT[1]
    );
    println!("| spin, rad/s | ice | distance, m | time, s | turns |\n|---|---|---|---|---|");
    let mut picture = Picture::new([[-1.0, -2.5], [40.0, 2.5]]);
    for (row, spin) in [0.0, 1.5, 15.0].into_iter().enumerate() {
        for (i, ice) in [Ice::Alone, Ice::Patch, Ice::Swept].into_iter().enumerate() {
            let end = slide(ice, spin)?;
            println!(
                "| {spin} | {} | {:.2} | {:.2} | {:.2} |",
                ["Rapier alone", "ring patch", "ring patch, swept"][i],
                end.distance,
                end.time,
                end.turns
            );
            let at = -1.5 + row as f32 + 0.25 * i as f32;
            let path: Vec<_> = end.path.iter().map(|[x, z]| [*x, z + at]).collect();
            picture.path(COLOURS[i], &path);
            picture.circle(COLOURS[i], [end.distance, at], STONE);
        }
        picture.text("black", [0.0, -1.6 + row as f32], &format!("{spin} rad/s"));
    }
    picture.save_where_asked()
}
