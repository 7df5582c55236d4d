//! Several feet under one body, on and off its centre of mass, against the integral over their areas.

use crate::table::*;
use rapier3d::prelude::*;
use tribos_rapier::Patch;

/// Radius of a foot.
const FOOT: f32 = 0.02;
const SPEED: f32 = 1.0;
/// Steps before the throw.
const SETTLING: usize = 240;
/// Points of a foot in the reference: rings and spokes.
const RINGS: usize = 12;
const SPOKES: usize = 24;

/// A body that cannot tilt, on disks around its centre of mass.
struct Throw {
    feet: Vec<[f32; 2]>,
    spin: f32,
    radius: f32,
}

/// Travel in metres, stop in seconds, and the least velocity along the throw.
#[derive(Debug)]
struct End {
    travel: f64,
    stop: f64,
    least: f64,
}

const MASS: f32 = 1.0;
const INERTIA: f32 = 0.006;

impl Throw {
    /// At 60 steps a second; also how the feet share the load in each step.
    fn thrown(&self) -> (End, Vec<Vec<f64>>) {
        let mut table = Table::level();
        let (body, feet) = self.put(&mut table);
        let dt = f64::from(table.world.integration_parameters.dt);
        let mut end = End {
            travel: 0.0,
            stop: f64::NAN,
            least: f64::INFINITY,
        };
        // The engine's split of the load over feet that cannot tilt is arbitrary, and changes.
        table.steps(SETTLING);
        let body_now = &mut table.world.bodies[body];
        let start = body_now.translation();
        body_now.set_linvel(Vector::new(SPEED, 0.0, 0.0), true);
        body_now.set_angvel(Vector::new(0.0, self.spin, 0.0), true);
        let mut shares = Vec::new();
        for step in 0..300 {
            table.steps(1);
            let load = |&foot: &ColliderHandle| {
                f64::from(table.patches.friction(foot, table.ground).unwrap().load)
            };
            let loads: Vec<f64> = feet.iter().map(load).collect();
            let whole: f64 = loads.iter().sum();
            shares.push(loads.iter().map(|load| load / whole).collect());
            end.least = end
                .least
                .min(f64::from(table.world.bodies[body].linvel().x));
            if let Some(stop) = table.patches.stop(feet[0], table.ground) {
                end.stop = f64::from(step) * dt + f64::from(stop.within_step);
                break;
            }
        }
        let place = table.world.bodies[body].translation() - start;
        end.travel = f64::from(place.x.hypot(place.z));
        (end, shares)
    }

    fn put(&self, table: &mut Table) -> (RigidBodyHandle, Vec<ColliderHandle>) {
        let body = lying(HALF_HEIGHT)
            .enabled_rotations(false, true, false)
            .additional_mass_properties(MassProperties::new(
                Vector::ZERO,
                MASS,
                Vector::splat(INERTIA),
            ))
            .can_sleep(false)
            .allow_fast_rotation(true);
        let body = table.world.insert_body(body);
        let mut colliders = Vec::new();
        for [x, z] in &self.feet {
            let foot = ColliderBuilder::cylinder(HALF_HEIGHT, self.radius)
                .translation(Vector::new(*x, 0.0, *z))
                .density(0.0);
            let foot = table.world.insert_collider(foot, Some(body));
            table.give(foot, Patch::disk(MU, self.radius).unwrap());
            colliders.push(foot);
        }
        (body, colliders)
    }

    /// Points of all feet: x, z, share of the foot's load; the foot.
    fn points(&self) -> Vec<([f64; 3], usize)> {
        let mut points = Vec::new();
        for (foot, [x, z]) in self.feet.iter().enumerate() {
            for ring in 0..RINGS {
                for spoke in 0..SPOKES {
                    // The middle of each ring by area, spokes between those of its neighbours.
                    let r = f64::from(self.radius) * ((ring as f64 + 0.5) / RINGS as f64).sqrt();
                    let turn = (spoke as f64 + 0.5 * (ring % 2) as f64) / SPOKES as f64;
                    let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
                    let weight = 1.0 / (RINGS * SPOKES) as f64;
                    let place = [f64::from(*x) + r * cos, f64::from(*z) + r * sin];
                    points.push(([place[0], place[1], weight], foot));
                }
            }
        }
        points
    }

