//! Table 4.1: stress along the compaction, carried by pushing and by pulling contacts.

use super::choices::{best_share, printed};
use super::porosity::few_sweeps;
use crate::exhibit::{Exhibit, points};
use crate::runs::{Case, Effort, Run, Runs, System};
use crate::text::Text;
use anyhow::Result;
use tribos::powder::PowderStopReason;
use tribos::statistics::statistics;
use tribos_report::claim::{Claim, MismatchMeaning};
use tribos_report::figure::{Axis, Figure, Legend, ReferenceLine, Series};
use tribos_report::verdict::{Allowance, Verdict};

const TEXT: Text = Text(include_str!("table-4.1.md"));

/// The table: μ_t, μ_n, σ_zz⁺, σ_zz⁻ in units of the pressure; the corners of figure 4.7 first.
pub(super) const TABLE: [[f64; 4]; 8] = [
    [0.0, 0.0, 2.2, -1.2],
    [1.0, 1.0, 1.1, -0.1],
    [0.0, 1.0, 1.9, -0.9],
    [1.0, 0.0, 1.4, -0.4],
    [0.1, 0.1, 1.4, -0.4],
    [0.3, 0.3, 1.1, -0.1],
    [0.0, 0.3, 2.2, -1.2],
    [0.3, 0.0, 1.2, -0.2],
];
/// Lines that need no other runs than figure 4.7.
const CORNERS: usize = 4;
/// Half a unit of the table's last digit.
const HALF_DIGIT: f64 = 0.05;
/// σ_zz⁺ of packings whose steps began from the forces of the step before, of both systems.
const FOUND: std::ops::RangeInclusive<f64> = 1.0..=9.0;

/// Partial stresses of the blocked packings.
pub fn table_4_1(runs: &Runs) -> Result<Exhibit> {
    let (system, lines) = match runs.effort() {
        Effort::Quick => (System::Small, &TABLE[..CORNERS]),
        Effort::Full => (System::Large, &TABLE[..]),
    };
    let case = |line: &[f64; 4]| Case::new(system, [line[0], line[1]], 1);
    let packings = runs.of(&lines.iter().map(case).collect::<Vec<_>>())?;
    let stresses: Vec<[f64; 3]> = packings.iter().map(|run| stress_zz(run)).collect();
    let rows: Vec<Vec<f64>> = lines
        .iter()
        .zip(&stresses)
        .enumerate()
        .map(|(at, (line, stress))| [&[at as f64 + 1.0], &line[..], stress].concat())
        .collect();
    let mut claims = line_claims(lines, &stresses)?;
    claims.extend(order_claims(&stresses));
    claims.extend(choice_claims(runs)?);
    let claims = claims
        .into_iter()
        .map(|claim| claim.uncertain("one deposit"))
        .chain([torsion_alone()?]);
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()).with("system", system.name()),
        figure(lines, &rows),
        &[
            "line",
            "rolling",
            "torsion",
            "thesis_plus",
            "thesis_minus",
            "stress_zz",
            "stress_zz_plus",
            "stress_zz_minus",
        ],
        rows,
        claims.collect(),
    )
    .seeded([1])
    .kept("exhibits/choices/runs.csv (row on torsion)"))
}

/// Points by line.
fn figure(lines: &[[f64; 4]], rows: &[Vec<f64>]) -> Figure {
    let cases = lines
        .iter()
        .map(|[rolling, torsion, ..]| format!("({rolling}, {torsion})"));
    Figure::new(
        "Partial stresses",
        Axis::named("(μ_t, μ_n)", cases.collect()),
        Axis::linear("σ_zz in units of the pressure"),
    )
    .series(Series::points("σ⁺", points(rows, 0, 6)))
    .series(Series::points("σ⁻", points(rows, 0, 7)))
    .series(Series::points("σ⁺, thesis", points(rows, 0, 3)))
    .series(Series::points("σ⁻, thesis", points(rows, 0, 4)))
    .guide(ReferenceLine::horizontal(0.0, ""))
    .guide(ReferenceLine::horizontal(1.0, "applied"))
    .legend(Legend::Below)
}

/// σ_zz of all contacts, of those that push and of those that pull, over the pressure.
fn stress_zz(run: &Run) -> [f64; 3] {
    let of = &run.outcome;
    [of.stress_zz, of.stress_zz_plus, of.stress_zz_minus]
}

/// "+6.06 −5.07"
fn split([_, plus, minus]: [f64; 3]) -> String {
    format!("+{plus:.2} −{:.2}", minus.abs())
}

/// What is known of the difference.
fn cause() -> Result<String> {
    Ok(TEXT.said("cause").with("share", best_share()?).text)
}

