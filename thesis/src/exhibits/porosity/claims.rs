//! What the thesis says on figure 4.7.

use super::super::choices::printed;
use super::{Porosities, TEXT, grid};
use crate::runs::{Case, Runs, System};
use anyhow::Result;
use std::f64::consts::SQRT_2;
use tribos::powder::PowderStopReason;
use tribos::scene::{BlockedCriterion, SweepMethod, SweepStop, WallLaw};
use tribos::statistics::{mean, statistics};
use tribos_report::claim::{Claim, MismatchMeaning};
use tribos_report::verdict::{Allowance, Verdict};

/// The thesis' fluctuations of single runs of the small system: what its means and the differences
/// of two of them are good to.
pub const FLUCTUATION: f64 = 0.02;
/// Where the thesis states it.
pub const FLUCTUATION_STATED: &str = "section 4.6.1: fluctuations ≈ 2 %";
/// Two such fluctuations in E₁(1, 0) ≈ 18 % and E₁(0, 1) ≈ 8 % leave so much of their ratio open.
pub(super) const RATIO_TOLERANCE: f64 = 0.6;
/// What the thesis calls about 3 %.
pub const ADDITIVITY: f64 = 0.035;

/// What our conditions gave before, to two points: E₀, E(1,1), E₁(1,0), E₁(0,1), E₁(1,1) and the
/// compaction left at (1,1).
const FOUND: [f64; 6] = [0.67, 0.894, 0.16, 0.08, 0.225, 0.024];

/// Rolling and torsion coefficients of the corners.
const PAIRS: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
/// What larger systems ended at in the corners, in per cent, one deposit: `tribos sweep compaction-large` and
/// `compaction-4193`, each with `--set mu_rolling=0,1 --set mu_torsion=0,1`.
const LARGE: [f64; 4] = [65.7, 73.4, 81.5, 89.2];
const LARGEST: [f64; 4] = [63.9, 72.9, 81.8, 89.4];

/// A range of cohesion a hundred times shorter.
const SHORT_RANGE: f64 = 1e-4;

/// The first small system with an iteration as it was usual: so many sweeps a step from zero forces,
/// whatever they leave. The law of eq. 4.4 asks for about (61.5/2)² ≈ 950 at the start.
pub fn few_sweeps(friction: [f64; 2]) -> Case {
    let keys = "solver=gauss-seidel,stop=fixed,sweeps=20,warm_start=off,blocked=piston,steps=4000";
    Case::new(System::Small, friction, 1).with(keys, |scene| {
        scene.solver = SweepMethod::GaussSeidel;
        scene.stop_rule = SweepStop::Fixed;
        scene.max_iterations = 20;
        scene.warm_start = 0.0.into();
        scene.blocked_criterion = BlockedCriterion::Piston;
        scene.max_steps = 4000;
    })
}

/// All claims.
pub fn all(runs: &Runs, small: &Porosities, large: Option<&Porosities>) -> Result<Vec<Claim>> {
    let mut claims = shape(small);
    claims.extend(levels(small));
    let single = [trials(runs)?, smooth(runs)?].concat();
    claims.extend(
        single
            .into_iter()
            .map(|claim| claim.uncertain("one deposit")),
    );
    claims.push(all_blocked(small));
    if let Some(large) = large {
        claims.extend(grid::all(small, large));
    }
    claims.extend(by_size()?);
    Ok(claims)
}

/// The thesis' largest system, and what the size changes; from kept runs.
fn by_size() -> Result<[Claim; 2]> {
    let [low, .., high] = LARGEST;
    let largest = Claim::compared(
        TEXT.said("larger-system"),
        ("≈ 54 % to ≈ 82 %", 54.0),
        (format!("{low} % to {high} %"), low),
        Allowance::StatedError(100.0 * FLUCTUATION, FLUCTUATION_STATED.into()),
        MismatchMeaning::Known(low..=low),
    );
    let ([width, _], mut small) = (System::Small.size(), [0.0; 4]);
    for (mean_porosity, pair) in small.iter_mut().zip(PAIRS) {
        let porosities: Vec<f64> = printed(width, pair)?.iter().map(|[e, _]| *e).collect();
        *mean_porosity = mean(&porosities);
    }
    let sizes = [small, LARGE, LARGEST];
    let apart = [0, 1, 2, 3].map(|at: usize| {
        let [a, b, c] = sizes.map(|corners| corners[at]);
        a.max(b).max(c) - a.min(b).min(c)
    });
    let most = apart.into_iter().fold(0.0, f64::max);
    let shown = sizes.map(|corners| corners.map(|porosity| format!("{porosity:.1}")).join(", "));
    let same = Claim::trend(
        TEXT.said("independent"),
        format!("{} %: at most {most:.1} points apart", shown.join("; ")),
        most < 100.0 * SQRT_2 * FLUCTUATION,
    );
    let deposits = "five deposits of the small system, one of the others";
    Ok([largest.uncertain("one deposit"), same.uncertain(deposits)])
}

