//! Odd exponents: the double sums of appendix A, with their errata, against the kernel.

use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{ReducedFriction, ReducedWrench};
use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn power(alpha: f64, ratio: f64) -> ReducedWrench<f64> {
    DiskTable64::new(alpha).unwrap().reduced_wrench(ratio, 1.0)
}

fn relative(got: f64, wanted: f64) -> f64 {
    (got / wanted - 1.0).abs()
}

#[test]
fn odd_exponents_are_the_rational_polynomials_of_the_table() {
    let table = Table::read("odd_exponents.csv");
    let mut worst = Worst::of("odd exponents");
    for alpha in table.distinct("alpha") {
        for e in [0.01, 0.3, 0.7, 1.0, 1.3, 4.0, 50.0_f64] {
            let sum = |quantity: &str| -> f64 {
                let rows = table.rows().filter(|row| row.number("alpha") == alpha);
                let rows = rows.filter(|row| row.text("quantity") == quantity);
                let coefficient = |row: &Row| row.number("numerator") / row.number("denominator");
                rows.map(|row| coefficient(&row) * e.powi(row.number("power") as i32))
                    .sum()
            };
            let got = power(alpha, e);
            let place = || format!("alpha {alpha}, eps {e}");
            worst.see(Reference::exact(sum("F")).relative(got.force), place);
            worst.see(Reference::exact(sum("T")).relative(got.torque), place);
        }
    }
    worst.assert_within(&tolerance::POLYNOMIAL);
}

fn factorial(n: u32) -> f64 {
    (1..=n).map(f64::from).product()
}

/// (n − 1)!!/n!! for even n: 1·3·5…/(2·4·6…).
fn odd_over_even(n: u32) -> f64 {
    (1..=n / 2)
        .map(|k| f64::from(2 * k - 1) / f64::from(2 * k))
        .product()
}

/// How A.7 and A.9 are read.
#[derive(Clone, Copy, PartialEq)]
enum Reading {
    Corrected,
    Printed,
}

/// A.7 with α = 2n + 1; printed without l! in the denominator.
fn force_a7(n: u32, e: f64, reading: Reading) -> f64 {
    let term = |k: u32, l: u32| {
        let bracket = match l {
            l if l % 2 == 0 => 2.0 * e / f64::from(2 * k - l + 2) * odd_over_even(l),
            l => -2.0 / f64::from(2 * k - l + 3) * odd_over_even(l + 1),
        };
        let missing = if reading == Reading::Printed {
            1.0
        } else {
            factorial(l)
        };
        (-2.0 * e).powi(l as i32) / (factorial(k - l) * missing) * bracket
    };
    double_sum(n, e, term)
}

/// A.9 with α = 2n + 1; the odd branch is printed with half its factor.
fn torque_a9(n: u32, e: f64, reading: Reading) -> f64 {
    let odd_factor = if reading == Reading::Printed {
        -e
    } else {
        -2.0 * e
    };
    let term = |k: u32, l: u32| {
        let bracket = match l {
            l if l % 2 == 0 => 2.0 / f64::from(2 * k - l + 4) * odd_over_even(l),
            l => odd_factor / f64::from(2 * k - l + 3) * odd_over_even(l + 1),
        };
        (-2.0 * e).powi(l as i32) / (factorial(k - l) * factorial(l)) * bracket
    };
    double_sum(n, e, term)
}

fn double_sum(n: u32, e: f64, term: impl Fn(u32, u32) -> f64) -> f64 {
    let outer = |k: u32| {
        let inner: f64 = (0..=k).map(|l| term(k, l)).sum();
        (e * e).powi((n - k) as i32) / factorial(n - k) * inner
    };
    factorial(n) * (0..=n).map(outer).sum::<f64>()
}

#[test]
fn appendix_a_holds_once_corrected() {
    let mut worst = Worst::of("A.7, A.9");
    for n in 0..=4 {
        for e in [0.05, 0.3, 0.7, 1.0, 1.6, 5.0] {
            let got = power(f64::from(2 * n + 1), e);
            let place = || format!("n {n}, eps {e}");
            worst.see(
                relative(force_a7(n, e, Reading::Corrected), got.force),
                place,
            );
            worst.see(
                relative(torque_a9(n, e, Reading::Corrected), got.torque),
                place,
            );
        }
    }
    worst.assert_within(&tolerance::POLYNOMIAL);
}

#[test]
fn appendix_a_as_printed_is_wrong_by_the_factors_of_the_errata() {
    let e = 0.7;
    let printed = |n| force_a7(n, e, Reading::Printed) / power(f64::from(2 * n + 1), e).force;
    // Right by luck for α = 1 and 3, where l ≤ 1.
    for (n, factor) in [(0, 1.0), (1, 1.0), (2, 1.1808), (3, 1.755), (4, 3.287)] {
        assert!(
            (printed(n) - factor).abs() < tolerance::QUOTED.limit,
            "{}",
            printed(n)
        );
    }
    let torque = torque_a9(1, e, Reading::Printed) / (e * e + 1.0 / 3.0);
    assert!((torque - 0.851).abs() < tolerance::QUOTED.limit, "{torque}");
}
