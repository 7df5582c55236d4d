//! Figures 3.9 and 3.10 and table 3.2: which bodies have a finite fixed point.

use crate::exhibit::{Exhibit, geometric, linear, modes};
use crate::text::Text;
use anyhow::Result;
use tribos_core::modes::{Stability, inertia_interval};
use tribos_report::claim::Claim;
use tribos_report::diagram::Diagram;
use tribos_report::figure::{Axis, Figure, ReferenceLine, Series};
use tribos_report::verdict::Allowance;

const FIGURE_3_9: Text = Text(include_str!("figure-3.9.md"));
const TABLE_3_2: Text = Text(include_str!("table-3.2.md"));
const FIGURE_3_10: Text = Text(include_str!("figure-3.10.md"));

/// Ratios so far out that the limits are reached to rounding: the next terms are of order ε².
const FAR: f64 = 1e9;

/// C_α(ε₀) for α = 0, 1, 3.
pub fn figure_3_9() -> Result<Exhibit> {
    let ratios = geometric(1e-2, 1e2, 300);
    let mut rows: Vec<Vec<f64>> = ratios.iter().map(|&ratio| vec![ratio]).collect();
    let mut figure = Figure::new(
        "Inertia ratio for which ε₀ is a fixed point",
        Axis::log10("ε₀"),
        Axis::linear("C").range(0.0, 1.1),
    );
    let mut claims = Vec::new();
    for alpha in [0.0, 1.0, 3.0] {
        let modes = modes(alpha, 0.5)?;
        let curve: Vec<_> = ratios
            .iter()
            .map(|&r| (r, modes.inertia_ratio_of(r)))
            .collect();
        let falls = curve.windows(2).all(|w| w[1].1 < w[0].1);
        let rises = curve.windows(2).all(|w| w[1].1 > w[0].1);
        claims.push(if alpha == 1.0 {
            let off = |a: f64, b: f64| (a - 0.5).abs().total_cmp(&(b - 0.5).abs());
            let worst = curve.iter().map(|p| p.1).max_by(|a, b| off(*a, *b));
            let worst = worst.unwrap_or(f64::NAN);
            Claim::stated(
                FIGURE_3_9.said("constant"),
                ("1/2", 0.5),
                worst,
                Allowance::Exact(1e-15),
            )
        } else {
            let (how, holds) = if alpha < 1.0 {
                ("falls", falls)
            } else {
                ("rises", rises)
            };
            Claim::trend(
                FIGURE_3_9.said("bijective").with("alpha", alpha),
                format!("{how} at {} ratios", curve.len()),
                holds,
            )
        });
        for (row, (_, c)) in rows.iter_mut().zip(&curve) {
            row.push(*c);
        }
        figure = figure.series(Series::line(format!("α = {alpha}"), curve));
    }
    Ok(Exhibit::new(
        FIGURE_3_9.prose(),
        figure.guide(ReferenceLine::horizontal(0.5, "disk")),
        &["ratio", "c_alpha_0", "c_alpha_1", "c_alpha_3"],
        rows,
        claims,
    ))
}

/// The limits of C_α.
pub fn table_3_2() -> Result<Exhibit> {
    let thirds = [("2/3", 2.0 / 3.0), ("1/2", 0.5), ("1/3", 1.0 / 3.0)];
    let quarters = [("1/4", 0.25), ("1/2", 0.5), ("1", 1.0)];
    let mut rows = Vec::new();
    let mut claims = Vec::new();
    for ((alpha, slow), fast) in [0.0, 1.0, 3.0].into_iter().zip(thirds).zip(quarters) {
        let modes = modes(alpha, 0.5)?;
        let (at_zero, at_infinity) = (
            modes.inertia_ratio_of(1.0 / FAR),
            modes.inertia_ratio_of(FAR),
        );
        for (end, printed, ours) in [("0", slow, at_zero), ("∞", fast, at_infinity)] {
            let allowance = Allowance::Exact(1e-15);
            claims.push(Claim::stated(
                TABLE_3_2
                    .said("limit")
                    .with("alpha", alpha)
                    .with("end", end),
                printed,
                ours,
                allowance,
            ));
        }
        rows.push(vec![alpha, at_zero, at_infinity]);
    }
    let column = |i: usize| rows.iter().map(|row| (row[0], row[i])).collect::<Vec<_>>();
    let figure = Figure::new(
        "Limits of C",
        Axis::linear("α").range(-0.2, 3.2),
        Axis::linear("C").range(0.0, 1.1),
    )
    .series(Series::points("ε₀ → 0", column(1)))
    .series(Series::points("ε₀ → ∞", column(2)));
    Ok(Exhibit::new(
        TABLE_3_2
            .prose()
            .with("small", format!("{:e}", 1.0 / FAR))
            .with("large", format!("{FAR:e}")),
        figure,
        &["alpha", "c_at_zero", "c_at_infinity"],
        rows,
        claims,
    ))
}

