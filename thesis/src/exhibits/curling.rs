//! Section 3.5.2: what is observed of curling rocks, against every model of the library.

use super::curling_statements::statements;
use super::rock::{DRAW, SLOW, ends, models, path, shot};
use crate::exhibit::Exhibit;
use crate::text::Text;
use anyhow::Result;
use tribos::slide::curling::CurlingModel;
use tribos::slide::planar::PlanarState;
use tribos_report::claim::{Claim, Statement};
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

pub(super) const TEXT: Text = Text(include_str!("section-3.5.2.md"));

/// Spins of a draw in the thesis, rad/s: the ends of its range, and half of the faster.
pub(super) const SPINS: [f64; 3] = [0.3, 0.7, 1.4];
/// Spins of the curves.
const SHOWN: [f64; 6] = [0.0, 0.3, 0.7, 1.4, 2.2, 3.0];
/// What counts as "1 m" of curl, and a change that is weak if the spin is doubled: ours.
const METRE: std::ops::Range<f64> = 0.5..1.5;
const WEAK: f64 = 0.25;
/// Ends that an experiment cannot tell apart, as a share of the time to rest: ours.
const RESOLUTION: f64 = 0.05;
/// Way forward and to the left of a slow rock with fast spin, m.
const SLOW_FORWARD: std::ops::RangeInclusive<f64> = 3.0..=4.0;
const SLOW_LEFT: std::ops::RangeInclusive<f64> = 0.5..=1.2;

/// How a model fares with an observation, as it was found before.
#[derive(Clone, Copy, PartialEq)]
enum EarlierVerdict {
    Agrees,
    Misses,
    /// The model was given what is observed.
    Imposed,
}
use EarlierVerdict::{Agrees, Imposed, Misses};

/// The observations that tell models apart: ids of their statements.
const OBSERVED: [&str; 5] = ["side", "size", "spin", "slow-path", "slow-end"];
/// Models in the order of the library: the id of their reason, and how they fare.
const FOUND: [(&str, [EarlierVerdict; 5]); 7] = [
    ("dry", [Misses; 5]),
    ("left-right", [Misses; 5]),
    ("front-back", [Misses; 5]),
    ("back-heavy", [Agrees, Misses, Misses, Misses, Misses]),
    ("film", [Agrees, Misses, Misses, Misses, Misses]),
    ("pivot-slide", [Agrees, Agrees, Misses, Misses, Misses]),
    ("scratch-guide", [Agrees, Imposed, Imposed, Misses, Misses]),
];

/// Curl over spin, paths of the slow shot, and the table of models and observations.
pub fn section_3_5_2() -> Result<Exhibit> {
    let models = models();
    let mut rows = Vec::new();
    let mut curls = Figure::new(
        "",
        Axis::linear("spin at launch [rad/s]").range(0.0, 3.0),
        Axis::linear("curl of a draw to the left [m]").range(-0.1, 1.2),
    );
    let mut slow = Figure::new(
        "",
        Axis::linear("slow shot: forward [m]").range(-0.5, 4.0),
        Axis::linear("to the left [m]").range(-0.5, 1.4),
    );
    let mut claims = Vec::new();
    let mut draws = Vec::new();
    for (i, (model, found)) in models.iter().zip(FOUND).enumerate() {
        let model = model.as_ref();
        let draw = path(model, (DRAW, SPINS[2]))?;
        let mut curve = Vec::new();
        for spin in SHOWN {
            let end = match draw.last() {
                Some(end) if spin == SPINS[2] => *end,
                _ => shot(model, (DRAW, spin))?,
            };
            let [forward, left] = end.position;
            curve.push((spin, left));
            rows.push(vec![i as f64, spin, forward, left, end.time]);
        }
        let slow_shot = path(model, SLOW)?;
        let line = slow_shot
            .iter()
            .map(|point| (point.position[0], point.position[1]));
        let half = curve.iter().find(|(spin, _)| *spin == SPINS[1]);
        let half = half.map_or(f64::NAN, |(_, curl)| *curl);
        claims.extend(observations(model, [&draw, &slow_shot], half, found)?);
        draws.push(ends(&draw)?);
        curls = curls.series(Series::line_points(model.name(), curve));
        slow = slow.series(Series::line(model.name(), line.collect()));
    }
    claims.push(together(&draws));
    claims.extend(statements()?);
    let title = "Curling models: a draw of 28 m, and a slow rock with fast spin";
    Ok(Exhibit::new(
        TEXT.prose(),
        Panels::new(title, 2)
            .figure(curls.legend(Legend::Below))
            .figure(slow.legend(Legend::Below)),
        &["model", "spin", "forward", "left", "time"],
        rows,
        claims,
    ))
}

