//! Figures 5.1 and 5.2: the tip on the substrate, and its angle over time.

use super::tip_choices;
use crate::exhibit::Exhibit;
use crate::runs::{Batch, Effort, FRAMES, Runs, film};
use crate::text::Text;
use anyhow::{Result, anyhow};
use nalgebra::Vector3;
use std::num::NonZero;
use std::path::PathBuf;
use std::thread::available_parallelism;
use tribos::run::in_order;
use tribos::scene::TipScene;
use tribos::tip::{AtomRole, Reversal, TipSimulation, TipSummary};
use tribos_report::claim::{Claim, MismatchMeaning};
use tribos_report::figure::{Axis, Figure, ReferenceLine, Series};
use tribos_report::player::Film;
use tribos_report::runs::tip::atoms;
use tribos_report::verdict::Allowance;

const FIGURE_5_1: Text = Text(include_str!("figure-5.1.md"));
pub(super) const FIGURE_5_2: Text = Text(include_str!("figure-5.2.md"));

/// Strengths of the torque: the thesis' two cases, and one that turns this tip for good.
const QUICK: [f64; 3] = [0.017, 0.020, 0.060];
/// From the thesis' weakest up, with what lies between.
const FULL: [f64; 10] = [
    0.010, 0.017, 0.018, 0.020, 0.025, 0.030, 0.040, 0.045, 0.050, 0.060,
];
/// Runs of each strength.
const FULL_SEEDS: u64 = 3;
/// Strength and seed of the film: a tip that is turned for good.
const FILMED: (f64, u64) = (0.060, 1);
/// The films of appendix B.
pub(super) const LISTED: [(f64, u64); 2] = [(0.017, 1), (0.020, 1)];
/// The last strength that the thesis found reversible.
const REVERSIBLE: f64 = 0.017;
/// Half of the step to the first that it found irreversible, 0.018.
const HALF_STEP: f64 = 0.0005;
/// Where ours was found before: the strongest tried that lets the tip turn back.
const FOUND: std::ops::RangeInclusive<f64> = 0.020..=0.045;
/// One run of a strength.
struct TorqueRun {
    lambda: f64,
    seed: u64,
    series: Vec<Vec<f64>>,
    outcome: TipSummary,
}

fn scene(lambda: f64, seed: u64, effort: Effort) -> TipScene {
    let whole = TipScene {
        lambda,
        seed,
        ..TipScene::default()
    };
    match effort {
        Effort::Full => whole,
        Effort::Quick => TipScene {
            time_step: 0.01,
            equilibration: 10.0,
            drive_time: 40.0,
            rest_time: 40.0,
            ..whole
        },
    }
}

/// The system.
pub fn figure_5_1() -> Result<Exhibit> {
    let scene = scene(REVERSIBLE, 1, Effort::Full);
    let sites = scene.shape().sites();
    let places: Vec<Vector3<f64>> = sites.iter().map(|site| site.place).collect();
    let number = |part: AtomRole| sites.iter().filter(|site| site.part == part).count();
    let rows = sites.iter().map(|site| {
        let part = AtomRole::ALL.iter().position(|&part| part == site.part);
        let [x, y, z] = site.place.into();
        vec![x, y, z, part.unwrap_or_default() as f64, site.layer as f64]
    });
    let counts: Vec<String> = AtomRole::ALL
        .iter()
        .map(|&part| format!("{} {}", number(part), part.name()))
        .collect();
    Ok(Exhibit::new(
        FIGURE_5_1.prose(),
        atoms("", &scene, &places)?.size(760, 560),
        &["x", "y", "z", "part", "layer"],
        rows.collect(),
        vec![
            Claim::definition(
                FIGURE_5_1.said("atoms"),
                format!("{}: {}", sites.len(), counts.join(", ")),
                sites.len() == 6330,
            )
            .printed("6330"),
            equilibrium(),
            unit_of_force(),
            unit_of_time(),
        ],
    ))
}

