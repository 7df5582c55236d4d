//! Force, torque and lateral function of every pressure at every row of the tables with 25 and
//! more digits, and the derivatives of the first two.

use tribos_core::coupling::round::{LateralPolynomialTable, PolynomialTable};
use tribos_core::coupling::{Annulus, ReducedFriction};
use tribos_core::patch::PolynomialPressure;
use tribos_tests::patches::{self, RowErrors, numbers};
use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

const POWERS: [&str; 5] = [
    "ring.csv",
    "hertz.csv",
    "punch.csv",
    "paraboloid.csv",
    "pressures.csv",
];

/// A tier, the exponents between which a bound of F, T and G and of the derivatives is promised.
const PROMISED: [(&str, [f64; 2], Bound, Bound); 8] = {
    use tolerance::*;
    [
        ("round table", [-0.5, 3.0], ROUND_TABLE, ROUND_JACOBIAN),
        (
            "round table",
            [-0.9, 10.0],
            ROUND_TABLE_ENDS,
            ROUND_JACOBIAN,
        ),
        (
            "round compact",
            [-0.75, 10.0],
            ROUND_COMPACT,
            ROUND_COMPACT_JACOBIAN,
        ),
        (
            "round compact",
            [-0.9, -0.9],
            ROUND_COMPACT_DEEP,
            ROUND_COMPACT_JACOBIAN,
        ),
        ("form ring", [0.0, 0.0], FORM, FORM_JACOBIAN),
        ("form punch", [0.0, 0.0], FORM, FORM_JACOBIAN),
        ("form Hertz", [0.0, 0.0], FORM, FORM_JACOBIAN),
        ("form paraboloid", [0.0, 0.0], FORM, FORM_JACOBIAN),
    ]
};

#[test]
fn every_tier_keeps_its_bound_at_every_row() {
    let name =
        |line: &(&str, [f64; 2], Bound, Bound)| format!("f64 {}, alpha {:?}", line.0, line.1);
    let mut errors = PROMISED.each_ref().map(|line| RowErrors::of(&name(line)));
    for table in POWERS.map(Table::read) {
        for order in table.distinct("q") {
            for alpha in table.distinct("alpha") {
                let tiers = patches::tiers::<f64>(order, alpha);
                for ((of, [low, high], ..), errors) in PROMISED.iter().zip(&mut errors) {
                    let is_meant = |name: &str| name == *of && (*low..=*high).contains(&alpha);
                    let Some((_, tier)) = tiers.iter().find(|(name, _)| is_meant(name)) else {
                        continue;
                    };
                    let here = |row: &Row| row.number("q") == order && row.number("alpha") == alpha;
                    for row in table.rows().filter(here) {
                        let ratio = row.number("eps");
                        let place = || format!("q {order}, alpha {alpha}, eps {ratio:e}");
                        errors.see(tier.as_ref(), &row, place);
                    }
                }
            }
        }
    }
    for ((of, _, wrench, derivatives), errors) in PROMISED.iter().zip(&errors) {
        errors.assert_within(wrench, derivatives);
        for (_, bounds) in FORMS.iter().filter(|(name, _)| name == of) {
            errors.assert_ulps(bounds);
        }
    }
}

/// A fitted form and the bounds of its force and torque.
const FORMS: [(&str, [Bound; 2]); 4] = {
    use tolerance::*;
    [
        ("form ring", [FORM_FORCE_RING_ULPS, FORM_TORQUE_ENDS_ULPS]),
        ("form punch", [FORM_FORCE_ULPS, FORM_TORQUE_ULPS]),
        ("form Hertz", [FORM_FORCE_ULPS, FORM_TORQUE_ULPS]),
        ("form paraboloid", [FORM_FORCE_ULPS, FORM_TORQUE_ENDS_ULPS]),
    ]
};

#[test]
fn fitted_forms_and_f32_tables_hit_arguments_that_f32_can_hold() {
    let [mut forms, mut rounds] = [
        "f32 fitted forms F, T, G (ulp)",
        "f32 round tiers F, T, G, alpha [-0.75, 5] (ulp)",
    ]
    .map(Worst::of);
    let is_single = |x: f64| f64::from(x as f32) == x;
    for rows in POWERS.map(Table::read) {
        for row in rows.rows() {
            let [order, alpha, ratio] = ["q", "alpha", "eps"].map(|column| row.number(column));
            let served = (-0.75..=5.0).contains(&alpha) && row.number("T") > 1e-30;
            if !(is_single(order) && is_single(alpha) && is_single(ratio) && served) {
                continue;
            }
            for (name, tier) in patches::tiers::<f32>(order, alpha) {
                let got = tier.reduced_wrench(ratio as f32, 1.0);
                let lateral = tier.lateral(ratio as f32, 1.0);
                let place = || format!("{name}, q {order}, alpha {alpha}, eps {ratio:e}");
                let worst = if name.starts_with("form") {
                    &mut forms
                } else {
                    &mut rounds
                };
                for (column, got) in [("F", got.force), ("T", got.torque), ("G", lateral)] {
                    worst.see(row.reference(column).ulps_f32(got), place);
                }
            }
        }
    }
    forms.assert_within(&tolerance::SINGLE_FORM_ULPS);
    rounds.assert_within(&tolerance::SINGLE_ROUND_ULPS);
}