/// Total and shares of each line.
fn line_claims(lines: &[[f64; 4]], stresses: &[[f64; 3]]) -> Result<Vec<Claim>> {
    let (mut claims, cause) = (Vec::new(), cause()?);
    for ([rolling, torsion, plus, minus], stress) in lines.iter().zip(stresses) {
        let said = |id| {
            let said = TEXT.said(id).with("rolling", rolling);
            said.with("torsion", torsion).with("cause", &cause)
        };
        claims.push(
            Claim::definition(
                said("total"),
                format!("{:.3}", stress[0]),
                (stress[0] - 1.0).abs() <= HALF_DIGIT,
            )
            .printed("1.0"),
        );
        let printed = format!("+{plus:.1} −{:.1}", minus.abs());
        // The total is 1: σ_zz⁻ adds nothing to compare.
        let claim = Claim::compared(
            said("split"),
            (&printed, *plus),
            (split(*stress), stress[1]),
            Allowance::Digits(HALF_DIGIT),
            MismatchMeaning::Known(FOUND),
        );
        let verdict = match claim.verdict {
            Verdict::Differs(cause) => Verdict::CauseKnown(cause),
            verdict => verdict,
        };
        claims.push(Claim { verdict, ..claim });
    }
    Ok(claims)
}

/// What the thesis reads off the table; corners in its order.
fn order_claims(stresses: &[[f64; 3]]) -> Vec<Claim> {
    let [none, both, rolling] = [0, 1, 3].map(|at: usize| stresses[at]);
    let pull = |stress: [f64; 3]| -stress[2];
    let left = |stress| pull(stress) / pull(none);
    vec![
        Claim::trend(
            TEXT.said("without-torques"),
            format!("{:.2}", none[1]),
            none[1] > 2.0,
        )
        .printed("2.2"),
        Claim::trend(
            TEXT.said("rolling"),
            format!("{:.2} to {:.2}", pull(none), pull(rolling)),
            left(rolling) < 0.5,
        )
        .printed("1.2 to 0.4"),
        Claim::trend(
            TEXT.said("tension"),
            format!("{:.2} of it", pull(none) / none[1]),
            pull(none) > 0.5 * none[1],
        ),
        Claim::trend(
            TEXT.said("both"),
            format!("{:.2}", both[1]),
            (both[1] - 1.0).abs() <= 0.2,
        )
        .printed("1.1"),
    ]
}

/// Half a digit of −0.9 and of −1.2 leaves so much of their ratio open.
const OF_RATIO: f64 = 0.075;
/// What torsion friction left of the pull before, with the scatter of five deposits.
const FOUND_LEFT: std::ops::RangeInclusive<f64> = 0.3..=0.9;

/// What torsion friction leaves of the pull, deposit by deposit of the small system as kept; the thesis has one packing.
fn torsion_alone() -> Result<Claim> {
    let [width, _] = System::Small.size();
    // The total is 1.
    let pulls = |pair| -> Result<Vec<f64>> {
        let kept = printed(width, pair)?;
        Ok(kept.iter().map(|[_, plus]| plus - 1.0).collect())
    };
    let (none, torsion) = (pulls([0.0, 0.0])?, pulls([0.0, 1.0])?);
    let left: Vec<f64> = torsion
        .iter()
        .zip(&none)
        .map(|(with, without)| with / without)
        .collect();
    let ((mean, scatter), deposits) = (statistics(&left), left.len());
    let [[_, _, plus, _], _, [_, _, twisted, _], ..] = TABLE;
    let thesis = (twisted - 1.0) / (plus - 1.0);
    let sigmas = [scatter / (deposits as f64).sqrt(), scatter];
    let claim = Claim::compared(
        TEXT.said("torsion"),
        ("−0.9 of −1.2", thesis),
        (format!("{mean:.2}"), mean),
        Allowance::Digits(OF_RATIO),
        MismatchMeaning::Known(FOUND_LEFT),
    );
    let claim = claim.apart(mean - thesis, sigmas, deposits as u64);
    Ok(claim.uncertain(format!("± {scatter:.2}, one of {deposits} deposits")))
}

/// The same deposit and law, other ways of the iteration.
fn choice_claims(runs: &Runs) -> Result<Vec<Claim>> {
    let usual = Case::new(System::Small, [0.0; 2], 1);
    let warm = runs.one(&usual)?;
    let few = runs.one(&few_sweeps([0.0; 2]))?;
    let plus = |run: &Run| run.outcome.stress_zz_plus;
    let shown = |run: &Run| {
        let porosity = 100.0 * run.outcome.porosity_final;
        let creeping = match run.outcome.ending {
            Some(PowderStopReason::Blocked) => "",
            _ => ", still sinking",
        };
        format!("{} at {porosity:.1} %{creeping}", split(stress_zz(run)))
    };
    let mut claims = vec![Claim::own_statement(
        TEXT.said("few-sweeps").with("warm", shown(&warm)),
        shown(&few),
        plus(&few) < TABLE[0][2] && plus(&warm) > TABLE[0][2],
    )];
    if runs.effort() == Effort::Full {
        let cold =
            runs.one(&usual.with("warm_start=off", |scene| scene.warm_start = 0.0.into()))?;
        let apart = cold.outcome.porosity_final - warm.outcome.porosity_final;
        let overlap = cold.outcome.max_overlap;
        claims.push(Claim::own_statement(
            TEXT.said("zero-forces").with("warm", shown(&warm)),
            format!("{}, overlaps up to {overlap:.2}R", shown(&cold)),
            apart.abs() < 0.02 && plus(&cold) < 0.5 * plus(&warm),
        ));
    }
    Ok(claims)
}
