//! Figure 3.4: force and torque for dry friction, with eqs. 3.11 to 3.18.

use crate::exhibit::{Exhibit, at, geometric, table};
use crate::text::Text;
use anyhow::Result;
use std::f64::consts::PI;
use tribos_core::coupling::{ReducedFriction, quadrature::DiskQuadrature};
use tribos_core::internals::CompleteElliptic;
use tribos_core::law::CoulombLaw;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-3.4.md"));

/// F and T over ε, and T over F.
pub fn figure_3_4() -> Result<Exhibit> {
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
    Ok(Exhibit::new(
        TEXT.prose(),
        panels,
        &["ratio", "force", "torque"],
        rows,
        claims,
    ))
}

/// Eqs. 3.12, 3.14, 3.15, 3.16.
fn limits() -> Result<Vec<Claim>> {
    let dry = table(0.0)?;
    let [force, torque] = at(&dry, 1.0);
    let slopes = dry.reduced_jacobian(1.0, 1.0);
    let rounding = 4.0 * f64::EPSILON;
    let rows = [
        ("eq. 3.12", "F(1)", ("8/(3π)", 8.0 / (3.0 * PI)), force),
        (
            "eq. 3.12",
            "dF/dε at 1",
            ("4/(3π)", 4.0 / (3.0 * PI)),
            slopes.force_slide,
        ),
        ("eq. 3.14", "T(1)", ("8/(9π)", 8.0 / (9.0 * PI)), torque),
        (
            "eq. 3.14",
            "dT/dε at 1",
            ("−4/(3π)", -4.0 / (3.0 * PI)),
            slopes.mixed,
        ),
        ("3.2.2", "F(0)", ("0", 0.0), at(&dry, 0.0)[0]),
        ("3.2.2", "F(∞)", ("1", 1.0), at(&dry, f64::INFINITY)[0]),
        ("eq. 3.15", "T(∞)", ("0", 0.0), at(&dry, f64::INFINITY)[1]),
        ("eq. 3.16", "T(0)", ("2/3", 2.0 / 3.0), at(&dry, 0.0)[1]),
    ];
    let rows = rows.into_iter().map(|(place, what, printed, ours)| {
        Claim::stated(
            TEXT.said("limit").with("place", place).with("what", what),
            printed,
            ours,
            Allowance::Exact(rounding),
        )
    });
    Ok(rows.collect())
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
fn closed_forms() -> Result<Vec<Claim>> {
    let dry = table(0.0)?;
    // An even number of intervals would hit ε = 1, where the second form is 0 · ∞.
    let moderate = geometric(0.1, 10.0, 201);
    let two = deviation(&moderate, cases, |ratio| at(&dry, ratio));
    let one = deviation(&moderate, single, |ratio| at(&dry, ratio));
    let disk = DiskQuadrature::new(CoulombLaw::new(1.0)?);
    let numeric = |ratio| {
        let wrench = disk.reduced_wrench(ratio, 1.0);
        [wrench.force, wrench.torque]
    };
    let integral = deviation(&geometric(1e-3, 1e3, 400), numeric, |ratio| at(&dry, ratio));
    let cubic_table = table(3.0)?;
    let cubic = deviation(
        &geometric(1e-3, 1e3, 400),
        |ratio| [ratio.powi(3) + ratio, ratio * ratio + 1.0 / 3.0],
        |ratio| at(&cubic_table, ratio),
    );
    // The printed forms lose digits like ε⁻² and ε⁴ towards the ends.
    Ok(vec![
        Claim::formula(TEXT.said("cases"), two, 1e-10),
        Claim::formula(TEXT.said("single-form"), one, 1e-10),
        Claim::formula(TEXT.said("integrals"), integral, 1e-8),
        Claim::formula(TEXT.said("cubic"), cubic, 1e-13),
    ])
}

/// What the text says about the curves.
fn statements(rows: &[Vec<f64>]) -> Result<Vec<Claim>> {
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
        Claim::trend(
            TEXT.said("monotonic"),
            format!("F rises and T falls at {} ratios", rows.len()),
            monotone,
        ),
        Claim::trend(
            TEXT.said("coupling"),
            format!("F < 1 and T < 2/3 at {} ratios", rows.len()),
            reduced,
        ),
        reduced_range()?,
        Claim::trend(
            TEXT.said("other-exponents"),
            "at 401 ratios for α = 0, 0.25, 0.5, 0.75, 1.5, 2, 3",
            other_exponents_are_monotonous()?,
        ),
        Claim::own_statement(
            TEXT.said("negative-exponents"),
            format!(
                "α = −0.5: F has a maximum {} near ε = {:.2}",
                short(peak.0),
                peak.1
            ),
            falls,
        ),
        Claim::not_checkable(TEXT.said("measured-disk")),
    ])
}

/// Where force and torque both lose a hundredth or more of their largest values.
fn reduced_range() -> Result<Claim> {
    const LOSS: f64 = 0.01;
    let dry = table(0.0)?;
    let shares = |ratio: f64| {
        let [force, torque] = at(&dry, ratio);
        [1.0 - force, 1.0 - 1.5 * torque]
    };
    let both: Vec<f64> = geometric(1e-3, 1e3, 10_000)
        .into_iter()
        .filter(|&ratio| shares(ratio).iter().all(|&loss| loss >= LOSS))
        .collect();
    let (low, high) = match (both.first(), both.last()) {
        (Some(first), Some(last)) => (*first, *last),
        _ => (f64::NAN, f64::NAN),
    };
    let ends = [shares(1e-2)[1], shares(1e2)[0]];
    Ok(Claim::refutation(
        TEXT.said("range"),
        format!(
            "{low:.3} to {high:.2}; at 10⁻² the torque loses {:.1e}, at 10² the force {:.1e}",
            ends[0], ends[1]
        ),
        low > 0.1 && high < 10.0 && ends.iter().all(|&loss| loss < 1e-4),
    ))
}

/// For exponents of the thesis other than 0 and 1.
fn other_exponents_are_monotonous() -> Result<bool> {
    let mut holds = true;
    for alpha in [0.0, 0.25, 0.5, 0.75, 1.5, 2.0, 3.0] {
        let law = table(alpha)?;
        let values: Vec<[f64; 2]> = geometric(1e-3, 1e3, 400)
            .into_iter()
            .map(|ratio| at(&law, ratio))
            .collect();
        // Below α = 1 the torque falls with ε, above it rises.
        let torque = |w: &[[f64; 2]]| (w[1][1] - w[0][1]) * (alpha - 1.0) > 0.0;
        holds &= values.windows(2).all(|w| w[1][0] > w[0][0] && torque(w));
    }
    Ok(holds)
}
