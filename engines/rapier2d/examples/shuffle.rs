//! A shuffleboard seen from above: pucks and boxes, walls, a strip of ice.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier2d --example shuffle [PICTURE.svg]`

mod picture;

use picture::{COLOURS, Picture, asked_for};
use rapier2d::prelude::*;
use std::error::Error;
use tribos_rapier2d::Floor;

const MU: f32 = 0.25;
const ICE: f32 = 0.03;
/// Half the length and half the width of the board, in metres.
const BOARD: [f32; 2] = [2.0, 0.6];
/// Half the length and the middle of the strip of ice.
const STRIP: [f32; 2] = [0.3, 0.2];
const RADIUS: f32 = 0.06;
const SPINS: [f32; 5] = [0.0, 30.0, -30.0, 60.0, 0.0];

struct Board {
    world: PhysicsWorld,
    floor: Floor,
    bodies: Vec<RigidBodyHandle>,
}

fn board() -> Result<Board, Box<dyn Error>> {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let [length, width] = BOARD;
    for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let half = [0.05 + length * f32::abs(y), 0.05 + width * f32::abs(x)];
        let wall = ColliderBuilder::cuboid(half[0], half[1])
            .translation(Vector::new(x * (length + 0.05), y * (width + 0.05)))
            .friction(0.1)
            .restitution(0.7);
        world.insert_collider(wall, None);
    }
    let mut floor = Floor::new(MU, 9.81)?;
    let strip = SharedShape::cuboid(STRIP[0], width);
    floor.add_region(strip, Pose::translation(STRIP[1], 0.0), ICE)?;
    let bodies = SPINS.iter().enumerate().map(|(k, &spin)| {
        let y = 0.2 * (k as f32 - 2.0);
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(-1.7, y))
            .linvel(Vector::new(3.5, 0.0))
            .angvel(spin)
            .allow_fast_rotation(true);
        let shape = match k == 4 {
            true => ColliderBuilder::cuboid(RADIUS, RADIUS),
            false => ColliderBuilder::ball(RADIUS),
        };
        world.insert(body, shape.friction(0.2).restitution(0.7)).0
    });
    let bodies = bodies.collect();
    Ok(Board {
        world,
        floor,
        bodies,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    asked_for()?;
    let mut board = board()?;
    let mut paths = vec![Vec::new(); board.bodies.len()];
    let mut stops = vec![f32::NAN; board.bodies.len()];
    let dt = board.world.integration_parameters.dt;
    for step in 0..360 {
        board.floor.step(&mut board.world);
        for (number, &body) in board.bodies.iter().enumerate() {
            let place = board.world.bodies[body].translation();
            paths[number].push([place.x, -place.y]);
            if let Some(stop) = board.floor.stop(body) {
                stops[number] = step as f32 * dt + stop.within_step;
            }
        }
    }
    println!("| | spin, rad/s | end, m | turned, ° | at rest after, s |\n|---|---|---|---|---|");
    for (number, &body) in board.bodies.iter().enumerate() {
        let body = &board.world.bodies[body];
        let ([x, y], stop) = (body.translation().into(), stops[number]);
        let name = if number == 4 { "box" } else { "puck" };
        let angle = body.rotation().angle().to_degrees();
        println!(
            "| {name} | {} | {x:.3}, {y:.3} | {angle:.1} | {stop:.3} |",
            SPINS[number]
        );
    }
    let [length, width] = BOARD;
    let mut picture = Picture::new([[-length - 0.1, -width - 0.1], [length + 0.1, width + 0.1]]);
    for x in [STRIP[1] - STRIP[0], STRIP[1] + STRIP[0]] {
        picture.path("#999999", &[[x, -width], [x, width]]);
    }
    for (path, colour) in paths.iter().zip(COLOURS) {
        picture.path(colour, path);
        if let Some(&end) = path.last() {
            picture.circle(colour, end, RADIUS);
        }
    }
    picture.save_where_asked()
}
