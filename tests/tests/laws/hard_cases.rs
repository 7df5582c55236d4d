//! The ends of the range: equal and nearly equal speeds, 600 decades between them, subnormal and
//! huge numbers, zeros of either sign.

use tribos_core::coupling::{ReducedJacobian, ReducedWrench};
use tribos_core::real::Real;
use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tiers;
use tribos_tests::tolerance;

const EXPONENTS: [f64; 8] = [-0.9, -0.5, 0.0, 0.25, 0.5, 1.0, 1.5, 3.0];

/// Distance of subnormal numbers.
const SMALLEST: f64 = f64::from_bits(1);

fn wrench<R: Real>(w: ReducedWrench<R>) -> [f64; 2] {
    [w.force, w.torque].map(R::to_f64)
}

fn jacobian<R: Real>(j: ReducedJacobian<R>) -> [f64; 4] {
    [j.force_per_slide, j.force_slide, j.mixed, j.torque_rim].map(R::to_f64)
}

/// Checks every row of hard_twists.csv in every exact tier; fails with all misses by name.
fn assert_rows(
    limit: impl Fn(&str) -> f64,
    checks: impl Fn(&Row, &tiers::Tier<f64>) -> Vec<(Reference, f64)>,
) {
    let table = Table::read("hard_twists.csv");
    let mut misses = Vec::new();
    for alpha in table.distinct("alpha") {
        for tier in tiers::exact::<f64>(alpha) {
            for row in table.rows().filter(|row| row.number("alpha") == alpha) {
                for (wanted, got) in checks(&row, &tier) {
                    let error = wanted.relative(got);
                    // A subnormal result half-way between two numbers may be either of them.
                    let is_neighbour = (wanted.high - got).abs() <= SMALLEST;
                    if error > limit(tier.0) && !is_neighbour {
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
    let limit = |tier: &str| match tier {
        "coulomb compact" => tolerance::AGM.limit,
        _ => tolerance::HARD_WRENCH.limit,
    };
    assert_rows(limit, |row, (_, tier)| {
        let got = tier.reduced_wrench(row.number("v"), row.number("w"));
        vec![
            (row.reference("F"), got.force),
            (row.reference("T"), got.torque),
        ]
    });
}

#[test]
fn every_hard_twist_has_its_derivatives() {
    assert_rows(
        |_| tolerance::HARD_JACOBIAN.limit,
        |row, (_, tier)| {
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
        },
    );
}

#[test]
fn signs_of_the_arguments_do_not_matter() {
    for alpha in EXPONENTS {
        for (name, tier) in tiers::all::<f64>(alpha) {
            for (slide, rim) in [
                (0.7, 1.1),
                (1.3, 0.2),
                (0.0, 1.0),
                (1.0, 0.0),
                (0.0, 0.0),
                (2.0, 2.0),
            ] {
                let bits = |v, w| {
                    let wrench = wrench(tier.reduced_wrench(v, w)).map(f64::to_bits);
                    let jacobian = jacobian(tier.reduced_jacobian(v, w)).map(f64::to_bits);
                    (wrench, jacobian)
                };
                let wanted = bits(slide, rim);
                for (v, w) in [(-slide, rim), (slide, -rim), (-slide, -rim)] {
                    assert_eq!(bits(v, w), wanted, "{name}, alpha {alpha}: ({v}, {w})");
                }
            }
        }
    }
}

#[test]
fn a_body_at_rest_feels_no_friction_and_its_damping_is_the_limit() {
    for alpha in EXPONENTS {
        for (name, tier) in tiers::exact::<f64>(alpha) {
            assert_eq!(wrench(tier.reduced_wrench(0.0, -0.0)), [0.0, 0.0], "{name}");
            let [slide, rim] = match alpha {
                1.0 => [1.0, 0.5],
                a if a > 1.0 => [0.0, 0.0],
                _ => [f64::INFINITY, f64::INFINITY],
            };
            let got = jacobian(tier.reduced_jacobian(0.0, 0.0));
            assert_eq!(got, [slide, slide, 0.0, rim], "{name}, alpha {alpha}");
        }
    }
}
