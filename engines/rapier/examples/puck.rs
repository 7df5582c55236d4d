//! A spinning puck thrown on a table: exact, by Rapier alone, with its patch.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example puck [PICTURE.svg]`

mod picture;

use picture::{COLOURS, Picture};
use rapier3d::prelude::*;
use std::error::Error;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_rapier::{Patch, PatchContacts};

const MU: f32 = 0.3;
const RADIUS: f32 = 0.08;
const HALF_HEIGHT: f32 = 0.01;
const GRAVITY: f32 = 9.81;
const SPEED: f32 = 1.0;
const SPINS: [f32; 6] = [0.0, 5.0, 12.5, 20.0, 30.0, 50.0];
const STEPS_A_SECOND: f32 = 60.0;
const STEPS: usize = 300;
/// What counts as rest where the engine does not tell: m/s, rad/s.
const STILL: [f32; 2] = [1e-3, 1e-2];

#[derive(Clone, Copy, Debug)]
enum Foot {
    Disk,
    Ring,
}

/// How far the puck went, and when it stopped.
#[derive(Clone, Copy, Debug)]
struct Throw {
    travel: f64,
    stop: f64,
}

fn exact(foot: Foot, spin: f32) -> Result<Throw, Box<dyn Error>> {
    let (deceleration, radius) = (f64::from(MU) * f64::from(GRAVITY), f64::from(RADIUS));
    let thrown = SliderState::launched(f64::from(SPEED), f64::from(spin));
    let rest = match foot {
        Foot::Disk => Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration,
                radius,
                inertia_ratio: 0.5,
            },
        )?
        .to_rest(&thrown),
        Foot::Ring => Slider::new(
            CoulombRing,
            SliderParameters {
                deceleration,
                radius,
                inertia_ratio: 0.5,
            },
        )?
        .to_rest(&thrown),
    };
    let motion = rest.ok_or("the puck never stops")?.motion;
    Ok(Throw {
        travel: motion.distance,
        stop: motion.time,
    })
}

fn world(spin: f32) -> (PhysicsWorld, RigidBodyHandle, [ColliderHandle; 2]) {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, -GRAVITY, 0.0);
    world.integration_parameters.dt = STEPS_A_SECOND.recip();
    let table = ColliderBuilder::cuboid(5.0, 0.1, 5.0).friction(MU);
    let (_, table) = world.insert(RigidBodyBuilder::fixed(), table);
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, 0.1 + HALF_HEIGHT, 0.0))
        .linvel(Vector::new(SPEED, 0.0, 0.0))
        .angvel(Vector::new(0.0, spin, 0.0))
        .allow_fast_rotation(true)
        .can_sleep(false);
    let puck = ColliderBuilder::cylinder(HALF_HEIGHT, RADIUS).friction(MU);
    let (body, puck) = world.insert(body, puck);
    (world, body, [puck, table])
}

/// A throw with the patch, or with Rapier's own friction without one.
fn thrown(spin: f32, patch: Option<Patch>) -> Throw {
    let (mut world, body, [puck, table]) = world(spin);
    let mut patches = PatchContacts::new();
    let is_alone = patch.is_none();
    if let Some(patch) = patch {
        patches
            .insert(puck, table, patch, &world.bodies, &mut world.colliders)
            .expect("a puck on a table");
    }
    let dt = f64::from(world.integration_parameters.dt);
    let mut stop = f64::NAN;
    for step in 0..STEPS {
        patches.step(&mut world);
        if let Some(rest) = patches.stop(puck, table) {
            stop = step as f64 * dt + f64::from(rest.within_step);
        }
        let body = &world.bodies[body];
        let is_still = body.linvel().length() < STILL[0] && body.angvel().y.abs() < STILL[1];
        if is_alone && is_still && stop.is_nan() {
            stop = (step + 1) as f64 * dt;
        }
    }
    let place = world.bodies[body].translation();
    Throw {
        travel: f64::from(place.x.hypot(place.z)),
        stop,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    picture::asked_for()?;
    println!(
        "A puck of {RADIUS} m radius, mu {MU}, thrown at {SPEED} m/s; {STEPS_A_SECOND} steps a second.\n"
    );
    println!(
        "| foot | spin, rad/s | travel, m | stop, s | Rapier alone: travel | stop | with the patch: travel | stop |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut picture = Picture::new([[-0.1, 0.0], [0.8, 0.6]]);
    for (foot, patch) in [
        (Foot::Disk, Patch::disk(MU, RADIUS)?),
        (Foot::Ring, Patch::ring(MU, RADIUS)?),
    ] {
        let mut travels: [Vec<[f32; 2]>; 3] = Default::default();
        for spin in SPINS {
            let throws = [
                exact(foot, spin)?,
                thrown(spin, None),
                thrown(spin, Some(patch.clone())),
            ];
            let [exact, alone, with] = throws;
            let percent = |is: f64, should: f64| 100.0 * (is / should - 1.0);
            println!(
                "| {foot:?} | {spin} | {:.4} | {:.4} | {:+.2} % | {:+.2} % | {:+.2} % | {:+.2} % |",
                exact.travel,
                exact.stop,
                percent(alone.travel, exact.travel),
                percent(alone.stop, exact.stop),
                percent(with.travel, exact.travel),
                percent(with.stop, exact.stop),
            );
            for (line, throw) in travels.iter_mut().zip(throws) {
                line.push([throw.travel as f32, 0.05 + 0.01 * spin]);
            }
        }
        for (line, colour) in travels.iter().zip(COLOURS) {
            picture.path(colour, line);
        }
    }
    for (line, text) in ["exact", "Rapier alone", "with the patch"]
        .into_iter()
        .enumerate()
    {
        picture.text(COLOURS[line], [0.6, 0.05 + 0.03 * line as f32], text);
    }
    picture.text(
        "black",
        [-0.08, 0.59],
        "travel to the right, 0.9 m; spin down, 0 to 50 rad/s",
    );
    picture.save_where_asked()
}
