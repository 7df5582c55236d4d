//! Bodies that come, go and change.

use crate::game::*;
use rapier2d::prelude::*;

#[test]
fn bodies_removed_between_the_halves_of_a_step_leave_the_others_alone() {
    let mut game = Game::level();
    let gone = game.put(thrown(1.0, 5.0).translation(Vector::new(0.0, 2.0)), disk());
    let stays = game.put(thrown(1.0, 5.0), disk());
    game.steps(3);
    let parameters = game.world.integration_parameters;
    let world = &mut game.world;
    game.floor.begin_step(
        world.gravity,
        &parameters,
        &mut world.bodies,
        &world.colliders,
    );
    assert!(world.bodies[stays].user_force() != Vector::ZERO);
    world.remove_body(gone);
    world.step();
    game.floor.finish_step(&parameters, &mut world.bodies);
    assert_eq!(world.bodies[stays].user_force(), Vector::ZERO);
    let mut alone = Game::level();
    let same = alone.put(thrown(1.0, 5.0), disk());
    alone.steps(4);
    assert_eq!(
        game.world.bodies[stays].linvel(),
        alone.world.bodies[same].linvel()
    );
    assert_eq!(
        game.world.bodies[stays].angvel(),
        alone.world.bodies[same].angvel()
    );
}

#[test]
fn a_step_that_is_not_taken_changes_nothing() {
    let mut game = Game::level();
    let body = game.put(thrown(1.0, 5.0), disk());
    game.world.bodies[body].add_force(Vector::new(0.0, 0.01), true);
    game.steps(2);
    let parameters = game.world.integration_parameters;
    let world = &mut game.world;
    let before = (world.bodies[body].linvel(), world.bodies[body].user_force());
    game.floor.begin_step(
        world.gravity,
        &parameters,
        &mut world.bodies,
        &world.colliders,
    );
    game.floor.cancel_step(&mut world.bodies);
    let (velocity, force) = (world.bodies[body].linvel(), world.bodies[body].user_force());
    assert!((velocity - before.0).length() < 1e-6);
    assert_eq!(force, before.1);
}

#[test]
fn a_shape_exchanged_midway_counts_from_then_on() {
    // Pure spin: the stopping time goes with the mean arm over the inertia, which the shape decides.
    let deceleration = |shape: SharedShape| {
        let mut game = Game::level();
        let body = game.put(thrown(0.0, 50.0), disk());
        game.steps(5);
        let collider = game.world.bodies[body].colliders()[0];
        game.world.colliders[collider].set_shape(shape);
        game.steps(1);
        let before = game.world.bodies[body].angvel();
        game.steps(10);
        (before - game.world.bodies[body].angvel()) * 6.0
    };
    // Disk of radius R: torque 2/3 μ m g R over inertia m R²/2.
    for radius in [0.04, 0.16] {
        let is = deceleration(SharedShape::ball(radius));
        let right = 4.0 / 3.0 * MU * GRAVITY / radius;
        assert!((is / right - 1.0).abs() < 1e-3, "{is} rad/s² for {right}");
    }
}

#[test]
fn sensors_and_disabled_colliders_carry_nothing() {
    let spun = |extra: Option<ColliderBuilder>| {
        let mut game = Game::level();
        let body = game.put(thrown(1.0, 10.0), disk());
        if let Some(extra) = extra {
            game.world.insert_collider(extra.density(0.0), Some(body));
        }
        game.steps(20);
        (
            game.world.bodies[body].linvel(),
            game.world.bodies[body].angvel(),
        )
    };
    let plain = spun(None);
    assert_eq!(spun(Some(ColliderBuilder::ball(1.0).sensor(true))), plain);
    assert_eq!(spun(Some(ColliderBuilder::ball(1.0).enabled(false))), plain);
}

#[test]
fn rounded_shapes_have_the_torque_of_their_area() {
    // Mean arms by brute force over a grid of the exact shape.
    let mean_arm = |inside: &dyn Fn(f64, f64) -> bool| {
        let (mut sum, mut count) = (0.0, 0.0);
        for i in -300..300 {
            for k in -300..300 {
                let [x, y] = [i, k].map(|n| (f64::from(n) + 0.5) * 1e-3);
                if inside(x, y) {
                    sum += x.hypot(y);
                    count += 1.0;
                }
            }
        }
        sum / count
    };
    type Region<'a> = &'a dyn Fn(f64, f64) -> bool;
    let shapes: [(ColliderBuilder, Region); 3] = [
        (ColliderBuilder::capsule_x(0.1, 0.05), &|x, y| {
            (x.abs() - 0.1).max(0.0).hypot(y) <= 0.05
        }),
        (ColliderBuilder::round_cuboid(0.1, 0.05, 0.05), &|x, y| {
            (x.abs() - 0.1).max(0.0).hypot((y.abs() - 0.05).max(0.0)) <= 0.05
        }),
        (ColliderBuilder::ball(0.2), &|x, y| x.hypot(y) <= 0.2),
    ];
    for (shape, inside) in shapes {
        let mut game = Game::level();
        let body = game.put(thrown(0.0, 20.0), shape);
        game.steps(1);
        let torque = game.floor.friction(body).unwrap().torque;
        let weight = GRAVITY * game.world.bodies[body].mass();
        let right = mean_arm(inside) as f32 * MU * weight;
        assert!((-torque / right - 1.0).abs() < 5e-3, "{torque} for {right}");
    }
}