/// Place and depth of the potential's minimum, from the printed U.
fn equilibrium() -> Claim {
    let power = |distance: f64| distance.powi(-6);
    let energy = |distance: f64| 4.0 * (power(distance) - 1.0) * power(distance);
    let slope = |distance: f64| (1.0 - 2.0 * power(distance)) * power(distance) / distance;
    let [mut low, mut high] = [1.0, 2.0];
    // Bisection to the last place.
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (low + high);
        if slope(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let off = (high - 2f64.powf(1.0 / 6.0))
        .abs()
        .max((energy(high) + 1.0).abs());
    Claim::formula(FIGURE_5_1.said("equilibrium"), off, 1e-14)
}

/// Argon and xenon: ε/k_B in K, σ in Å, mass in u (Hirschfelder, Curtiss and Bird 1954, from second
/// virial coefficients).
const NOBLE_GASES: [[f64; 3]; 2] = [[119.8, 3.405, 39.948], [221.0, 4.10, 131.293]];
const BOLTZMANN: f64 = 1.380_649e-23;
const ATOMIC_MASS: f64 = 1.660_539e-27;

/// ε/σ in N.
fn unit_of_force() -> Claim {
    let [argon, xenon] =
        NOBLE_GASES.map(|[energy, length, _]| BOLTZMANN * energy / (1e-10 * length));
    // Largest pull of the potential, in ε/σ, at (26/7)^(1/6) σ.
    const STRONGEST_PULL: f64 = 2.396;
    Claim::refutation(
        FIGURE_5_1.said("unit-of-force"),
        format!(
            "{:.1} pN for argon, {:.1} pN for xenon",
            1e12 * argon,
            1e12 * xenon
        ),
        STRONGEST_PULL * argon.max(xenon) < 1e-10,
    )
}

/// σ√(m/ε) in s.
fn unit_of_time() -> Claim {
    let [argon, xenon] = NOBLE_GASES.map(|[energy, length, mass]| {
        1e-10 * length * (mass * ATOMIC_MASS / (BOLTZMANN * energy)).sqrt()
    });
    Claim::trend(
        FIGURE_5_1.said("unit-of-time"),
        format!(
            "{:.1} ps for argon, {:.1} ps for xenon",
            1e12 * argon,
            1e12 * xenon
        ),
        [argon, xenon]
            .iter()
            .all(|time| (1e-12..1e-11).contains(time)),
    )
}

/// Angles over time.
pub fn figure_5_2(runs: &Runs) -> Result<Exhibit> {
    let turned = all(runs)?;
    let mut figure = Figure::new(
        "",
        Axis::linear("time [σ√(m/ε)]"),
        Axis::linear("torsion angle Δφ [degree]").range(-2.0, 60.0),
    );
    let mut rows = Vec::new();
    for run in &turned {
        let curve = run.series.iter().map(|line| (line[0], line[1])).collect();
        if run.seed == 1 {
            figure = figure.series(Series::line(format!("λ = {}", run.lambda), curve));
        }
        let line = |line: &Vec<f64>| vec![run.lambda, run.seed as f64, line[0], line[1]];
        rows.extend(run.series.iter().map(line));
    }
    let end = scene(REVERSIBLE, 1, runs.effort()).drive_time;
    figure = figure.guide(ReferenceLine::vertical(end, "off"));
    Ok(Exhibit {
        film: Some(film(&folder(FILMED.0, FILMED.1, runs))?),
        seeds: turned.iter().map(|run| run.seed).collect(),
        ..Exhibit::new(
            FIGURE_5_2
                .prose_of(runs.effort())
                .with("count", tip_choices::count()?),
            figure,
            &["lambda", "seed", "time", "angle_degrees"],
            rows,
            claims(&turned, runs.effort())
                .into_iter()
                .map(|claim| claim.uncertain(seeds(runs.effort())))
                .chain(tip_choices::claims(runs)?)
                .collect(),
        )
    }
    .kept("exhibits/tip_choices/runs.csv (choices of height, outline and reading)"))
}

fn all(runs: &Runs) -> Result<Vec<TorqueRun>> {
    let cases: Vec<(f64, u64)> = match runs.effort() {
        Effort::Quick => QUICK.map(|lambda| (lambda, 1)).to_vec(),
        Effort::Full => FULL
            .iter()
            .flat_map(|&lambda| (1..=FULL_SEEDS).map(move |seed| (lambda, seed)))
            .collect(),
    };
    let threads = available_parallelism().map_or(1, NonZero::get);
    let batch = Batch::new(cases.len(), runs.reader());
    let results = in_order(cases.len(), threads, |index| {
        let turned = turn(cases[index], runs)?;
        let (driven, after) = (
            turned.outcome.driven_angle_degrees,
            turned.outcome.final_angle_degrees,
        );
        let (lambda, seed) = cases[index];
        batch.tell(&format!(
            "tip, lambda={lambda}, seed={seed}: {driven:.2} degrees driven, {after:.2} after it"
        ));
        anyhow::Ok(turned)
    });
    results
        .into_iter()
        .map(|run| run.ok_or_else(|| anyhow!("a run gave no result"))?)
        .collect()
}

/// The films of some runs, each once it has run, with the angles at the end.
pub(super) fn films(runs: &Runs, cases: &[(f64, u64)]) -> Result<Vec<(Film, f64)>> {
    let threads = available_parallelism().map_or(1, NonZero::get);
    let results = in_order(cases.len(), threads, |index| {
        let (lambda, seed) = cases[index];
        let turned = turn((lambda, seed), runs)?;
        anyhow::Ok((
            film(&folder(lambda, seed, runs))?,
            turned.outcome.final_angle_degrees,
        ))
    });
    results
        .into_iter()
        .map(|film| film.ok_or_else(|| anyhow!("a run gave no result"))?)
        .collect()
}

/// One run, on from where its folder has it.
fn turn((lambda, seed): (f64, u64), runs: &Runs) -> Result<TorqueRun> {
    let scene = scene(lambda, seed, runs.effort());
    let folder = folder(lambda, seed, runs);
    let is_filmed = LISTED
        .iter()
        .chain([&FILMED])
        .any(|run| *run == (lambda, seed));
    let frames = if is_filmed { FRAMES } else { 0 };
    let run: TipSimulation = runs.session(&folder).frames(frames).run(&scene)?;
    Ok(TorqueRun {
        lambda,
        seed,
        series: run.series().to_vec(),
        outcome: run.outcome(),
    })
}

/// Of a run.
fn folder(lambda: f64, seed: u64, runs: &Runs) -> PathBuf {
    let effort = runs.effort().name();
    runs.kept()
        .run(&format!("tip,{effort},lambda={lambda},seed={seed}"))
}

/// How many runs of each strength stand behind a claim.
fn seeds(effort: Effort) -> String {
    match effort {
        Effort::Quick => "one seed".into(),
        Effort::Full => format!("{FULL_SEEDS} seeds"),
    }
}

/// What the thesis says.
fn claims(turned: &[TorqueRun], effort: Effort) -> Vec<Claim> {
    let is_back = |run: &&TorqueRun| run.outcome.verdict == Reversal::Reversible;
    let below: Vec<&TorqueRun> = turned
        .iter()
        .filter(|run| run.lambda <= REVERSIBLE)
        .collect();
    let above: Vec<&TorqueRun> = turned
        .iter()
        .filter(|run| run.lambda > REVERSIBLE)
        .collect();
    let back = below.iter().filter(|run| is_back(run)).count();
    let weakest = above
        .iter()
        .filter(|run| !is_back(run))
        .map(|run| run.lambda)
        .fold(f64::INFINITY, f64::min);
    let strongest = turned
        .iter()
        .map(|run| run.lambda)
        .filter(|&lambda| lambda < weakest)
        .fold(f64::NAN, f64::max);
    vec![
        Claim::trend(
            FIGURE_5_2.said("reversible"),
            format!(
                "{back} of {} runs with λ ≤ 0.017 end within 1°",
                below.len()
            ),
            back == below.len(),
        )
        .printed("0.017"),
        strongest_claim([strongest, weakest], effort),
        Claim::trend(
            FIGURE_5_2.said("threshold"),
            format!("between {strongest} and {weakest}"),
            back > 0 && weakest.is_finite(),
        )
        .printed("0.017 to 0.018"),
        Claim::not_checkable(FIGURE_5_2.said("layers").with("slips", slips(turned))),
    ]
}

/// The last strength that lets the tip turn back. A quick report only brackets it: nothing to compare.
fn strongest_claim([strongest, weakest]: [f64; 2], effort: Effort) -> Claim {
    let found = format!("{strongest}; the next that was tried, {weakest}, does not");
    match effort {
        Effort::Quick => {
            Claim::not_checkable(FIGURE_5_2.said("strongest-quick").with("found", found))
                .printed("0.017")
        }
        Effort::Full => Claim::compared(
            FIGURE_5_2.said("strongest"),
            ("0.017", REVERSIBLE),
            (found, strongest),
            Allowance::Digits(HALF_STEP),
            MismatchMeaning::Known(FOUND),
        ),
    }
}

/// Interfaces that slipped while driven, strength by strength.
fn slips(turned: &[TorqueRun]) -> String {
    let of = |run: &TorqueRun| {
        let list: Vec<String> = run
            .outcome
            .slipped_interfaces_while_driven
            .iter()
            .map(usize::to_string)
            .collect();
        let list = if list.is_empty() {
            "none".into()
        } else {
            list.join(" ")
        };
        format!("λ = {}: {list}", run.lambda)
    };
    let first = turned.iter().filter(|run| run.seed == 1).map(of);
    let list: Vec<String> = first.collect();
    list.join("; ")
}
