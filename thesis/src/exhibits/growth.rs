//! Figures 3.6, 3.7 and 3.8: growth of the velocity ratio and its fixed points.

use crate::exhibit::{Exhibit, at, linear, modes, table};
use crate::text::Text;
use anyhow::Result;
use tribos_core::internals::CompleteElliptic;
use tribos_core::modes::{FixedPoints, Stability, inertia_interval};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Panels, ReferenceLine, Series};
use tribos_report::verdict::Allowance;

const FIGURE_3_6: Text = Text(include_str!("figure-3.6.md"));
const FIGURE_3_7: Text = Text(include_str!("figure-3.7.md"));
const FIGURE_3_8: Text = Text(include_str!("figure-3.8.md"));

/// The golden ratio (√5 − 1)/2, the limit of ε₀ for α → 1.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Curves of g over ε for several exponents, as series and as rows.
fn curves(
    exponents: &[f64],
    inertia_ratio: f64,
    ratios: &[f64],
) -> Result<(Vec<Series>, Vec<Vec<f64>>)> {
    let mut rows: Vec<Vec<f64>> = ratios.iter().map(|&ratio| vec![ratio]).collect();
    let mut series = Vec::new();
    for &alpha in exponents {
        let modes = modes(alpha, inertia_ratio)?;
        let points: Vec<_> = ratios
            .iter()
            .map(|&ratio| (ratio, modes.growth(ratio)))
            .collect();
        for (row, (_, growth)) in rows.iter_mut().zip(&points) {
            row.push(*growth);
        }
        series.push(Series::line(format!("α = {alpha}"), points));
    }
    Ok((series, rows))
}

fn figure(title: &str, range: (f64, f64), growth: (f64, f64), series: Vec<Series>) -> Figure {
    let empty = Figure::new(
        title,
        Axis::linear("velocity ratio ε").range(range.0, range.1),
        Axis::linear("g(ε)").range(growth.0, growth.1),
    );
    series
        .into_iter()
        .fold(empty, Figure::series)
        .guide(ReferenceLine::horizontal(0.0, ""))
}

fn word(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Semistable => "semistable",
        Stability::Unstable => "unstable",
    }
}

/// Words for the three fixed points.
fn in_words(points: &FixedPoints<f64>) -> String {
    let finite = match points.finite {
        Some((ratio, stability)) => format!("ε₀ = {} {}", short(ratio), word(stability)),
        None => "no ε₀".into(),
    };
    let (spinning, sliding) = (word(points.spinning), word(points.sliding));
    format!("0 {spinning}, {finite}, ∞ {sliding}")
}

/// Checks the stabilities of 0, of ε₀ if there is one, and of ∞.
fn stabilities(
    id: &str,
    points: &FixedPoints<f64>,
    expected: (Stability, Option<Stability>, Stability),
) -> Claim {
    let found = (
        points.spinning,
        points.finite.map(|(_, stability)| stability),
        points.sliding,
    );
    Claim::trend(FIGURE_3_6.said(id), in_words(points), found == expected)
}

/// g for α = 0, 1, 3 and the disk.
pub fn figure_3_6() -> Result<Exhibit> {
    let (series, rows) = curves(&[0.0, 1.0, 3.0], 0.5, &linear(0.0, 1.5, 300))?;
    let title = "g(ε) of the disk, C = 1/2";
    let drawing = figure(title, (0.0, 1.5), (-0.25, 0.35), series);
    let mut claims = dry_claims(&rows)?;
    claims.extend(linear_and_cubic_claims(&rows)?);
    Ok(Exhibit::new(
        FIGURE_3_6.prose(),
        drawing,
        &["ratio", "g_alpha_0", "g_alpha_1", "g_alpha_3"],
        rows,
        claims,
    ))
}

/// Largest distance of a column of g from a formula of the thesis.
fn deviation(rows: &[Vec<f64>], column: usize, formula: impl Fn(f64) -> f64) -> f64 {
    let distance = |row: &Vec<f64>| (row[column] - formula(row[0])).abs();
    // ε = 0 and 1 are removable singularities of the printed forms.
    let regular = rows
        .iter()
        .filter(|row| row[0] > 0.1 && (row[0] - 1.0).abs() > 1e-9);
    regular.map(distance).fold(0.0, f64::max)
}

