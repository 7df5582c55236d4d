//! Figure 4.5 and section 4.5: ballistic deposits.

use crate::exhibit::Exhibit;
use crate::text::Text;
use anyhow::Result;
use tribos::powder::deposit::curve::{COLUMNS, PorosityCurve, Sample};
use tribos::powder::deposit::{Ballistic, Deposit, DepositTarget};
use tribos::statistics::{statistics, straight_line};
use tribos_report::claim::{Claim, MismatchMeaning, Statement};
use tribos_report::runs::deposit::porosity;
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-4.5.md"));

/// Base and height of the curve's deposits, in radii: large enough for 10R, and all of them grow
/// in a second. The thesis does not state its own.
const CURVE: [f64; 2] = [40.0, 200.0];
const FIRST_SEED: u64 = 1;

/// The thesis' systems at 3R: name, width, height, spheres. The width of the last follows from its
/// spheres, porosity and aspect ratio of 3.5.
const SYSTEMS: [(&str, f64, f64, f64); 3] = [
    ("small system", 20.0, 61.5, 470.0),
    ("large system", 25.0, 87.5, 1015.0),
    ("larger system", 40.0, 140.0, 4193.0),
];
/// Deposits of each system, so that the mean is good to a sixth of the scatter.
const DEPOSITS: u64 = 40;

/// Porosity over 1/r_capt.
pub fn figure_4_5() -> Result<Exhibit> {
    let [width, height] = CURVE;
    let curve = PorosityCurve::new(width, DepositTarget::Cut(height), FIRST_SEED)?;
    let mut claims = curve_claims(&curve);
    claims.push(points_claim(&curve)?);
    claims.extend(branch_claims()?);
    claims.extend(system_claims()?);
    Ok(Exhibit::new(
        TEXT.prose()
            .with("width", width)
            .with("height", height)
            .with("deposits", DEPOSITS),
        porosity(&curve),
        &COLUMNS,
        curve.rows.iter().map(|row| row.to_vec()).collect(),
        claims,
    )
    .seeded(FIRST_SEED..FIRST_SEED + DEPOSITS))
}

fn curve_claims(curve: &PorosityCurve) -> Vec<Claim> {
    let solid = curve.solid();
    let (sparse, touching) = match (solid.first(), solid.last()) {
        (Some(first), Some(last)) => (first.1, last.1),
        _ => (f64::NAN, f64::NAN),
    };
    vec![
        Claim::trend(
            TEXT.said("density-falls"),
            format!("solid fraction of the bulk from {touching:.4} at 2R to {sparse:.4} at 10R"),
            solid.windows(2).all(|pair| pair[0].1 < pair[1].1),
        ),
        linearity(&solid),
        Claim::own(TEXT.said("sticking-spheres"), touching, 0.15, 0.01),
        Claim::not_checkable(TEXT.said("points")),
    ]
}

/// Deposits of each point of the figure (section 4.5).
const POINT: u64 = 5;

/// The first point of the curve is the mean of as many deposits.
fn points_claim(curve: &PorosityCurve) -> Result<Claim> {
    let [width, height] = CURVE;
    let [_, capture, kept, ..] = curve.rows.first().copied().unwrap_or_default();
    let sample = Sample::new(
        &Ballistic::new(width, 1.0, capture)?,
        DepositTarget::Cut(height),
        FIRST_SEED..FIRST_SEED + POINT,
    )?;
    let (porosity, _) = statistics(&sample.porosity);
    let said = TEXT.said("five");
    Ok(Claim::definition(said, format!("{POINT}"), porosity == kept).printed("5"))
}

/// The pressure on the piston, in F_coh/R² (section 4.5).
const PRESSURE: f64 = 1.0 / 400.0;

/// Distance between branches and load on one, in the small system.
fn branch_claims() -> Result<[Claim; 2]> {
    let (_, width, height, _) = SYSTEMS[0];
    let ballistic = Ballistic::new(width, 1.0, 3.0)?;
    let mut all = Vec::new();
    for seed in FIRST_SEED..FIRST_SEED + DEPOSITS {
        let deposit = ballistic.grow(DepositTarget::Cut(height), seed)?;
        all.push(width / crossings(&deposit, height).sqrt());
    }
    let (distance, scatter) = statistics(&all);
    let share = 1.0 / (PRESSURE * distance * distance);
    let uncertainty = format!("± {scatter:.1}, one of {DEPOSITS} deposits");
    Ok([
        Claim::trend(
            TEXT.said("branches"),
            format!("{distance:.1}R"),
            (2.5..10.0).contains(&distance),
        )
        .printed("5R")
        .uncertain(uncertainty),
        Claim::trend(
            TEXT.said("branch-load"),
            format!("F_coh/{share:.0}"),
            (8.0..32.0).contains(&share),
        )
        .printed("1/16"),
    ])
}

