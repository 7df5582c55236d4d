//! What else the engine knows: sleep, sensors, removals, locks, grounds without body.

use crate::table::*;
use rapier3d::prelude::*;
use tribos_rapier::Patch;

fn sliding() -> RigidBodyBuilder {
    lying(HALF_HEIGHT).linvel(Vector::new(1.0, 0.0, 0.0))
}

#[test]
fn a_puck_at_rest_falls_asleep_and_wakes() {
    let mut table = Table::level();
    let (body, foot) = table.world.insert(sliding(), puck_shape());
    table.give(foot, disk().unwrap());
    table.steps(600);
    let body_now = &table.world.bodies[body];
    assert!(body_now.is_sleeping());
    assert_eq!(body_now.linvel(), Vector::ZERO);
    assert_eq!(body_now.user_force(), Vector::ZERO);
    let start = body_now.translation().x;
    table.world.bodies[body].set_linvel(Vector::X, true);
    table.steps(120);
    let way = table.world.bodies[body].translation().x - start;
    let right = 0.5 / (MU * GRAVITY);
    assert!((way / right - 1.0).abs() < 5e-3, "{way} m for {right} m");
}

#[test]
fn a_removed_body_takes_its_pair_along() {
    let mut table = Table::level();
    let (body, _) = table.put(sliding(), puck_shape(), disk());
    let (other, _) = table.put(
        RigidBodyBuilder::dynamic().translation(Vector::new(0.0, HALF_HEIGHT, 1.0)),
        puck_shape(),
        ring(),
    );
    table.steps(5);
    table.world.remove_body(body);
    table.steps(5);
    assert_eq!(table.patches.len(), 1);
    table.world.remove_body(other);
    let ground = table.ground;
    table.world.remove_collider(ground);
    table.steps(1);
    assert!(table.patches.is_empty());
}

#[test]
fn a_sensor_and_a_disabled_body_feel_nothing() {
    let mut table = Table::level();
    table.world.gravity = Vector::ZERO;
    let (body, _) = table.put(sliding(), puck_shape().sensor(true), disk());
    table.steps(30);
    assert_eq!(table.world.bodies[body].linvel().x, 1.0);

    let mut table = Table::level();
    let (body, _) = table.put(sliding(), puck_shape(), disk());
    table.steps(5);
    let before = table.world.bodies[body].linvel();
    table.world.bodies[body].set_enabled(false);
    table.steps(5);
    assert_eq!(table.world.bodies[body].linvel(), before);
    assert_eq!(table.world.bodies[body].user_force(), Vector::ZERO);
}

#[test]
fn a_ground_without_body_brakes() {
    let mut world = PhysicsWorld::new();
    let top = ColliderBuilder::cuboid(5.0, 0.1, 5.0).translation(Vector::new(0.0, -0.1, 0.0));
    let ground = world.insert_collider(top, None);
    let mut table = Table {
        world,
        patches: Default::default(),
        ground,
    };
    let (body, _) = table.put(sliding(), puck_shape(), disk());
    table.steps(60);
    let way = table.world.bodies[body].translation().x;
    let right = 0.5 / (MU * GRAVITY);
    assert!((way / right - 1.0).abs() < 5e-3, "{way} m for {right} m");
}

#[test]
fn a_body_that_cannot_turn_is_braked_all_the_same() {
    let mut table = Table::level();
    let (body, _) = table.put(sliding().lock_rotations(), puck_shape(), disk());
    table.steps(60);
    let way = table.world.bodies[body].translation().x;
    let right = 0.5 / (MU * GRAVITY);
    assert!((way / right - 1.0).abs() < 5e-3, "{way} m for {right} m");
    assert_eq!(table.world.bodies[body].linvel().x, 0.0);
}

#[test]
fn a_body_that_cannot_shift_is_spun_down() {
    let mut table = Table::level();
    let spinning = lying(HALF_HEIGHT)
        .angvel(Vector::new(0.0, 10.0, 0.0))
        .enabled_translations(false, true, false);
    let (body, foot) = table.put(spinning, puck_shape(), disk());
    // Torque 2/3 mu N R, inertia M R²/2.
    let right = 10.0 * 0.75 * RADIUS / (MU * GRAVITY);
    let dt = table.world.integration_parameters.dt;
    let stop = (0..60).find_map(|step| {
        table.steps(1);
        let end = table.patches.stop(foot, table.ground)?;
        Some(step as f32 * dt + end.within_step)
    });
    let stop = stop.expect("it stops");
    assert!((stop / right - 1.0).abs() < 5e-3, "{stop} s for {right} s");
    assert_eq!(table.world.bodies[body].translation().x, 0.0);
}

