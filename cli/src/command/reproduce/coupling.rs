//! Figure 3.4: force and torque for dry friction, with eqs. 3.11 to 3.18.

use super::exhibit::{
    Exhibit, at, claim, geometric, not_checked, refutation, short, statement, table,
};
use crate::failure::Failure;
use crate::report::figure::{Axis, Figure, Legend, Panels, Series};
use crate::report::page::Claim;
use std::f64::consts::PI;
use tribos_core::coupling::{Coupling, quadrature::DiskQuadrature};
use tribos_core::law::Coulomb;
use tribos_core::special::CompleteElliptic;

/// F and T over ε, and T over F.
pub fn figure_3_4() -> Result<Exhibit, Failure> {
    let dry = table(0.0)?;
    let ratios = geometric(1e-3, 1e3, 400);
    let rows: Vec<Vec<f64>> = ratios
        .iter()
        .map(|&ratio| {
            let [force, torque] = at(&dry, ratio);
            vec![ratio, force, torque]
        })
        .collect();
    let curve = |x: usize, y: usize| rows.iter().map(|row| (row[x], row[y])).collect::<Vec<_>>();
    let over_ratio = Figure::new(
        "Dry friction, α = 0",
        Axis::log10("velocity ratio ε = v/(ωR)"),
        Axis::linear("F, T").range(0.0, 1.05),
    )
    .series(Series::line("force F", curve(0, 1)))
    .series(Series::line("torque T", curve(0, 2)))
    .legend(Legend::Below);
    let pairs = Figure::new(
        "Possible pairs",
        Axis::linear("force F").range(0.0, 1.05),
        Axis::linear("torque T").range(0.0, 0.7),
    )
    .series(Series::line("T(F)", curve(1, 2)))
    .legend(Legend::Below);
    let panels = Panels::new("", 2)
        .figure(over_ratio)
        .figure(pairs)
        .cell(520, 400);
    let mut claims = limits()?;
    claims.extend(closed_forms()?);
    claims.extend(statements(&rows)?);
    Ok(Exhibit {
        heading: "Figure 3.4: coupled force and torque under dry friction".into(),
        text: vec![
            "For Coulomb friction F and T depend on the velocity ratio alone. Each motion takes \
             friction away from the other: whoever adds sliding and spinning friction as if they \
             were independent overestimates both."
                .into(),
        ],
        film: None,
        caption: "Left: force and torque over the velocity ratio. Right: the pairs that occur, \
                  the limit curve of the disk."
            .into(),
        drawing: Box::new(panels),
        columns: vec!["ratio", "force", "torque"],
        rows,
        claims,
    })
}

/// Eqs. 3.12, 3.14, 3.15, 3.16.
fn limits() -> Result<Vec<Claim>, Failure> {
    let dry = table(0.0)?;
    let [force, torque] = at(&dry, 1.0);
    let slopes = dry.reduced_jacobian(1.0, 1.0);
    let rounding = 4.0 * f64::EPSILON;
    Ok(vec![
        claim("3.12: F(1)", ("8/(3π)", 8.0 / (3.0 * PI)), force, rounding),
        claim(
            "3.12: dF/dε at 1",
            ("4/(3π)", 4.0 / (3.0 * PI)),
            slopes.force_slide,
            rounding,
        ),
        claim("3.14: T(1)", ("8/(9π)", 8.0 / (9.0 * PI)), torque, rounding),
        claim(
            "3.14: dT/dε at 1",
            ("−4/(3π)", -4.0 / (3.0 * PI)),
            slopes.mixed,
            rounding,
        ),
        claim("F(0)", ("0", 0.0), at(&dry, 0.0)[0], 0.0),
        claim("F(∞)", ("1", 1.0), at(&dry, f64::INFINITY)[0], rounding),
        claim("3.15: T(∞)", ("0", 0.0), at(&dry, f64::INFINITY)[1], 0.0),
        claim("3.16: T(0)", ("2/3", 2.0 / 3.0), at(&dry, 0.0)[1], rounding),
    ])
}

/// F and T as the thesis writes them: 3.11 and 3.13, with the factor 4 over the whole bracket.
fn cases(ratio: f64) -> [f64; 2] {
    let e2 = ratio * ratio;
    if ratio <= 1.0 {
        let i = CompleteElliptic::new(1.0 - e2);
        let (k, e) = (i.k(), i.e());
        let force = 4.0 * ((e2 + 1.0) * e + (e2 - 1.0) * k) / (3.0 * ratio * PI);
        [
            force,
            4.0 * ((4.0 - 2.0 * e2) * e + (e2 - 1.0) * k) / (9.0 * PI),
        ]
    } else {
        let i = CompleteElliptic::new(1.0 - 1.0 / e2);
        let (k, e) = (i.k(), i.e());
        let force = 4.0 * ((e2 + 1.0) * e - (e2 - 1.0) * k) / (3.0 * PI);
        let torque = (4.0 - 2.0 * e2) * e + (2.0 * e2 - 5.0 + 3.0 / e2) * k;
        [force, 4.0 * ratio * torque / (9.0 * PI)]
    }
}

