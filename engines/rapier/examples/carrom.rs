//! A spinning striker into a row of pieces on a board with cushions.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example carrom [PICTURE.svg]`

mod picture;

use picture::{COLOURS, Picture};
use rapier3d::prelude::*;
use std::error::Error;
use tribos_rapier::{Patch, PatchContacts};

const MU: f32 = 0.2;
/// Half the width of the board, in metres.
const BOARD: f32 = 0.37;
const HALF_HEIGHT: f32 = 0.004;
const STRIKER: f32 = 0.0206;
const PIECE: f32 = 0.0159;
const SPEED: f32 = 2.5;
const SPIN: f32 = 60.0;
const STEPS_A_SECOND: f32 = 240.0;

struct Game {
    world: PhysicsWorld,
    patches: PatchContacts,
    pieces: Vec<(RigidBodyHandle, f32)>,
}

/// The board with its cushions, a striker and five pieces.
fn game(with_patches: bool) -> Result<Game, Box<dyn Error>> {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.dt = STEPS_A_SECOND.recip();
    // Shapes of centimetres: tolerances of the engine scale with this.
    world.integration_parameters.length_unit = 0.1;
    let board = ColliderBuilder::cuboid(BOARD, 0.1, BOARD)
        .translation(Vector::new(0.0, -0.1, 0.0))
        .friction(MU);
    let board = world.insert_collider(board, None);
    for (x, z) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let half = Vector::new(0.02 + BOARD * f32::abs(z), 0.02, 0.02 + BOARD * f32::abs(x));
        let cushion = ColliderBuilder::cuboid(half.x, half.y, half.z)
            .translation(Vector::new(x, 0.0, z) * (BOARD + 0.02))
            .friction(0.1)
            .restitution(0.7);
        world.insert_collider(cushion, None);
    }
    let mut patches = PatchContacts::new();
    let mut pieces = Vec::new();
    let places = [
        [0.0, 0.0],
        [0.04, 0.035],
        [0.04, -0.035],
        [0.09, 0.01],
        [0.13, -0.06],
    ];
    let striker = ([-0.3, 0.012], STRIKER, Vector::new(SPEED, 0.0, 0.0), SPIN);
    let resting = places.map(|place| (place, PIECE, Vector::ZERO, 0.0));
    for ([x, z], radius, velocity, spin) in core::iter::once(striker).chain(resting) {
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(x, HALF_HEIGHT, z))
            .linvel(velocity)
            .angvel(Vector::new(0.0, spin, 0.0))
            .allow_fast_rotation(true);
        let shape = ColliderBuilder::cylinder(HALF_HEIGHT, radius)
            .friction(MU)
            .restitution(0.8);
        let (body, foot) = world.insert(body, shape);
        if with_patches {
            let patch = Patch::disk(MU, radius)?;
            patches.insert(foot, board, patch, &world.bodies, &mut world.colliders)?;
        }
        pieces.push((body, radius));
    }
    Ok(Game {
        world,
        patches,
        pieces,
    })
}

/// The path of every piece, the time of rest, and the turns of the striker.
fn played(mut game: Game) -> (Vec<Vec<[f32; 2]>>, f32, f32) {
    let mut paths = vec![Vec::new(); game.pieces.len()];
    let (mut time, mut turns) = (0.0, 0.0);
    for step in 1..=(5.0 * STEPS_A_SECOND) as usize {
        game.patches.step(&mut game.world);
        for (path, (body, _)) in paths.iter_mut().zip(&game.pieces) {
            let body = &game.world.bodies[*body];
            path.push([body.translation().x, body.translation().z]);
            if body.linvel().length() > 1e-3 || body.angvel().length() > 1e-2 {
                time = step as f32 / STEPS_A_SECOND;
            }
        }
        let striker = &game.world.bodies[game.pieces[0].0];
        turns += striker.angvel().y / STEPS_A_SECOND / core::f32::consts::TAU;
    }
    (paths, time, turns)
}

fn main() -> Result<(), Box<dyn Error>> {
    picture::asked_for()?;
    println!(
        "A striker at {SPEED} m/s and {SPIN} rad/s, mu {MU}; {STEPS_A_SECOND} steps a second.\n"
    );
    println!(
        "| friction | all rest after, s | turns of the striker | rest of striker and pieces, cm |\n|---|---|---|---|"
    );
    let edge = BOARD + 0.02;
    let mut picture = Picture::new([[-edge, -edge], [3.0 * edge, edge]]);
    for (i, name) in ["Rapier alone", "disk patches"].into_iter().enumerate() {
        let game = game(i == 1)?;
        let radii: Vec<_> = game.pieces.iter().map(|piece| piece.1).collect();
        let (paths, time, turns) = played(game);
        let right = 2.0 * edge * i as f32;
        picture.text("black", [right - BOARD, -BOARD + 0.02], name);
        let mut ends = String::new();
        for ((path, radius), colour) in paths.iter().zip(radii).zip(COLOURS) {
            let path: Vec<_> = path.iter().map(|[x, z]| [x + right, *z]).collect();
            picture.path(colour, &path);
            if let Some(&[x, z]) = path.last() {
                picture.circle(colour, [x, z], radius);
                ends += &format!(" ({:.1}, {:.1})", 100.0 * (x - right), 100.0 * z);
            }
        }
        println!("| {name} | {time:.2} | {turns:.2} |{ends} |");
    }
    picture.save_where_asked()
}
