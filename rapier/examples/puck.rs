//! A spinning puck thrown on a table at 60 steps a second: exact, by Rapier alone, with its patch.
//!
//! `cargo run --release -p tribos-rapier --example puck`

use rapier3d::prelude::*;
use std::error::Error;
use tribos_core::coupling::table::Coulomb;
use tribos_core::slider::{Motion, Slider};
use tribos_rapier::{Patch, PatchContacts};

const MU: f32 = 0.3;
const RADIUS: f32 = 0.08;
const HALF_HEIGHT: f32 = 0.01;
const GRAVITY: f32 = 9.81;
const SPEED: f32 = 1.0;

/// How far the puck went, and when it stopped.
#[derive(Clone, Copy, Debug)]
struct Throw {
    travel: f64,
    stop: f64,
}

fn exact(spin: f32) -> Result<Throw, Box<dyn Error>> {
    let puck = Slider::new(
        Coulomb,
        f64::from(MU) * f64::from(GRAVITY),
        f64::from(RADIUS),
        0.5,
    )?;
    let rest = puck.to_rest(&Motion::launched(f64::from(SPEED), f64::from(spin)));
    let motion = rest.ok_or("the puck never stops")?.motion;
    Ok(Throw {
        travel: motion.distance,
        stop: motion.time,
    })
}

fn world(spin: f32) -> (PhysicsWorld, RigidBodyHandle, [ColliderHandle; 2]) {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, -GRAVITY, 0.0);
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

fn thrown(spin: f32, mut patches: Option<PatchContacts>) -> Result<Throw, Box<dyn Error>> {
    let (mut world, body, [puck, table]) = world(spin);
    if let Some(patches) = &mut patches {
        patches.insert(puck, table, Patch::disk(MU, RADIUS)?, &mut world.colliders);
    }
    let dt = f64::from(world.integration_parameters.dt);
    let mut stop = f64::NAN;
    for step in 0..300 {
        match &mut patches {
            Some(patches) => {
                patches.step(&mut world);
                if let Some(rest) = patches.stop(puck, table) {
                    stop = f64::from(step) * dt + f64::from(rest.within_step);
                }
            }
            None => {
                world.step();
                let body = &world.bodies[body];
                let still = body.linvel().length() < 1e-3 && body.angvel().y.abs() < 1e-2;
                if still && stop.is_nan() {
                    stop = f64::from(step + 1) * dt;
                }
            }
        }
    }
    let place = world.bodies[body].translation();
    Ok(Throw {
        travel: f64::from(place.x.hypot(place.z)),
        stop,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("disk: mu {MU}, radius {RADIUS} m, thrown at {SPEED} m/s; 60 steps a second");
    println!(
        "{:>8} {:>24} {:>26} {:>26}",
        "spin", "exact", "Rapier alone", "Rapier, disk patch"
    );
    println!(
        "{:>8} {:>12} {:>11} {:>13} {:>12} {:>13} {:>12}",
        "rad/s", "travel m", "stop s", "travel %", "stop %", "travel %", "stop %"
    );
    for spin in [0.0, 5.0, 12.5, 20.0, 30.0, 50.0] {
        let exact = exact(spin)?;
        let alone = thrown(spin, None)?;
        let patch = thrown(spin, Some(PatchContacts::new()))?;
        let percent = |is: f64, should: f64| 100.0 * (is / should - 1.0);
        println!(
            "{spin:>8} {:>12.5} {:>11.5} {:>+13.2} {:>+12.2} {:>+13.2} {:>+12.2}",
            exact.travel,
            exact.stop,
            percent(alone.travel, exact.travel),
            percent(alone.stop, exact.stop),
            percent(patch.travel, exact.travel),
            percent(patch.stop, exact.stop),
        );
    }
    Ok(())
}
