//! Ends in closed form, and the slope against the force that it belongs to.

use super::*;
use crate::coupling::ReducedFriction;
use core::f64::consts::PI;

use super::form::{force_and_slope, force_and_torque};

/// Φ at equal speeds, from the sum of Gauss' series at 1, and Φ, Φ' and Χ where one motion is alone.
fn ends<F: Fitted>(equal: f64, spinning: [f64; 3]) {
    let near = |found: f64, known: f64| (found - known).abs() <= 2.0 * f64::EPSILON * known.abs();
    let q = F::PRESSURE.order();
    // By Θ = (Φ/2 + zΦ')/n.
    let chi_equal = 0.5 * equal / (q + 1.5);
    for slides in [false, true] {
        let [phi, chi] = force_and_torque::<F, f64>(slides, 0.0);
        assert!(
            near(phi, equal) && near(chi, chi_equal),
            "{phi} {equal} {chi} {chi_equal}"
        );
        let alone = if slides {
            [1.0, -0.25 / (q + 2.0), 0.5 / (q + 2.0)]
        } else {
            spinning
        };
        let ([phi, slope], [same, chi]) = (
            force_and_slope::<F, f64>(slides, 1.0),
            force_and_torque::<F, f64>(slides, 1.0),
        );
        assert!(near(phi, alone[0]) && near(same, alone[0]), "{phi} {same}");
        assert!(
            (slope - alone[1]).abs() < 1e-15 && near(chi, alone[2]),
            "{slope} {chi}"
        );
    }
}

#[test]
fn forms_end_as_closed_forms_do() {
    ends::<CoulombRing>(2.0 / PI, [0.5, 0.0625, 1.0]);
    ends::<CoulombPunch>(PI / 4.0, [PI / 4.0, 0.0, PI / 4.0]);
    ends::<CoulombDisk>(8.0 / (3.0 * PI), [1.0, -0.125, 2.0 / 3.0]);
    let hertz = 3.0 * PI / 16.0;
    ends::<CoulombHertz>(9.0 * PI / 32.0, [2.0 * hertz, -0.5 * hertz, hertz]);
    ends::<CoulombParaboloid>(128.0 / (45.0 * PI), [4.0 / 3.0, -0.5, 8.0 / 15.0]);
}

/// The fitted torque is that of force and slope.
fn torque_belongs_to_slope<F: Fitted>() {
    for slides in [false, true] {
        for i in 0..=1000 {
            let x = f64::from(i) / 1000.0;
            let [_, chi] = force_and_torque::<F, f64>(slides, 1.0 - x);
            let [_, _, by_slope] = form::factors_and_slope::<F, f64>(slides, [x, 1.0 - x]);
            assert!(
                (chi / by_slope - 1.0).abs() < 3e-15,
                "{x}: {chi} {by_slope}"
            );
        }
    }
}

#[test]
fn torques_are_those_of_the_slopes() {
    torque_belongs_to_slope::<CoulombRing>();
    torque_belongs_to_slope::<CoulombPunch>();
    torque_belongs_to_slope::<CoulombDisk>();
    torque_belongs_to_slope::<CoulombHertz>();
    torque_belongs_to_slope::<CoulombParaboloid>();
}

/// Gauss–Legendre, 3 points: the integral of Φ' over a short way is the difference of Φ.
fn slope_belongs_to_force<F: Fitted>() {
    for slides in [false, true] {
        for i in 1..1000 {
            let (x, half) = (f64::from(i) / 1000.0, 0.0005);
            let slope = |x: f64| force_and_slope::<F, f64>(slides, 1.0 - x)[1];
            let apart = 0.6_f64.sqrt() * half;
            let mean = (5.0 * (slope(x - apart) + slope(x + apart)) + 8.0 * slope(x)) / 18.0;
            let force = |x: f64| force_and_slope::<F, f64>(slides, 1.0 - x)[0];
            let rise = (force(x + half) - force(x - half)) / (2.0 * half);
            // Next to equal speeds a ring's slope has a logarithm, which the rule sees to a thousandth.
            let bound = if x < 0.95 { 2e-12 } else { 4e-3 };
            assert!((mean - rise).abs() < bound, "{x}: {mean} {rise}");
        }
    }
}

#[test]
fn slopes_are_those_of_the_forces() {
    slope_belongs_to_force::<CoulombRing>();
    slope_belongs_to_force::<CoulombPunch>();
    slope_belongs_to_force::<CoulombDisk>();
    slope_belongs_to_force::<CoulombHertz>();
    slope_belongs_to_force::<CoulombParaboloid>();
}

/// Wrench of a group and of single calls, with equal speeds and one motion alone among them.
fn group_has_bits_of_calls<R: Real>(form: &impl ReducedFriction<R>) {
    let slides = [0.0, 1e-9, 0.3, 1.0, 1.0 + 1e-6, 2.0, 5.0, 1e8].map(R::from_f64);
    for rim in [0.0, 0.3, 1.0, 1.0 + 1e-7].map(R::from_f64) {
        let ([mut forces, mut torques], rims) = ([[R::ZERO; 8]; 2], [rim; 8]);
        form.reduced_wrench_batch(&slides, &rims, &mut forces, &mut torques);
        for (slide, found) in slides.into_iter().zip(forces.into_iter().zip(torques)) {
            let wrench = form.reduced_wrench(slide, rim);
            assert_eq!(found, (wrench.force, wrench.torque), "{slide:?} {rim:?}");
        }
    }
}

#[test]
fn groups_have_the_bits_of_single_calls() {
    group_has_bits_of_calls::<f64>(&CoulombRing);
    group_has_bits_of_calls::<f32>(&CoulombRing);
    group_has_bits_of_calls::<f64>(&CoulombHertz);
    group_has_bits_of_calls::<f32>(&CoulombDisk);
}
