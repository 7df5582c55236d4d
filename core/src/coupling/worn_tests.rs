//! Worn annuli against radial bars with 22 digits, and their limits.

extern crate std;

use super::WornAnnulus;
use crate::coupling::coulomb::CoulombRing;
use crate::coupling::{ReducedFriction, ReducedWrench};
use crate::patch::PatchError;
use crate::real::Real;
use std::vec::Vec;

const TABLE: &str = include_str!("../../../tests/tables/worn.csv");

/// Friction of a band, in f64.
fn friction<R: Real>(inner: f64, slide: f64, rim: f64) -> [f64; 6] {
    let band = WornAnnulus::new(R::from_f64(inner)).unwrap();
    let (slide, rim) = (R::from_f64(slide), R::from_f64(rim));
    let ReducedWrench { force, torque } = band.reduced_wrench(slide, rim);
    let j = band.reduced_jacobian(slide, rim);
    [
        force,
        torque,
        j.force_per_slide,
        j.force_slide,
        j.mixed,
        j.torque_rim,
    ]
    .map(R::to_f64)
}

/// Errors of wrench and Jacobian, the latter of the larger of the entry and F/v.
fn errors(found: &[f64], exact: &[f64]) -> [f64; 2] {
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let wrench = (0..2).map(|k| (found[k] - exact[k]).abs());
    let jacobian = (2..6).map(|k| (found[k] - exact[k]).abs() / exact[2].abs().max(exact[k].abs()));
    [
        most(&mut wrench.into_iter()),
        most(&mut jacobian.into_iter()),
    ]
}

#[test]
fn radial_bars_with_many_digits_agree() {
    let (mut double, mut single, mut count) = ([0.0_f64; 2], [0.0_f64; 2], 0);
    for line in TABLE.lines().skip(2) {
        let row: Vec<f64> = line
            .split(',')
            .map(|x| x.replace("+inf", "inf").parse().unwrap())
            .collect();
        let [inner, slide, rim] = [row[0], row[1], row[2]];
        count += 1;
        // A full disk that spins in place has an infinite drag.
        if row[5].is_infinite() {
            let [force, torque, drag, ..] = friction::<f64>(inner, slide, rim);
            assert!(force == 0.0 && (torque - 0.5).abs() < 1e-15 && drag > 100.0);
            continue;
        }
        let lost = 1.0 / (1.0 - inner);
        let found = errors(&friction::<f64>(inner, slide, rim), &row[3..]);
        double = [double[0].max(found[0]), double[1].max(found[1] / lost)];
        let [inner, slide, rim] = [inner, slide, rim].map(|x| f64::from(x as f32));
        let found = errors(
            &friction::<f32>(inner, slide, rim),
            &friction::<f64>(inner, slide, rim),
        );
        single = [single[0].max(found[0]), single[1].max(found[1] / lost)];
    }
    assert_eq!(count, 147);
    assert!(double[0] < 2e-15 && double[1] < 1e-14, "{double:?}");
    assert!(single[0] < 1e-6 && single[1] < 5e-6, "{single:?}");
}

#[test]
fn a_band_without_width_is_a_ring() {
    let max = WornAnnulus::<f64>::MAX_INNER_RATIO;
    for k in 0..40 {
        let (slide, rim) = (0.05 * f64::from(k), 1.0);
        let ring = CoulombRing.reduced_wrench(slide, rim);
        let [force, torque, ..] = friction::<f64>(max, slide, rim);
        assert!(
            (force - ring.force).abs() < 1e-5 && (torque - ring.torque).abs() < 1e-5,
            "{slide}"
        );
    }
}

#[test]
fn it_turns_on_its_mean_radius() {
    for inner in [0.0, 0.3, 0.9, 0.999_999] {
        let [force, torque, ..] = friction::<f64>(inner, 0.0, 3.0);
        assert!(
            force == 0.0 && (torque - 0.5 * (1.0 + inner)).abs() < 4e-16,
            "{inner}"
        );
    }
}

#[test]
fn panels_meet_without_a_step() {
    // On both sides of every place where the integral changes its form.
    for inner in [0.0, 0.01, 0.2, 0.5, 0.95] {
        for radius in [inner, 1.0] {
            for part in [0.6, 1.0, 2.5, 2.5 * 2.75, 2.5 * 2.75 * 2.75, 133.0] {
                let [below, above] = [1.0 - 1e-13, 1.0 + 1e-13]
                    .map(|side| friction::<f64>(inner, side * radius / part, 1.0));
                for k in 0..2 {
                    assert!(
                        (below[k] - above[k]).abs() < 1e-12,
                        "{inner} {radius} {part}"
                    );
                }
            }
        }
    }
}

#[test]
fn no_band_is_refused() {
    for given in [-0.1, 1.0, f64::NAN] {
        let made = WornAnnulus::new(given);
        assert!(
            matches!(made, Err(PatchError::InnerRatio { .. })),
            "{given}"
        );
    }
}
