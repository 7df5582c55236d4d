//! Final motion under pressures: fixed points, their uniqueness and their ends.

use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction, compact};
use tribos_core::modes::{Stability, TerminalMode, TerminalMotion, inertia_interval};
use tribos_tests::patches::pressure;
use tribos_tests::pucks::relative;
use tribos_tests::sweep;
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn compact(order: f64, alpha: f64) -> compact::CompactPower<f64> {
    compact::CompactPower::with_pressure(alpha, pressure(order)).expect("in range")
}

fn table(order: f64, alpha: f64) -> RoundTable64 {
    RoundTable64::new(alpha, pressure(order)).expect("in range")
}

#[test]
fn fixed_points_are_those_of_the_table() {
    let [mut by_table, mut by_series, mut ends] = [
        "finite fixed points of pressures, table",
        "finite fixed points of pressures, compact",
        "ends of C_alpha",
    ]
    .map(Worst::of);
    for row in Table::read("modes_pressure.csv").rows() {
        let [order, alpha, c] = ["q", "alpha", "C"].map(|column| row.number(column));
        let place = || format!("q {order}, alpha {alpha}, C {c}");
        let (low, high) = inertia_interval(alpha, order);
        let [spinning, sliding] = ["c_spinning", "c_sliding"].map(|column| row.reference(column));
        let falls = spinning.high > sliding.high;
        let [least, most] = if falls {
            [sliding, spinning]
        } else {
            [spinning, sliding]
        };
        ends.see(least.relative(low), place);
        ends.see(most.relative(high), place);
        let table = TerminalMotion::new(table(order, alpha), c).expect("in range");
        let series = TerminalMotion::new(compact(order, alpha), c).expect("in range");
        for (worst, points) in [
            (&mut by_table, table.fixed_points()),
            (&mut by_series, series.fixed_points()),
        ] {
            match (row.optional("eps0"), points.finite) {
                (Some(wanted), Some((got, stability))) => {
                    worst.see(wanted.relative(got), place);
                    let wanted = if alpha < 1.0 {
                        Stability::Stable
                    } else {
                        Stability::Unstable
                    };
                    assert_eq!(stability, wanted, "{}", place());
                    assert_ne!(points.spinning, stability, "{}", place());
                    assert_ne!(points.sliding, stability, "{}", place());
                }
                (None, None) => {}
                (wanted, got) => panic!("{}: {got:?} instead of {wanted:?}", place()),
            }
        }
    }
    by_table.assert_within(&tolerance::TABLE_FIXED_POINT);
    by_series.assert_within(&tolerance::PRESSURE_FIXED_POINT);
    ends.assert_within(&tolerance::INERTIA_ENDS);
}

/// True if C_α of the profile falls (or rises, for α > 1) over all ratios, to rounding.
fn is_monotone(
    modes: &TerminalMotion<f64, compact::CompactPower<f64>>,
    ratios: &[f64],
    alpha: f64,
) -> bool {
    let sense = if alpha < 1.0 { -1.0 } else { 1.0 };
    let mut last: Option<f64> = None;
    ratios.iter().all(|&ratio| {
        let next = modes.inertia_ratio_of(ratio);
        let slack = 4.0 * tolerance::IDENTITY.limit * next;
        let fine = last.is_none_or(|last| sense * (next - last) >= -slack);
        last = Some(next);
        fine
    })
}

#[test]
fn inertia_ratio_of_the_fixed_point_is_monotone_for_every_pressure() {
    let mut ratios = sweep::ratios(200);
    ratios.retain(|ratio| (1e-6..1e6).contains(ratio));
    ratios.sort_by(f64::total_cmp);
    let mut exceptions = Vec::new();
    for order in (-8..=48).map(|n| f64::from(n) / 8.0) {
        for alpha in [
            -0.9, -0.75, -0.5, -0.2, 0.0, 0.3, 0.6, 0.9, 0.99, 1.01, 1.2, 2.0, 3.0, 5.0, 7.0, 9.0,
        ] {
            let modes = TerminalMotion::new(compact(order, alpha), 0.5).expect("in range");
            if !is_monotone(&modes, &ratios, alpha) {
                exceptions.push((order, alpha));
            }
        }
    }
    assert!(exceptions.is_empty(), "{exceptions:?}");
}

#[test]
fn a_fixed_point_is_where_friction_keeps_the_ratio() {
    // C F = eps T, the residual of the definition by the other tier's force and torque.
    let mut worst = Worst::of("C F - eps T at fixed points, relative");
    for order in [-1.0, -0.5, 0.5, 1.0, 3.0] {
        for alpha in [-0.5, 0.0, 0.5, 0.9, 1.5, 3.0] {
            let (least, most) = inertia_interval(alpha, order);
            for share in [0.02, 0.3, 0.5, 0.7, 0.98] {
                let c = least + share * (most - least);
                let modes = TerminalMotion::new(table(order, alpha), c).expect("in range");
                let ratio = modes.finite_fixed_point().expect("inside the interval");
                let got = compact(order, alpha).reduced_wrench(ratio, 1.0);
                let residual = (c * got.force / (ratio * got.torque) - 1.0).abs();
                worst.see(residual, || {
                    format!("q {order}, alpha {alpha}, C {c}: {ratio}")
                });
                assert_eq!(modes.terminal_mode(ratio), TerminalMode::Together { ratio });
            }
        }
    }
    worst.assert_within(&tolerance::FIXED_POINT_RESIDUAL);
}

