//! Grounds that give everything on them a patch of its shape.

use crate::table::*;
use rapier3d::prelude::*;
use tribos_rapier::{GroundMu, PairError, Patch};

/// A table with patches for everything.
fn covered(mu: GroundMu) -> Table {
    let mut table = Table::level();
    let colliders = &mut table.world.colliders;
    table
        .patches
        .insert_ground(table.ground, mu, colliders)
        .expect("the table is there");
    table
}

/// Travel of a body after two seconds.
fn travel(table: &mut Table, body: RigidBodyHandle) -> f64 {
    let start = table.world.bodies[body].translation();
    table.steps(120);
    let end = table.world.bodies[body].translation();
    assert!(
        table.world.bodies[body].linvel().length() < 1e-3,
        "still moves"
    );
    f64::from((end.x - start.x).hypot(end.z - start.z))
}

fn spinning() -> RigidBodyBuilder {
    lying(HALF_HEIGHT)
        .linvel(Vector::new(1.0, 0.0, 0.0))
        .angvel(Vector::new(0.0, 12.5, 0.0))
}

fn hull() -> ColliderBuilder {
    let corners = [-1.0, 1.0].into_iter().flat_map(|y| {
        [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]
            .map(|[x, z]| Vector::new(x, HALF_HEIGHT * y, z))
    });
    let corners: Vec<Vector> = corners.collect();
    ColliderBuilder::convex_hull(&corners).expect("a box")
}

const SQUARE: [[f32; 2]; 4] = [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]];

#[test]
fn a_shape_goes_as_far_as_with_the_patch_that_it_has() {
    let square = Patch::polygon(MU, &SQUARE, 2).unwrap();
    let cases = [
        (puck_shape(), disk().unwrap()),
        (
            ColliderBuilder::cuboid(0.1, HALF_HEIGHT, 0.1),
            square.clone(),
        ),
        (hull(), square),
    ];
    for (shape, patch) in cases {
        let mut explicit = Table::level();
        let (body, _) = explicit.put(spinning(), shape.clone(), Some(patch));
        let right = travel(&mut explicit, body);
        let mut table = covered(GroundMu::Combined);
        let (body, foot) = table.put(spinning(), shape, None);
        let is = travel(&mut table, body);
        assert!((is / right - 1.0).abs() < 1e-4, "{is} m for {right} m");
        assert!(table.patches.friction(foot, table.ground).unwrap().holds);
    }
}

#[test]
fn a_body_on_any_side_has_the_area_of_that_side() {
    // The torque of a rectangle a × b: mean arm times the limit.
    let arm = |a: f64, b: f64| {
        let mut sum = 0.0;
        for i in 0..400 {
            for k in 0..400 {
                let [x, y] = [i, k].map(|n| (f64::from(n) + 0.5) / 400.0);
                sum += (a * x).hypot(b * y);
            }
        }
        sum / 160_000.0
    };
    let half = [0.1_f32, 0.04, 0.06];
    for up in 0..3 {
        let mut table = covered(GroundMu::Combined);
        let turn = match up {
            0 => Rotation::from_rotation_z(core::f32::consts::FRAC_PI_2),
            1 => Rotation::IDENTITY,
            _ => Rotation::from_rotation_x(core::f32::consts::FRAC_PI_2),
        };
        let place = Pose::from_parts(Vector::new(0.0, half[up], 0.0), turn);
        let body = RigidBodyBuilder::dynamic()
            .pose(place)
            .angvel(Vector::new(0.0, 20.0, 0.0));
        let [x, y, z] = half;
        let (body, foot) = table.put(body, ColliderBuilder::cuboid(x, y, z), None);
        table.steps(5);
        let friction = table
            .patches
            .friction(foot, table.ground)
            .expect("stands flat");
        let [a, b] = [(up + 1) % 3, (up + 2) % 3].map(|side| f64::from(half[side]));
        let right = arm(a, b) * f64::from(MU * friction.load);
        let is = f64::from(friction.torque.length());
        assert!(
            (is / right - 1.0).abs() < 5e-3,
            "side {up}: {is} for {right}"
        );
        assert!(table.world.bodies[body].angvel().y > 0.0);
    }
}

#[test]
fn round_bodies_and_cylinders_that_roll_stay_the_engines() {
    let rolls = |table: &mut Table, shape: ColliderBuilder, turn: Rotation, radius: f32| {
        let place = Pose::from_parts(Vector::new(0.0, radius, 0.0), turn);
        let body = RigidBodyBuilder::dynamic()
            .pose(place)
            .linvel(Vector::new(1.0, 0.0, 0.0));
        let (body, foot) = table.put(body, shape, None);
        table.steps(60);
        assert!(table.patches.friction(foot, table.ground).is_none());
        table.world.bodies[body].linvel().x
    };
    let lying_down = Rotation::from_rotation_x(core::f32::consts::FRAC_PI_2);
    let cylinder = || ColliderBuilder::cylinder(0.1, 0.05);
    for (shape, turn, left) in [
        (ColliderBuilder::ball(0.05), Rotation::IDENTITY, 5.0 / 7.0),
        (cylinder(), lying_down, 2.0 / 3.0),
    ] {
        let with = rolls(&mut covered(GroundMu::Combined), shape, turn, 0.05);
        // Sliding turns into rolling.
        assert!((with / left - 1.0).abs() < 0.02, "{with} m/s for {left}");
    }
}

