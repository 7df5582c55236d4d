//! Appendix A: the double sums for odd exponents, as printed and mended.

use crate::exhibit::{Exhibit, at, linear, table};
use anyhow::Result;
use std::f64::consts::PI;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Series};

/// Ratio at which the sums are compared.
const RATIO: f64 = 0.7;

fn factorial(n: u32) -> f64 {
    (1..=n).map(f64::from).product()
}

/// ⟨sinˡ⟩ over the circle: (l−1)!!/l!! for even l, zero for odd.
fn mean_of_sine_power(l: u32) -> f64 {
    if l % 2 == 1 {
        return 0.0;
    }
    (1..=l / 2)
        .map(|k| f64::from(2 * k - 1) / f64::from(2 * k))
        .product()
}

/// F (A.7) for α = 2n + 1; `with_l_factorial` mends the denominator.
fn force_sum(n: u32, ratio: f64, with_l_factorial: bool) -> f64 {
    double_sum(n, ratio, with_l_factorial, |k, l| {
        let even = 2.0 * ratio / f64::from(2 * k - l + 2) * mean_of_sine_power(l);
        even - 2.0 / f64::from(2 * k - l + 3) * mean_of_sine_power(l + 1)
    })
}

/// T (A.9) for α = 2n + 1; `odd_factor` is 2, printed as 1.
fn torque_sum(n: u32, ratio: f64, odd_factor: f64) -> f64 {
    double_sum(n, ratio, true, |k, l| {
        let even = 2.0 / f64::from(2 * k - l + 4) * mean_of_sine_power(l);
        even - odd_factor * ratio / f64::from(2 * k - l + 3) * mean_of_sine_power(l + 1)
    })
}

fn double_sum(n: u32, ratio: f64, l_factorial: bool, term: impl Fn(u32, u32) -> f64) -> f64 {
    let mut sum = 0.0;
    for k in 0..=n {
        let outer = ratio.powi(2 * (n - k) as i32) / factorial(n - k);
        for l in 0..=k {
            let divisor = factorial(k - l) * if l_factorial { factorial(l) } else { 1.0 };
            sum += outer * (-2.0 * ratio).powi(l as i32) / divisor * term(k, l);
        }
    }
    factorial(n) * sum
}

/// The sentence before A.6.
fn even_powers_of_the_sine() -> Claim {
    let integral = 2.0 * PI * mean_of_sine_power(4);
    Claim::erratum(
        "before A.6",
        "The integral of sinˡφ over the circle for an even exponent; l = 4",
        ("π", PI),
        (integral, 0.75 * PI),
        "it is 2π (l−1)!!/l!!, which is π for l = 2 only",
    )
}

/// Both sums of α = 2n + 1 against the kernel, mended and as printed.
fn sum_claims(n: u32, alpha: f64, [force, torque]: [f64; 2]) -> Vec<Claim> {
    let (right_force, right_torque) = (force_sum(n, RATIO, true), torque_sum(n, RATIO, 2.0));
    let mended = |place: &str, what: &str, ours: f64, sum: f64| {
        let what = format!("α = {alpha}: {what}");
        Claim::formula(
            place,
            &what,
            (ours / sum - 1.0).abs(),
            1e-13,
            "mended, relative",
        )
    };
    let mut claims = vec![
        mended(
            "A.7",
            "F(0.7) of the sum, l! put into the denominator",
            force,
            right_force,
        ),
        mended(
            "A.9",
            "T(0.7) of the sum, 2ε put into the odd branch",
            torque,
            right_torque,
        ),
    ];
    if n >= 2 {
        let printed = force_sum(n, RATIO, false);
        claims.push(Claim::erratum(
            "A.7",
            &format!("α = {alpha}: F(0.7) of the sum as printed"),
            (&short(printed), printed),
            (force, right_force),
            &format!(
                "l! is missing in the denominator of the inner sum: {:.4} times too large; no \
                 effect for α = 1 and 3",
                printed / force
            ),
        ));
    }
    if n >= 1 {
        let printed = torque_sum(n, RATIO, 1.0);
        claims.push(Claim::erratum(
            "A.9",
            &format!("α = {alpha}: T(0.7) of the sum as printed"),
            (&short(printed), printed),
            (torque, right_torque),
            &format!(
                "the odd branch needs −2ε: {:.4} of the right value; as printed it contradicts \
                 eq. 3.22",
                printed / torque
            ),
        ));
    }
    claims
}

/// The sums against the kernel.
pub fn appendix_a() -> Result<Exhibit> {
    let mut claims = vec![even_powers_of_the_sine()];
    let mut figure = Figure::new(
        "Odd exponents: force",
        Axis::linear("velocity ratio ε"),
        Axis::log10("F"),
    );
    let ratios = linear(0.02, 2.0, 99);
    let mut rows: Vec<Vec<f64>> = ratios.iter().map(|&ratio| vec![ratio]).collect();
    for n in 0..=4 {
        let alpha = f64::from(2 * n + 1);
        let law = table(alpha)?;
        claims.extend(sum_claims(n, alpha, at(&law, RATIO)));
        let curve: Vec<_> = ratios
            .iter()
            .map(|&ratio| (ratio, at(&law, ratio)[0]))
            .collect();
        for (row, (_, value)) in rows.iter_mut().zip(&curve) {
            row.push(*value);
        }
        figure = figure.series(Series::line(format!("α = {alpha}"), curve));
    }
    Ok(Exhibit {
        heading: "Appendix A: odd exponents".into(),
        text: vec![
            "For odd α the integrand is a polynomial and the thesis gives double sums. Mended, \
             they agree with the general formula; as printed they do not. (In eq. 3.22 the label \
             T_n,1 should read T_n,3, and one term of its integrand lacks the fourth power of r.)"
                .into(),
        ],
        film: None,
        caption: "Force over the velocity ratio at ωR = 1.".into(),
        drawing: Box::new(figure),
        columns: vec![
            "ratio",
            "f_alpha_1",
            "f_alpha_3",
            "f_alpha_5",
            "f_alpha_7",
            "f_alpha_9",
        ],
        rows,
        claims,
    })
}
