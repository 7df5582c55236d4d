//! Travel, rest and cost of boxes and pucks under each friction model of Rapier.

use rapier3d::prelude::*;
use std::time::{Duration, Instant};

const GRAVITY: f32 = 10.0;
const MU: f32 = 0.3;
/// Half sides of the box and its half height.
const HALF: f32 = 0.05;
const LOW: f32 = 0.005;

fn models() -> Vec<(&'static str, FrictionModel)> {
    vec![
        ("Simplified", FrictionModel::Simplified),
        ("Coulomb", FrictionModel::Coulomb),
        #[cfg(feature = "area")]
        ("Area", FrictionModel::Area),
    ]
}

/// A floor whose gravity is inclined by a tangent along x.
fn world(model: FrictionModel, rate: f32, tangent: f32) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let cosine = (1.0 + tangent * tangent).sqrt().recip();
    world.gravity = Vector::new(GRAVITY * tangent * cosine, -GRAVITY * cosine, 0.0);
    world.integration_parameters.dt = rate.recip();
    world.integration_parameters.friction_model = model;
    let floor = ColliderBuilder::cuboid(50.0, 1.0, 50.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.insert_collider(floor.friction(MU), None);
    world
}

fn flat(
    shape: ColliderBuilder,
    height: f32,
    world: &mut PhysicsWorld,
    speed: f32,
    spin: f32,
) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, height, 0.0))
        .linvel(Vector::new(speed, 0.0, 0.0))
        .angvel(Vector::new(0.0, spin, 0.0))
        .can_sleep(false)
        .allow_fast_rotation(true);
    world.insert(body, shape.friction(MU)).0
}

fn steps(world: &mut PhysicsWorld, seconds: f32) {
    let steps = (seconds / world.integration_parameters.dt).round() as usize;
    for _ in 0..steps {
        world.step();
    }
}

/// Travel in m and angle in rad of a body thrown at 1 m/s.
fn thrown(
    shape: ColliderBuilder,
    height: f32,
    model: FrictionModel,
    rate: f32,
    spin: f32,
) -> [f32; 2] {
    let mut world = world(model, rate, 0.0);
    let body = flat(shape, height, &mut world, 1.0, spin);
    let mut angle = 0.0;
    for _ in 0..(3.0 * rate) as usize {
        world.step();
        angle += world.bodies[body].angvel().y / rate;
    }
    let place = world.bodies[body].translation();
    [place.x.hypot(place.z), angle]
}

fn travels() {
    // Exact: the law integrated over the uniform square, and over the disk (tribos_core::slider).
    let boxes = [
        (0.0, 0.1667),
        (5.0, 0.1702),
        (12.5, 0.1898),
        (25.0, 0.2591),
        (50.0, 0.4413),
    ];
    let square = || ColliderBuilder::cuboid(HALF, LOW, HALF);
    println!("\n## Travel of a box of half side 5 cm, m (error)\n");
    print!("| model | steps/s |");
    boxes
        .iter()
        .for_each(|(spin, exact)| print!(" {spin} rad/s, exact {exact} |"));
    println!("\n|---|---|---|---|---|---|---|");
    for rate in [60.0, 240.0] {
        for (name, model) in models() {
            print!("| {name} | {rate} |");
            for (spin, exact) in boxes {
                let [travel, _] = thrown(square(), LOW, model, rate, spin);
                print!(" {travel:.4} ({:+.1} %) |", 100.0 * (travel / exact - 1.0));
            }
            println!();
        }
    }
    let turned = [(5.0, 1.13), (12.5, 2.92), (25.0, 6.64), (50.0, 20.31)];
    println!("\n## Angle to rest of the same box, rad, 240 steps/s\n");
    for (name, model) in models() {
        print!("| {name} |");
        for (spin, exact) in turned {
            let [_, angle] = thrown(square(), LOW, model, 240.0, spin);
            print!(" {angle:.2} of {exact} |");
        }
        println!();
    }
    // By 384 cells of a disk in steps of 0.2 ms.
    let disks = [
        (0.0, 0.1667),
        (5.0, 0.1693),
        (12.5, 0.1838),
        (25.0, 0.2385),
        (50.0, 0.3918),
    ];
    println!("\n## Travel of a cylinder of radius 5 cm, m, 240 steps/s\n");
    for (name, model) in models() {
        print!("| {name} |");
        for (spin, exact) in disks {
            let [travel, _] = thrown(
                ColliderBuilder::cylinder(LOW, HALF),
                LOW,
                model,
                240.0,
                spin,
            );
            print!(" {travel:.4} of {exact} |");
        }
        println!();
    }
}