/// 3.17 and 3.18, without the distinction of cases.
fn single(ratio: f64) -> [f64; 2] {
    let sum = 1.0 + ratio;
    let gap = (1.0 - ratio) * (1.0 - ratio);
    let i = CompleteElliptic::new(gap / (sum * sum));
    let (k, e) = (i.k(), i.e());
    let force = 2.0 * sum / (3.0 * PI * ratio) * ((1.0 + ratio * ratio) * e - gap * k);
    let torque = 4.0 * sum / (9.0 * PI) * ((2.0 - ratio * ratio) * e + gap * k);
    [force, torque]
}

/// Largest relative deviation of two evaluations over the ratios.
fn deviation(ratios: &[f64], f: impl Fn(f64) -> [f64; 2], g: impl Fn(f64) -> [f64; 2]) -> f64 {
    let one = |&ratio: &f64| {
        let (a, b) = (f(ratio), g(ratio));
        (a[0] / b[0] - 1.0).abs().max((a[1] / b[1] - 1.0).abs())
    };
    ratios.iter().map(one).fold(0.0, f64::max)
}

/// The closed forms against the kernel where they do not cancel.
fn closed_forms() -> Result<Vec<Claim>, Failure> {
    let dry = table(0.0)?;
    // An even number of intervals would hit ε = 1, where the second form is 0 · ∞.
    let moderate = geometric(0.1, 10.0, 201);
    let two = deviation(&moderate, cases, |ratio| at(&dry, ratio));
    let one = deviation(&moderate, single, |ratio| at(&dry, ratio));
    let disk = DiskQuadrature::new(Coulomb::new(1.0).map_err(Failure::run)?);
    let numeric = |ratio| {
        let wrench = disk.reduced_wrench(ratio, 1.0);
        [wrench.force, wrench.torque]
    };
    let integral = deviation(&geometric(1e-3, 1e3, 400), numeric, |ratio| at(&dry, ratio));
    let equal = ("0", 0.0);
    // The printed forms lose digits like ε⁻² and ε⁴ towards the ends.
    Ok(vec![
        claim(
            "3.11, 3.13 (factor 4 over the bracket): largest deviation, 0.1 < ε < 10",
            equal,
            two,
            1e-10,
        ),
        claim(
            "3.17, 3.18: largest deviation, 0.1 < ε < 10",
            equal,
            one,
            1e-10,
        ),
        claim(
            "numerical integration of 3.9, 3.10: largest deviation, 1e-3 < ε < 1e3",
            equal,
            integral,
            1e-8,
        ),
    ])
}

/// What the text says about the curves.
fn statements(rows: &[Vec<f64>]) -> Result<Vec<Claim>, Failure> {
    let monotone = rows
        .windows(2)
        .all(|w| w[1][1] > w[0][1] && w[1][2] < w[0][2]);
    let reduced = rows.iter().all(|row| row[1] < 1.0 && row[2] < 2.0 / 3.0);
    let weakening = table(-0.5)?;
    let peak = geometric(0.1, 10.0, 2000)
        .into_iter()
        .map(|ratio| (at(&weakening, ratio)[0], ratio))
        .fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
    let falls = at(&weakening, 1e3)[0] < peak.0;
    Ok(vec![
        statement(
            "F rises and T falls strictly with ε (α = 0)",
            "strictly monotonous",
            format!("at {} ratios", rows.len()),
            monotone,
        ),
        statement(
            "Coupling only ever reduces friction (α = 0)",
            "F < 1 and T < 2/3",
            format!("at {} ratios", rows.len()),
            reduced,
        ),
        refutation(
            "F and T are strictly monotonous for all α ≠ 1 (section 3.4.4)",
            "for all α ≠ 1",
            format!(
                "α = −0.5: F has a maximum {} at ε = {}",
                short(peak.0),
                short(peak.1)
            ),
            falls,
            "for −1 < α < 0 F rises like ε and then falls like ε^α",
        ),
        not_checked(
            "Figure 3.5: measured force and torque of a plastic disk lie on the curves",
            "agreement by eye",
            "the measurements are not published as numbers",
        ),
    ])
}
