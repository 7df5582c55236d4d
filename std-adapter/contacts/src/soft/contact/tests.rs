//! Springs turn with their contact.

use super::*;
use crate::cd::solid;
use crate::soft::Stiffness;
use nalgebra::{Rotation3, Unit};
use tribos_core::contact::{AllModes, Attraction, Cohesion, IndependentFriction};

/// Error of the sliding spring of a pair that turns as one rigid body, after ten turns.
fn error(axis: Vector3<f64>, steps_a_turn: usize) -> f64 {
    const OVERLAP: f64 = 1e-2;
    let balls = [solid(1.0, 1.0); 2];
    let touch =
        |normal: Vector3<f64>| ContactGeometry::spheres(&(normal * (2.0 - OVERLAP)), [1.0; 2]);
    let law = Law {
        stiffness: Stiffness::Linear(1e3),
        damping: 1.0,
        cohesion: Cohesion::new(1.0, 0.0, Attraction::Pull).unwrap(),
        friction: IndependentFriction::<f64, AllModes>::all(1.0, 1.0, 1.0).unwrap(),
    };
    let block = Block::new(&touch(Vector3::x()).unwrap(), &balls[0], &balls[1]);
    let mut contact = SoftContact::<AllModes>::apart([0, 1], &block);
    let springs = [
        Vector3::new(0.0, 1e-3, 2e-3),
        Vector3::new(0.0, -2e-3, 1e-3),
    ];
    let stored = ContactVector::new(1e3, springs[0], springs[1], 3e-3);
    contact.restore(
        &touch(Vector3::x()).unwrap(),
        ContactVector::default(),
        stored,
    );

    let axis = Unit::new_normalize(axis);
    let dt = 1e-3;
    let rate = std::f64::consts::TAU / (steps_a_turn as f64 * dt);
    let mut worst = 0.0_f64;
    for step in 1..=10 * steps_a_turn {
        let turn = Rotation3::from_axis_angle(&axis, rate * dt * step as f64);
        let spin = axis.into_inner() * rate;
        let motion = Motion {
            velocity: Vector3::zeros(),
            spin: Vector3::zeros(),
            turning: spin,
        };
        contact.advance(&touch(turn * Vector3::x()).unwrap(), &motion, &law, dt);
        let held = &contact.springs;
        let expected = springs.map(|spring| turn * spring);
        let apart = (held.sliding() - expected[0]).norm() + (held.rolling() - expected[1]).norm();
        worst = worst.max(apart / springs[0].norm());
        assert!((held.torsion() - 3e-3).abs() < 1e-12);
    }
    worst
}

#[test]
fn springs_of_a_pair_that_sticks_turn_with_it_for_ten_turns() {
    let across = Vector3::z();
    let oblique = Vector3::new(1.0, 2.0, -0.5);
    let along = Vector3::x();
    for axis in [across, -across, oblique, along] {
        let [coarse, fine] = [1_000, 2_000].map(|steps| error(axis, steps));
        assert!(coarse < 1e-3, "{axis:?}: {coarse:e}");
        // Second order in the angle of a step, or exact.
        assert!(
            fine < 0.3 * coarse || fine < 1e-10,
            "{axis:?}: {coarse:e} {fine:e}"
        );
    }
}
