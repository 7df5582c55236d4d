// cargo add avian3d@0.7 --no-default-features --features 3d,parry-f32
// cargo add bevy@0.19 --no-default-features
//! Avian 0.7: a body that stands on a cylinder of 1 cm radius and spins is now and then thrown off. For one step its contact with the cuboid of 100 m under it
//! has the normal of a side of that cuboid, and is tens of metres deep. On a cuboid of 4 m that is far rarer, on a half-space it was not seen: there the body
//! turns as far as on corners, 2/3 of the exact angle.

use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::transform::TransformPlugin;
use core::time::Duration;

const MU: f32 = 0.3;
const RADIUS: f32 = 0.01;
const SPIN: f32 = 20.0; // rad/s
const UPRIGHT: f32 = 0.0008; // kg m^2 about the upright axis
const RATE: u16 = 240; // steps a second

/// Angle in rad, and the deepest contact with its normal.
fn run(ground: Collider, middle: f32, yaw: f32) -> (f32, f32, Vec3) {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugins::default()));
    let step = Duration::from_secs_f64(1.0 / f64::from(RATE));
    app.insert_resource(Time::<Fixed>::from_duration(step));
    app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
    app.insert_resource(SubstepCount(12));
    let under = Transform::from_xyz(0.0, middle, 0.0);
    app.world_mut()
        .spawn((RigidBody::Static, ground, Friction::new(MU), under));
    let inertia = AngularInertia::new(Vec3::new(0.55, 1.0, 0.55) * UPRIGHT);
    let place = Transform::from_xyz(0.0, 0.01, 0.0).with_rotation(Quat::from_rotation_y(yaw));
    let body = app.world_mut().spawn((
        (RigidBody::Dynamic, Collider::cylinder(RADIUS, 0.02), place),
        (NoAutoMass, NoAutoAngularInertia, NoAutoCenterOfMass),
        (Mass(1.0), inertia, CenterOfMass(Vec3::NEG_Y * 0.01)),
        (Friction::new(MU), Restitution::ZERO, SleepingDisabled),
    ));
    let body = body.id();
    app.finish();
    app.cleanup();
    for _ in 0..=RATE / 2 {
        app.update();
    }
    let launch = (LinearVelocity::ZERO, AngularVelocity(Vec3::Y * SPIN));
    app.world_mut().entity_mut(body).insert(launch);
    let (mut turned, mut deepest, mut normal) = (0.0, 0.0, Vec3::ZERO);
    for _ in 0..RATE {
        app.update();
        let world = app.world();
        turned += world.get::<AngularVelocity>(body).unwrap().y / f32::from(RATE);
        let pairs = world.resource::<ContactGraph>().contact_pairs_with(body);
        for manifold in pairs.flat_map(|pair| &pair.manifolds) {
            for point in &manifold.points {
                if point.penetration > deepest {
                    (deepest, normal) = (point.penetration, manifold.normal);
                }
            }
        }
    }
    (turned, deepest, normal)
}

fn main() {
    // Torque of a disk: 2/3 mu m g R.
    let exact = SPIN * SPIN * UPRIGHT / (2.0 * 2.0 / 3.0 * MU * 9.81 * RADIUS);
    let cuboid = |side| (Collider::cuboid(side, 1.0, side), -0.5);
    for (name, (ground, middle)) in [
        ("cuboid of 100 m", cuboid(100.0)),
        ("cuboid of 4 m", cuboid(4.0)),
        ("half-space", (Collider::half_space(Vec3::Y), 0.0)),
    ] {
        let runs: Vec<_> = (0..100u16)
            .map(|pose| run(ground.clone(), middle, 0.03 * f32::from(pose)))
            .collect();
        let least = runs.iter().map(|run| run.0).fold(f32::MAX, f32::min);
        let most = runs.iter().map(|run| run.0).fold(0.0, f32::max);
        let wrong = runs.iter().filter(|run| run.1 > 0.1).count();
        let worst = runs.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        println!(
            "{name}: 100 runs turn {least:.3} to {most:.3} rad, exactly {exact:.3}; in {wrong} a contact deeper than 0.1 m; deepest {:.6} m, normal {:.2}",
            worst.1, worst.2
        );
    }
}