#[test]
fn no_finite_fixed_point_exists_at_the_ends_of_the_interval_and_one_does_inside() {
    for order in [-1.0, -0.5, 0.5, 1.0] {
        for alpha in [-0.5, 0.0, 0.5, 2.0, 3.0] {
            let profile = compact(order, alpha);
            let (least, most) = inertia_interval(alpha, order);
            let at = |c: f64| TerminalMotion::new(profile, c).expect("in range");
            assert_eq!(at(least).inertia_interval(), (least, most));
            let [spinning, sliding] = PowerLawFriction::<f64>::inertia_ends(&profile);
            let wanted = [
                2.0 / (2.0 * order + 3.0 + alpha),
                (1.0 + alpha) / (2.0 * order + 4.0),
            ];
            assert!(relative(spinning, wanted[0]) <= tolerance::ROUNDING.limit);
            assert!(relative(sliding, wanted[1]) <= tolerance::ROUNDING.limit);
            for end in [least, most] {
                assert_eq!(
                    at(end).finite_fixed_point(),
                    None,
                    "q {order}, alpha {alpha}, C {end}"
                );
            }
            for inside in [least * (1.0 + 1e-9), most * (1.0 - 1e-9)] {
                let found = at(inside).finite_fixed_point();
                assert!(
                    found.is_some_and(|ratio| ratio > 0.0 && ratio.is_finite()),
                    "{found:?}"
                );
            }
            // Beyond the ends one pure motion takes all: g has the sign of C_alpha - C.
            for (c, spinning, sliding) in [
                (least * 0.9, Stability::Unstable, Stability::Stable),
                (most * 1.1, Stability::Stable, Stability::Unstable),
            ] {
                let points = at(c).fixed_points();
                assert_eq!(
                    (points.spinning, points.sliding),
                    (spinning, sliding),
                    "C {c}"
                );
            }
        }
    }
}

#[test]
fn on_the_border_itself_the_pure_motion_next_to_it_wins_or_loses_as_its_neighbourhood_does() {
    for order in [-1.0, -0.5, 0.5, 1.0] {
        for alpha in [-0.5, 0.0, 0.5, 2.0, 3.0] {
            let profile = compact(order, alpha);
            let [spinning, sliding] = PowerLawFriction::<f64>::inertia_ends(&profile);
            // g has the sign of C_alpha - C, of a ratio close to the border's own end.
            let at = |c: f64| TerminalMotion::new(profile, c).expect("in range");
            let grows = at(spinning).growth(0.05) > 0.0;
            let wanted = if grows {
                Stability::Unstable
            } else {
                Stability::Stable
            };
            assert_eq!(
                at(spinning).fixed_points().spinning,
                wanted,
                "q {order}, alpha {alpha}"
            );
            let grows = at(sliding).growth(20.0) > 0.0;
            let wanted = if grows {
                Stability::Stable
            } else {
                Stability::Unstable
            };
            assert_eq!(
                at(sliding).fixed_points().sliding,
                wanted,
                "q {order}, alpha {alpha}"
            );
        }
    }
}

#[test]
fn linear_friction_keeps_every_ratio_if_the_inertia_is_that_of_the_pressure() {
    for order in [-1.0, -0.5, 0.0, 0.5, 1.0, 2.0] {
        let c = 1.0 / (order + 2.0);
        for points in [
            TerminalMotion::new(compact(order, 1.0), c)
                .expect("in range")
                .fixed_points(),
            TerminalMotion::new(table(order, 1.0), c)
                .expect("in range")
                .fixed_points(),
        ] {
            assert_eq!(points.spinning, Stability::Semistable, "q {order}");
            assert_eq!(points.sliding, Stability::Semistable, "q {order}");
            assert_eq!(points.finite, None);
        }
        let modes = TerminalMotion::new(compact(order, 1.0), c).expect("in range");
        for ratio in [1e-3, 0.5, 1.0, 40.0] {
            assert!(modes.growth(ratio).abs() <= tolerance::ROUNDING.limit * ratio);
            assert_eq!(modes.terminal_mode(ratio), TerminalMode::Together { ratio });
        }
        for (factor, spinning, sliding) in [
            (0.99, Stability::Unstable, Stability::Stable),
            (1.01, Stability::Stable, Stability::Unstable),
        ] {
            let points = TerminalMotion::new(compact(order, 1.0), c * factor)
                .expect("in range")
                .fixed_points();
            assert_eq!(
                (points.spinning, points.sliding),
                (spinning, sliding),
                "q {order}"
            );
        }
    }
}

#[test]
fn a_dry_ring_on_its_own_rim_keeps_equal_speeds() {
    // Symmetric in both speeds: C = 1 has eps0 = 1, and C_0 runs from 2 to 1/2.
    let modes = TerminalMotion::new(CoulombRing, 1.0_f64).expect("in range");
    assert_eq!(modes.inertia_interval(), (0.5, 2.0));
    let ratio = modes.finite_fixed_point().expect("inside");
    assert!(
        (ratio - 1.0).abs() <= tolerance::PRESSURE_FIXED_POINT.limit,
        "{ratio}"
    );
}
