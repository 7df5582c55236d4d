//! Thrown pucks against the exact solution.

use crate::exact::{Throw, answer, assert_stops};
use crate::table::*;
use rapier3d::prelude::*;
use tribos_rapier::Patch;

const SPEED: f32 = 1.0;
const STEPS: usize = 300;

fn thrown(spin: f32, patch: Option<Patch>) -> Throw {
    let mut table = Table::level();
    let body = lying(HALF_HEIGHT)
        .linvel(Vector::new(SPEED, 0.0, 0.0))
        .angvel(Vector::new(0.0, spin, 0.0));
    let (body, foot) = table.put(body, puck_shape(), patch);
    let dt = f64::from(table.world.integration_parameters.dt);
    let mut stop = f64::NAN;
    for step in 0..STEPS {
        table.steps(1);
        if let Some(end) = table.patches.stop(foot, table.ground) {
            assert!(stop.is_nan(), "a puck stops once");
            stop = step as f64 * dt + f64::from(end.within_step);
        }
    }
    let place = table.world.bodies[body].translation();
    Throw {
        travel: f64::from(place.x.hypot(place.z)),
        stop,
    }
}

#[test]
fn a_thrown_puck_or_cup_stops_where_and_when_it_should() {
    for (scene, patch) in [("puck", disk()), ("ring", ring())] {
        assert_stops(scene, 5e-3, |spin| thrown(spin, patch.clone()));
    }
}

#[test]
fn a_body_on_a_blade_stops_turning_when_the_exact_one_does() {
    let half = 0.5 * RADIUS;
    let mut table = Table::level();
    let spin = 12.5;
    let body = lying(HALF_HEIGHT).angvel(Vector::new(0.0, spin, 0.0));
    let (body, foot) = table.put(body, puck_shape(), Patch::bar(MU, half).ok());
    let dt = f64::from(table.world.integration_parameters.dt);
    let mut stop = f64::NAN;
    for step in 0..STEPS {
        table.steps(1);
        if let Some(end) = table.patches.stop(foot, table.ground) {
            stop = step as f64 * dt + f64::from(end.within_step);
        }
    }
    // The mean arm of a bar is half of its half length.
    let exact = f64::from(0.5 * RADIUS * RADIUS * spin / (MU * GRAVITY * 0.5 * half));
    assert!((stop / exact - 1.0).abs() < 5e-3, "{stop} for {exact}");
    assert!(table.world.bodies[body].translation().x.abs() < 1e-4);
}

#[test]
fn the_engine_alone_is_off_by_a_fifth() {
    let exact = answer("puck", 12.5);
    let alone = thrown(12.5, None);
    assert!(alone.travel < 0.8 * exact.travel, "{alone:?} for {exact:?}");
}

#[test]
fn substeps_do_not_move_the_stop() {
    let exact = answer("puck", 12.5);
    for iterations in [1, 2, 8, 12] {
        let mut table = Table::level();
        table.world.integration_parameters.num_solver_iterations = iterations;
        let body = lying(HALF_HEIGHT)
            .additional_solver_iterations(iterations / 2)
            .linvel(Vector::new(SPEED, 0.0, 0.0))
            .angvel(Vector::new(0.0, 12.5, 0.0));
        let (body, _) = table.put(body, puck_shape(), disk());
        table.steps(STEPS);
        let travel = f64::from(table.world.bodies[body].translation().x);
        assert!(
            (travel / exact.travel - 1.0).abs() < 5e-3,
            "{iterations}: {travel}"
        );
    }
}

#[test]
fn a_box_and_a_puck_slide_alike_in_all_directions() {
    let side = 0.1;
    let corners = [[-side, -side], [side, -side], [side, side], [-side, side]];
    let square = || Patch::polygon(MU, &corners, 2).ok();
    let cube = ColliderBuilder::cuboid(side, 0.05, side);
    let exact = 1.0 / (2.0 * MU * GRAVITY);
    for (name, shape, half, patch) in [
        ("box", &cube, 0.05, square()),
        ("box, engine alone", &cube, 0.05, None),
        ("puck", &puck_shape(), HALF_HEIGHT, disk()),
        ("puck, engine alone", &puck_shape(), HALF_HEIGHT, None),
    ] {
        let [mut least, mut most, mut across] = [f32::MAX, 0.0, 0.0_f32];
        for i in 0..24 {
            let angle = i as f32 * core::f32::consts::TAU / 24.0;
            let [along, aside] = travel_along(angle, half, shape.clone(), &patch);
            least = least.min(along);
            most = most.max(along);
            across = across.max(aside.abs());
        }
        println!("{name}: {least} to {most} m (exact {exact}), across {across:.1e} m");
        if patch.is_some() {
            assert!(
                most - least < 1e-5,
                "{name}: travel from {least} to {most} m"
            );
            assert!(across < 2e-6, "{name}: {across} m across");
            assert!(
                (most / exact - 1.0).abs() < 1e-3,
                "{name}: {most} for {exact} m"
            );
        }
    }
}

/// Travel along and across the direction of the throw, from where the body has settled.
fn travel_along(angle: f32, half: f32, shape: ColliderBuilder, patch: &Option<Patch>) -> [f32; 2] {
    let mut table = Table::level();
    let (body, _) = table.put(lying(half), shape, patch.clone());
    table.steps(30);
    let start = table.world.bodies[body].translation();
    let (sin, cos) = angle.sin_cos();
    let along = Vector::new(cos, 0.0, sin);
    table.world.bodies[body].set_linvel(along * SPEED, true);
    table.steps(60);
    let way = table.world.bodies[body].translation() - start;
    [way.dot(along), way.dot(Vector::new(-sin, 0.0, cos))]
}
