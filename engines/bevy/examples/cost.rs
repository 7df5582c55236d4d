//! What the patches cost: many bodies that slide apart on one ground, or rest, by contact and step. Opens no window.
//!
//! `cargo run --release --example cost`

use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::transform::TransformPlugin;
use std::error::Error;
use std::time::{Duration, Instant};
use tribos_bevy::{FrictionPatch, FrictionPatchPlugin};

const MU: f32 = 0.05;
const RADIUS: f32 = 0.08;
const HEIGHT: f32 = 0.02;
/// Bodies along and across.
const GRID: [usize; 2] = [40, 25];
const PITCH: f32 = 0.2;
/// Steps in which contacts are made, and those that are timed.
const SETTLE: usize = 5;
const STEPS: usize = 40;
/// Worlds that are stepped through; of each step the fastest counts.
const ROUNDS: usize = 5;

/// All bodies go the same way, so that they never meet.
fn app(slides: bool, is_round: bool, patch: Option<&FrictionPatch>) -> App {
    let mut app = App::new();
    app.add_plugins((
        MinimalPlugins,
        TransformPlugin,
        PhysicsPlugins::default(),
        FrictionPatchPlugin,
    ));
    let step = Duration::from_secs_f64(1.0 / 60.0);
    app.insert_resource(Time::<Fixed>::from_duration(step));
    app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
    let world = app.world_mut();
    world.spawn((
        RigidBody::Static,
        Collider::cuboid(10.0, 0.2, 10.0),
        Friction::new(MU),
        Transform::from_xyz(0.0, -0.1, 0.0),
    ));
    for i in 0..GRID[0] * GRID[1] {
        let [x, z] = [i / GRID[1], i % GRID[1]].map(|k| PITCH * k as f32);
        let collider = match is_round {
            true => Collider::cylinder(RADIUS, HEIGHT),
            false => Collider::cuboid(2.0 * RADIUS, HEIGHT, 2.0 * RADIUS),
        };
        let mut body = world.spawn((
            RigidBody::Dynamic,
            collider,
            Friction::new(MU),
            SleepingDisabled,
            Transform::from_xyz(x - 4.8, 0.5 * HEIGHT, z - 2.5),
        ));
        if slides {
            let spin = 5.0 + 0.01 * i as f32;
            body.insert((
                LinearVelocity(Vec3::new(2.0, 0.0, 0.3)),
                AngularVelocity(Vec3::Y * spin),
            ));
        }
        if let Some(patch) = patch {
            body.insert(patch.clone());
        }
    }
    app.finish();
    app.cleanup();
    app
}

/// Times of the steps.
fn run(mut app: App) -> Vec<Duration> {
    for _ in 0..SETTLE {
        app.update();
    }
    let mut time = || {
        let start = Instant::now();
        app.update();
        start.elapsed()
    };
    (0..STEPS).map(|_| time()).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    if std::env::args().len() > 1 {
        return Err("takes no arguments: prints a table".into());
    }
    let corners = [
        [-RADIUS, -RADIUS],
        [RADIUS, -RADIUS],
        [RADIUS, RADIUS],
        [-RADIUS, RADIUS],
    ];
    let shapes = [
        ("disk", true, FrictionPatch::disk(MU, RADIUS)?),
        ("square", false, FrictionPatch::polygon(MU, &corners)?),
    ];
    let bodies = GRID[0] * GRID[1];
    println!(
        "{bodies} bodies; microseconds by contact and step, each of {STEPS} steps the fastest of {ROUNDS}.\n"
    );
    println!("| | patch | Avian alone | with patches | more |\n|---|---|---|---|---|");
    for slides in [true, false] {
        for (name, is_round, patch) in &shapes {
            // In turns, so that a busy machine slows both.
            let mut fastest = [[Duration::MAX; STEPS]; 2];
            for _ in 0..ROUNDS {
                for (best, patch) in fastest.iter_mut().zip([None, Some(patch)]) {
                    let times = run(app(slides, *is_round, patch));
                    for (best, time) in best.iter_mut().zip(times) {
                        *best = time.min(*best);
                    }
                }
            }
            let by_contact = |times: &[Duration; STEPS]| {
                times.iter().sum::<Duration>().as_secs_f64() * 1e6 / (bodies * STEPS) as f64
            };
            let [alone, patched] = [by_contact(&fastest[0]), by_contact(&fastest[1])];
            let motion = if slides { "sliding" } else { "at rest" };
            println!(
                "| {motion} | {name} | {alone:.2} | {patched:.2} | {:+.2} |",
                patched - alone
            );
        }
    }
    Ok(())
}