fn finite(points: &FixedPoints<f64>) -> f64 {
    points.finite.map_or(f64::NAN, |(ratio, _)| ratio)
}

/// 3.28, C = 1/2.
fn growth_as_printed(ratio: f64) -> f64 {
    let (sum, gap) = (1.0 + ratio, (1.0 - ratio) * (1.0 - ratio));
    let integrals = CompleteElliptic::new(gap / (sum * sum));
    let (k, e) = (integrals.k(), integrals.e());
    let above = (1.0 + ratio * ratio) * e - gap * k;
    ratio - 0.75 / ratio * above / ((2.0 - ratio * ratio) * e + gap * k)
}

/// α = 0.
fn dry_claims(rows: &[Vec<f64>]) -> Result<Vec<Claim>> {
    use Stability::{Stable, Unstable};
    let points = modes(0.0, 0.5)?.fixed_points();
    let exact = 0.653_001_789_205_598;
    let printed = deviation(rows, 1, growth_as_printed);
    let ratio = finite(&points);
    Ok(vec![
        Claim::stated(
            FIGURE_3_6.said("dry-fixed-point"),
            ("≈ 0.653", 0.653),
            ratio,
            Allowance::Digits(5e-4),
        ),
        Claim::own(FIGURE_3_6.said("dry-digits"), ratio, exact, 1e-14),
        Claim::stated(
            FIGURE_3_6.said("voyerli"),
            ("≈ 1.53", 1.53),
            1.0 / ratio,
            Allowance::Digits(5e-3),
        ),
        Claim::formula(FIGURE_3_6.said("dry-growth"), printed, 1e-12),
        stabilities("dry-stability", &points, (Unstable, Some(Stable), Unstable)),
    ])
}

/// α = 1 and α = 3.
fn linear_and_cubic_claims(rows: &[Vec<f64>]) -> Result<Vec<Claim>> {
    use Stability::{Semistable, Stable, Unstable};
    let linear_law = modes(1.0, 0.5)?.fixed_points();
    let cubic = modes(3.0, 0.5)?.fixed_points();
    let flat = deviation(rows, 2, |_| 0.0);
    let bent = deviation(rows, 3, |e| e - (e.powi(3) + e) / (2.0 / 3.0 + 2.0 * e * e));
    Ok(vec![
        Claim::stated(
            FIGURE_3_6.said("linear-growth"),
            ("0", 0.0),
            flat,
            Allowance::Exact(1e-15),
        ),
        stabilities(
            "linear-stability",
            &linear_law,
            (Semistable, None, Semistable),
        ),
        Claim::stated(
            FIGURE_3_6.said("cubic-fixed-point"),
            ("√3/3", 1.0 / 3f64.sqrt()),
            finite(&cubic),
            Allowance::Exact(1e-14),
        ),
        Claim::formula(FIGURE_3_6.said("cubic-growth"), bent, 1e-14),
        stabilities("cubic-stability", &cubic, (Stable, Some(Unstable), Stable)),
    ])
}

/// The transition from α = 0 to α = 1.
pub fn figure_3_7() -> Result<Exhibit> {
    let exponents = [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0];
    let (series, rows) = curves(&exponents, 0.5, &linear(0.0, 1.2, 240))?;
    let (zoomed, _) = curves(&exponents, 0.5, &linear(0.6, 0.67, 140))?;
    let whole = figure("g(ε), C = 1/2", (0.0, 1.2), (-0.16, 0.06), series).legend(Legend::Below);
    let zoom = figure("its zeros", (0.6, 0.67), (-0.01, 0.012), zoomed).legend(Legend::Below);
    Ok(Exhibit::new(
        FIGURE_3_7.prose(),
        Panels::new("", 2).figure(whole).figure(zoom).cell(520, 420),
        &["ratio", "0", "0.1", "0.25", "0.5", "0.75", "0.9", "1"],
        rows,
        transition_claims(&exponents)?,
    ))
}