fn rests() {
    println!(
        "\n## Slopes by their share of the friction angle: travel in 4 s, m, and angle, rad; 60 steps/s\n"
    );
    for (name, model) in models() {
        print!("| {name} |");
        for share in [0.95, 0.99, 1.01, 1.05] {
            let mut world = world(model, 60.0, share * MU);
            let body = flat(
                ColliderBuilder::cuboid(HALF, HALF, HALF),
                HALF,
                &mut world,
                0.0,
                0.0,
            );
            steps(&mut world, 4.0);
            let body = &world.bodies[body];
            let turned = body.rotation().y.abs() * 2.0;
            print!(" {share}: {:.1e} m, {turned:.1e} |", body.translation().x);
        }
        println!();
    }
    println!(
        "\n## Stack of ten boxes, each turned by 0.1 rad and shifted by 2 % of its side; 10 s: drift of the top, m, and angle, rad\n"
    );
    for (name, model) in models() {
        let mut world = world(model, 60.0, 0.0);
        let mut top = RigidBodyHandle::invalid();
        let half = 0.5;
        for k in 0..10 {
            let body = RigidBodyBuilder::dynamic()
                .translation(Vector::new(
                    0.02 * (k % 2) as f32,
                    half + 2.0 * half * k as f32,
                    0.0,
                ))
                .rotation(Vector::new(0.0, 0.1 * k as f32, 0.0))
                .can_sleep(false);
            top = world
                .insert(
                    body,
                    ColliderBuilder::cuboid(half, half, half).friction(0.6),
                )
                .0;
        }
        let start = *world.bodies[top].position();
        steps(&mut world, 10.0);
        let end = world.bodies[top].position();
        let way = end.translation - start.translation;
        let turned = (end.rotation * start.rotation.inverse()).to_scaled_axis().y;
        println!("| {name} | {:.2e} | {turned:.1e} |", way.x.hypot(way.z));
    }
}

/// Time of the fastest of many steps of 196 boxes that slide and spin, or rest.
fn cost(model: FrictionModel, speed: f32, spin: f32) -> Duration {
    let mut world = world(model, 60.0, 0.0);
    for k in 0..196 {
        let body = flat(
            ColliderBuilder::cuboid(HALF, LOW, HALF),
            LOW,
            &mut world,
            speed,
            spin,
        );
        let place = Vector::new((k % 14) as f32 - 7.0, LOW, (k / 14) as f32 - 7.0);
        world.bodies[body].set_translation(place, true);
    }
    steps(&mut world, 0.1);
    let time = |_| {
        let start = Instant::now();
        world.step();
        start.elapsed()
    };
    (0..25).map(time).min().unwrap_or_default()
}

fn costs() {
    println!(
        "\n## Microseconds of the fastest step of 196 boxes, best of 7 rounds in turns: all sliding and spinning, all at rest\n"
    );
    let mut best = vec![[Duration::MAX; 2]; models().len()];
    for _ in 0..7 {
        for (best, (_, model)) in best.iter_mut().zip(models()) {
            best[0] = best[0].min(cost(model, 3.0, 30.0));
            best[1] = best[1].min(cost(model, 0.0, 0.0));
        }
    }
    for ([slides, rests], (name, _)) in best.iter().zip(models()) {
        println!(
            "| {name} | {} | {} |",
            slides.as_micros(),
            rests.as_micros()
        );
    }
}

fn main() {
    travels();
    rests();
    costs();
}