    /// The integral over the union of the areas, in steps of 0.1 ms.
    fn integrated(&self, shares: &[Vec<f64>]) -> End {
        const DT: f64 = 1e-4;
        let points = self.points();
        let (mass, inertia) = (f64::from(MASS), f64::from(INERTIA));
        let limit = f64::from(MU * GRAVITY) * mass;
        // Forces at velocity v, w about y: the velocity of a point r is v + w y × r.
        let slope = |[vx, vz, w]: [f64; 3], angle: f64, shares: &[f64]| {
            let (sin, cos) = angle.sin_cos();
            let mut sums = [0.0; 3];
            for ([x, z, weight], foot) in &points {
                let weight = weight * shares[*foot];
                let [x, z] = [cos * x + sin * z, cos * z - sin * x];
                let [ux, uz] = [vx + w * z, vz - w * x];
                let speed = ux.hypot(uz).max(1e-9);
                let [fx, fz] = [ux, uz].map(|u| -limit * weight * u / speed);
                sums[0] += fx / mass;
                sums[1] += fz / mass;
                sums[2] += (z * fx - x * fz) / inertia;
            }
            sums
        };
        let mut motion = [f64::from(SPEED), 0.0, f64::from(self.spin)];
        let [mut x, mut z, mut angle, mut time] = [0.0_f64; 4];
        let mut least = f64::INFINITY;
        let size = |motion: [f64; 3]| motion[0].hypot(motion[1]).hypot(0.1 * motion[2]);
        let mut before = f64::INFINITY;
        while size(motion) > 2e-3 {
            before = size(motion);
            let step = (60.0 * time) as usize;
            let shares = &shares[step.min(shares.len() - 1)];
            let first = slope(motion, angle, shares);
            let mid = [0, 1, 2].map(|i| motion[i] + 0.5 * DT * first[i]);
            let second = slope(mid, angle + 0.5 * DT * motion[2], shares);
            x += DT * mid[0];
            z += DT * mid[1];
            angle += DT * mid[2];
            motion = [0, 1, 2].map(|i| motion[i] + DT * second[i]);
            time += DT;
            least = least.min(motion[0]);
        }
        // The rest of the way at the rate of the last step.
        let left = DT * size(motion) / (before - size(motion));
        End {
            travel: (x + 0.5 * left * motion[0]).hypot(z + 0.5 * left * motion[1]),
            stop: time + left,
            least,
        }
    }
}

/// Feet on a circle, moved aside.
fn circle(count: usize, radius: f32, aside: [f32; 2]) -> Vec<[f32; 2]> {
    let place = |k: usize| {
        let (sin, cos) = (std::f32::consts::TAU * k as f32 / count as f32).sin_cos();
        [aside[0] + radius * cos, aside[1] + radius * sin]
    };
    (0..count).map(place).collect()
}

