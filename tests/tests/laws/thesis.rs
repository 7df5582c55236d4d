//! The printed formulas of chapter 3, with their errata, against the kernel.

use std::f64::consts::PI;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{ReducedFriction, ReducedWrench};
use tribos_core::internals::CompleteElliptic;
use tribos_core::modes::inertia_interval;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// (K, E) of the modulus k, as the thesis writes them.
fn elliptic(modulus: f64) -> (f64, f64) {
    let got = CompleteElliptic::new((1.0 - modulus) * (1.0 + modulus));
    (got.k(), got.e())
}

fn coulomb(ratio: f64) -> ReducedWrench<f64> {
    CoulombDisk.reduced_wrench(ratio, 1.0)
}

fn power(alpha: f64, ratio: f64) -> ReducedWrench<f64> {
    DiskTable64::new(alpha).unwrap().reduced_wrench(ratio, 1.0)
}

fn relative(got: f64, wanted: f64) -> f64 {
    (got / wanted - 1.0).abs()
}

/// Ratios where the printed forms still have digits: they cancel at both ends.
fn ratios() -> impl Iterator<Item = f64> {
    (1..200).map(|n| f64::from(n) * 0.025).filter(|&e| e != 1.0)
}

#[test]
fn equations_3_11_and_3_13_hold_with_the_factor_four_on_the_whole_bracket() {
    let mut worst = Worst::of("3.11, 3.13");
    for e in ratios() {
        let (force, torque) = if e < 1.0 {
            let (k, c) = elliptic(e);
            (
                4.0 * ((e * e + 1.0) * c + (e * e - 1.0) * k) / (3.0 * PI * e),
                4.0 * ((4.0 - 2.0 * e * e) * c + (e * e - 1.0) * k) / (9.0 * PI),
            )
        } else {
            let (k, c) = elliptic(1.0 / e);
            (
                4.0 * ((e * e + 1.0) * c - (e * e - 1.0) * k) / (3.0 * PI),
                4.0 * e * ((4.0 - 2.0 * e * e) * c + (2.0 * e * e - 5.0 + 3.0 / (e * e)) * k)
                    / (9.0 * PI),
            )
        };
        let got = coulomb(e);
        worst.see(relative(force, got.force), || format!("F, eps {e}"));
        worst.see(relative(torque, got.torque), || format!("T, eps {e}"));
    }
    worst.assert_within(&tolerance::FORMULA);
}

#[test]
fn equation_3_11_as_printed_is_wrong() {
    // Read literally, 4 multiplies E alone: 1.28873 instead of 0.48384 at ε = 1/2.
    let e: f64 = 0.5;
    let (k, c) = elliptic(e);
    let printed = (4.0 * (e * e + 1.0) * c + (e * e - 1.0) * k) / (3.0 * e * PI);
    assert!(
        (printed - 1.28873).abs() < tolerance::QUOTED_VALUE.limit,
        "{printed}"
    );
    assert!((coulomb(e).force - 0.48384).abs() < tolerance::QUOTED_VALUE.limit);
    let printed = (4.0 * (4.0 - 2.0 * e * e) * c + (e * e - 1.0) * k) / (9.0 * PI);
    assert!(relative(printed, coulomb(e).torque) > 0.1);
}

#[test]
fn equations_3_17_and_3_18_need_no_cases() {
    let mut worst = Worst::of("3.17, 3.18");
    for e in ratios() {
        let (k, c) = elliptic(2.0 * e.sqrt() / (1.0 + e));
        let gap_sq = (1.0 - e) * (1.0 - e);
        let force = 2.0 * (1.0 + e) / (3.0 * PI * e) * ((1.0 + e * e) * c - gap_sq * k);
        let torque = 4.0 * (1.0 + e) / (9.0 * PI) * ((2.0 - e * e) * c + gap_sq * k);
        let got = coulomb(e);
        worst.see(relative(force, got.force), || format!("F, eps {e}"));
        worst.see(relative(torque, got.torque), || format!("T, eps {e}"));
    }
    worst.assert_within(&tolerance::FORMULA);
}

