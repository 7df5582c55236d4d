//! Friction on the floor together with the engine's contacts.

use crate::game::*;
use rapier2d::prelude::*;

#[test]
fn a_puck_that_hits_another_hands_on_its_momentum() {
    // Head on and elastic: the first one stops, the second one slides as far as its speed carries it.
    let mut game = Game::level();
    let elastic = || disk().friction(0.0).restitution(1.0);
    let insert = |game: &mut Game, x: f32, v: f32| {
        let body = thrown(v, 0.0)
            .translation(Vector::new(x, 0.0))
            .can_sleep(false);
        game.world.insert(body, elastic()).0
    };
    let speed = 2.0_f32;
    let gap = 0.3_f32;
    let first = insert(&mut game, -gap - 2.0 * RADIUS, speed);
    let second = insert(&mut game, 0.0, 0.0);
    game.steps(300);
    let travel = game.world.bodies[second].translation().x;
    // v²/(2 mu g) in all, of which the first one slides the gap.
    let right = speed * speed / (2.0 * MU * GRAVITY) - gap;
    assert!(
        (travel / right - 1.0).abs() < 0.05,
        "{travel} m for {right} m"
    );
    let left = game.world.bodies[first].translation().x + 2.0 * RADIUS;
    assert!(left.abs() < 0.03, "the first one stopped {left} m away");
    for body in [first, second] {
        assert_eq!(game.world.bodies[body].linvel(), Vector::ZERO);
    }
}

#[test]
fn a_puck_pressed_against_a_wall_stays() {
    let mut game = Game::inclined(2.0 * MU * GRAVITY);
    let wall = ColliderBuilder::cuboid(0.1, 1.0).translation(Vector::new(0.1 + RADIUS, 0.0));
    game.world.insert_collider(wall, None);
    let puck = game.put(RigidBodyBuilder::dynamic(), disk());
    game.steps(120);
    let settled = game.world.bodies[puck].translation();
    game.steps(2000);
    let end = game.world.bodies[puck].translation();
    assert!((end - settled).length() < 1e-5, "crept {:?}", end - settled);
}

#[test]
fn a_row_of_boxes_is_pushed_by_less_than_all_its_friction_and_stays() {
    // A force on the first box that exceeds its own friction and not that of two.
    let mut game = Game::level();
    let boxes: Vec<RigidBodyHandle> = (0..2)
        .map(|i| {
            let at = Vector::new(0.2 * i as f32, 0.0);
            game.put(
                RigidBodyBuilder::dynamic().translation(at),
                ColliderBuilder::cuboid(0.1, 0.1),
            )
        })
        .collect();
    let limit = MU * GRAVITY * game.world.bodies[boxes[0]].mass();
    game.world.bodies[boxes[0]].add_force(Vector::new(1.5 * limit, 0.0), true);
    game.steps(60);
    let settled = game.world.bodies[boxes[0]].translation().x;
    game.steps(600);
    let crept = game.world.bodies[boxes[0]].translation().x - settled;
    println!("crept {crept:.1e} m in ten seconds");
    assert!(crept.abs() < 1e-3, "crept {crept} m");
    // Beyond that of two they move with the force that is left.
    game.world.bodies[boxes[0]].reset_forces(true);
    game.world.bodies[boxes[0]].add_force(Vector::new(2.5 * limit, 0.0), true);
    game.steps(60);
    let speed = game.world.bodies[boxes[1]].linvel().x;
    let right = 0.25 * MU * GRAVITY;
    assert!(
        (speed / right - 1.0).abs() < 0.05,
        "{speed} m/s for {right}"
    );
}