/// The phase diagram.
pub fn figure_3_10() -> Result<Exhibit> {
    let rows = linear(0.0, 5.0, 200)
        .into_iter()
        .map(|alpha| {
            let (low, high) = inertia_interval(alpha, 0.0);
            vec![alpha, low, high]
        })
        .collect();
    Ok(Exhibit::new(
        FIGURE_3_10.prose(),
        Diagram::uniform_disk().figure(None),
        &["alpha", "c_min", "c_max"],
        rows,
        plane_claims()?,
    ))
}

/// What was found at points of the plane.
#[derive(Default)]
struct PointCounts {
    points: usize,
    right: usize,
    single: usize,
    fitting: usize,
}

/// Signs of g on a grid of the plane against the diagram's regions.
fn look(exponents: impl Iterator<Item = f64>) -> Result<PointCounts> {
    let ratios = geometric(1e-6, 1e6, 60);
    let mut found = PointCounts::default();
    for alpha in exponents {
        let (low, high) = inertia_interval(alpha, 0.0);
        for c in linear(0.03, 2.53, 25) {
            let modes = modes(alpha, c)?;
            let signs: Vec<bool> = ratios.iter().map(|&r| modes.growth(r) > 0.0).collect();
            let changes = signs.windows(2).filter(|w| w[0] != w[1]).count();
            let inside = c > low && c < high;
            found.points += 1;
            found.single += usize::from(changes <= 1);
            found.right += usize::from((changes == 1) == inside);
            let stable = matches!(modes.fixed_points().finite, Some((_, Stability::Stable)));
            // g falls through zero at a stable point.
            let fits = !inside || (signs[0] == stable && stable == (alpha < 1.0));
            found.fitting += usize::from(fits);
        }
    }
    Ok(found)
}

/// C of fixed points at both ends of ε, for α from 1.5 to 9.
fn broadens() -> Result<Claim> {
    let widths = linear(1.5, 9.0, 15).into_iter().map(|alpha| {
        let modes = modes(alpha, 0.5)?;
        Ok([FAR, 1.0 / FAR].map(|ratio| modes.inertia_ratio_of(ratio)))
    });
    let ends = widths.collect::<Result<Vec<[f64; 2]>>>()?;
    let steps = || {
        ends.windows(2)
            .map(|w| [w[1][0] - w[0][0], w[1][1] - w[0][1]])
    };
    let even = steps().all(|[upper, lower]| (upper - 0.125).abs() < 1e-6 && lower < 0.0);
    let [first, last] =
        [ends.first(), ends.last()].map(|end| end.map_or(f64::NAN, |c| c[0] - c[1]));
    Ok(Claim::trend(
        FIGURE_3_10.said("broadens"),
        format!("width {first:.3} at α = 1.5, {last:.3} at 9"),
        even && last > first,
    ))
}

/// The thesis' half of the plane, and negative exponents.
fn plane_claims() -> Result<Vec<Claim>> {
    let exponents = || linear(-0.9, 9.0, 99).into_iter();
    let positive = look(exponents().filter(|alpha| *alpha > -1e-9 && (alpha - 1.0).abs() > 1e-9))?;
    let negative = look(exponents().filter(|alpha| *alpha < -1e-9))?;
    let all = positive.points;
    let shown = |n: usize| format!("{n} of {all} points of the plane, 0 ≤ α ≤ 9");
    let row = |id, n: usize| Claim::trend(FIGURE_3_10.said(id), shown(n), n == all);
    let PointCounts {
        points,
        right,
        single,
        fitting,
    } = negative;
    Ok(vec![
        row("regions", positive.right),
        row("single", positive.single),
        row("stability", positive.fitting),
        broadens()?,
        Claim::own_statement(
            FIGURE_3_10.said("negative"),
            format!("{right} of {points} points of the plane, −0.9 ≤ α < 0"),
            [right, single, fitting] == [points; 3],
        ),
    ])
}