/// "66.3 %".
pub(super) fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// "± 0.4 points, 2 deposits": standard deviations over so many deposits.
fn scatter(deviations: &[f64], deposits: usize) -> String {
    let points = deviations.iter().map(|d| format!("{:.1}", 100.0 * d));
    let points: Vec<String> = points.collect();
    format!("± {} points, {deposits} deposits", points.join(", "))
}

/// Order, ratio and sum of the contributions.
fn shape(small: &Porosities) -> Vec<Claim> {
    let corners = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| small.corner(i, j));
    let [none, torsion, rolling, both] = corners.map(|(mean, _)| mean);
    let deviations = corners.map(|(_, deviation)| deviation);
    let widest = deviations.iter().fold(0.0_f64, |most, d| most.max(*d));
    let shown = corners.map(|(mean, _)| percent(mean)).join(", ");
    let excess = both - rolling - torsion + none;
    let ratio = (rolling - none) / (torsion - none);
    vec![
        Claim::trend(
            TEXT.said("order"),
            shown,
            none < torsion && torsion < rolling && rolling < both,
        )
        .printed("54, 54 + 8, 54 + 18, 82 %")
        .uncertain(scatter(&deviations, small.initial.len())),
        Claim::trend(
            TEXT.said("twice"),
            format!("{ratio:.1}"),
            (ratio - 2.0).abs() < RATIO_TOLERANCE,
        )
        .printed("≈ 2"),
        Claim::trend(
            TEXT.said("sum"),
            format!("ΔE = {:+.1} %", 100.0 * excess),
            excess.abs() < ADDITIVITY,
        )
        .printed("3 %"),
        Claim::trend(
            TEXT.said("fluctuations"),
            format!("largest standard deviation {:.1} %", 100.0 * widest),
            widest < 1.5 * FLUCTUATION,
        )
        .printed("≈ 2 %"),
    ]
}

/// The porosities themselves.
fn levels(small: &Porosities) -> Vec<Claim> {
    let (none, both) = (small.corner(0, 0), small.corner(1, 1));
    // Deposit by deposit: what a deposit adds to both cancels.
    let paired = |more: &[f64], less: &[f64]| {
        let each: Vec<f64> = more.iter().zip(less).map(|(a, b)| a - b).collect();
        statistics(&each)
    };
    let added = |i, j| paired(small.each(i, j), small.each(0, 0));
    let rows = [
        ("base", ("≈ 54 %", 54.0), none),
        ("top", ("≈ 82 %", 82.0), both),
        ("rolling-alone", ("≈ 18 %", 18.0), added(1, 0)),
        ("torsion-alone", ("≈ 8 %", 8.0), added(0, 1)),
        ("both", ("≈ 28 %", 28.0), added(1, 1)),
        (
            "compaction",
            ("≈ 10 %", 10.0),
            paired(&small.initial, small.each(1, 1)),
        ),
    ];
    let (difference, deposits) = (TEXT.said("difference").text, small.initial.len() as f64);
    let rows = rows.into_iter().zip(FOUND);
    rows.map(|((id, printed, (ours, deviation)), found)| {
        // In points, as the thesis and the reader have them.
        let range = 100.0 * (found - FLUCTUATION).max(0.0)..=100.0 * (found + FLUCTUATION);
        let said = TEXT.said(id).with("difference", &difference);
        let claim = Claim::compared(
            said.clone(),
            printed,
            (percent(ours), 100.0 * ours),
            Allowance::StatedError(100.0 * FLUCTUATION, FLUCTUATION_STATED.into()),
            MismatchMeaning::Known(range),
        );
        let verdict = match claim.verdict {
            // A difference of two numbers that are both off agrees in size alone.
            Verdict::Reproduced(_) if id == "torsion-alone" => Verdict::Trend(said.basis),
            verdict => verdict,
        };
        Claim { verdict, ..claim }
            .uncertain(scatter(&[deviation], small.initial.len()))
            .apart(
                100.0 * ours - printed.1,
                [deviation / deposits.sqrt(), FLUCTUATION].map(|share| 100.0 * share),
                small.initial.len() as u64,
            )
    })
    .collect()
}