#[test]
fn a_foot_of_several_parts_and_several_feet_are_braked() {
    let mut table = Table::level();
    let half = Vector::new(0.04, HALF_HEIGHT, 0.04);
    let part = |x: f32| {
        (
            Pose::from_translation(Vector::new(x, 0.0, 0.0)),
            SharedShape::cuboid(half.x, half.y, half.z),
        )
    };
    let compound = ColliderBuilder::compound(vec![part(-0.06), part(0.06)]);
    let (body, _) = table.put(sliding(), compound, disk());
    let (pair, left) = table.put(
        sliding().translation(Vector::new(0.0, HALF_HEIGHT, 1.0)),
        ColliderBuilder::cuboid(half.x, half.y, half.z).translation(Vector::new(0.0, 0.0, -0.05)),
        disk(),
    );
    let right =
        ColliderBuilder::cuboid(half.x, half.y, half.z).translation(Vector::new(0.0, 0.0, 0.05));
    let right = table.world.insert_collider(right, Some(pair));
    let ground = table.ground;
    table.give(right, Patch::disk(MU, RADIUS).unwrap());
    table.steps(60);
    let exact = 0.5 / (MU * GRAVITY);
    for (name, body) in [("parts", body), ("feet", pair)] {
        let body = &table.world.bodies[body];
        let way = body.translation().x;
        assert!(
            (way / exact - 1.0).abs() < 0.01,
            "{name}: {way} m for {exact} m"
        );
        assert!(body.linvel().length() < 1e-3, "{name}: {:?}", body.linvel());
    }
    assert!(table.patches.remove(left, ground) && !table.patches.remove(left, ground));
}

#[test]
fn a_bounce_on_landing_takes_friction_and_gives_no_energy() {
    let mut table = Table::level();
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, 0.3, 0.0))
        .linvel(Vector::new(2.0, 0.0, 0.0))
        .angvel(Vector::new(0.0, 5.0, 0.0));
    let (body, _) = table.put(body, puck_shape().restitution(0.6), disk());
    let energy = |table: &Table| {
        let body = &table.world.bodies[body];
        body.kinetic_energy() + body.mass() * GRAVITY * body.translation().y
    };
    let start = energy(&table);
    let mut speed = 2.0;
    for _ in 0..240 {
        table.steps(1);
        let now = table.world.bodies[body].linvel().x;
        assert!(
            now <= speed + 1e-4,
            "friction does not push: {now} after {speed} m/s"
        );
        speed = now;
        assert!(energy(&table) < 1.01 * start);
    }
    // It may lie a rounding error askew.
    assert!(speed.abs() < 1e-12, "{speed} m/s");
}

#[test]
fn a_free_ground_takes_the_momentum() {
    let raft = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, -0.1, 0.0))
        .enabled_translations(true, false, true)
        .enabled_rotations(false, true, false)
        .can_sleep(false);
    let mut table = Table::on(raft, Vector::new(0.0, -GRAVITY, 0.0));
    let raft = table.world.colliders[table.ground].parent().unwrap();
    table.world.colliders[table.ground].set_mass(1.0);
    let (puck, foot) = table.put(sliding(), puck_shape().mass(0.5), disk());
    table.steps(60);
    let [v, w] = [puck, raft].map(|body| table.world.bodies[body].linvel().x);
    assert!(table.patches.friction(foot, table.ground).unwrap().holds);
    assert_eq!(v, w);
    assert!((v - 1.0 / 3.0).abs() < 1e-4, "{v} m/s");
}

#[test]
fn steps_of_no_length_and_odd_states_do_not_panic() {
    let mut table = Table::level();
    let (body, _) = table.put(sliding(), puck_shape(), disk());
    table.steps(3);
    table.world.integration_parameters.dt = 0.0;
    table.steps(2);
    table.world.integration_parameters.dt = 1.0 / 60.0;
    table.world.bodies[body].set_linvel(Vector::new(f32::NAN, 0.0, 0.0), true);
    table.steps(3);
}
