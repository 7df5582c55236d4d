//! Every tier keeps its bound at every row of the tables with 25 and more digits.

use tribos_tests::patches::{self, Tier};
use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};
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
            for tier in patches::all::<f64>(alpha) {
                for row in table.rows().filter(|row| row.number("alpha") == alpha) {
                    visit(&tier, row, alpha);
                }
            }
        }
    }
}

/// A tier, the exponents, the unit of its errors, and the bounds of force and torque.
type Line = (
    &'static str,
    [f64; 2],
    fn(&Reference, f64) -> f64,
    [Bound; 2],
);

const LINES: [Line; 8] = {
    use tolerance::*;
    let (relative, ulps) = (Reference::relative, Reference::ulps);
    [
        (
            "form disk",
            [0.0, 0.0],
            ulps,
            [FORM_FORCE_ULPS, FORM_TORQUE_ULPS],
        ),
        ("disk table", [0.0, 0.0], ulps, [TABLE_DRY_ULPS; 2]),
        ("disk table", [-0.75, 10.0], relative, [TABLE; 2]),
        ("disk table", [-0.99, -0.76], relative, [TABLE, TABLE_DEEP]),
        ("compact", [-0.99, 30.0], relative, [COMPACT; 2]),
        ("compact", [31.0, 128.0], relative, [COMPACT_ENDS; 2]),
        ("quadrature", [0.0, 5.0], relative, [QUADRATURE; 2]),
        (
            "quadrature",
            [-0.5, -0.01],
            relative,
            [QUADRATURE_FALLING; 2],
        ),
    ]
};

#[test]
fn every_tier_keeps_its_bound_of_force_and_torque() {
    for (of, [low, high], measure, bounds) in LINES {
        let label = |part| format!("f64 {of} {part}, alpha [{low}, {high}]");
        let [mut force, mut torque] = ["F", "T"].map(|part| Worst::of(label(part)));
        rows(low, high, |(name, tier), row, alpha| {
            if *name == of {
                let ratio = row.number("eps");
                let place = || format!("alpha {alpha}, eps {ratio:e}");
                let got = tier.reduced_wrench(ratio, 1.0);
                force.see(measure(&row.reference("F"), got.force), place);
                torque.see(measure(&row.reference("T"), got.torque), place);
            }
        });
        force.assert_within(&bounds[0]);
        // A bound of another order is there because it is needed.
        if bounds[1].limit > 2.0 * bounds[0].limit {
            torque.assert_excused(&bounds[1], &bounds[0]);
        } else {
            torque.assert_within(&bounds[1]);
        }
    }
}

fn assert_all(worst: &[Worst], bound: &Bound) {
    for worst in worst {
        worst.assert_within(bound);
    }
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
