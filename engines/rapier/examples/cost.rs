//! What the patches cost: many pucks that slide apart on one table, by contact and step.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example cost`

use rapier3d::prelude::*;
use std::error::Error;
use std::time::{Duration, Instant};
use tribos_rapier::{Patch, PatchContacts};

const MU: f32 = 0.05;
const RADIUS: f32 = 0.08;
const HALF_HEIGHT: f32 = 0.01;
/// Pucks along and across.
const GRID: [usize; 2] = [20, 10];
const PITCH: f32 = 0.5;
const STEPS: usize = 60;
/// Worlds that are stepped through; of each step the fastest counts.
const ROUNDS: usize = 15;

#[derive(Clone, Copy, Debug)]
enum Motion {
    Sliding,
    Resting,
}

/// Time of a step: whole, and of what comes before and after the engine's.
#[derive(Clone, Copy, Debug)]
struct Times {
    whole: Duration,
    around: Duration,
}

/// All pucks go the same way, so that they never meet.
fn run(motion: Motion, patch: Option<&Patch>) -> Vec<Times> {
    let mut world = PhysicsWorld::new();
    let table = ColliderBuilder::cuboid(20.0, 0.1, 20.0)
        .translation(Vector::new(0.0, -0.1, 0.0))
        .friction(MU);
    let table = world.insert_collider(table, None);
    let mut patches = PatchContacts::new();
    for i in 0..GRID[0] * GRID[1] {
        let [x, z] = [i / GRID[1], i % GRID[1]].map(|k| PITCH * k as f32);
        let mut body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(x - 5.0, HALF_HEIGHT, z - 2.5))
            .can_sleep(false);
        if let Motion::Sliding = motion {
            body = body.linvel(Vector::new(2.0, 0.0, 0.3)).angvel(Vector::new(
                0.0,
                5.0 + 0.05 * i as f32,
                0.0,
            ));
        }
        let shape = ColliderBuilder::cylinder(HALF_HEIGHT, RADIUS).friction(MU);
        let (_, foot) = world.insert(body, shape);
        if let Some(patch) = patch {
            patches
                .insert(
                    foot,
                    table,
                    patch.clone(),
                    &world.bodies,
                    &mut world.colliders,
                )
                .expect("a puck on a table");
        }
    }
    let mut times = Vec::with_capacity(STEPS);
    let parameters = world.integration_parameters;
    for step in 0..STEPS + 5 {
        let start = Instant::now();
        patches.begin_step(
            world.gravity,
            &parameters,
            &mut world.bodies,
            &world.colliders,
        );
        let begun = Instant::now();
        world.step_with_events(&patches, &());
        let stepped = Instant::now();
        patches.finish_step(
            &parameters,
            &mut world.bodies,
            &world.colliders,
            &world.narrow_phase,
        );
        let end = Instant::now();
        // Contacts are made in the first steps.
        if step >= 5 {
            times.push(Times {
                whole: end - start,
                around: (begun - start) + (end - stepped),
            });
        }
    }
    times
}

fn keep_fastest(best: &mut Vec<Times>, times: Vec<Times>) {
    if best.is_empty() {
        *best = times;
        return;
    }
    for (best, times) in best.iter_mut().zip(times) {
        best.whole = best.whole.min(times.whole);
        best.around = best.around.min(times.around);
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    if std::env::args().len() > 1 {
        return Err("takes no arguments: prints a table".into());
    }
    let pucks = GRID[0] * GRID[1];
    let corners = [
        [-RADIUS, -RADIUS],
        [RADIUS, -RADIUS],
        [RADIUS, RADIUS],
        [-RADIUS, RADIUS],
    ];
    let feet = [
        ("Rapier alone", None),
        ("disk", Some(Patch::disk(MU, RADIUS)?)),
        ("ring", Some(Patch::ring(MU, RADIUS)?)),
        (
            "polygon of 56 points",
            Some(Patch::polygon(MU, &corners, 2)?),
        ),
    ];
    println!(
        "{pucks} pucks; nanoseconds by contact and step over {STEPS} steps, each the fastest of {ROUNDS}.\n"
    );
    println!(
        "| | friction | whole step | more than Rapier alone | before and after the engine's step |\n|---|---|---|---|---|"
    );
    for motion in [Motion::Sliding, Motion::Resting] {
        // In turns, so that a busy machine slows all of them.
        let mut fastest = [const { Vec::new() }; 4];
        for _ in 0..ROUNDS {
            for (best, (_, patch)) in fastest.iter_mut().zip(&feet) {
                keep_fastest(best, run(motion, patch.as_ref()));
            }
        }
        let by_contact = |time: Duration| time.as_secs_f64() * 1e9 / (pucks * STEPS) as f64;
        let fastest = fastest.map(|steps: Vec<Times>| {
            let whole = steps.iter().map(|times| times.whole).sum();
            let around = steps.iter().map(|times| times.around).sum();
            [whole, around].map(by_contact)
        });
        for ([whole, around], (name, _)) in fastest.iter().zip(&feet) {
            let more = whole - fastest[0][0];
            println!("| {motion:?} | {name} | {whole:.0} | {more:+.0} | {around:.0} |");
        }
    }
    Ok(())
}
