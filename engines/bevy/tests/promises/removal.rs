//! Patches and bodies that are removed while they slide.

use crate::exact::answer;
use crate::table::*;
use avian3d::prelude::*;
use bevy::prelude::*;
use tribos_bevy::{FrictionPatch, PatchFriction};

/// Deceleration in the next steps.
fn deceleration(table: &mut Table, puck: Entity, steps: usize) -> f32 {
    let before = table.velocity(puck)[0].length();
    table.steps(steps);
    let after = table.velocity(puck)[0].length();
    (before - after) * STEPS_A_SECOND / steps as f32
}

#[test]
fn without_its_patch_a_puck_has_the_friction_of_the_engine() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, 10.0);
    table.give(puck, disk(0.0));
    table.steps(4);
    let smooth = deceleration(&mut table, puck, 4);
    assert!(smooth.abs() < 1e-4, "{smooth} m/s²");
    table
        .app
        .world_mut()
        .entity_mut(puck)
        .remove::<FrictionPatch>();
    table.steps(2);
    assert_eq!(table.friction(puck), PatchFriction::default());
    let rough = deceleration(&mut table, puck, 4);
    assert!(rough > 0.5 * MU * GRAVITY, "{rough} m/s²");
    table.give(puck, disk(0.0));
    table.steps(1);
    let smooth = deceleration(&mut table, puck, 4);
    assert!(smooth.abs() < 1e-4, "{smooth} m/s²");
}

#[test]
fn a_body_that_is_removed_leaves_the_others_alone() {
    let mut table = Table::level();
    let [gone, stays] = [-1.0, 1.0].map(|z| {
        let puck = table.puck(Vec3::Z * z, Vec3::X, 25.0);
        table.give(puck, disk(MU));
        puck
    });
    table.steps(8);
    table.app.world_mut().entity_mut(gone).despawn();
    table.steps(120);
    let exact = answer("puck", 25.0).travel;
    let travel = f64::from(table.place(stays).x);
    assert!(
        (travel / exact - 1.0).abs() < 3e-3,
        "{travel} m for {exact} m"
    );
}

#[test]
fn a_puck_falls_when_its_table_is_removed() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, 20.0);
    table.give(puck, disk(MU));
    table.steps(8);
    table.app.world_mut().entity_mut(table.ground).despawn();
    table.steps(2);
    assert_eq!(table.friction(puck), PatchFriction::default());
    let [before, _] = table.velocity(puck);
    table.steps(30);
    let [after, _] = table.velocity(puck);
    assert_eq!(after.x, before.x);
    assert!(after.y < before.y - 4.0);
}

#[test]
fn a_body_that_becomes_static_stops_without_a_patch() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, 20.0);
    table.give(puck, disk(MU));
    table.steps(8);
    table
        .app
        .world_mut()
        .entity_mut(puck)
        .insert(RigidBody::Static);
    table.steps(8);
    assert_eq!(table.friction(puck), PatchFriction::default());
}
