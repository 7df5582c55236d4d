//! Pushes below and above what friction carries, and pucks that hit each other.

use crate::table::*;
use rapier3d::prelude::*;

#[test]
fn a_force_below_the_threshold_moves_nothing() {
    let mut table = Table::level();
    let (body, foot) = table.put(lying(HALF_HEIGHT), puck_shape(), disk());
    table.steps(60);
    let start = *table.world.bodies[body].position();
    let limit = MU * table.world.bodies[body].mass() * GRAVITY;
    let push = Vector::new(0.6, 0.0, 0.8) * (0.98 * limit);
    table.world.bodies[body].add_force(push, true);
    table.steps(300);
    let friction = table.patches.friction(foot, table.ground).unwrap();
    assert!(friction.holds);
    assert!(
        (friction.force + push).length() < 1e-5 * limit,
        "{friction:?}"
    );
    let body = &table.world.bodies[body];
    assert_eq!(body.user_force(), push, "the user's force is the user's");
    let way = body.translation() - start.translation;
    assert!(way.x.hypot(way.z) < 1e-6, "{way:?}");
}

#[test]
fn a_force_above_the_threshold_accelerates() {
    let mut table = Table::level();
    let (body, _) = table.put(lying(HALF_HEIGHT), puck_shape(), disk());
    table.steps(60);
    let limit = MU * table.world.bodies[body].mass() * GRAVITY;
    table.world.bodies[body].add_force(Vector::X * (1.1 * limit), true);
    table.steps(60);
    let speed = table.world.bodies[body].linvel().x;
    let right = 0.1 * MU * GRAVITY;
    assert!(
        (speed / right - 1.0).abs() < 0.01,
        "{speed} m/s for {right}"
    );
}

/// A slippery block that is pressed against a puck with a `share` of what friction carries; returns
/// how far the puck goes in the first second and in the next, its speed, and what it should be.
fn pushed_by_a_block(share: f32) -> [f32; 4] {
    let mut table = Table::level();
    let (puck, _) = table.put(lying(HALF_HEIGHT), puck_shape(), disk());
    let block = ColliderBuilder::cuboid(0.02, HALF_HEIGHT, 0.05)
        .friction_combine_rule(CoefficientCombineRule::Min);
    let guided = RigidBodyBuilder::dynamic()
        .translation(Vector::new(-RADIUS - 0.02, HALF_HEIGHT, 0.0))
        .enabled_translations(true, true, false)
        .lock_rotations();
    let (block, shape) = table.put(guided, block, None);
    table.world.colliders[shape].set_friction(0.0);
    table.steps(60);
    let place = |table: &Table| table.world.bodies[puck].translation().x;
    let [mass, more] = [puck, block].map(|body| table.world.bodies[body].mass());
    let start = place(&table);
    table.world.bodies[block].add_force(Vector::X * (share * MU * mass * GRAVITY), true);
    table.steps(60);
    let halfway = place(&table);
    table.steps(60);
    [
        halfway - start,
        place(&table) - halfway,
        table.world.bodies[puck].linvel().x,
        2.0 * (share - 1.0) * MU * GRAVITY * mass / (mass + more),
    ]
}

#[test]
fn a_body_pushes_a_puck_above_the_threshold_only() {
    let [first, next, speed, _] = pushed_by_a_block(0.9);
    println!("pushed at 90 %: {first:.1e} m in a second, {next:.1e} m in the next");
    // A push that comes anew through a contact is met one step late.
    let dt = 1.0 / 60.0;
    assert!(first.abs() < MU * GRAVITY * dt * dt, "{first} m");
    assert!(next.abs() < 1e-6, "{next} m");
    assert!(speed.abs() < 1e-9, "{speed} m/s");
    let [.., speed, right] = pushed_by_a_block(1.2);
    assert!(
        (speed / right - 1.0).abs() < 0.01,
        "{speed} m/s for {right}"
    );
}

#[test]
fn momentum_is_kept_but_for_friction() {
    let mut table = Table::level();
    let bouncy = || puck_shape().restitution(1.0);
    let put = |table: &mut Table, x: f32, z: f32, v: f32| {
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(x, HALF_HEIGHT, z))
            .linvel(Vector::new(v, 0.0, 0.0))
            .angvel(Vector::new(0.0, 10.0, 0.0));
        table.put(body, bouncy(), disk())
    };
    let pucks = [
        put(&mut table, 0.0, 0.0, 2.0),
        put(&mut table, 0.3, 0.05, 0.0),
    ];
    let dt = table.world.integration_parameters.dt;
    let momentum = |table: &Table| -> Vector {
        let of = |body: RigidBodyHandle| {
            let body = &table.world.bodies[body];
            body.linvel() * body.mass()
        };
        pucks.iter().map(|puck| of(puck.0)).sum()
    };
    let scale = momentum(&table).length();
    for step in 0..30 {
        let before = momentum(&table);
        table.steps(1);
        let friction: Vector = pucks
            .iter()
            .filter_map(|puck| table.patches.friction(puck.1, table.ground))
            .map(|friction| friction.force * dt)
            .sum();
        let left = momentum(&table) - before - friction;
        assert!(left.x.hypot(left.z) < 1e-5 * scale, "step {step}: {left:?}");
    }
    let struck = table.world.bodies[pucks[1].0].linvel();
    assert!(struck.x > 0.5, "they have met: {struck:?}");
}

#[test]
fn two_runs_have_the_same_bits() {
    let run = || {
        let mut table = Table::level();
        let mut bodies = Vec::new();
        for i in 0..9 {
            let (row, column) = ((i / 3) as f32, (i % 3) as f32);
            let body = RigidBodyBuilder::dynamic()
                .translation(Vector::new(0.17 * row, HALF_HEIGHT, 0.17 * column))
                .linvel(Vector::new(2.0 - row, 0.0, 0.5 - column))
                .angvel(Vector::new(0.0, 3.0 * column - row, 0.0));
            let patch = if i % 2 == 0 { disk() } else { ring() };
            bodies.push(table.put(body, puck_shape(), patch).0);
        }
        table.steps(120);
        let bits = |body: &RigidBodyHandle| {
            let body = &table.world.bodies[*body];
            let [v, w] = [body.linvel(), body.angvel()];
            let pose = body.position();
            let all = [v, w, pose.translation].map(|v| v.to_array().map(f32::to_bits));
            (all, pose.rotation.to_array().map(f32::to_bits))
        };
        bodies.iter().map(bits).collect::<Vec<_>>()
    };
    assert_eq!(run(), run());
}
