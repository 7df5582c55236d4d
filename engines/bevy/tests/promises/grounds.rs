//! Grounds that move, and contacts that are not the patch's.

use crate::table::*;
use avian3d::prelude::*;
use bevy::prelude::*;

#[test]
fn a_turntable_carries_a_puck() {
    let spin = 2.0;
    // Held up to 0.75 of its friction.
    let radius = 0.75 * MU * GRAVITY / (spin * spin);
    let body = (RigidBody::Kinematic, AngularVelocity(Vec3::Y * spin));
    let mut table = Table::on(body, Quat::IDENTITY, Vec3::NEG_Y * GRAVITY);
    let puck = table.puck(Vec3::X * radius, Vec3::NEG_Z * (spin * radius), spin);
    table.give(puck, disk(MU));
    let turn = std::f32::consts::TAU / spin;
    table.steps((turn * STEPS_A_SECOND) as usize);
    let place = table.place(puck);
    let now = place.x.hypot(place.z);
    assert!((now / radius - 1.0).abs() < 1e-3, "{now} m from {radius} m");
    assert!(table.friction(puck).holds);
    let force = table.friction(puck).force.length() / table.friction(puck).load;
    assert!((force / (0.75 * MU) - 1.0).abs() < 1e-2, "{force}");
}

#[test]
fn a_plank_is_dragged_along() {
    let mut table = Table::level();
    table
        .app
        .world_mut()
        .entity_mut(table.ground)
        .insert(Friction::new(0.0));
    let plank = table.app.world_mut().spawn((
        RigidBody::Dynamic,
        Collider::cuboid(2.0, 0.1, 2.0),
        Friction::new(0.0).with_combine_rule(CoefficientCombine::Min),
        Mass(3.0),
        SleepingDisabled,
        Transform::from_xyz(0.0, 0.05, 0.0),
    ));
    let plank = plank.id();
    let puck = table.puck(Vec3::Y * 0.1, Vec3::X, 10.0);
    table.app.world_mut().entity_mut(puck).insert(Mass(1.0));
    table.give(puck, disk(MU));
    table.steps(90);
    let [of_puck, of_plank] = [puck, plank].map(|body| table.velocity(body)[0].x);
    assert!((of_puck - 0.25).abs() < 1e-3, "puck {of_puck} m/s");
    assert!((of_plank - 0.25).abs() < 1e-3, "plank {of_plank} m/s");
    assert!(table.friction(puck).holds);
}

#[test]
fn a_rim_keeps_the_friction_of_the_engine() {
    let spin = |friction: f32| {
        let mut table = Table::level();
        table.app.world_mut().spawn((
            RigidBody::Static,
            Collider::cuboid(0.2, 0.4, 4.0),
            Friction::new(friction).with_combine_rule(CoefficientCombine::Max),
            Transform::from_xyz(0.3, 0.2, 0.0),
        ));
        let puck = table.puck(Vec3::ZERO, Vec3::X * 2.0, 20.0);
        let smooth = Friction::new(0.0);
        table.app.world_mut().entity_mut(puck).insert(smooth);
        table.give(puck, disk(0.0));
        table.steps(30);
        table.velocity(puck)[1].y
    };
    assert!((spin(0.0) - 20.0).abs() < 0.1);
    assert!(spin(0.5) < 15.0);
}
