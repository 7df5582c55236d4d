//! A spinning puck thrown on a table: exact, by Avian alone, with a friction patch. Opens no window.
//!
//! `cargo run --example puck`

use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::transform::TransformPlugin;
use std::error::Error;
use std::time::Duration;
use tribos_bevy::{FrictionPatch, FrictionPatchPlugin, PatchFriction};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

const MU: f32 = 0.3;
const RADIUS: f32 = 0.08;
const HEIGHT: f32 = 0.02;
const GRAVITY: f32 = 9.81;
const SPEED: f32 = 1.0;
const SPINS: [f32; 6] = [0.0, 5.0, 12.5, 20.0, 30.0, 50.0];
const STEPS_A_SECOND: f64 = 60.0;
const STEPS: usize = 300;
/// What counts as rest where the engine does not tell: m/s, rad/s.
const STILL: [f32; 2] = [1e-3, 1e-2];

#[derive(Clone, Copy, Debug)]
enum Foot {
    Disk,
    Ring,
}

/// How far the puck went in metres, and when it stopped in seconds.
#[derive(Clone, Copy, Debug)]
struct Throw {
    travel: f64,
    stop: f64,
}

fn exact(foot: Foot, spin: f32) -> Result<Throw, Box<dyn Error>> {
    let parameters = SliderParameters {
        deceleration: f64::from(MU) * f64::from(GRAVITY),
        radius: f64::from(RADIUS),
        inertia_ratio: 0.5,
    };
    let thrown = SliderState::launched(f64::from(SPEED), f64::from(spin));
    let rest = match foot {
        Foot::Disk => Slider::new(CoulombDisk, parameters)?.to_rest(&thrown),
        Foot::Ring => Slider::new(CoulombRing, parameters)?.to_rest(&thrown),
    };
    let motion = rest.ok_or("the puck never stops")?.motion;
    Ok(Throw {
        travel: motion.distance,
        stop: motion.time,
    })
}

/// A table with a puck on it, 60 steps a second.
fn app(spin: f32, patch: Option<FrictionPatch>) -> (App, Entity) {
    let mut app = App::new();
    app.add_plugins((
        MinimalPlugins,
        TransformPlugin,
        PhysicsPlugins::default(),
        FrictionPatchPlugin,
    ));
    let step = Duration::from_secs_f64(1.0 / STEPS_A_SECOND);
    app.insert_resource(Time::<Fixed>::from_duration(step));
    app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
    app.insert_resource(Gravity(Vec3::NEG_Y * GRAVITY));
    let world = app.world_mut();
    world.spawn((
        RigidBody::Static,
        Collider::cuboid(10.0, 0.2, 10.0),
        Friction::new(MU),
        Transform::from_xyz(0.0, -0.1, 0.0),
    ));
    let mut puck = world.spawn((
        RigidBody::Dynamic,
        Collider::cylinder(RADIUS, HEIGHT),
        Friction::new(MU),
        SleepingDisabled,
        Transform::from_xyz(0.0, 0.5 * HEIGHT, 0.0),
        LinearVelocity(Vec3::X * SPEED),
        AngularVelocity(Vec3::Y * spin),
    ));
    if let Some(patch) = patch {
        puck.insert(patch);
    }
    let puck = puck.id();
    app.finish();
    app.cleanup();
    (app, puck)
}

/// A throw with the patch, or with Avian's own friction without one.
fn thrown(spin: f32, patch: Option<FrictionPatch>) -> Option<Throw> {
    let is_alone = patch.is_none();
    let (mut app, puck) = app(spin, patch);
    let mut begun = 0;
    let mut stop = f64::NAN;
    for _ in 0..STEPS {
        let before = *app.world().get::<Position>(puck)?;
        app.update();
        let world = app.world();
        // The first update advances no time.
        if begun == 0 && before == *world.get::<Position>(puck)? {
            continue;
        }
        let time = f64::from(begun) / STEPS_A_SECOND;
        begun += 1;
        let friction = world.get::<PatchFriction>(puck);
        if let Some(within) = friction.and_then(|friction| friction.stopped_after) {
            stop = time + f64::from(within);
        }
        let (v, w) = (
            world.get::<LinearVelocity>(puck)?,
            world.get::<AngularVelocity>(puck)?,
        );
        let is_still = v.length() < STILL[0] && w.y.abs() < STILL[1];
        if is_alone && is_still && stop.is_nan() {
            stop = f64::from(begun) / STEPS_A_SECOND;
        }
    }
    let place = app.world().get::<Position>(puck)?;
    Some(Throw {
        travel: f64::from(place.x.hypot(place.z)),
        stop,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "A puck of {RADIUS} m radius, mu {MU}, thrown at {SPEED} m/s; {STEPS_A_SECOND} steps a second.\n"
    );
    println!(
        "| foot | spin, rad/s | travel, m | stop, s | Avian alone: travel | stop | with the patch: travel | stop |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for (foot, patch) in [
        (Foot::Disk, FrictionPatch::disk(MU, RADIUS)?),
        (Foot::Ring, FrictionPatch::ring(MU, RADIUS)?),
    ] {
        for spin in SPINS {
            let exact = exact(foot, spin)?;
            let gone = "the puck has been removed";
            let alone = thrown(spin, None).ok_or(gone)?;
            let with = thrown(spin, Some(patch.clone())).ok_or(gone)?;
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
        }
    }
    Ok(())
}