#[test]
fn any_number_of_feet_travel_as_the_integral_over_their_areas() {
    for (count, radius, aside, spin) in [
        (1, 0.0, [0.0, 0.0], 10.0),
        (1, 0.0, [0.03, 0.0], 10.0),
        (1, 0.0, [0.0, -0.05], 5.0),
        (2, 0.1, [0.0, 0.0], 10.0),
        (2, 0.1, [0.04, 0.03], 10.0),
        (4, 0.1, [0.0, 0.0], 10.0),
        (4, 0.1, [0.0, 0.0], 0.0),
        (4, 0.1, [0.05, 0.0], 10.0),
        (4, 0.1, [0.02, -0.05], 25.0),
        (8, 0.1, [0.0, 0.0], 10.0),
        (8, 0.1, [-0.03, 0.05], 15.0),
    ] {
        let throw = Throw {
            feet: circle(count, radius, aside),
            spin,
            radius: FOOT,
        };
        let (is, shares) = throw.thrown();
        let right = throw.integrated(&shares);
        let errors = [is.travel / right.travel - 1.0, is.stop / right.stop - 1.0];
        println!(
            "{count} feet, {aside:?} m aside, {spin} rad/s: {:.4} m, {:.4} s, errors {:+.2} % {:+.2} %",
            right.travel,
            right.stop,
            100.0 * errors[0],
            100.0 * errors[1]
        );
        for step in [0, 1, 2, 5, 10, 20] {
            println!("   loads in step {step}: {:.3?}", shares.get(step));
        }
        assert!(
            errors.iter().all(|error| error.abs() < 5e-3),
            "{count} {aside:?}: {is:?} for {right:?}"
        );
        // It does not run backwards but for a part of what friction takes in the last step.
        let last = f64::from(MU * GRAVITY) / 60.0;
        assert!(is.least > right.least - 0.2 * last, "{is:?} for {right:?}");
    }
}

#[test]
fn feet_at_rest_stay_to_the_last_bit_and_hold_what_their_areas_hold() {
    let throw = Throw {
        feet: circle(4, 0.1, [0.0, 0.0]),
        spin: 0.0,
        radius: FOOT,
    };
    let mut table = Table::level();
    let (body, feet) = throw.put(&mut table);
    table.steps(SETTLING);
    let start = *table.world.bodies[body].position();
    // With equal loads the feet hold mu M g times their distance from their middle.
    table.world.bodies[body].add_torque(Vector::Y * (0.7 * MU * MASS * GRAVITY * 0.1), true);
    table.steps(300);
    let holds = |table: &Table| {
        let friction = |&foot: &ColliderHandle| table.patches.friction(foot, table.ground).unwrap();
        feet.iter().map(friction).all(|friction| friction.holds)
    };
    assert!(holds(&table));
    let end = table.world.bodies[body].position();
    assert_eq!(end.translation.x, start.translation.x);
    assert_eq!(end.translation.z, start.translation.z);
    let [turn, turned] = [start, *end].map(|pose| [pose.rotation.y, pose.rotation.w]);
    assert_eq!(turn, turned);
    // Not twice as much.
    table.world.bodies[body].add_torque(Vector::Y * (0.7 * MU * MASS * GRAVITY * 0.1), true);
    table.steps(30);
    assert!(!holds(&table) && table.world.bodies[body].angvel().y > 0.1);
}

#[test]
fn a_body_with_one_foot_on_a_belt_turns() {
    // Two feet: one on the table, one on a belt beside it that runs along z.
    let mut table = Table::level();
    let belt = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::new(10.0, -0.1, 0.0))
        .linvel(Vector::new(0.0, 0.0, 0.5));
    let (_, belt) = table
        .world
        .insert(belt, ColliderBuilder::cuboid(5.0, 0.1, 5.0));
    let throw = Throw {
        feet: vec![[-0.1, 0.0], [0.1, 0.0]],
        spin: 0.0,
        radius: FOOT,
    };
    let (body, feet) = throw.put(&mut table);
    let patches = &mut table.patches;
    patches.remove(feet[1], table.ground);
    let patch = Patch::disk(MU, FOOT).unwrap();
    let world = &mut table.world;
    patches
        .insert(feet[1], belt, patch, &world.bodies, &mut world.colliders)
        .unwrap();
    let body_now = world.bodies.get_mut(body).unwrap();
    body_now.set_translation(Vector::new(5.0, HALF_HEIGHT, 0.0), true);
    body_now.set_linvel(Vector::ZERO, true);
    table.steps(6);
    // Each foot carries half: they push along z, with a torque that turns z to x.
    let body = &table.world.bodies[body];
    let pushed = table.patches.friction(feet[1], belt).unwrap();
    assert!(pushed.force.z > 0.0 && body.angvel().y < -0.1, "{body:?}");
    assert!(body.linvel().z.abs() < 0.5);
}
