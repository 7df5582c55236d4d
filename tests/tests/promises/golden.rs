//! Every tier keeps its bound at every row of the tables with 25 and more digits.

use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tiers::{self, Tier};
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

const TABLES: [&str; 2] = ["uniform.csv", "exponents.csv"];

/// Calls `visit` for every row whose exponent lies in [`low`, `high`], with that exponent's tiers.
fn rows(low: f64, high: f64, mut visit: impl FnMut(&Tier<f64>, Row, f64)) {
    for name in TABLES {
        let table = Table::read(name);
        for alpha in table.distinct("alpha") {
            if !(low..=high).contains(&alpha) {
                continue;
            }
            for tier in tiers::all::<f64>(alpha) {
                for row in table.rows().filter(|row| row.number("alpha") == alpha) {
                    visit(&tier, row, alpha);
                }
            }
        }
    }
}

/// The worst of force and torque over the rows of one tier, by `measure`.
fn wrench(
    quantities: [&'static str; 2],
    tier_name: &str,
    [low, high]: [f64; 2],
    measure: impl Fn(&Reference, f64) -> f64,
) -> [Worst; 2] {
    let [mut force, mut torque] = quantities.map(Worst::of);
    rows(low, high, |(name, tier), row, alpha| {
        if *name == tier_name {
            let ratio = row.number("eps");
            let place = || format!("alpha {alpha}, eps {ratio:e}");
            let got = tier.reduced_wrench(ratio, 1.0);
            force.see(measure(&row.reference("F"), got.force), place);
            torque.see(measure(&row.reference("T"), got.torque), place);
        }
    });
    [force, torque]
}

fn assert_all(worst: &[Worst], bound: &Bound) {
    for worst in worst {
        worst.assert_within(bound);
    }
}

#[test]
fn coulomb_tables_stay_within_five_ulps() {
    for name in ["coulomb table", "table"] {
        let quantities = ["f64 table F, alpha 0 (ulp)", "f64 table T, alpha 0 (ulp)"];
        let worst = wrench(quantities, name, [0.0, 0.0], Reference::ulps);
        assert_all(&worst, &tolerance::COULOMB_TABLE_ULPS);
    }
}

#[test]
fn power_tables_stay_within_their_bound() {
    let names = [
        "f64 table F, alpha [-0.75, 10]",
        "f64 table T, alpha [-0.75, 10]",
    ];
    let worst = wrench(names, "table", [-0.75, 10.0], Reference::relative);
    assert_all(&worst, &tolerance::TABLE);
    let names = [
        "f64 table F, alpha [-0.99, -0.75)",
        "f64 table T, alpha [-0.99, -0.75)",
    ];
    let [force, torque] = wrench(names, "table", [-0.99, -0.76], Reference::relative);
    force.assert_within(&tolerance::TABLE);
    torque.assert_excused(&tolerance::TABLE_DEEP, &tolerance::TABLE);
}

#[test]
fn elliptic_coulomb_stays_within_its_bound() {
    let names = ["f64 AGM F", "f64 AGM T"];
    let worst = wrench(names, "coulomb compact", [0.0, 0.0], Reference::relative);
    assert_all(&worst, &tolerance::AGM);
}

#[test]
fn compact_powers_stay_within_their_bound() {
    let names = [
        "f64 compact F, alpha [-0.99, 30]",
        "f64 compact T, alpha [-0.99, 30]",
    ];
    let worst = wrench(names, "compact", [-0.99, 30.0], Reference::relative);
    assert_all(&worst, &tolerance::COMPACT);
}

#[test]
fn compact_powers_work_up_to_their_largest_exponent() {
    let names = [
        "f64 compact F, alpha 50 and 100",
        "f64 compact T, alpha 50 and 100",
    ];
    let worst = wrench(names, "compact", [31.0, 128.0], Reference::relative);
    assert_all(&worst, &tolerance::COMPACT_ENDS);
}

#[test]
fn quadrature_keeps_its_promise() {
    let names = [
        "f64 quadrature F, alpha [0, 5]",
        "f64 quadrature T, alpha [0, 5]",
    ];
    let worst = wrench(names, "quadrature", [0.0, 5.0], Reference::relative);
    assert_all(&worst, &tolerance::QUADRATURE);
    let names = [
        "f64 quadrature F, alpha [-0.5, 0)",
        "f64 quadrature T, alpha [-0.5, 0)",
    ];
    let worst = wrench(names, "quadrature", [-0.5, -0.01], Reference::relative);
    assert_all(&worst, &tolerance::QUADRATURE_FALLING);
}

/// Derivatives of F and T of the tiers that are exact, relative.
fn jacobian(quantities: [&'static str; 2], range: [f64; 2]) -> [Worst; 2] {
    let [mut force, mut torque] = quantities.map(Worst::of);
    rows(range[0], range[1], |(name, tier), row, alpha| {
        let ratio = row.number("eps");
        if *name == "quadrature" || !row.number("F").is_finite() {
            return;
        }
        let place = || format!("{name}, alpha {alpha}, eps {ratio:e}");
        let got = tier.reduced_jacobian(ratio, 1.0);
        force.see(row.reference("dF").relative(got.force_slide), place);
        torque.see(row.reference("dT").relative(got.mixed), place);
    });
    [force, torque]
}

#[test]
fn derivatives_stay_within_their_bound() {
    let worst = jacobian(
        [
            "f64 dF/dv, alpha [-0.95, 30]",
            "f64 dT/dv, alpha [-0.95, 30]",
        ],
        [-0.95, 30.0],
    );
    assert_all(&worst, &tolerance::JACOBIAN);
    let [force, torque] = jacobian(
        ["f64 dF/dv, alpha -0.99", "f64 dT/dv, alpha -0.99"],
        [-0.99, -0.96],
    );
    force.assert_excused(&tolerance::JACOBIAN_DEEP, &tolerance::JACOBIAN);
    torque.assert_within(&tolerance::JACOBIAN);
}

#[test]
fn the_other_two_entries_follow_from_homogeneity() {
    // F/v directly; w dT/dw = alpha T - v dT/dv, in units of the larger term.
    let [mut drag, mut spin] = ["f64 F/v", "f64 dT/dw (of its larger term)"].map(Worst::of);
    rows(-0.99, 30.0, |(name, tier), row, alpha| {
        let ratio = row.number("eps");
        let (force, torque) = (row.number("F"), row.number("T"));
        if *name == "quadrature" || ratio == 0.0 || !force.is_finite() {
            return;
        }
        let place = || format!("{name}, alpha {alpha}, eps {ratio:e}");
        let got = tier.reduced_jacobian(ratio, 1.0);
        drag.see((got.force_per_slide * ratio / force - 1.0).abs(), place);
        let along = ratio * row.number("dT");
        let terms = (alpha * torque).abs() + along.abs();
        let error = (got.torque_rim - (alpha * torque - along)).abs();
        spin.see(if error == 0.0 { 0.0 } else { error / terms }, place);
    });
    assert_all(&[drag, spin], &tolerance::JACOBIAN_DENSE);
}

#[test]
fn quadrature_derivatives_keep_their_promise() {
    let mut worst = Worst::of("f64 quadrature dF/dv, dT/dv, alpha [0, 10] (of F/v)");
    rows(0.0, 10.0, |(name, tier), row, alpha| {
        let ratio = row.number("eps");
        if *name != "quadrature" || ratio == 0.0 {
            return;
        }
        let place = || format!("alpha {alpha}, eps {ratio:e}");
        let drag = row.number("F") / ratio;
        let got = tier.reduced_jacobian(ratio, 1.0);
        worst.see(row.reference("dF").over(got.force_slide, drag), place);
        worst.see(row.reference("dT").over(got.mixed, drag), place);
    });
    worst.assert_within(&tolerance::QUADRATURE_JACOBIAN);
}
