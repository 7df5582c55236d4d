//! Thrown bodies against the exact solution.

use crate::exact::{self, Throw};
use crate::table::*;
use avian3d::prelude::*;
use bevy::prelude::*;
use tribos_bevy::FrictionPatch;

const SPINS: [f32; 6] = [0.0, 5.0, 12.5, 20.0, 30.0, 50.0];
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
fn a_thrown_disk_stops_where_and_when_the_exact_one_does() {
    for spin in SPINS {
        let what = format!("disk at {spin} rad/s");
        thrown(spin, disk(MU)).assert_near(&exact::disk(spin), TOLERANCE, &what);
    }
}

#[test]
fn a_thrown_ring_stops_where_and_when_the_exact_one_does() {
    for spin in SPINS {
        let ring = FrictionPatch::ring(MU, RADIUS).expect("a valid ring");
        let what = format!("ring at {spin} rad/s");
        thrown(spin, ring).assert_near(&exact::ring(spin), TOLERANCE, &what);
    }
}

#[test]
fn a_puck_without_a_patch_stops_early() {
    let mut table = Table::level();
    let puck = table.puck(Vec3::ZERO, Vec3::X, 50.0);
    let exact = exact::disk(50.0);
    table.steps((0.9 * exact.stop * f64::from(STEPS_A_SECOND)) as usize);
    assert!(table.velocity(puck)[0].x < 1e-3);
}

#[test]
fn a_thrown_box_goes_as_far_as_its_integral() {
    let (half, spin) = (0.05_f32, 25.0_f32);
    let mut table = Table::level();
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
    // Midpoints of 60 by 60 cells.
    let cell = |i: i32| f64::from(half) * ((2 * i + 1) as f64 / 60.0 - 1.0);
    let cells = (0..60).flat_map(|i| (0..60).map(move |j| ([cell(i), cell(j)], 1.0 / 3600.0)));
    let inertia = 2.0 / 3.0 * f64::from(half * half);
    let exact = exact::on_points(&cells.collect::<Vec<_>>(), inertia, f64::from(spin));
    is.assert_near(&exact, 1e-3, "box");
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
    let exact = exact::on_points(&points, f64::from(inertia), f64::from(spin));
    is.assert_near(&exact, SHARED, "four feet");
}