/// Bonds that cross a horizontal plane, in the mean over the planes of the middle half.
fn crossings(deposit: &Deposit, height: f64) -> f64 {
    let [low, high] = [0.25 * height, 0.75 * height];
    let bonds = deposit.positions.iter().zip(&deposit.parents);
    let risen = bonds.filter_map(|(place, parent)| {
        let parent = deposit.positions.get((*parent)? as usize)?;
        Some((place.z.clamp(low, high) - parent.z.clamp(low, high)).abs())
    });
    risen.sum::<f64>() / (high - low)
}

/// The density as a straight line and as a power.
fn linearity(solid: &[(f64, f64)]) -> Claim {
    /// Several times what five deposits scatter by.
    const SCATTER: f64 = 0.25;
    let (intercept, slope) = straight_line(solid);
    let miss = |&(x, y): &(f64, f64)| ((intercept + slope * x) / y - 1.0).abs();
    let worst = solid.iter().map(miss).fold(0.0, f64::max);
    let logs: Vec<(f64, f64)> = solid.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let (factor, power) = straight_line(&logs);
    let off = |&(x, y): &(f64, f64)| ((factor + power * x - y).exp() - 1.0).abs();
    let rest = logs.iter().map(off).fold(0.0, f64::max);
    Claim::contradiction(
        TEXT.said("linear-density"),
        format!(
            "the best line misses the solid fraction by up to {:.0} % and is zero at {:.1}R; \
             r_capt^−{power:.2} misses it by {:.0} %",
            100.0 * worst,
            -slope / intercept,
            100.0 * rest
        ),
        worst > SCATTER && rest < SCATTER && intercept < 0.0,
    )
}

/// A number of the thesis' one deposit beside our mean, in the unit of both.
fn one_of_many(
    statement: Statement,
    thesis: (&str, f64),
    ours: (String, f64),
    scatter: f64,
) -> Claim {
    let sigmas = [scatter / (DEPOSITS as f64).sqrt(), scatter];
    let (allowance, apart) = (Allowance::Scatter(2.0 * scatter), ours.1 - thesis.1);
    Claim::compared(statement, thesis, ours, allowance, MismatchMeaning::Failure)
        .apart(apart, sigmas, DEPOSITS)
}

/// Spheres and porosities of the three systems.
fn system_claims() -> Result<Vec<Claim>> {
    let mut claims = Vec::new();
    for (name, width, height, spheres) in SYSTEMS {
        let ballistic = Ballistic::new(width, 1.0, 3.0)?;
        let sample = Sample::new(
            &ballistic,
            DepositTarget::Cut(height),
            FIRST_SEED..FIRST_SEED + DEPOSITS,
        )?;
        let (count, scatter) = statistics(&sample.particles);
        let said = |id: &str| {
            let said = TEXT.said(id).with("name", name);
            said.with("width", width).with("height", height)
        };
        let (printed, shown) = (format!("{spheres}"), format!("{count:.0}"));
        let claim = if width < 40.0 {
            one_of_many(said("count"), (&printed, spheres), (shown, count), scatter)
        } else {
            let is_near = (count - spheres).abs() < 2.0 * scatter;
            Claim::trend(said("count-inferred"), shown, is_near).printed(&printed)
        };
        claims.push(claim.uncertain(format!("± {scatter:.0}, one of {DEPOSITS} deposits")));

        let (porosity, scatter) = statistics(&sample.porosity);
        let shown = format!("{:.1} %", 100.0 * porosity);
        // 92.3 % belongs to one deposit, "approximately 92 %" to all at this capture radius.
        let claim = if width < 40.0 {
            Claim::compared(
                TEXT.said("porosity").with("name", name),
                ("≈ 92 %", 92.0),
                (shown, 100.0 * porosity),
                Allowance::Digits(0.5),
                MismatchMeaning::Failure,
            )
        } else {
            one_of_many(
                said("porosity-of-one"),
                ("92.3 %", 92.3),
                (shown, 100.0 * porosity),
                100.0 * scatter,
            )
        };
        let uncertainty = format!("± {:.1} %, one of {DEPOSITS} deposits", 100.0 * scatter);
        claims.push(claim.uncertain(uncertainty));
    }
    Ok(claims)
}