#[test]
fn limits_3_12_to_3_16_are_met_from_both_sides() {
    for ratio in [1.0, 1.0_f64.next_down(), 1.0_f64.next_up()] {
        let (got, slopes) = (coulomb(ratio), CoulombDisk.reduced_jacobian(ratio, 1.0));
        assert!(relative(got.force, 8.0 / (3.0 * PI)) < tolerance::ROUNDING.limit);
        assert!(relative(got.torque, 8.0 / (9.0 * PI)) < tolerance::ROUNDING.limit);
        assert!(relative(slopes.force_slide, 4.0 / (3.0 * PI)) < tolerance::SLOPE_AT_ONE.limit);
        assert!(relative(slopes.mixed, -4.0 / (3.0 * PI)) < tolerance::SLOPE_AT_ONE.limit);
    }
    assert_eq!(
        coulomb(0.0),
        ReducedWrench {
            force: 0.0,
            torque: 2.0 / 3.0
        }
    );
    let sliding = CoulombDisk.reduced_wrench(1.0, 0.0);
    assert_eq!(
        sliding,
        ReducedWrench {
            force: 1.0,
            torque: 0.0
        }
    );
}

#[test]
fn the_cubic_torque_of_fast_sliding_has_no_third() {
    // Section 3.3 prints −(1/3)(ωR)² v²; table 3.1 and the kernel give ωR v².
    let (v, w) = (2e5, 0.5);
    let got = DiskTable64::new(3.0).unwrap().reduced_wrench(v, w).torque;
    assert!(relative(got, w * v * v) < tolerance::FAST_SLIDING.limit);
    assert!(relative(got, w * w * v * v / 3.0) > 1.0);
}

#[test]
fn table_3_1_is_approached_with_the_square_of_the_ratio() {
    for alpha in [-0.5, 0.0, 0.5, 2.0, 3.0, 5.0] {
        let error = |e: f64| {
            let (slow, fast) = (power(alpha, e), power(alpha, 1.0 / e));
            [
                relative(slow.force, e),
                relative(slow.torque, 2.0 / (alpha + 3.0)),
                relative(fast.force, e.powf(-alpha)),
                relative(fast.torque, (1.0 + alpha) / 4.0 * e.powf(1.0 - alpha)),
            ]
        };
        for (coarse, fine) in error(1e-2).into_iter().zip(error(1e-3)) {
            let order = (coarse / fine).log10();
            assert!(
                (order - 2.0).abs() < tolerance::ORDER_OF_LIMITS.limit,
                "alpha {alpha}: order {order}"
            );
        }
    }
    // The linear law has no corrections at all.
    assert_eq!(power(1.0, 1e-3).torque, 0.5);
}

#[test]
fn table_3_2_and_the_double_disk_have_their_limits() {
    for (alpha, at_zero, at_infinity) in [
        (0.0, 2.0 / 3.0, 0.25),
        (1.0, 0.5, 0.5),
        (3.0, 1.0 / 3.0, 1.0),
    ] {
        let wanted = if at_zero < at_infinity {
            (at_zero, at_infinity)
        } else {
            (at_infinity, at_zero)
        };
        assert_eq!(inertia_interval(alpha, 0.0), wanted);
        let c = |e: f64| {
            let got = power(alpha, e);
            e * got.torque / got.force
        };
        assert!(
            (c(1e-6) - at_zero).abs() < tolerance::LIMIT_OF_INERTIA.limit
                && (c(1e6) - at_infinity).abs() < tolerance::LIMIT_OF_INERTIA.limit
        );
    }
    // √(2c) bounds the ratio of radii, eqs. 3.35 and 3.36.
    let radii = |alpha: f64| {
        let (low, high) = inertia_interval(alpha, 0.0);
        ((2.0_f64 * low).sqrt(), (2.0 * high).sqrt())
    };
    let (low, high) = radii(0.0);
    assert!(
        relative(low, 1.0 / 2.0_f64.sqrt()) < tolerance::ROUNDING.limit
            && relative(high, 2.0 / 3.0_f64.sqrt()) < tolerance::ROUNDING.limit
    );
    let (low, high) = radii(3.0);
    assert!(
        relative(low, (2.0_f64 / 3.0).sqrt()) < tolerance::ROUNDING.limit
            && relative(high, 2.0_f64.sqrt()) < tolerance::ROUNDING.limit
    );
}
