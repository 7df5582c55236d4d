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

/// How a floor moves: its rotation and its displacement along x at a time, in rad and m.
type Motion = fn(f32, f32) -> [f32; 3];

/// A turntable on which a puck at `REACH` needs `share` of its friction.
fn turning(share: f32, time: f32) -> [f32; 3] {
    [(share * MU * GRAVITY / REACH).sqrt() * time, 0.0, 0.0]
}

/// A table that rocks about z by `share` of the angle of friction.
fn rocking(share: f32, time: f32) -> [f32; 3] {
    [0.0, (share * MU).atan() * time.sin(), 0.0]
}

/// A table that is shaken along x, with `share` of the acceleration that friction gives.
fn shaken(share: f32, time: f32) -> [f32; 3] {
    const RATE: f32 = 6.0;
    [
        0.0,
        0.0,
        share * MU * GRAVITY / (RATE * RATE) * ((RATE * time).sin()),
    ]
}

/// Largest distance in metres, within 60 s, of a held puck from its place on a floor.
fn strayed(motion: Motion, share: f32) -> f32 {
    const RATE: u32 = 60;
    let ground =
        RigidBodyBuilder::kinematic_velocity_based().translation(Vector::new(0.0, -0.1, 0.0));
    let mut table = Table::on(ground, Vector::new(0.0, -GRAVITY, 0.0));
    let dt = 1.0 / RATE as f32;
    table.world.integration_parameters.dt = dt;
    let speed = |step: u32| {
        let [now, next] = [step, step + 1].map(|n| motion(share, n as f32 * dt));
        [0, 1, 2].map(|i| (next[i] - now[i]) / dt)
    };
    let [turn, tilt, along] = speed(0);
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(REACH, HALF_HEIGHT, 0.0))
        .linvel(Vector::new(along, tilt * REACH, -turn * REACH))
        .angvel(Vector::new(0.0, turn, tilt));
    let (body, _) = table.put(body, puck_shape(), disk());
    let floor = table.world.colliders[table.ground].parent().unwrap();
    let mut places = (0..60 * RATE).map(|step| {
        let [turn, tilt, along] = speed(step);
        let under = &mut table.world.bodies[floor];
        under.set_linvel(Vector::new(along, 0.0, 0.0), true);
        under.set_angvel(Vector::new(0.0, turn, tilt), true);
        table.steps(1);
        let pose = table.world.colliders[table.ground].position();
        pose.inverse_transform_point(table.world.bodies[body].translation())
    });
    // It settles on its contacts within the first steps.
    let first = places.nth(5).unwrap();
    let away = places.map(|place| (place.x - first.x).hypot(place.z - first.z));
    away.fold(0.0, f32::max)
}

#[test]
fn a_held_puck_keeps_its_place_on_a_floor_that_moves() {
    let floors = [
        ("turning", turning as Motion, 1e-5),
        ("rocking", rocking, 1e-4),
        ("shaken", shaken, 1e-5),
    ];
    for (name, motion, most) in floors {
        for share in [0.5, 0.95] {
            let away = strayed(motion, share);
            println!("{name} at {share} of what holds: {away:.1e} m in a minute");
            assert!(away < most, "{name}, {share}: {away:e} m");
        }
    }
}
