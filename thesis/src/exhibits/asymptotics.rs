//! Table 3.1: force and torque for ε ≪ 1 and ε ≫ 1.

use crate::exhibit::{Exhibit, at, geometric, table};
use crate::text::Text;
use anyhow::Result;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("table-3.1.md"));

const EXPONENTS: [f64; 6] = [-0.5, 0.0, 0.5, 1.0, 2.0, 3.0];
/// Ratio at which the limits are compared; they err like its square.
const SMALL: f64 = 1e-6;
/// What the next terms leave, of relative order ε² = 1e-12 with coefficients of order one.
const TRUNCATION: f64 = 20.0 * SMALL * SMALL;

/// F/ε, T, F/ε^α and T/ε^(α−1): the four limits at both ends.
pub fn table_3_1() -> Result<Exhibit> {
    let mut rows = Vec::new();
    let mut claims = Vec::new();
    let mut slow = Figure::new(
        "ε ≪ 1: T/T(0)",
        Axis::log10("ε"),
        Axis::linear("T (3+α)/2").range(0.8, 1.5),
    )
    .legend(Legend::Below);
    let mut fast = Figure::new(
        "ε ≫ 1: T over its limit",
        Axis::log10("ε"),
        Axis::linear("T ε^(1−α) 4/(1+α)").range(0.8, 1.5),
    )
    .legend(Legend::Below);
    for alpha in EXPONENTS {
        let law = table(alpha)?;
        let label = format!("α = {alpha}");
        let [f_slow, t_slow] = at(&law, SMALL);
        let [f_fast, t_fast] = at(&law, 1.0 / SMALL);
        let limits = [
            f_slow / SMALL,
            t_slow,
            f_fast * SMALL.powf(alpha),
            t_fast * SMALL.powf(alpha - 1.0),
        ];
        rows.push([vec![alpha], limits.to_vec()].concat());
        claims.extend(torque_claims(alpha, limits));
        let curve = |from, to, scale: &dyn Fn(f64, f64) -> f64| {
            let one = |ratio| (ratio, scale(ratio, at(&law, ratio)[1]));
            geometric(from, to, 100)
                .into_iter()
                .map(one)
                .collect::<Vec<_>>()
        };
        let pure_spin = (3.0 + alpha) / 2.0;
        slow = slow.series(Series::line(
            &label,
            curve(1e-3, 1.0, &|_, t| t * pure_spin),
        ));
        let pure_slide = 4.0 / (1.0 + alpha);
        let scaled = |ratio: f64, t| t * ratio.powf(1.0 - alpha) * pure_slide;
        fast = fast.series(Series::line(&label, curve(1.0, 1e3, &scaled)));
    }
    claims.extend(force_claims(&rows));
    claims.push(cubic_torque()?);
    Ok(Exhibit::new(
        TEXT.prose().with("small", format!("{SMALL:e}")),
        Panels::new("", 2).figure(slow).figure(fast).cell(520, 420),
        &[
            "alpha",
            "force_slow",
            "torque_slow",
            "force_fast",
            "torque_fast",
        ],
        rows,
        claims,
    ))
}

/// The limits of the torque; the thesis has them for α ≥ 0 only.
fn torque_claims(alpha: f64, [_, slow, _, fast]: [f64; 4]) -> Vec<Claim> {
    let formulas = [2.0 / (3.0 + alpha), (1.0 + alpha) / 4.0];
    let rows = [
        (
            "ε ≪ 1: T",
            format!("2/(3+α) = {}", short(formulas[0])),
            slow,
        ),
        (
            "ε ≫ 1: T/ε^(α−1)",
            format!("(1+α)/4 = {}", short(formulas[1])),
            fast,
        ),
    ];
    let rows = rows.into_iter().zip(formulas);
    rows.map(|((name, text, ours), value)| {
        let said = |id| TEXT.said(id).with("alpha", alpha).with("limit", name);
        if alpha < 0.0 {
            return Claim::own(
                said("torque-continued").with("formula", text),
                ours,
                value,
                TRUNCATION,
            );
        }
        let allowance = Allowance::Exact(TRUNCATION);
        Claim::stated(said("torque"), (&text, value), ours, allowance)
    })
    .collect()
}

/// The limits of the force, F = ε and F = ε^α.
fn force_claims(rows: &[Vec<f64>]) -> [Claim; 2] {
    [("ε ≪ 1: F = ε", 1), ("ε ≫ 1: F = ε^α", 3)].map(|(name, column)| {
        let off = rows.iter().map(|row| (row[column] - 1.0).abs());
        Claim::formula(
            TEXT.said("force")
                .with("limit", name)
                .with("exponents", format!("{EXPONENTS:?}")),
            off.fold(0.0, f64::max),
            TRUNCATION,
        )
    })
}

/// Section 3.3 prints the cubic torque for ε ≫ 1 with a third and one power of ωR too many.
fn cubic_torque() -> Result<Claim> {
    let law = table(3.0)?;
    // At ωR = 1 the surplus power of ωR does not show, the third does.
    let ours = at(&law, 1.0 / SMALL)[1] * SMALL * SMALL;
    Ok(Claim::erratum(
        TEXT.said("cubic-torque"),
        ("1/3", 1.0 / 3.0),
        (ours, 1.0),
    ))
}
