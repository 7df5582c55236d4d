//! Travel and stop of thrown pucks and boxes seen from above, against the exact law.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier2d --example disks_and_boxes`

#[path = "../../feet/tests/exact/mod.rs"]
#[allow(dead_code, reason = "what tests need")]
mod exact;

use exact::{GRAVITY, MU, RADIUS, Throw, on_cells, rectangle};
use rapier2d::prelude::*;
use std::error::Error;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_rapier2d::{Floor, Footprint, PlacedFoot};

const SPINS: [f32; 6] = [0.0, 5.0, 12.5, 20.0, 30.0, 50.0];

/// Travel in m and stop in s of a body thrown at 1 m/s.
fn thrown(
    shape: ColliderBuilder,
    foot: Option<Footprint>,
    spin: f32,
) -> Result<Throw, Box<dyn Error>> {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let body = RigidBodyBuilder::dynamic()
        .linvel(Vector::new(1.0, 0.0))
        .angvel(spin)
        .allow_fast_rotation(true);
    let (body, _) = world.insert(body, shape);
    let mut floor = Floor::new(MU, GRAVITY)?;
    if let Some(foot) = foot {
        floor.set_feet(body, vec![PlacedFoot::new(foot, Pose::identity())])?;
    }
    let dt = f64::from(world.integration_parameters.dt);
    for step in 0..600 {
        floor.step(&mut world);
        if let Some(stop) = floor.stop(body) {
            let travel = world.bodies[body].translation().length();
            return Ok(Throw {
                travel: f64::from(travel),
                stop: f64::from(step) * dt + f64::from(stop.within_step),
            });
        }
    }
    Err("moves after ten seconds".into())
}

fn line(name: &str, spin: f32, is: Throw, exact: Throw) {
    let Throw {
        travel: right,
        stop: end,
    } = exact;
    let [travel, stop] = [is.travel / right, is.stop / end].map(|ratio| 100.0 * (ratio - 1.0));
    println!("| {name} | {spin} | {right:.4} | {end:.4} | {travel:+.2} % | {stop:+.2} % |");
}

fn main() -> Result<(), Box<dyn Error>> {
    if std::env::args().len() > 1 {
        return Err("takes no arguments: prints a table".into());
    }
    println!("| shape | spin, rad/s | travel, m | stop, s | with the floor: travel | stop |");
    println!("|---|---|---|---|---|---|");
    let deceleration = f64::from(MU) * f64::from(GRAVITY);
    let parameters = SliderParameters {
        deceleration,
        radius: f64::from(RADIUS),
        inertia_ratio: 0.5,
    };
    for spin in SPINS {
        let launched = SliderState::launched(1.0, f64::from(spin));
        let end = Slider::new(CoulombDisk, parameters)?
            .to_rest(&launched)
            .ok_or("never stops")?
            .motion;
        let is = thrown(ColliderBuilder::ball(RADIUS), None, spin)?;
        line(
            "disk",
            spin,
            is,
            Throw {
                travel: end.distance,
                stop: end.time,
            },
        );
    }
    for spin in SPINS {
        let launched = SliderState::launched(1.0, f64::from(spin));
        let end = Slider::new(CoulombRing, parameters)?
            .to_rest(&launched)
            .ok_or("never stops")?
            .motion;
        let ring = Some(Footprint::ring(RADIUS)?);
        let is = thrown(ColliderBuilder::ball(RADIUS), ring, spin)?;
        line(
            "ring",
            spin,
            is,
            Throw {
                travel: end.distance,
                stop: end.time,
            },
        );
    }
    for (name, [a, b]) in [
        ("box 20 × 20 cm", [0.1, 0.1]),
        ("plank 40 × 10 cm", [0.2, 0.05]),
    ] {
        let cells = rectangle([a, b], 100);
        for spin in [0.0, 5.0, 12.5, 25.0] {
            let right = on_cells(&cells, (a * a + b * b) / 3.0, spin);
            let is = thrown(ColliderBuilder::cuboid(a as f32, b as f32), None, spin)?;
            line(name, spin, is, right);
        }
    }
    Ok(())
}
