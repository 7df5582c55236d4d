//! The ends of the range: equal and nearly equal speeds, 600 decades between them, subnormal and
//! huge numbers.

use tribos_tests::patches::{Tier, exact};
use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};

use tribos_tests::tolerance;

/// Distance of subnormal numbers.
const SMALLEST: f64 = f64::from_bits(1);

/// Checks every row of hard_twists.csv in every exact tier; fails with all misses by name.
fn assert_rows(limit: f64, checks: impl Fn(&Row, &Tier<f64>) -> Vec<(Reference, f64)>) {
    let table = Table::read("hard_twists.csv");
    let mut misses = Vec::new();
    for alpha in table.distinct("alpha") {
        for tier in exact::<f64>(alpha) {
            for row in table.rows().filter(|row| row.number("alpha") == alpha) {
                for (wanted, got) in checks(&row, &tier) {
                    let error = wanted.relative(got);
                    // A subnormal result half-way between two numbers may be either of them.
                    let is_neighbour = (wanted.high - got).abs() <= SMALLEST;
                    if error > limit && !is_neighbour {
                        let name = row.text("name");
                        misses.push(format!(
                            "{name}, alpha {alpha}, {}: {got:e} instead of {:e} ({error:.1e})",
                            tier.0, wanted.high
                        ));
                    }
                }
            }
        }
    }
    assert!(
        misses.is_empty(),
        "{} misses\n{}",
        misses.len(),
        misses.join("\n")
    );
}

#[test]
fn every_hard_twist_has_its_force_and_torque() {
    assert_rows(tolerance::HARD_WRENCH.limit, |row, (_, tier)| {
        let got = tier.reduced_wrench(row.number("v"), row.number("w"));
        vec![
            (row.reference("F"), got.force),
            (row.reference("T"), got.torque),
        ]
    });
}

#[test]
fn every_hard_twist_has_its_derivatives() {
    assert_rows(tolerance::HARD_JACOBIAN.limit, |row, (_, tier)| {
        let got = tier.reduced_jacobian(row.number("v"), row.number("w"));
        let entries = [
            ("F_v", got.force_slide),
            ("F_w", got.mixed),
            ("T_w", got.torque_rim),
        ];
        // Blank: beyond the range of f64, on the side of its sign.
        let overflow = |x: f64| Reference::exact(f64::INFINITY.copysign(x));
        let reference = |column, x| row.optional(column).unwrap_or(overflow(x));
        entries
            .map(|(column, x)| (reference(column, x), x))
            .to_vec()
    });
}
