//! Elliptic integrals and Gauss' function against 25-digit tables.

use tribos_core::internals::{CompleteElliptic, Gauss};
use tribos_tests::reference::ulp_f64;
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// The worst of one integral over the table, in units of the last place of column `unit`.
fn elliptic(
    quantity: &'static str,
    [column, unit]: [&str; 2],
    value: impl Fn(&CompleteElliptic<f64>) -> f64,
) -> Worst {
    let mut worst = Worst::of(quantity);
    for row in Table::read("elliptic.csv").rows() {
        let complement = row.number("mc");
        let got = value(&CompleteElliptic::new(complement));
        let error = row.reference(column).over(got, ulp_f64(row.number(unit)));
        worst.see(error, || format!("1 - m = {complement:e}"));
    }
    worst
}

#[test]
fn elliptic_integrals_keep_their_bound() {
    let [k, d, c] = [
        elliptic("K (ulp)", ["K", "K"], CompleteElliptic::k),
        elliptic("D (ulp)", ["D", "D"], |e| e.d),
        elliptic("C (ulp)", ["C", "C"], |e| e.c),
    ];
    for worst in [k, d, c] {
        worst.assert_within(&tolerance::ELLIPTIC_ULPS);
    }
    elliptic("B (ulp of K)", ["B", "K"], |e| e.b).assert_within(&tolerance::ELLIPTIC_B_ULPS);
    elliptic("E (ulp of K)", ["E", "K"], CompleteElliptic::e)
        .assert_within(&tolerance::ELLIPTIC_B_ULPS);
}

#[test]
fn elliptic_integrals_satisfy_legendre_everywhere() {
    // E(m) K(1−m) + E(1−m) K(m) − K(m) K(1−m) = π/2
    let mut worst = Worst::of("Legendre's relation");
    for n in 1..1000 {
        let m = f64::from(n) / 1000.0;
        // 1 − m as the second parameter, so that both complements are exact numbers.
        let (one, other) = (
            CompleteElliptic::new(1.0 - m),
            CompleteElliptic::new(1.0 - (1.0 - m)),
        );
        let left = one.e() * other.k() + other.e() * one.k() - one.k() * other.k();
        let scale = one.k() * other.k();
        worst.see((left - std::f64::consts::FRAC_PI_2).abs() / scale, || {
            format!("m = {m}")
        });
    }
    worst.assert_within(&tolerance::LEGENDRE);
}

#[test]
fn elliptic_special_values_are_documented_ones() {
    let end = CompleteElliptic::new(0.0_f64);
    assert_eq!((end.b, end.e()), (1.0, 1.0));
    assert!([end.k(), end.d, end.c].iter().all(|&x| x == f64::INFINITY));
    for outside in [-0.5, f64::NAN] {
        let got = CompleteElliptic::new(outside);
        assert!(
            [got.k(), got.e(), got.b, got.d, got.c]
                .iter()
                .all(|x| x.is_nan()),
            "{outside}"
        );
    }
}

#[test]
fn gauss_function_keeps_its_bound() {
    let [mut value, mut slope] = ["2F1 of the disk", "its slope"].map(Worst::of);
    for row in Table::read("gauss.csv").rows() {
        let (alpha, z) = (row.number("alpha"), row.number("mc"));
        // The table's x is 1 − z exactly; its nearest f64 is what a caller has.
        let phi = Gauss::new(0.5 * (1.0 - alpha), -0.5 * (1.0 + alpha), 2.0);
        let got = phi.at(row.number("x"), z);
        let place = || format!("alpha {alpha}, z {z:e}");
        value.see(row.reference("Phi").relative(got.value), place);
        slope.see(row.reference("dPhi").relative(got.slope), place);
    }
    value.assert_within(&tolerance::GAUSS);
    slope.assert_within(&tolerance::GAUSS_SLOPE);
}

#[test]
fn gauss_function_knows_elementary_cases() {
    // (1−x)^(−a) for b = c, and the finite sum of a = −2.
    for n in 0..=100 {
        let z = f64::from(n) / 100.0;
        let x = 1.0 - z;
        let power = Gauss::new(-2.5, 1.0, 1.0).at(x, z).value;
        assert!(
            (power - z.powf(2.5)).abs() <= tolerance::IDENTITY.limit,
            "z {z}: {power:e}"
        );
        let sum = Gauss::new(-2.0, 3.0, 4.0).at(x, z).value;
        let wanted = 1.0 - 1.5 * x + 0.6 * x * x;
        assert!(
            (sum - wanted).abs() <= tolerance::IDENTITY.limit,
            "z {z}: {sum}"
        );
    }
    let not_a_number = Gauss::new(0.5, -0.5, 2.0).at(f64::NAN, f64::NAN);
    assert!(not_a_number.value.is_nan());
}

#[test]
fn gauss_function_works_for_the_parameters_of_steep_laws() {
    // Gauss' theorem at x = 1 for the force of even α = 2n, whose series does not end:
    // Γ(2n+2)/(Γ(n+3/2) Γ(n+5/2)), from 8/(3π) by its ratio of neighbours; and for odd α = 2n+1
    // the sum of Chu and Vandermonde, (n+3)(n+4)…(2n+2)/(2·3…(n+1)).
    let mut moderate = Worst::of("2F1 at 1, exponents up to 48");
    let mut steep = Worst::of("2F1 at 1, exponents up to 128");
    let (mut even, mut odd) = (8.0 / (3.0 * std::f64::consts::PI), 1.0);
    for n in 0..=64 {
        let m = f64::from(n);
        for (alpha, wanted) in [(2.0 * m, even), (2.0 * m + 1.0, odd)] {
            let got = Gauss::new(0.5 * (1.0 - alpha), -0.5 * (1.0 + alpha), 2.0).at(1.0, 0.0);
            let worst = if alpha <= 48.0 {
                &mut moderate
            } else {
                &mut steep
            };
            worst.see((got.value / wanted - 1.0).abs(), || {
                format!("alpha {alpha}")
            });
        }
        even *= (2.0 * m + 2.0) * (2.0 * m + 3.0) / ((m + 1.5) * (m + 2.5));
        odd *= (2.0 * m + 3.0) * (2.0 * m + 4.0) / ((m + 3.0) * (m + 2.0));
    }
    moderate.assert_within(&tolerance::GAUSS_RISING);
    steep.assert_within(&tolerance::GAUSS_STEEP);
}
