//! Whole runs with a mode that is present but has no effect, and with the mode left out.
//!
//! What a scene does not need must cost nothing. A coefficient of 1e-12 has the price of its mode but not its
//! effect: both runs have the same result, and the time of one over that of the other is the saving.

mod pairs;

use super::{Finding, Front, Setting};
use crate::clock::Clock;
use crate::picture::{PicturePoint, scatter};
use crate::timing::median;
use crate::written::{Sheet, short};
use pairs::{BodySize, ModePair, PAIRS};
use tribos::golden::{Quantity, measure};
use tribos::scene::Scene;

/// Seeds of the scenes, rounds of those without one; and of a quick look.
const SEEDS: u64 = 9;
const QUICK_SEEDS: u64 = 2;
/// A run is repeated until it has taken this long, in s.
const ENOUGH: f64 = 0.02;
/// Differences below rounding are drawn at it.
const ROUNDING: f64 = 1e-16;
const PICTURE: &str = "modes.svg";

/// Time in s and result of the run without the mode, and of that with it.
type SeedRuns = [[f64; 2]; 2];

/// A pair of runs, measured.
struct ModePrice {
    pair: ModePair,
    carried: [BodySize; 2],
    rounds: Vec<SeedRuns>,
}

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let one = one.map_err(|error| error.to_string())?;
    let seeds = if setting.quick { QUICK_SEEDS } else { SEEDS };
    let prices = one.install(|| {
        let prices = PAIRS.into_iter().map(|pair| price(pair, seeds));
        prices.collect::<Result<Vec<_>, String>>()
    })?;
    let sheet = sheet(&prices, seeds);
    setting.table("modes", &sheet)?;
    let body = format!(
        "![Time saved and difference of the result]({PICTURE})\n\n{}\n{LEGEND}",
        sheet.markdown()
    );
    setting.page(Front::Modes, &body)?;
    draw(setting, &prices)?;
    Ok(Finding {
        line: line(&prices),
        picture: PICTURE,
    })
}

/// What the columns mean.
const LEGEND: &str = "\
Every run is a scene of the library from its start to its end, growth of a deposit and summary included; *switched \
on by* are the keys of the run that has the mode. *Unknowns* are those of a contact, of a sphere of a gas, of a \
sliding body, or of all atoms and their thermostats; *bytes* are those of a contact. *Time* is that without the \
mode over that with it: the median over the seeds (over rounds, where a scene has no seed) of the ratio of two runs \
in turn. *Difference* is the largest relative difference of the results of two runs with the same seed, *scatter* \
the relative standard deviation of the result over the seeds. Packings, gases and atoms are chaotic: a mode without \
effect changes last places, and the run makes them as large as the difference shows.

Not every mode can be left out: smooth spheres of a gas store their spins, a disk without spin has it as an unknown, \
and a flat cylinder under Coulomb's law computes a lean of zero.
";

/// Runs both scenes of a pair in turn, seed by seed.
fn price(pair: ModePair, seeds: u64) -> Result<ModePrice, String> {
    let told = |error: &dyn std::fmt::Display| format!("{}: {}: {error}", pair.body, pair.mode);
    let [left_out, present] = pair.scenes(1)?;
    let carried = |scene| BodySize::by(scene).map_err(|error| told(&error));
    let carried = [carried(&left_out)?, carried(&present)?];
    let mut rounds = Vec::new();
    for seed in 1..=seeds {
        let [left_out, present] = pair.scenes(seed)?;
        let run = |scene| timed(scene, pair.result).map_err(|error| told(&error));
        rounds.push([run(&left_out)?, run(&present)?]);
    }
    Ok(ModePrice {
        pair,
        carried,
        rounds,
    })
}

/// Least time of a run, and its result.
fn timed(scene: &Scene, result: &str) -> Result<[f64; 2], String> {
    let (mut least, mut total) = (f64::INFINITY, 0.0);
    loop {
        let clock = Clock::start();
        let run = measure(scene, || ()).map_err(|error| error.to_string())?;
        let seconds = clock.seconds();
        least = least.min(seconds);
        total += seconds;
        if total > ENOUGH {
            let found = run.summary.into_iter().find(|(name, _)| name == result);
            return match found {
                Some((_, Quantity::Number(value))) => Ok([least, value]),
                _ => Err(format!("{result} is no number of the summary")),
            };
        }
    }
}

