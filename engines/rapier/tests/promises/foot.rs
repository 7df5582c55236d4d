//! Polygons under boxes.

use crate::table::*;
use rapier3d::prelude::*;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::CoulombLaw;
use tribos_core::patch::nodes::NodeList;
use tribos_core::twist::Twist;
use tribos_rapier::Patch;

const HALF: f32 = 0.1;
const HEIGHT: f32 = 0.02;
const CORNERS: [[f32; 2]; 4] = [[-HALF, -HALF], [HALF, -HALF], [HALF, HALF], [-HALF, HALF]];

/// Travel and stop of a square box.
fn thrown(speed: f32, spin: f32, divisions: u32) -> [f64; 2] {
    let mut table = Table::level();
    let body = lying(HEIGHT)
        .linvel(Vector::new(speed, 0.0, 0.0))
        .angvel(Vector::new(0.0, spin, 0.0));
    let shape = ColliderBuilder::cuboid(HALF, HEIGHT, HALF);
    let patch = Patch::polygon(MU, &CORNERS, divisions).ok();
    let (body, foot) = table.put(body, shape, patch);
    let dt = f64::from(table.world.integration_parameters.dt);
    let mut stop = f64::NAN;
    for step in 0..300 {
        table.steps(1);
        if let Some(end) = table.patches.stop(foot, table.ground) {
            stop = f64::from(step) * dt + f64::from(end.within_step);
        }
    }
    let place = table.world.bodies[body].translation();
    [f64::from(place.x.hypot(place.z)), stop]
}

/// The same by a dense polygon and fine steps.
fn exact(speed: f64, spin: f64) -> [f64; 2] {
    const DT: f64 = 1e-4;
    let corners = CORNERS.map(|corner| corner.map(f64::from));
    let dense: NodeList<f64, 2016> = NodeList::polygon(&corners, 12).unwrap();
    let friction = NodeFriction::new(CoulombLaw::new(f64::from(MU)).unwrap(), dense);
    let half = f64::from(HALF);
    let inertia = 2.0 / 3.0 * half * half;
    // Per mass, in axes that turn with the box.
    let slope = |twist: &Twist<f64>| {
        let wrench = friction.wrench(f64::from(GRAVITY), twist);
        let turn = twist.spin;
        Twist::new(
            wrench.force.x + turn * twist.velocity.y,
            wrench.force.y - turn * twist.velocity.x,
            wrench.torque / inertia,
        )
    };
    let moved = |twist: &Twist<f64>, by: &Twist<f64>, dt: f64| Twist {
        velocity: twist.velocity + by.velocity * dt,
        spin: twist.spin + by.spin * dt,
    };
    let mut twist = Twist::new(speed, 0.0, spin);
    let [mut angle, mut x, mut y, mut time] = [0.0_f64; 4];
    while twist.speed().hypot(half * twist.spin) > 2.0 * DT * 3.0 {
        let mid = moved(&twist, &slope(&twist), 0.5 * DT);
        let (sin, cos) = (angle + 0.5 * DT * twist.spin).sin_cos();
        x += DT * (cos * mid.velocity.x - sin * mid.velocity.y);
        y += DT * (sin * mid.velocity.x + cos * mid.velocity.y);
        twist = moved(&twist, &slope(&mid), DT);
        angle += DT * mid.spin;
        time += DT;
    }
    [x.hypot(y), time]
}

#[test]
fn a_box_that_does_not_spin_stops_after_its_friction_way() {
    let [travel, stop] = thrown(1.0, 0.0, 2);
    let deceleration = f64::from(MU * GRAVITY);
    let right = [0.5 / deceleration, 1.0 / deceleration];
    assert!((travel / right[0] - 1.0).abs() < 5e-3, "{travel} m");
    assert!((stop / right[1] - 1.0).abs() < 5e-3, "{stop} s");
}

#[test]
fn a_spinning_box_stops_with_the_mean_arm_of_its_square() {
    // Mean distance from the middle of a square of side a: (√2 + ln(1 + √2)) a/6.
    let side = 2.0 * f64::from(HALF);
    let root = core::f64::consts::SQRT_2;
    let arm = (root + (1.0 + root).ln()) * side / 6.0;
    let inertia = side * side / 6.0;
    let right = inertia * 10.0 / (f64::from(MU * GRAVITY) * arm);
    let [travel, stop] = thrown(0.0, 10.0, 2);
    println!("spin alone: {stop} s, exact {right} s; wandered {travel:.1e} m");
    assert!((stop / right - 1.0).abs() < 0.01, "{stop} s for {right} s");
    assert!(travel < 1e-4, "{travel} m");
}

#[test]
fn a_box_that_slides_and_spins_stops_as_the_dense_polygon() {
    for (speed, spin) in [(1.0, 5.0), (1.0, 12.5), (0.5, 20.0)] {
        let right = exact(f64::from(speed), f64::from(spin));
        for divisions in [2, 4] {
            let is = thrown(speed, spin, divisions);
            let errors = [0, 1].map(|i| is[i] / right[i] - 1.0);
            println!("{speed} m/s, {spin} rad/s, {divisions}: {errors:.4?} of {right:?}");
            assert!(
                errors.iter().all(|e| e.abs() < 3e-3),
                "{is:?} for {right:?}"
            );
        }
    }
}
