//! At rest nothing creeps.
//!
//! The relative motion is zero to the last bit where the normal is an axis of the world. What is left
//! of creep is how the engine rounds: gravity and the friction against it cancel to rounding within a
//! step, and its normal forces move the puck along the normal and tilt it.

use crate::exact::assert_gains;
use crate::table::*;
use rapier3d::prelude::*;

const STEPS: usize = 10_000;

/// How far a puck creeps along a slope of `tangent`: by gravity, or by the ground turned.
struct Crept {
    /// In the plane, in metres.
    plane: f32,
    /// About the normal, in radians.
    turn: f32,
    /// The fastest relative velocity after any step.
    speed: f32,
}

fn slope(tangent: f32, turns_ground: bool) -> (Table, RigidBodyBuilder, Vector) {
    let angle = tangent.atan();
    let (sin, cos) = angle.sin_cos();
    if turns_ground {
        let rotation = Rotation::from_rotation_z(-angle);
        let table = Table::turned(rotation, Vector::new(0.0, -GRAVITY, 0.0));
        let place = rotation * Vector::new(0.0, HALF_HEIGHT, 0.0);
        let body = RigidBodyBuilder::dynamic().pose(Pose::from_parts(place, rotation));
        (table, body, Vector::new(cos, -sin, 0.0))
    } else {
        let gravity = Vector::new(GRAVITY * sin, -GRAVITY * cos, 0.0);
        let table = Table::turned(Rotation::IDENTITY, gravity);
        (table, lying(HALF_HEIGHT), Vector::X)
    }
}

fn creep(tangent: f32, turns_ground: bool, with_patch: bool) -> Crept {
    let (mut table, body, down) = slope(tangent, turns_ground);
    let patch = disk().filter(|_| with_patch);
    let (body, _) = table.put(body, puck_shape(), patch);
    // The engine's contacts settle first.
    table.steps(120);
    let normal = down.cross(Vector::NEG_Z).normalize();
    let across = normal.cross(down);
    let start = *table.world.bodies[body].position();
    let mut speed = 0.0_f32;
    for _ in 0..STEPS {
        table.steps(1);
        let v = table.world.bodies[body].linvel();
        speed = speed.max(v.dot(down).hypot(v.dot(across)));
    }
    let end = table.world.bodies[body].position();
    let way = end.translation - start.translation;
    let turn = (end.rotation * start.rotation.inverse()).to_scaled_axis();
    Crept {
        plane: way.dot(down).hypot(way.dot(across)),
        turn: turn.dot(normal).abs(),
        speed,
    }
}

#[track_caller]
fn assert_rests(what: &str, tangent: f32, turns_ground: bool, bounds: [f32; 3]) {
    let with = creep(tangent, turns_ground, true);
    let alone = creep(tangent, turns_ground, false);
    println!(
        "{what}: {:.1e} m, {:.1e} rad, {:.1e} m/s; the engine alone {:.1e} m, {:.1e} rad, {:.1e} m/s",
        with.plane, with.turn, with.speed, alone.plane, alone.turn, alone.speed
    );
    assert!(with.plane <= bounds[0], "{what}: crept {} m", with.plane);
    assert!(with.turn <= bounds[1], "{what}: turned {} rad", with.turn);
    assert!(with.speed <= bounds[2], "{what}: {} m/s", with.speed);
}

#[test]
fn a_puck_on_a_level_table_stays_to_the_last_bit() {
    assert_rests("level", 0.0, false, [0.0, 0.0, 0.0]);
}

#[test]
fn a_slope_just_below_the_friction_angle_holds() {
    assert_rests("99 %, gravity turned", 0.99 * MU, false, [0.0, 0.0, 0.0]);
    // The normal is no axis of the world: rounding of products with it is left.
    assert_rests("99 %, ground turned", 0.99 * MU, true, [1e-7, 1e-7, 1e-12]);
}

#[test]
fn a_slope_just_above_the_friction_angle_slides() {
    for turns_ground in [false, true] {
        let tangent = 1.01 * MU;
        let (mut table, body, down) = slope(tangent, turns_ground);
        let (body, _) = table.put(body, puck_shape(), disk());
        table.steps(30);
        let before = table.world.bodies[body].linvel().dot(down);
        table.steps(60);
        let gained = table.world.bodies[body].linvel().dot(down) - before;
        let angle = tangent.atan();
        let accelerations = [angle.sin(), MU * angle.cos()].map(|share| share * GRAVITY);
        assert_gains(gained, accelerations, 1.0);
    }
}
