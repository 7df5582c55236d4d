//! Thrown bodies against the exact solution.

use crate::exact::{BOX_GRAVITY, HALF_SIDES, Throw, answer, assert_stops, on_cells};
use crate::table::*;
use avian3d::prelude::*;
use bevy::prelude::*;
use tribos_bevy::FrictionPatch;

const STEPS: usize = 150;
/// Largest relative error of travel and stop.
const TOLERANCE: f64 = 2e-4;
/// The same on several feet, among which the engine shares the load.
const SHARED: f64 = 2e-2;

/// Follows a thrown body to rest, which its foot reports.
fn followed(table: &mut Table, body: Entity, foot: Entity) -> Throw {
    let start = table.place(body);
    let [mut steps, mut stop] = [0.0, f64::NAN];
    for _ in 0..STEPS {
        let before = table.place(body);
        table.steps(1);
        if steps == 0.0 && table.place(body) == before {
            continue; // Time has not begun.
        }
        if let Some(within) = table.friction(foot).stopped_after {
            assert!(stop.is_nan(), "a body stops once");
            stop = steps / f64::from(STEPS_A_SECOND) + f64::from(within);
        }
        steps += 1.0;
    }
    let way = table.place(body) - start;
    Throw {
        travel: f64::from(way.x.hypot(way.z)),
        stop,
    }
}

fn thrown(spin: f32, patch: FrictionPatch) -> Throw {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, spin);
    table.give(puck, patch);
    followed(&mut table, puck, puck)
}

#[test]
fn a_thrown_puck_or_cup_stops_where_and_when_it_should() {
    let ring = FrictionPatch::ring(MU, RADIUS).expect("a valid ring");
    for (scene, patch) in [("puck", disk(MU)), ("ring", ring)] {
        assert_stops(scene, TOLERANCE, |spin| thrown(spin, patch.clone()));
    }
}

#[test]
fn a_puck_without_a_patch_stops_early() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, 50.0);
    let exact = answer("puck", 50.0);
    table.steps((0.9 * exact.stop * f64::from(STEPS_A_SECOND)) as usize);
    assert!(table.velocity(puck)[0].x < 1e-3);
}

#[test]
fn a_thrown_box_stops_where_and_when_it_should() {
    let (scene, [half, _]) = HALF_SIDES[0];
    let spin = 25.0;
    let mut table = Table::turned(Quat::IDENTITY, Vec3::NEG_Y * BOX_GRAVITY);
    let body = table.app.world_mut().spawn((
        RigidBody::Dynamic,
        Collider::cuboid(2.0 * half, 0.02, 2.0 * half),
        Friction::new(MU),
        SleepingDisabled,
        Transform::from_xyz(0.0, 0.01, 0.0),
        LinearVelocity(Vec3::X),
        AngularVelocity(Vec3::Y * spin),
    ));
    let body = body.id();
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    table.give(
        body,
        FrictionPatch::polygon(MU, &corners).expect("a square"),
    );
    let is = followed(&mut table, body, body);
    is.assert_near(&answer(scene, spin), 1e-3, scene);
}

#[test]
fn a_body_on_four_feet_goes_as_far_as_its_integral() {
    let (arm, radius, spin) = (0.1_f32, 0.02_f32, 10.0_f32);
    let mut table = Table::level();
    let places = [[arm, 0.0], [0.0, arm], [-arm, 0.0], [0.0, -arm]];
    let inertia = 0.005;
    let body = table.app.world_mut().spawn((
        RigidBody::Dynamic,
        SleepingDisabled,
        Mass(1.0),
        AngularInertia::new(Vec3::splat(inertia)),
        CenterOfMass(Vec3::ZERO),
        (NoAutoMass, NoAutoAngularInertia, NoAutoCenterOfMass),
        Transform::from_xyz(0.0, 0.01, 0.0),
        LinearVelocity(Vec3::X),
        AngularVelocity(Vec3::Y * spin),
    ));
    let body = body.id();
    let feet = places.map(|[x, z]| {
        let foot = table.app.world_mut().spawn((
            Collider::cylinder(radius, 0.02),
            Transform::from_xyz(x, 0.0, z),
            ChildOf(body),
            FrictionPatch::disk(MU, radius).expect("a valid disk"),
        ));
        foot.id()
    });
    let is = followed(&mut table, body, feet[0]);
    // Rings of equal area in each disk, with points between their borders.
    let (rings, around) = (12, 24);
    let mut points = Vec::new();
    for [x, z] in places {
        for i in 0..rings {
            let r = f64::from(radius) * ((f64::from(i) + 0.5) / f64::from(rings)).sqrt();
            for j in 0..around {
                let (sin, cos) =
                    (f64::from(j) * std::f64::consts::TAU / f64::from(around)).sin_cos();
                let place = [f64::from(x) + r * cos, f64::from(z) + r * sin];
                points.push((place, 0.25 / f64::from(rings * around)));
            }
        }
    }
    let exact = on_cells(&points, f64::from(inertia), spin);
    is.assert_near(&exact, SHARED, "four feet");
}
