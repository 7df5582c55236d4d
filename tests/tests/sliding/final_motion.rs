//! Where the velocity ratio goes: fixed points, their stability, and the modes of chapter 3.4.

use tribos_core::coupling::PowerLawFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::modes::{Stability, TerminalMode, TerminalMotion, inertia_interval};
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn modes(alpha: f64, inertia_ratio: f64) -> TerminalMotion<f64, DiskTable64> {
    TerminalMotion::new(DiskTable64::new(alpha).unwrap(), inertia_ratio).unwrap()
}

#[test]
fn fixed_points_have_their_place_and_stability() {
    let mut worst = Worst::of("fixed points");
    for row in Table::read("fixed_points.csv").rows() {
        let (alpha, c) = (row.number("alpha"), row.number("C"));
        let points = modes(alpha, c).fixed_points();
        let place = || format!("alpha {alpha}, C {c}");
        let (spinning, sliding) = match row.text("stability") {
            "stable" => (Stability::Unstable, Stability::Unstable),
            "unstable" => (Stability::Stable, Stability::Stable),
            "eps=0 stable" => (Stability::Stable, Stability::Unstable),
            "eps=inf stable" => (Stability::Unstable, Stability::Stable),
            other => panic!("unknown stability {other}"),
        };
        assert_eq!(points.spinning, spinning, "{}", place());
        assert_eq!(points.sliding, sliding, "{}", place());
        if row.text("eps0") == "none" {
            assert_eq!(points.finite, None, "{}", place());
            continue;
        }
        let (ratio, stability) = points
            .finite
            .unwrap_or_else(|| panic!("none at {}", place()));
        let stable = row.text("stability") == "stable";
        assert_eq!(stability == Stability::Stable, stable, "{}", place());
        worst.see(row.reference("eps0").relative(ratio), place);
    }
    worst.assert_within(&tolerance::FIXED_POINT);
}

#[test]
fn intervals_have_the_ends_of_the_table() {
    for row in Table::read("fixed_points.csv").rows() {
        let alpha = row.number("alpha");
        let (low, high) = inertia_interval(alpha, 0.0);
        let (at_zero, at_infinity) = (row.reference("C_at_0"), row.reference("C_at_inf"));
        let (at_low, at_high) = if alpha < 1.0 {
            (at_infinity, at_zero)
        } else {
            (at_zero, at_infinity)
        };
        assert!(
            at_low.ulps(low) <= 1.5 && at_high.ulps(high) <= 1.5,
            "alpha {alpha}"
        );
    }
}

#[test]
fn towards_the_linear_law_the_fixed_point_is_the_golden_ratio() {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    let at = |alpha| modes(alpha, 0.5).finite_fixed_point().unwrap();
    for alpha in [0.999999, 1.000001] {
        assert!((at(alpha) - golden).abs() <= tolerance::GOLDEN_RATIO.limit);
    }
    // Linear in α − 1, so that the mean of both sides is quadratically closer.
    assert!((0.5 * (at(0.9999) + at(1.0001)) - golden).abs() < tolerance::GOLDEN_MEAN.limit);
    // Errata 7: all disks of 0 ≤ α < 1 lie between it and the Coulomb value.
    for n in 1..100 {
        let ratio = at(f64::from(n) / 100.0);
        assert!(golden < ratio && ratio < 0.653_001_789_206);
    }
}

#[test]
fn only_an_inertia_inside_the_interval_has_a_finite_fixed_point() {
    for alpha in [-0.5, 0.0, 0.5, 0.9, 1.5, 2.0, 3.0, 7.0] {
        let (low, high): (f64, f64) = inertia_interval(alpha, 0.0);
        let has = |c: f64| modes(alpha, c).finite_fixed_point();
        for outside in [low, high, 0.99 * low, 1.01 * high] {
            assert_eq!(has(outside), None, "alpha {alpha}, C {outside}");
        }
        for inside in [low + 1e-6, 0.5 * (low + high), high - 1e-6] {
            let ratio = has(inside).unwrap_or_else(|| panic!("alpha {alpha}, C {inside}"));
            assert!(ratio > 0.0 && ratio.is_finite());
            let residual = modes(alpha, inside).growth(ratio);
            assert!(
                residual.abs() <= tolerance::GROWTH_AT_FIXED_POINT.limit * ratio,
                "alpha {alpha}, C {inside}: {residual:e}"
            );
        }
    }
}