#[test]
fn coefficients_are_combined_or_from_the_table() {
    const WOOD: u128 = 7;
    let decelerated = |mu: GroundMu, shape: ColliderBuilder| {
        let mut table = covered(mu);
        let body = lying(HALF_HEIGHT)
            .linvel(Vector::new(2.0, 0.0, 0.0))
            .can_sleep(false);
        let (body, foot) = table.world.insert(body, shape);
        table.steps(3);
        let before = table.world.bodies[body].linvel().x;
        table.steps(12);
        assert!(table.patches.friction(foot, table.ground).is_some());
        (before - table.world.bodies[body].linvel().x) * 60.0 / 12.0
    };
    let near = |is: f32, mu: f32| {
        let right = mu * GRAVITY;
        assert!((is / right - 1.0).abs() < 1e-2, "{is} for {right}");
    };
    let wooden = || puck_shape().friction(0.5).user_data(WOOD);
    // The mean of 0.5 and the table's.
    near(decelerated(GroundMu::Combined, wooden()), 0.5 * (0.5 + MU));
    let highest = wooden().friction_combine_rule(CoefficientCombineRule::Max);
    near(decelerated(GroundMu::Combined, highest), 0.5);
    near(decelerated(GroundMu::Same(0.1), wooden()), 0.1);
    let table = || GroundMu::ByUserData(vec![(WOOD, 0.2)]);
    near(decelerated(table(), wooden()), 0.2);
    near(
        decelerated(table(), puck_shape().friction(0.5)),
        0.5 * (0.5 + MU),
    );
}

#[test]
fn an_explicit_patch_wins_and_stays() {
    let mut table = covered(GroundMu::Combined);
    let slippery = Patch::disk(0.05, RADIUS).unwrap();
    let (body, foot) = table.put(spinning(), puck_shape(), Some(slippery));
    table.steps(30);
    let friction = table.patches.friction(foot, table.ground).unwrap();
    let force = friction.force.length();
    assert!(force <= 0.0501 * friction.load, "{friction:?}");
    assert!(table.patches.remove_ground(table.ground));
    assert!(table.patches.friction(foot, table.ground).is_some());
    // Without it the face's patch takes over, after one step of the engine's.
    let colliders = &mut table.world.colliders;
    table
        .patches
        .insert_ground(table.ground, GroundMu::Combined, colliders)
        .unwrap();
    assert!(table.patches.remove(foot, table.ground));
    table.steps(3);
    let lost = table.world.bodies[body].linvel();
    table.steps(6);
    let rate = (lost - table.world.bodies[body].linvel()).length() * 10.0;
    assert!(rate > 0.2 * GRAVITY, "{rate} m/s²");
}

#[test]
fn a_box_that_tips_over_changes_its_face() {
    let mut table = covered(GroundMu::Combined);
    let half = [0.05, 0.2, 0.05];
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, half[1], 0.0))
        .linvel(Vector::new(0.5, 0.0, 0.0))
        .angvel(Vector::new(0.0, 0.0, -2.5));
    let (body, foot) = table.put(
        body,
        ColliderBuilder::cuboid(half[0], half[1], half[2]),
        None,
    );
    table.steps(5);
    table.steps(300);
    let up = *table.world.bodies[body].rotation() * Vector::Y;
    assert!(up.y.abs() < 0.1, "it fell over");
    let friction = table
        .patches
        .friction(foot, table.ground)
        .expect("lies flat");
    assert!(friction.holds);
    let start = *table.world.bodies[body].position();
    table.steps(600);
    let end = table.world.bodies[body].position();
    assert_eq!(
        [end.translation.x, end.translation.z],
        [start.translation.x, start.translation.z]
    );
}

#[test]
fn removed_colliders_and_grounds_and_bad_coefficients() {
    let mut table = covered(GroundMu::Combined);
    let (body, _) = table.put(spinning(), puck_shape(), None);
    table.steps(5);
    assert_eq!(table.patches.len(), 1);
    table.world.remove_body(body);
    table.steps(2);
    assert!(table.patches.is_empty());
    let colliders = &mut table.world.colliders;
    let refused = table
        .patches
        .insert_ground(table.ground, GroundMu::Same(-1.0), colliders);
    assert_eq!(refused, Err(PairError::Coefficient { given: -1.0 }));
    let nobody = ColliderHandle::invalid();
    let refused = table
        .patches
        .insert_ground(nobody, GroundMu::Combined, colliders);
    assert_eq!(refused, Err(PairError::Missing { collider: nobody }));
}