fn transition_claims(exponents: &[f64]) -> Result<Vec<Claim>> {
    let mut zeros = Vec::new();
    let below: Vec<f64> = exponents
        .iter()
        .copied()
        .filter(|&alpha| alpha < 1.0)
        .collect();
    for &alpha in &below {
        if let Some((ratio, Stability::Stable)) = modes(alpha, 0.5)?.fixed_points().finite {
            zeros.push(ratio);
        }
    }
    let shown: Vec<String> = zeros.iter().map(|zero| format!("{zero:.4}")).collect();
    let (low, high) = zeros
        .iter()
        .fold((f64::MAX, 0.0_f64), |(l, h), &z| (l.min(z), h.max(z)));
    let near = modes(1.0 - 1e-9, 0.5)?
        .finite_fixed_point()
        .unwrap_or(f64::NAN);
    Ok(vec![
        Claim::trend(
            FIGURE_3_7.said("stable-zeros"),
            format!("ε₀ = {}, all stable", shown.join(", ")),
            zeros.len() == below.len(),
        ),
        Claim::refutation(
            FIGURE_3_7.said("small-range"),
            format!("from {} (α = 0.9) to {} (α = 0)", short(low), short(high)),
            high > 0.64,
        )
        .printed("[0.62, 0.64]"),
        Claim::own(FIGURE_3_7.said("golden-ratio"), near, GOLDEN, 1e-9),
        trapezoid_claim()?,
    ])
}

/// Force and torque of a Coulomb disk by the trapezoid rule beside the closed forms.
fn trapezoid_claim() -> Result<Claim> {
    let law = table(0.0)?;
    let mut off = 0.0_f64;
    for ratio in linear(0.05, 1.2, 23) {
        let exact = at(&law, ratio);
        let apart = |(a, b): (f64, f64)| (a - b).abs();
        off = trapezoids(ratio)
            .into_iter()
            .zip(exact)
            .map(apart)
            .fold(off, f64::max);
    }
    Ok(Claim::trend(
        FIGURE_3_7.said("trapezoid"),
        format!(
            "off by {} at most with {INTERVALS} × {INTERVALS} intervals",
            short(off)
        ),
        off < INSIGNIFICANT,
    ))
}

/// Intervals of the radius and of the angle: ours.
const INTERVALS: usize = 100;
/// What a curve of F and T, which reach 1 and 2/3, does not show: a line's width of its drawing.
const INSIGNIFICANT: f64 = 2e-3;

/// 3.9 and 3.10 at α = 0: radii with half weights at both ends; angles close.
fn trapezoids(ratio: f64) -> [f64; 2] {
    let step = 1.0 / INTERVALS as f64;
    let [mut force, mut torque] = [0.0; 2];
    for i in 1..=INTERVALS {
        let radius = i as f64 * step;
        let weight = if i == INTERVALS { 1.0 } else { 2.0 } * radius * step * step;
        for j in 0..INTERVALS {
            let (along, across) = {
                let (sin, cos) = (std::f64::consts::TAU * j as f64 * step).sin_cos();
                (ratio - radius * sin, radius * cos)
            };
            let speed = along.hypot(across);
            // A point at rest has no direction.
            if speed > 0.0 {
                force += weight * along / speed;
                torque += weight * (radius * radius - ratio * (ratio - along)) / speed;
            }
        }
    }
    [force, torque]
}

/// The ring's inertia on the disk's contact.
pub fn figure_3_8() -> Result<Exhibit> {
    let (series, rows) = curves(&[0.0, 1.0, 3.0], 1.0, &linear(0.0, 1.5, 300))?;
    let drawing = figure("g(ε) with C = 1", (0.0, 1.5), (-1.5, 0.2), series);
    let mut claims = Vec::new();
    for alpha in [0.0, 1.0, 3.0] {
        let points = modes(alpha, 1.0)?.fixed_points();
        let only_spinning = points.spinning == Stability::Stable
            && points.finite.is_none()
            && points.sliding == Stability::Unstable;
        claims.push(Claim::trend(
            FIGURE_3_8.said("spinning").with("alpha", alpha),
            in_words(&points),
            only_spinning,
        ));
    }
    let border = inertia_interval(3.0, 0.0).1;
    claims.push(Claim::refutation(
        FIGURE_3_8.said("upper-bound"),
        format!("c₃,max = {border}"),
        border == 1.0,
    ));
    Ok(Exhibit::new(
        FIGURE_3_8.prose(),
        drawing,
        &["ratio", "g_alpha_0", "g_alpha_1", "g_alpha_3"],
        rows,
        claims,
    ))
}