#[test]
fn on_the_border_of_the_interval_the_fixed_point_merges_with_a_trivial_one() {
    // Errata 8: α = 3, C = 1 is c_max itself; sliding takes over the unstable point from infinity.
    let points = modes(3.0, 1.0).fixed_points();
    assert_eq!(
        (points.spinning, points.finite, points.sliding),
        (Stability::Stable, None, Stability::Unstable)
    );
    assert_eq!(modes(3.0, 1.0).terminal_mode(1e9), TerminalMode::Spinning);
    // α = 3, C = c_min = 1/3: the same at ε = 0.
    let third = inertia_interval(3.0_f64, 0.0).0;
    let points = modes(3.0, third).fixed_points();
    assert_eq!(
        (points.spinning, points.finite, points.sliding),
        (Stability::Unstable, None, Stability::Stable)
    );
    // α = 0: C = 2/3 draws everything to spinning, C = 1/4 to sliding.
    let (low, high) = inertia_interval(0.0_f64, 0.0);
    assert_eq!(modes(0.0, high).terminal_mode(5.0), TerminalMode::Spinning);
    assert_eq!(modes(0.0, low).terminal_mode(0.1), TerminalMode::Sliding);
}

#[test]
fn the_linear_law_keeps_every_ratio_of_a_disk() {
    let disk = modes(1.0, 0.5);
    let points = disk.fixed_points();
    assert_eq!(
        [points.spinning, points.sliding],
        [Stability::Semistable; 2]
    );
    assert_eq!(points.finite, None);
    for ratio in [1e-3, 0.4, 1.0, 7.0] {
        assert_eq!(disk.growth(ratio), 0.0);
        assert_eq!(disk.terminal_mode(ratio), TerminalMode::Together { ratio });
    }
    assert_eq!(modes(1.0, 0.4).terminal_mode(1.0), TerminalMode::Sliding);
    assert_eq!(modes(1.0, 0.6).terminal_mode(1.0), TerminalMode::Spinning);
}

#[test]
fn an_unstable_point_parts_the_starts() {
    let disk = modes(3.0, 0.5);
    let border = disk.finite_fixed_point().unwrap();
    assert!((border - 1.0 / 3.0_f64.sqrt()).abs() <= tolerance::ROUNDING.limit);
    assert_eq!(
        disk.terminal_mode(border.next_down()),
        TerminalMode::Spinning
    );
    assert_eq!(
        disk.terminal_mode(border),
        TerminalMode::Together { ratio: border }
    );
    assert_eq!(disk.terminal_mode(border.next_up()), TerminalMode::Sliding);
    let stable = modes(0.0, 0.5);
    let ratio = stable.finite_fixed_point().unwrap();
    for start in [1e-9, 0.3, ratio, 2.0, 1e9] {
        assert_eq!(
            stable.terminal_mode(start),
            TerminalMode::Together { ratio }
        );
    }
    assert_eq!(stable.terminal_mode(0.0), TerminalMode::Spinning);
    assert_eq!(stable.terminal_mode(f64::INFINITY), TerminalMode::Sliding);
}

#[test]
fn growth_has_the_sign_of_the_motion() {
    for alpha in [-0.5, 0.0, 0.5, 1.5, 3.0] {
        for c in [0.2, 0.45, 0.5, 0.8] {
            let profile = DiskTable64::new(alpha).unwrap();
            let puck = Slider::new(
                profile,
                SliderParameters {
                    deceleration: 1.0,
                    radius: 1.0,
                    inertia_ratio: c,
                },
            )
            .unwrap();
            let modes = modes(alpha, c);
            for start in [0.05, 0.3, 0.6, 0.9, 1.1, 3.0, 20.0] {
                let launched = SliderState::launched(start, 1.0);
                let before = puck.ratio(&launched);
                let after = puck.ratio(&puck.advance(&launched, 1e-3).motion);
                let growth = modes.growth(start);
                if growth.abs() > 1e-6 * start {
                    assert_eq!(
                        after > before,
                        growth > 0.0,
                        "alpha {alpha}, C {c}, eps {start}"
                    );
                }
            }
        }
    }
}

#[test]
fn inertia_of_a_ratio_inverts_the_fixed_point() {
    for alpha in [-0.5, 0.0, 0.5, 2.0, 5.0] {
        let any = modes(alpha, 0.5);
        let mut last = any.inertia_ratio_of(0.0);
        assert!((last - 2.0 / (3.0 + alpha)).abs() < tolerance::ROUNDING.limit);
        for n in 1..200 {
            let ratio = f64::from(n) * 0.02;
            let c = any.inertia_ratio_of(ratio);
            // Falls for α < 1, rises for α > 1: one fixed point at most.
            assert_eq!(c < last, alpha < 1.0, "alpha {alpha}, eps {ratio}");
            last = c;
            let back = modes(alpha, c).finite_fixed_point().unwrap();
            assert!(
                (back / ratio - 1.0).abs() < tolerance::INERTIA_INVERTED.limit,
                "alpha {alpha}, eps {ratio}: {back}"
            );
        }
        let end = any.inertia_ratio_of(f64::INFINITY);
        assert!((end - (1.0 + alpha) / 4.0).abs() < tolerance::ROUNDING.limit);
    }
}

#[test]
fn impossible_inertia_is_refused() {
    for c in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(TerminalMotion::new(CoulombDisk, c).is_err(), "{c}");
    }
    assert_eq!(PowerLawFriction::<f64>::exponent(&CoulombDisk), 0.0);
}
