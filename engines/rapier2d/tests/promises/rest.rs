//! At rest nothing creeps.

use crate::exact::assert_gains;
use crate::game::*;
use rapier2d::prelude::*;

/// Distance and angle of a body after 10,000 steps at `share` of its friction limit.
fn crept(share: f32, shape: ColliderBuilder) -> [f32; 2] {
    let mut game = Game::inclined(share * MU * GRAVITY);
    let body = game.put(RigidBodyBuilder::dynamic().rotation(0.3), shape);
    let start = *game.world.bodies[body].position();
    game.steps(10_000);
    let end = game.world.bodies[body].position();
    let turned = end.rotation.angle() - start.rotation.angle();
    [(end.translation - start.translation).length(), turned.abs()]
}

#[test]
fn a_slope_just_below_the_friction_angle_holds_to_the_last_bit() {
    for share in [0.0, 0.5, 0.99] {
        for shape in [disk(), ColliderBuilder::cuboid(0.1, 0.05)] {
            assert_eq!(crept(share, shape), [0.0, 0.0], "{share}");
        }
    }
}

#[test]
fn a_slope_just_above_the_friction_angle_slides() {
    let mut game = Game::inclined(1.01 * MU * GRAVITY);
    let body = game.put(RigidBodyBuilder::dynamic(), disk());
    game.steps(60);
    let gained = game.world.bodies[body].linvel().x;
    assert_gains(gained, [1.01 * MU * GRAVITY, MU * GRAVITY], 1.0);
}

#[test]
fn a_push_and_a_torque_are_held_up_to_the_limit() {
    let mut game = Game::level();
    let body = game.put(RigidBodyBuilder::dynamic(), disk());
    let limit = MU * GRAVITY * game.world.bodies[body].mass();
    // The largest torque of a disk is 2/3 of its radius times its largest force.
    let torque = 2.0 / 3.0 * RADIUS * limit;
    for (force, torque, holds) in [
        (0.99 * limit, 0.0, true),
        (0.0, 0.99 * torque, true),
        (0.0, 1.01 * torque, false),
        // Both at 0.8 are beyond: even the ellipsoid carries 0.707 of both.
        (0.8 * limit, 0.8 * torque, false),
    ] {
        let mut trial = Game::level();
        let body = trial.put(RigidBodyBuilder::dynamic(), disk());
        trial.world.bodies[body].add_force(Vector::new(force, 0.0), true);
        trial.world.bodies[body].add_torque(torque, true);
        trial.steps(100);
        let is_at_rest = trial.world.bodies[body].translation() == Vector::ZERO
            && trial.world.bodies[body].rotation().angle() == 0.0;
        assert_eq!(is_at_rest, holds, "{force} N, {torque} N m");
        assert_eq!(trial.floor.friction(body).unwrap().holds, holds);
    }
}

#[test]
fn a_body_at_rest_falls_asleep_and_wakes_by_a_hit() {
    let mut game = Game::level();
    let (rests, _) = game.world.insert(RigidBodyBuilder::dynamic(), disk());
    let hits = RigidBodyBuilder::dynamic().translation(Vector::new(-2.0, 0.0));
    let hits = game.put(hits, disk());
    game.steps(200);
    assert!(game.world.bodies[rests].is_sleeping());
    game.world.bodies[hits].set_linvel(Vector::new(4.5, 0.0), true);
    game.steps(200);
    assert!(game.world.bodies[rests].translation().x > 0.01);
}