/// Our own trials with what is not stated, all on the first deposit.
fn trials(runs: &Runs) -> Result<Vec<Claim>> {
    let (none, both) = ([0.0; 2], [1.0; 2]);
    let usual = |friction| Case::new(System::Small, friction, 1);
    let short = |friction| {
        let key = format!("cohesion_range={SHORT_RANGE}");
        usual(friction).with(&key, |scene| scene.cohesion_range = SHORT_RANGE)
    };
    // Bottom and piston with cohesion, but without friction.
    let smooth =
        |case: Case| case.with("wall=smooth", |scene| scene.wall_contact = WallLaw::Smooth);
    let cases = [
        usual(none),
        short(none),
        few_sweeps(none),
        usual(both),
        short(both),
        few_sweeps(both),
        smooth(short(none)),
    ];
    let runs = runs.of(&cases)?;
    let ends: Vec<f64> = runs.iter().map(|run| run.outcome.porosity_final).collect();
    let blocked = |at: usize| runs[at].outcome.ending == Some(PowderStopReason::Blocked);
    let shown = |at: usize| {
        let creeping = if blocked(at) { "" } else { ", still sinking" };
        format!("{:.1} %{creeping}", 100.0 * ends[at])
    };
    let between = |at: usize| format!("{} instead of {}", shown(at + 1), shown(at));
    let early = |at: usize| format!("{} instead of {}", shown(at + 2), shown(at));
    let row = |id, shown, holds| Claim::own_statement(TEXT.said(id), shown, holds);
    Ok(vec![
        row("short-base", between(0), ends[1] < ends[0] - FLUCTUATION),
        row(
            "short-smooth-base",
            format!("{} instead of {}", shown(6), shown(1)),
            ends[6] < ends[1] - FLUCTUATION,
        ),
        row(
            "short-top",
            between(3),
            (ends[4] - ends[3]).abs() < 0.5 * FLUCTUATION,
        ),
        row("few-base", early(0), ends[2] < ends[0] - FLUCTUATION),
        row(
            "few-top",
            early(3),
            ends[5] < ends[3] - FLUCTUATION && !blocked(5),
        ),
    ])
}

/// Without sliding friction (eq. 4.9).
fn smooth(runs: &Runs) -> Result<Vec<Claim>> {
    let both = [[0.0; 2], [1.0; 2]];
    let rough = both.map(|friction| Case::new(System::Small, friction, 1));
    let smooth = rough
        .clone()
        .map(|case| case.with("sliding=0", |scene| scene.mu = 0.0));
    let ends = runs.of(&[smooth, rough].concat())?;
    let [free, held, base, with_sliding] =
        [0, 1, 2, 3].map(|at: usize| ends[at].outcome.porosity_final);
    Ok(vec![
        Claim::definition(
            TEXT.said("no-sliding"),
            format!(
                "E(0,0,0) = {:.1} %, E(0,1,1) = {:.1} %",
                100.0 * free,
                100.0 * held
            ),
            (held - free).abs() < FLUCTUATION,
        ),
        Claim::trend(
            TEXT.said("no-sliding-is-low"),
            format!(
                "{:.1} % against {:.1} % with μ = 0.3 alone",
                100.0 * held,
                100.0 * base
            ),
            held < base - FLUCTUATION,
        ),
        Claim::trend(
            TEXT.said("not-a-sum"),
            format!(
                "E(0.3,1,1) = {:.1} %, the sum {:.1} %",
                100.0 * with_sliding,
                100.0 * (base + held - free)
            ),
            with_sliding - (base + held - free) > ADDITIVITY,
        ),
    ])
}

/// Nothing is counted that is still moving.
pub(super) fn all_blocked(small: &Porosities) -> Claim {
    let [blocked, all] = small.blocked;
    Claim::trend(
        TEXT.said("all-blocked").with("system", small.system.name()),
        format!("{blocked} of {all}"),
        blocked == all,
    )
}
