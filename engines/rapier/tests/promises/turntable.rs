//! Grounds that are driven.

use crate::table::*;
use rapier3d::prelude::*;

const REACH: f32 = 0.3;

/// Radius, and angle against the table, of a puck after one turn of a table on which it needs `share`
/// of its friction to stay.
fn after_a_turn(share: f32) -> [f32; 2] {
    let rate = (share * MU * GRAVITY / REACH).sqrt();
    let ground = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::new(0.0, -0.1, 0.0))
        .angvel(Vector::new(0.0, rate, 0.0));
    let mut table = Table::on(ground, Vector::new(0.0, -GRAVITY, 0.0));
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(REACH, HALF_HEIGHT, 0.0))
        .linvel(Vector::new(0.0, 0.0, -rate * REACH))
        .angvel(Vector::new(0.0, rate, 0.0));
    let (body, _) = table.put(body, puck_shape(), disk());
    let dt = table.world.integration_parameters.dt;
    table.steps((core::f32::consts::TAU / (rate * dt)) as usize);
    let ground = table.world.colliders[table.ground].position();
    let place = ground.inverse_transform_point(table.world.bodies[body].translation());
    [place.x.hypot(place.z), place.z.atan2(place.x)]
}

#[test]
fn a_puck_below_the_slip_radius_turns_with_the_table() {
    for share in [0.1, 0.5, 0.9] {
        let [radius, angle] = after_a_turn(share);
        println!("{share} of friction: radius {radius} m, angle {angle:.1e} rad after a turn");
        assert!((radius / REACH - 1.0).abs() < 5e-3, "{share}: {radius} m");
        assert!(angle.abs() < 5e-3, "{share}: {angle} rad");
    }
}

#[test]
fn a_puck_beyond_the_slip_radius_leaves() {
    let [radius, _] = after_a_turn(1.2);
    assert!(radius > 1.5 * REACH, "{radius} m");
}

#[test]
fn a_conveyor_takes_a_puck_along() {
    let ground = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::new(0.0, -0.1, 0.0))
        .linvel(Vector::new(0.5, 0.0, 0.0));
    let mut table = Table::on(ground, Vector::new(0.0, -GRAVITY, 0.0));
    let (body, foot) = table.put(lying(HALF_HEIGHT), puck_shape(), disk());
    table.steps(60);
    assert_eq!(table.world.bodies[body].linvel().x, 0.5);
    assert!(table.patches.friction(foot, table.ground).unwrap().holds);
    // It slides until v = mu g t: half of that way is lost.
    let lost = 0.5 * 0.5 * 0.5 / (MU * GRAVITY);
    let way = table.world.bodies[body].translation().x;
    assert!((way - (0.5 - lost)).abs() < 1e-3, "{way} m");
}
