//! Section 5.3: friction of the slid tip over seven loads, from a kept table or from runs of this report.

use super::tip_runs::{Line, Point, Row, STROKES, Slide, all, one, slid};
use super::tip_slid::{TEMPERATURE, TEXT};
use crate::runs::{Effort, Runs};
use anyhow::Result;
use std::path::Path;
use tribos::record::{OtherColumns, Rows};
use tribos::scene::TipScene;
use tribos_report::claim::Claim;

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("tip_loads/runs.csv");
const COLUMNS: [&str; 6] = [
    "load",
    "slid.friction",
    "slid.normal_force",
    "slid.period",
    "slid.imbalance",
    "slid.loop_work",
];

/// Loads on a driven atom.
const LOADS: [f64; 7] = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0];
/// Speed and stroke of the support in scenes/tip-slid.toml, and time to settle.
const SPEED: f64 = 0.1;
const STROKE: f64 = 6.735;
const SETTLING: f64 = 20.0;

/// What a row may leave the line by where friction is called "rather linear": ours.
const RATHER: f64 = 0.1;
/// Two runs of one scene have the same bits; this allows for the decimals of a file.
const SAME: f64 = 1e-9;

/// Rows of the kept table, load by load.
fn kept() -> Result<Vec<Point>> {
    let (file, others) = (Path::new("runs.csv"), OtherColumns::Ignored);
    let mut rows = Rows::of(file, KEPT.as_bytes(), others, |_| &COLUMNS)?;
    let mut points = LOADS.map(|load| Point::new([load, SPEED, TEMPERATURE], &[]));
    let mut line = [0.0; COLUMNS.len()];
    while rows.next(&mut line)?.is_some() {
        let [load, friction, normal_force, period, imbalance, loop_work] = line;
        for point in points.iter_mut().filter(|point| point.load == load) {
            point.slid.push(Slide {
                friction,
                normal_force,
                period,
                imbalance,
                loop_work,
            });
        }
    }
    Ok(points.into())
}

/// A full report makes all runs.
pub(super) fn points(runs: &Runs) -> Result<Vec<Point>> {
    if runs.effort() == Effort::Quick {
        return kept();
    }
    let ran = all(runs, &LOADS.map(row))?;
    let point = |(load, ran): (f64, &Vec<_>)| Point::new([load, SPEED, TEMPERATURE], ran);
    Ok(LOADS.into_iter().zip(&ran).map(point).collect())
}

/// The scene at a load, whatever the effort.
fn row(load: f64) -> Row {
    let Row { name, scene } = slid(Effort::Quick, SPEED, load, TEMPERATURE);
    Row {
        name: format!("{name},stroke={STROKE}"),
        scene: TipScene {
            stroke: Some(STROKE),
            equilibration: SETTLING,
            drive_time: STROKES * STROKE / SPEED,
            ..scene
        },
    }
}

/// What the loads tell.
pub(super) fn load_claims(points: &[Point]) -> [Claim; 2] {
    let all = points.iter().flat_map(|point| &point.slid);
    let all: Vec<(f64, f64)> = all.map(|slid| (slid.normal_force, slid.friction)).collect();
    let Line {
        slope,
        error,
        intercept,
    } = Line::through(&all);
    let mean = all.iter().map(|(_, friction)| friction).sum::<f64>() / all.len() as f64;
    // Means of the rows: squares about the line and about their mean, largest distance from the line over the friction.
    let [mut rest, mut spread, mut off] = [0.0_f64; 3];
    for point in points {
        let ([normal, _], [friction, _]) = (point.of(|slid| slid.normal_force), point.friction());
        let apart = (friction - intercept - slope * normal).abs();
        rest += apart * apart;
        spread += (friction - mean) * (friction - mean);
        off = off.max(apart / friction);
    }
    [
        Claim::trend(
            TEXT.said("load"),
            format!(
                "F = {intercept:.2} + ({slope:.4} ± {error:.4}) N, R² = {:.3}; rows are within {:.1} % of it",
                1.0 - rest / spread,
                100.0 * off
            ),
            slope > 3.0 * error && off <= RATHER,
        ),
        Claim::not_checkable(
            TEXT.said("coefficient")
                .with("mu", format!("{slope:.4} ± {error:.4}")),
        )
        .printed("0.01"),
    ]
}

/// The first line of the kept table, run again.
pub(super) fn repeated(runs: &Runs) -> Result<Claim> {
    let (_, again) = one(runs, &row(LOADS[0]), 1)?;
    let again = Slide::of(&again).map_or(f64::NAN, |slid| slid.friction);
    let table = kept()?;
    let first = table.first().and_then(|point| point.slid.first());
    let kept = first.map_or(f64::NAN, |slid| slid.friction);
    Ok(Claim::own(TEXT.said("repeated"), again, kept, SAME))
}