#[test]
fn lateral_function_of_the_uniform_disk_stays_within_its_bound() {
    let mut exact = Worst::of("f64 uniform disk G, alpha [-0.9, 10]");
    let table = Table::read("uniform_lateral.csv");
    for alpha in table.distinct("alpha") {
        let mut tiers = patches::disks::<f64>(alpha);
        tiers.extend(patches::tiers(0.0, alpha).into_iter().take(2));
        for (name, tier) in &tiers {
            for row in table.rows().filter(|row| row.number("alpha") == alpha) {
                let ratio = row.number("eps");
                let error = row.reference("G").relative(tier.lateral(ratio, 1.0));
                exact.see(error, || format!("{name}, alpha {alpha}, eps {ratio:e}"));
            }
        }
    }
    exact.assert_within(&tolerance::DISK_LATERAL);
}

/// The disk's factor of cancellation under an annulus of inner ratio k: 2/(1−k).
fn cancellation(inner: f64) -> f64 {
    2.0 / (1.0 - inner)
}

#[test]
fn annuli_lose_what_cancels_and_no_more() {
    let of = |disk: &str| {
        ["F, T, G", "dF, dT"]
            .map(|part| Worst::of(format!("f64 annulus of {disk}, {part} (of 2/(1-k))")))
    };
    let mut exact = of("forms and tables");
    let thin = ["alpha >= 0", "alpha < 0"];
    let mut thin = thin.map(|part| Worst::of(format!("thin bands, {part}, F, T")));
    let table = Table::read("annulus.csv");
    for alpha in table.distinct("alpha") {
        let mut tiers = patches::disks::<f64>(alpha);
        tiers.extend(patches::tiers(0.0, alpha).into_iter().take(2));
        for (name, tier) in tiers {
            let [wrench, derivatives] = &mut exact;
            let kind = usize::from(alpha < 0.0);
            let is_promised = name == "disk table" || name == "form disk";
            for row in table.rows().filter(|row| row.number("alpha") == alpha) {
                let [inner, ratio] = ["k", "eps"].map(|column| row.number(column));
                let band = Annulus::new(tier.as_ref(), inner).expect("an inner ratio in range");
                let place = || format!("{name}, k {inner}, alpha {alpha}, eps {ratio:e}");
                let [f, t, g, _, slide, mixed, ..] = numbers(&band, ratio, 1.0);
                for (column, got) in [("F", f), ("T", t), ("G", g)] {
                    let error = row.reference(column).relative(got);
                    wrench.see(error / cancellation(inner), place);
                    // Thin bands keep the digits of their disks: means over rings.
                    if inner >= 0.99 && column != "G" && is_promised {
                        thin[kind].see(error, place);
                    }
                }
                let drag = row.number("F") / ratio;
                for (column, got) in [("dF", slide), ("dT", mixed)] {
                    let error = patches::slope_error(&row.reference(column), got, drag);
                    derivatives.see(error / cancellation(inner), place);
                }
            }
        }
    }
    let bounds = {
        use tolerance::*;
        [
            ANNULUS,
            ANNULUS_JACOBIAN,
            THIN_ANNULUS,
            THIN_ANNULUS_WEAKENING,
        ]
    };
    for (worst, bound) in exact.iter().chain(&thin).zip(bounds) {
        worst.assert_within(&bound);
    }
}

#[test]
fn polynomial_pressures_stay_within_their_bound() {
    let mut errors = RowErrors::of("f64 polynomial");
    let table = Table::read("polynomial.csv");
    let mut built: Option<([f64; 4], LateralPolynomialTable)> = None;
    for row in table.rows() {
        let key = ["a0", "a1", "a2", "alpha"].map(|column| row.number(column));
        let [a0, a1, a2, alpha] = key;
        if built.as_ref().is_none_or(|(of, _)| *of != key) {
            let pressure = PolynomialPressure::new([a0, a1, a2]).expect("a positive pressure");
            let table = LateralPolynomialTable::new(alpha, &pressure).expect("in range");
            built = Some((key, table));
        }
        let Some((_, tier)) = &built else { continue };
        let ratio = row.number("eps");
        let place = || format!("a {a0} {a1} {a2}, alpha {alpha}, eps {ratio:e}");
        errors.see(tier, &row, place);
    }
    errors.assert_within(&tolerance::POLYNOMIAL_TABLE, &tolerance::ROUND_JACOBIAN);
}

#[test]
fn polynomial_table_is_the_lateral_one_without_its_lateral_function() {
    let pressure = PolynomialPressure::new([0.2, 1.0, 0.3]).expect("a positive pressure");
    let plain = PolynomialTable::new(0.5, &pressure).expect("in range");
    let lateral = LateralPolynomialTable::new(0.5, &pressure).expect("in range");
    for ratio in [0.0, 0.3, 1.0, 1.7, 1e5] {
        assert_eq!(
            plain.reduced_wrench(ratio, 1.0),
            lateral.reduced_wrench(ratio, 1.0)
        );
        assert_eq!(
            plain.reduced_jacobian(ratio, 1.0),
            lateral.reduced_jacobian(ratio, 1.0)
        );
    }
}

#[test]
fn infinite_slopes_of_the_tables_are_infinite() {
    // Rows at equal speeds, where q + α ≤ -1/2 or so: +-inf, never a large number.
    let table = Table::read("pressures.csv");
    let mut seen = 0;
    for row in table.rows().filter(|row| !row.number("dF").is_finite()) {
        let (order, alpha) = (row.number("q"), row.number("alpha"));
        for (name, tier) in patches::tiers::<f64>(order, alpha) {
            let got = tier.reduced_jacobian(row.number("eps"), 1.0);
            for (column, got) in [("dF", got.force_slide), ("dT", got.mixed)] {
                let wanted: &Reference = &row.reference(column);
                assert_eq!(
                    got, wanted.high,
                    "{name}, q {order}, alpha {alpha}: {column}"
                );
            }
            seen += 1;
        }
    }
    assert!(seen > 0, "no such row");
}
