//! Appendix A: the double sums for odd exponents, as printed and mended.

use crate::exhibit::{Exhibit, at, linear, table};
use crate::text::Text;
use anyhow::Result;
use std::f64::consts::PI;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Series};

const TEXT: Text = Text(include_str!("appendix-a.md"));

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
    Claim::erratum(TEXT.said("sine"), ("π", PI), (integral, 0.75 * PI))
}

/// Signs and letters of single lines, each against the line after it.
fn misprints() -> Result<[Claim; 3]> {
    /// Points of the circle: exact for the square of the cosine.
    const POINTS: u32 = 64;
    /// Radius at which A.4 is compared, with φ = π/2.
    const RADIUS: f64 = 0.5;
    let step = 2.0 * PI / f64::from(POINTS);
    let squares = (0..POINTS).map(|i| (f64::from(i) * step).cos().powi(2));
    // Without the component along e_v there is only r cos φ · ṽ² · r cos φ, over the disk.
    let square = RATIO * RATIO;
    let half_a_torque = square / 4.0 + 1.0 / 6.0;
    // n = 1: the sum of both k, and ε² + r² − 2 ε r.
    let line: f64 = [0, 1]
        .map(|k| {
            let terms = RADIUS.powi(2 - 2 * k) + (-2.0 * RATIO * RADIUS).powi(k);
            square.powi(1 - k) * terms
        })
        .iter()
        .sum();
    let [_, torque] = at(&table(3.0)?, RATIO);
    let binomial = (RATIO - RADIUS).powi(2);
    Ok([
        Claim::erratum(
            TEXT.said("cosine"),
            ("0", 0.0),
            (squares.sum::<f64>() * step, PI),
        ),
        Claim::erratum(
            TEXT.said("cubic-torque"),
            (&short(half_a_torque), half_a_torque),
            (torque, square + 1.0 / 3.0),
        ),
        Claim::erratum(
            TEXT.said("binomial"),
            (&short(line), line),
            (square + RADIUS * RADIUS - 2.0 * RATIO * RADIUS, binomial),
        ),
    ])
}

/// Both sums of α = 2n + 1 against the kernel, mended and as printed.
fn sum_claims(n: u32, alpha: f64, [force, torque]: [f64; 2]) -> Vec<Claim> {
    let (right_force, right_torque) = (force_sum(n, RATIO, true), torque_sum(n, RATIO, 2.0));
    let mended = |id, ours: f64, sum: f64| {
        let said = TEXT.said(id).with("alpha", alpha);
        Claim::formula(said, (ours / sum - 1.0).abs(), 1e-13)
    };
    let mut claims = vec![
        mended("force", force, right_force),
        mended("torque", torque, right_torque),
    ];
    if n >= 2 {
        let printed = force_sum(n, RATIO, false);
        claims.push(Claim::erratum(
            TEXT.said("printed-force")
                .with("alpha", alpha)
                .with("factor", format!("{:.4}", printed / force)),
            (&short(printed), printed),
            (force, right_force),
        ));
    }
    if n >= 1 {
        let printed = torque_sum(n, RATIO, 1.0);
        claims.push(Claim::erratum(
            TEXT.said("printed-torque")
                .with("alpha", alpha)
                .with("factor", format!("{:.4}", printed / torque)),
            (&short(printed), printed),
            (torque, right_torque),
        ));
    }
    claims
}

/// The sums against the kernel.
pub fn appendix_a() -> Result<Exhibit> {
    let mut claims = vec![even_powers_of_the_sine()];
    claims.extend(misprints()?);
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
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &[
            "ratio",
            "f_alpha_1",
            "f_alpha_3",
            "f_alpha_5",
            "f_alpha_7",
            "f_alpha_9",
        ],
        rows,
        claims,
    ))
}