impl ModePrice {
    /// Median time of a run without the mode, 0, or with it, 1; in s.
    fn seconds(&self, run: usize) -> f64 {
        median(&self.rounds.iter().map(|r| r[run][0]).collect::<Vec<_>>())
    }

    /// Time without the mode over that with it.
    fn ratio(&self) -> f64 {
        let ratio = |[left_out, present]: &SeedRuns| left_out[0] / present[0];
        median(&self.rounds.iter().map(ratio).collect::<Vec<_>>())
    }

    /// Largest relative difference of the results.
    fn difference(&self) -> f64 {
        let off = |[left_out, present]: &SeedRuns| (present[1] / left_out[1] - 1.0).abs();
        self.rounds.iter().map(off).fold(0.0, f64::max)
    }

    /// Relative standard deviation of the result over the seeds; none without seeds.
    fn scatter(&self) -> Option<f64> {
        let results = || self.rounds.iter().map(|[left_out, _]| left_out[1]);
        let count = self.rounds.len() as f64;
        let mean = results().sum::<f64>() / count;
        let squares: f64 = results().map(|x| (x / mean - 1.0).powi(2)).sum();
        (self.pair.has_seed).then(|| (squares / (count - 1.0)).sqrt())
    }
}

/// A row a pair.
fn sheet(prices: &[ModePrice], seeds: u64) -> Sheet {
    // No decimals of a count, and one cell for both runs.
    let of = |[left_out, present]: [String; 2]| format!("{left_out} of {present}");
    let bytes = |price: &ModePrice| match price.carried.map(|carried| carried.bytes) {
        [Some(left_out), Some(present)] => of([left_out, present].map(|bytes| bytes.to_string())),
        _ => "-".into(),
    };
    Sheet::of(
        format!(
            "Whole runs without a mode, beside runs in which it is present without effect: {seeds} seeds or rounds in \
             turn on one thread"
        ),
        prices,
        &[
            ("body", &|price| price.pair.body.into()),
            ("left out", &|price| price.pair.mode.into()),
            ("switched on by", &|price| price.pair.switch()),
            ("unknowns", &|price| {
                of(price.carried.map(|carried| carried.unknowns.to_string()))
            }),
            ("bytes", &|price| bytes(price)),
            ("s a run", &|price| {
                of([0, 1].map(|run| short(price.seconds(run))))
            }),
            ("time", &|price| short(price.ratio())),
            ("result", &|price| price.pair.result.into()),
            ("difference", &|price| short(price.difference())),
            ("scatter", &|price| {
                price.scatter().map_or("-".into(), short)
            }),
        ],
    )
}

/// Difference of the result over the time.
fn draw(setting: &Setting<'_>, prices: &[ModePrice]) -> Result<(), String> {
    let point = |price: &ModePrice| PicturePoint {
        label: price.pair.mode.into(),
        group: price.pair.body.into(),
        at: (price.ratio(), price.difference().max(ROUNDING)),
    };
    scatter(
        setting.out,
        "modes",
        Front::Modes.title(),
        [
            "time without the mode [time with it]",
            "relative difference of the result",
        ],
        prices.iter().map(point).collect(),
    )
}

/// Summary of the front.
fn line(prices: &[ModePrice]) -> String {
    let told = |price: &ModePrice| {
        let ModePair { body, mode, .. } = price.pair;
        let (ratio, difference) = (short(price.ratio()), short(price.difference()));
        format!("{body} without {mode} {ratio} ({difference})")
    };
    let all: Vec<String> = prices.iter().map(told).collect();
    format!(
        "Time of a whole run without a mode over that of a run with the mode present but without effect, and the relative \
         difference of their results: {}.",
        all.join("; ")
    )
}
