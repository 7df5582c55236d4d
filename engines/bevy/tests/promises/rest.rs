//! Bodies that friction holds.

use crate::table::*;
use bevy::prelude::*;
use tribos_bevy::FrictionPatch;

const STEPS: usize = 1500;
/// Steps in which a body settles on the ground.
const SETTLED: usize = 60;

/// A gravity that is turned by a fraction of the friction angle.
fn tilted(share: f32) -> Vec3 {
    let angle = share * MU.atan();
    Vec3::new(angle.sin(), -angle.cos(), 0.0) * GRAVITY
}

#[test]
fn a_puck_at_rest_does_not_creep_on_a_level_table() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::ZERO, 0.0);
    table.give(puck, disk(MU));
    table.steps(STEPS);
    let place = table.place(puck);
    assert_eq!([place.x, place.z], [0.0, 0.0]);
    assert!(table.friction(puck).holds);
}

#[test]
fn a_puck_at_rest_does_not_creep_on_a_slope() {
    let mut table = Table::turned(Quat::IDENTITY, tilted(0.99));
    let puck = table.puck(Vec3::ZERO, Vec3::ZERO, 0.0);
    table.give(puck, disk(MU));
    table.steps(SETTLED);
    let settled = table.place(puck);
    table.steps(STEPS);
    let place = table.place(puck);
    assert_eq!([place.x, place.z], [settled.x, settled.z]);
    assert_eq!(table.velocity(puck)[0].x, 0.0);
}

#[test]
fn a_puck_on_a_turned_table_creeps_less_than_a_micrometre() {
    let angle = 0.99 * MU.atan();
    let rotation = Quat::from_rotation_z(-angle);
    let mut table = Table::turned(rotation, Vec3::NEG_Y * GRAVITY);
    let puck = table.puck(Vec3::ZERO, Vec3::ZERO, 0.0);
    let lying = Transform::from_translation(rotation * (Vec3::Y * (0.5 * HEIGHT)));
    let lying = lying.with_rotation(rotation);
    table.app.world_mut().entity_mut(puck).insert(lying);
    table.give(puck, disk(MU));
    table.steps(SETTLED);
    let settled = table.place(puck);
    table.steps(STEPS);
    let way = table.place(puck).distance(settled);
    assert!(way < 1e-6, "{way} m");
    assert!(table.friction(puck).holds);
}

#[test]
fn a_puck_slides_beyond_the_friction_angle() {
    let share = 1.1;
    let gravity = tilted(share);
    let mut table = Table::turned(Quat::IDENTITY, gravity);
    let puck = table.puck(Vec3::ZERO, Vec3::ZERO, 0.0);
    table.give(puck, disk(MU));
    table.steps(SETTLED);
    let before = table.velocity(puck)[0].x;
    table.steps(SETTLED);
    let gained = table.velocity(puck)[0].x - before;
    let acceleration = gravity.x + MU * gravity.y;
    let expected = acceleration * SETTLED as f32 / STEPS_A_SECOND;
    assert!(
        (gained / expected - 1.0).abs() < 1e-2,
        "{gained} for {expected}"
    );
}

#[test]
fn a_box_on_a_slope_is_held() {
    let mut table = Table::turned(Quat::IDENTITY, tilted(0.9));
    let half = 0.1;
    let body = table.app.world_mut().spawn((
        avian3d::prelude::RigidBody::Dynamic,
        avian3d::prelude::Collider::cuboid(0.2, 0.2, 0.2),
        avian3d::prelude::SleepingDisabled,
        Transform::from_xyz(0.0, half, 0.0),
    ));
    let body = body.id();
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    table.give(
        body,
        FrictionPatch::polygon(MU, &corners).expect("a square"),
    );
    table.steps(SETTLED);
    let settled = table.place(body);
    table.steps(STEPS);
    let place = table.place(body);
    assert_eq!([place.x, place.z], [settled.x, settled.z]);
}
