//! State that is put aside and taken up again: the same bits.

use crate::game::*;
use rapier2d::prelude::*;
use tribos_rapier2d::Floor;

/// The bits of all places and motions after 120 steps of a small game, with the floor put through `saved` after
/// each tenth of them.
fn played(saved: impl Fn(Floor) -> Floor) -> Vec<u32> {
    let mut game = Game::level();
    let ice = SharedShape::ball(0.4);
    game.floor
        .add_region(ice, Pose::translation(0.5, 0.0), 0.02)
        .unwrap();
    for k in 0..6 {
        let at = Vector::new(-0.3, 0.25 * k as f32 - 0.6);
        let body = thrown(1.5, 4.0 * k as f32).translation(at);
        let shape = if k % 2 == 0 {
            disk()
        } else {
            ColliderBuilder::cuboid(0.08, 0.06)
        };
        game.put(body, shape);
    }
    let wall = ColliderBuilder::cuboid(0.1, 2.0).translation(Vector::new(0.9, 0.0));
    game.world.insert_collider(wall, None);
    // At rest under a push.
    let held = game.put(
        RigidBodyBuilder::dynamic().translation(Vector::new(-2.0, 0.0)),
        disk(),
    );
    let push = 0.5 * MU * GRAVITY * game.world.bodies[held].mass();
    game.world.bodies[held].add_force(Vector::new(push, 0.0), true);
    for step in 0..120 {
        if step % 10 == 9 {
            game.floor = saved(game.floor);
        }
        game.steps(1);
    }
    let numbers = |(_, body): (RigidBodyHandle, &RigidBody)| {
        let (v, x) = (body.linvel(), body.translation());
        [v.x, v.y, body.angvel(), x.x, x.y].map(f32::to_bits)
    };
    game.world.bodies.iter().flat_map(numbers).collect()
}

#[test]
fn the_same_game_has_the_same_bits() {
    assert_eq!(played(|floor| floor), played(|floor| floor));
}

#[test]
fn a_clone_goes_on_to_the_same_bits() {
    assert_eq!(played(|floor| floor.clone()), played(|floor| floor));
}

#[cfg(feature = "serde-serialize")]
#[test]
fn what_was_serialised_goes_on_to_the_same_bits() {
    let through_text = |floor: Floor| {
        let text = serde_json::to_string(&floor).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    assert_eq!(played(through_text), played(|floor| floor));
}

#[cfg(feature = "serde-serialize")]
#[test]
fn a_floor_restored_in_the_middle_of_a_step_takes_back_what_was_lent() {
    let mut game = Game::level();
    let body = game.put(thrown(1.0, 5.0), disk());
    let parameters = game.world.integration_parameters;
    let world = &mut game.world;
    game.floor.begin_step(
        world.gravity,
        &parameters,
        &mut world.bodies,
        &world.colliders,
    );
    let text = serde_json::to_string(&game.floor).unwrap();
    let mut restored: Floor = serde_json::from_str(&text).unwrap();
    world.step();
    restored.finish_step(&parameters, &mut world.bodies);
    assert_eq!(world.bodies[body].user_force(), Vector::ZERO);
}
