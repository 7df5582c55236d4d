//! Bodies that friction holds.

use crate::exact::assert_gains;
use crate::table::*;
use avian3d::prelude::*;
use bevy::prelude::*;
use tribos_bevy::FrictionPatch;

const STEPS: usize = 1500;
/// How far rounding of the contact's normal moves a body in these steps, in metres.
const ROUNDING: f32 = 1e-9;
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
    assert!(place.x.hypot(place.z) < ROUNDING, "{place} m");
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
    let way = table.place(puck) - settled;
    assert!(way.x.hypot(way.z) < ROUNDING, "{way} m");
    assert!(table.friction(puck).holds);
}

#[test]
fn a_puck_on_a_turned_table_creeps_less_than_ten_nanometres() {
    let angle = 0.9 * MU.atan();
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
    assert!(way < 1e-8, "{way} m");
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
    let time = SETTLED as f32 / STEPS_A_SECOND;
    assert_gains(gained, [gravity.x, -MU * gravity.y], time);
}

#[test]
fn a_box_on_a_slope_is_held() {
    let mut table = Table::turned(Quat::IDENTITY, tilted(0.9));
    let half = 0.1;
    let body = table.app.world_mut().spawn((
        RigidBody::Dynamic,
        Collider::cuboid(0.2, 0.2, 0.2),
        SleepingDisabled,
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
    let way = table.place(body) - settled;
    assert!(way.x.hypot(way.z) < ROUNDING, "{way} m");
}

#[test]
fn a_sleeping_puck_keeps_its_friction_and_wakes() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, 0.0);
    let world = table.app.world_mut();
    world.entity_mut(puck).remove::<SleepingDisabled>();
    table.give(puck, disk(MU));
    table.steps(120);
    assert!(table.app.world().entity(puck).contains::<Sleeping>());
    assert!(table.friction(puck).holds);
    let start = table.place(puck);
    let mut puck_mut = table.app.world_mut().entity_mut(puck);
    puck_mut
        .insert(LinearVelocity(Vec3::X))
        .remove::<Sleeping>();
    table.steps(120);
    let travel = table.place(puck).x - start.x;
    let exact = 0.5 / (MU * GRAVITY);
    assert!(
        (travel / exact - 1.0).abs() < 2e-2,
        "{travel} m for {exact} m"
    );
}