/// One model beside the observations that tell models apart: paths of a draw and of the slow shot, and
/// the curl of a draw with half the spin.
fn observations(
    model: &dyn CurlingModel,
    [draw, slow]: [&[PlanarState]; 2],
    half: f64,
    (reason, fares): (&str, [EarlierVerdict; 5]),
) -> Result<Vec<Claim>> {
    let fast = draw.last().map_or(f64::NAN, |point| point.position[1]);
    let [slow_slide, slow_turn] = ends(slow)?;
    let [x, y] = slow.last().map_or([f64::NAN; 2], |point| point.position);
    let parts = |share: f64| format!("{:.0} %", 100.0 * share);
    let outcomes = [
        (fast > 0.0, format!("{} m", short_metres(fast))),
        (METRE.contains(&fast), format!("{} m", short_metres(fast))),
        (
            half > 0.0 && (fast / half - 1.0).abs() < WEAK,
            format!(
                "{} m and {} m: {} m per rad/s",
                short_metres(half),
                short_metres(fast),
                short_metres((fast - half) / (SPINS[2] - SPINS[1]))
            ),
        ),
        (
            SLOW_FORWARD.contains(&x) && SLOW_LEFT.contains(&y),
            format!("{x:.2} m forward, {y:.2} m to the left"),
        ),
        (
            slow_turn - slow_slide > RESOLUTION,
            format!(
                "slide after {}, spin after {} of the time",
                parts(slow_slide),
                parts(slow_turn)
            ),
        ),
    ];
    let why = TEXT.said(reason).basis;
    let rows = OBSERVED.into_iter().zip(outcomes).zip(fares);
    Ok(rows
        .map(|((id, (agrees, ours)), fares)| {
            let statement = TEXT.said(id).with("model", model.name());
            judged(statement, ours, (agrees, fares), &why)
        })
        .collect())
}

/// When slide and spin of a draw end, under all models: they do not differ in it.
fn together(draws: &[[f64; 2]]) -> Claim {
    let gap = |[slide, turn]: &[f64; 2]| (slide - turn).abs();
    let widest = draws.iter().map(gap).fold(0.0, f64::max);
    Claim::trend(
        TEXT.said("together"),
        format!(
            "{} models; slide and spin end within {:.1} % of the time",
            draws.len(),
            100.0 * widest
        ),
        widest < RESOLUTION,
    )
}

/// Millimetres are enough, and nothing is exactly nothing.
pub(super) fn short_metres(length: f64) -> String {
    short((1e3 * length).round() / 1e3)
}

/// The row of a model that agrees, or misses for the reason that its formula gives.
fn judged(
    statement: Statement,
    ours: String,
    (agrees, fares): (bool, EarlierVerdict),
    why: &str,
) -> Claim {
    match fares {
        Agrees => Claim::trend(statement, ours, agrees),
        Imposed => {
            let basis = why.to_owned();
            Claim::definition(Statement { basis, ..statement }, ours, agrees)
        }
        Misses => {
            let basis = why.to_owned();
            Claim::contradiction(Statement { basis, ..statement }, ours, !agrees)
        }
    }
}
