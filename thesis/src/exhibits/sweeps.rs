//! Section 4.4.2: what the sweeps of contact dynamics leave: pseudo-elasticity, and the rules that end them.

use super::elasticity::{BODIES, SWEEPS, Wave, sweeps_needed};
use crate::exhibit::Exhibit;
use crate::runs::{Case, Effort, Run, Runs, System};
use crate::text::Text;
use anyhow::Result;
use std::sync::Arc;
use tribos::powder::PowderStopReason;
use tribos::scene::{BlockedCriterion, SweepMethod, SweepStop};
use tribos::statistics::straight_line;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-4.4.2.md"));

/// Orders whose waves are averaged.
const SEEDS: u64 = 8;
/// Links are 1/200 of the wave and its ends half a link uncertain: 1 % in k, 2 % in the damping, and 1 % scatter.
const PERIOD_ACCURACY: f64 = 0.015;
const DAMPING_ACCURACY: f64 = 0.03;
/// Rows whose sweeps are counted.
const ROWS: [usize; 5] = [6, 12, 25, 50, 100];
/// Tolerances of the rules that end sweeps.
const QUICK: &[f64] = &[1e-2];
const FULL: &[f64] = &[1e-1, 1e-2, 1e-3, 1e-4];
/// A fixed number of sweeps beside them.
const FIXED: usize = 100;
/// Bound for sweeps that do not converge.
const MOST_SWEEPS: usize = 20_000;
/// A load that ends early.
const PRESSURE: f64 = 0.01;

/// How the sweeps of a run end.
#[derive(Clone, Copy)]
struct Rule {
    stop: SweepStop,
    tolerance: f64,
}

impl Rule {
    fn name(self) -> String {
        match self.stop {
            SweepStop::Local => format!("local {:e}", self.tolerance),
            SweepStop::Global => format!("global {:e}", self.tolerance),
            SweepStop::Fixed => format!("{FIXED} sweeps"),
        }
    }

    fn case(self, system: System) -> Case {
        let keys = format!("pressure={PRESSURE},gauss-seidel,{}", self.name());
        Case::new(system, [0.0; 2], 1).with(&keys, |scene| {
            scene.solver = SweepMethod::GaussSeidel;
            scene.blocked_criterion = BlockedCriterion::Piston;
            scene.pressure = PRESSURE;
            scene.stop_rule = self.stop;
            scene.max_iterations = MOST_SWEEPS;
            match self.stop {
                SweepStop::Fixed => scene.max_iterations = FIXED,
                SweepStop::Local | SweepStop::Global => scene.tolerance = self.tolerance,
            }
        })
    }
}

/// A rule and its run.
type Ended = (Rule, Arc<Run>);

/// Waves, sweeps and rules.
pub fn section_4_4_2(runs: &Runs) -> Result<Exhibit> {
    let waves: Vec<Wave> = (0..SEEDS).map(Wave::measured).collect::<Result<_>>()?;
    let needed = ROWS.map(|bodies| Ok((bodies as f64, sweeps_needed(bodies)? as f64)));
    let needed: Vec<(f64, f64)> = needed.into_iter().collect::<Result<_>>()?;
    let (system, tolerances) = match runs.effort() {
        Effort::Quick => (System::Tiny, QUICK),
        Effort::Full => (System::Small, FULL),
    };
    let ended = by_rule(runs, system, tolerances)?;
    let claims = [
        wave_claims(&waves),
        vec![needed_claim(&needed)],
        rule_claims(&ended),
    ]
    .concat();
    let speeds = waves.first().map_or(&[][..], |wave| &wave.speeds);
    let rows = speeds
        .iter()
        .enumerate()
        .map(|(step, speed)| vec![step as f64 + 1.0, *speed]);
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()).with("system", system.name()),
        figure(speeds, &needed, &ended),
        &["step", "piston_velocity"],
        rows.collect(),
        claims,
    )
    .seeded(0..SEEDS))
}

/// Compactions of one deposit; the fixed number comes last.
fn by_rule(runs: &Runs, system: System, tolerances: &[f64]) -> Result<Vec<Ended>> {
    let mut rules = Vec::new();
    for stop in [SweepStop::Global, SweepStop::Local] {
        rules.extend(tolerances.iter().map(|&tolerance| Rule { stop, tolerance }));
    }
    rules.push(Rule {
        stop: SweepStop::Fixed,
        tolerance: f64::NAN,
    });
    let cases: Vec<Case> = rules.iter().map(|rule| rule.case(system)).collect();
    Ok(rules.into_iter().zip(runs.of(&cases)?).collect())
}

/// Sweeps of a step, and the relative residual that the last step left.
fn cost_and_error(run: &Run) -> (f64, f64) {
    let outcome = &run.outcome;
    (
        outcome.iterations_total as f64 / outcome.steps as f64,
        outcome.residual_final,
    )
}

fn figure(speeds: &[f64], needed: &[(f64, f64)], ended: &[Ended]) -> Panels {
    let curve = speeds
        .iter()
        .enumerate()
        .map(|(step, speed)| (step as f64 + 1.0, *speed));
    let wave = Figure::new(
        format!("Row of {BODIES}, {SWEEPS} sweeps a step"),
        Axis::linear("step"),
        Axis::linear("velocity of the last body [R/step]"),
    )
    .series(Series::line("", curve.collect()))
    .guide(ReferenceLine::horizontal(0.0, ""));
    let squares = needed
        .iter()
        .map(|(bodies, _)| (*bodies, bodies * bodies))
        .collect();
    let sweeps = Figure::new(
        "Rigid rows",
        Axis::log10("L/d"),
        Axis::log10("sweeps needed"),
    )
    .series(Series::line_points("from zero forces", needed.to_vec()))
    .series(Series::dashed("(L/d)²", squares));
    let of = |stop: SweepStop| -> Vec<(f64, f64)> {
        let of = ended.iter().filter(|(rule, _)| rule.stop == stop);
        of.map(|(_, run)| cost_and_error(run)).collect()
    };
    let rules = Figure::new(
        "Rules",
        Axis::log10("sweeps a step"),
        Axis::log10("relative residual"),
    )
    .series(Series::line_points("global", of(SweepStop::Global)))
    .series(Series::line_points("local", of(SweepStop::Local)))
    .series(Series::points("fixed", of(SweepStop::Fixed)));
    Panels::new("", 2)
        .cell(540, 340)
        .figure(wave)
        .figure(sweeps)
        .figure(rules)
}

/// Period and damping against the theory.
fn wave_claims(waves: &[Wave]) -> Vec<Claim> {
    let mean = |of: fn(&Wave) -> f64| waves.iter().map(of).sum::<f64>() / waves.len() as f64;
    let theory = Wave::expected();
    let (period, damping) = (mean(|wave| wave.period), mean(|wave| wave.damping));
    let bounds = [
        PERIOD_ACCURACY * theory.period,
        DAMPING_ACCURACY * theory.damping,
    ];
    let rows = [
        Claim::own(
            TEXT.said("period")
                .with("theory", format!("{:.2}", theory.period)),
            period,
            theory.period,
            bounds[0],
        ),
        Claim::own(
            TEXT.said("damping")
                .with("theory", format!("{:.5}", theory.damping)),
            damping,
            theory.damping,
            bounds[1],
        ),
    ];
    let elastic = Claim::trend(
        TEXT.said("elastic"),
        format!(
            "swings with a period of {period:.1} steps, damped by {:.0} % in each",
            100.0 * (1.0 - (-damping * period).exp())
        ),
        damping * period < 1.0,
    );
    let averaged = rows
        .into_iter()
        .map(|row| row.uncertain(format!("mean of {} orders", waves.len())));
    [elastic].into_iter().chain(averaged).collect()
}

/// Eq. 4.4.
fn needed_claim(needed: &[(f64, f64)]) -> Claim {
    let logarithms: Vec<(f64, f64)> = needed.iter().map(|(l, n)| (l.ln(), n.ln())).collect();
    let (_, slope) = straight_line(&logarithms);
    let factor = needed.last().map_or(f64::NAN, |(l, n)| n / (l * l));
    Claim::trend(
        TEXT.said("needed"),
        format!("N_I = {factor:.2} (L/d)² for the longest row; exponent {slope:.2}"),
        (slope - 2.0).abs() < 0.2 && (0.1..10.0).contains(&factor),
    )
    .printed("2")
}

/// Local against global, and both against a fixed number.
fn rule_claims(ended: &[Ended]) -> Vec<Claim> {
    let porosities: Vec<f64> = ended
        .iter()
        .map(|(_, run)| run.outcome.porosity_final)
        .collect();
    let [least, most] = [
        porosities.iter().fold(f64::INFINITY, |a, b| a.min(*b)),
        porosities.iter().fold(0.0, |a: f64, b| a.max(*b)),
    ];
    let shown: Vec<String> = ended
        .iter()
        .map(|(rule, run)| {
            let (sweeps, residual) = cost_and_error(run);
            format!(
                "{}: {sweeps:.0} sweeps, residual {residual:.1e}",
                rule.name()
            )
        })
        .collect();
    let of = |stop: SweepStop| ended.iter().filter(move |(rule, _)| rule.stop == stop);
    let pairs = of(SweepStop::Global).zip(of(SweepStop::Local));
    // At the same tolerance.
    let dearer = pairs
        .clone()
        .all(|((_, global), (_, local))| cost_and_error(local).0 > cost_and_error(global).0);
    let blocked = ended
        .iter()
        .filter(|(_, run)| run.outcome.ending == Some(PowderStopReason::Blocked))
        .count();
    vec![
        Claim::trend(
            TEXT.said("rules"),
            shown.join("; "),
            dearer && pairs.count() > 0,
        ),
        Claim::trend(
            TEXT.said("porosity"),
            format!(
                "{:.1} to {:.1} %, {blocked} of {} blocked",
                100.0 * least,
                100.0 * most,
                ended.len()
            ),
            most - least < 0.04,
        ),
    ]
}
