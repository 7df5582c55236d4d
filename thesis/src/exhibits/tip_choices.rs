//! Section 5.3: which heights of the driven layers, outlines and readings of λ give the thesis' threshold together, and
//! which tips have its atoms.

use super::tip::FIGURE_5_2;
use crate::runs::Runs;
use anyhow::{Context, Result};
use std::path::Path;
use tribos::record::{OtherColumns, Rows};
use tribos::scene::{TipScene, TorqueNormalisation};
use tribos::tip::{AtomRole, Reversal, TipOutline, TipSimulation};
use tribos_report::claim::Claim;

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("tip_choices/runs.csv");
const NUMBERS: usize = 4;
const COLUMNS: [&str; NUMBERS + 4] = [
    "raise",
    "lambda",
    "driven_angle_degrees",
    "final_angle_degrees",
    "outline",
    "reading",
    "verdict",
    "plateaus.angle_degrees",
];

/// Atoms of the thesis' system.
const ATOMS: usize = 6330;
/// Layers of the substrate and of the tip: two a colour.
const LAYERS: usize = 6;
/// Sides of a substrate that still looks square: ours.
const SQUARE: std::ops::RangeInclusive<f64> = 0.75..=4.0 / 3.0;
/// Atoms on a side of the tips that are counted; a narrowing tip of five still has a layer of two or more at each height.
const SIDES: std::ops::RangeInclusive<usize> = 5..=15;
/// The strengths of the thesis' two films: the tip turns back, and does not.
const FILMED: [f64; 2] = [0.017, 0.020];

const OUTLINES: [TipOutline; 3] = [TipOutline::Hexagon, TipOutline::Disk, TipOutline::Cone];
const READINGS: [TorqueNormalisation; 3] = [
    TorqueNormalisation::Angular,
    TorqueNormalisation::Mean,
    TorqueNormalisation::Largest,
];

/// A run and its end.
#[derive(Clone, Debug)]
struct Line {
    outline: TipOutline,
    reading: TorqueNormalisation,
    raise: f64,
    lambda: f64,
    has_turned_back: bool,
    /// While driven and at the end, in degrees.
    angles: [f64; 2],
    plateaus: String,
}

/// Where a threshold is, by the thesis' two strengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Threshold {
    /// The weaker one turns the tip for good.
    Below,
    Between,
    /// The stronger one turns the tip for good; the weaker was not tried.
    NotAbove,
    /// The stronger one lets it turn back.
    Above,
}

impl Line {
    fn scene(&self) -> TipScene {
        TipScene {
            lambda: self.lambda,
            outline: self.outline,
            reading: self.reading,
            raise: self.raise,
            time_step: 0.02,
            equilibration: 10.0,
            drive_time: 40.0,
            rest_time: 25.0,
            ..TipScene::default()
        }
    }

    /// Force on a driven atom over its distance from the axis.
    fn strength(&self) -> f64 {
        self.lambda / arm(self.outline, self.reading)
    }
}

/// What λ is divided by for the force over the distance from the axis, in σ.
fn arm(outline: TipOutline, reading: TorqueNormalisation) -> f64 {
    let scene = TipScene {
        outline,
        ..TipScene::default()
    };
    let (shape, [x, y]) = (scene.shape(), scene.shape().axis());
    let sites = shape.sites();
    let driven = sites.iter().filter(|site| site.part == AtomRole::Driven);
    let arms: Vec<f64> = driven
        .map(|site| (site.place.x - x).hypot(site.place.y - y))
        .collect();
    match reading {
        TorqueNormalisation::Angular => 1.0,
        TorqueNormalisation::Mean => arms.iter().sum::<f64>() / arms.len() as f64,
        TorqueNormalisation::Largest => arms.into_iter().fold(0.0, f64::max),
    }
}

/// All lines.
fn kept() -> Result<Vec<Line>> {
    let (file, others) = (Path::new("runs.csv"), OtherColumns::Ignored);
    let mut rows = Rows::of(file, KEPT.as_bytes(), others, |_| &COLUMNS)?;
    let (mut lines, mut row) = (Vec::new(), [0.0; NUMBERS]);
    while rows.next(&mut row)?.is_some() {
        let [raise, lambda, driven, last] = row;
        let [outline, reading, verdict, plateaus] = rows.words() else {
            continue;
        };
        lines.push(Line {
            outline: outline.parse()?,
            reading: reading.parse()?,
            raise,
            lambda,
            has_turned_back: *verdict == Reversal::Reversible.to_string(),
            angles: [driven, last],
            plateaus: plateaus.clone(),
        });
    }
    Ok(lines)
}

/// Runs of the kept table.
pub(super) fn count() -> Result<usize> {
    Ok(kept()?.len())
}

/// Whether a tip turns back from a strength: one that does from a stronger one, and not one that does not from a weaker.
fn turns_back(lines: &[&Line], strength: f64) -> Option<bool> {
    /// Strengths of one λ in two orders of arithmetic.
    const ROUNDING: f64 = 1e-9;
    let is_seen = |back: bool| {
        let seen = |line: &&&Line| {
            let over = line.strength() / strength - 1.0;
            let as_much = if back { over } else { -over };
            line.has_turned_back == back && as_much > -ROUNDING
        };
        lines.iter().any(|line| seen(&line))
    };
    match (is_seen(true), is_seen(false)) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    }
}

/// Heights at which the thesis' strengths were decided for an outline and a reading, with the threshold there.
fn thresholds(
    lines: &[Line],
    outline: TipOutline,
    reading: TorqueNormalisation,
) -> Vec<(f64, Threshold)> {
    let of = |line: &&Line| line.outline == outline;
    let mut raises: Vec<f64> = lines.iter().filter(of).map(|line| line.raise).collect();
    raises.sort_by(f64::total_cmp);
    raises.dedup();
    let at = |raise: f64| {
        let here: Vec<&Line> = lines
            .iter()
            .filter(of)
            .filter(|line| line.raise == raise)
            .collect();
        let [weak, strong] = FILMED.map(|lambda| turns_back(&here, lambda / arm(outline, reading)));
        let threshold = match (weak, strong) {
            (_, Some(true)) => Threshold::Above,
            (Some(true), Some(false)) => Threshold::Between,
            (Some(false), _) => Threshold::Below,
            (None, Some(false)) => Threshold::NotAbove,
            _ => return None,
        };
        Some((raise, threshold))
    };
    raises.into_iter().filter_map(at).collect()
}

/// "angular: above at 0, between at 0.57".
fn words(lines: &[Line], outline: TipOutline) -> String {
    let of = |reading: TorqueNormalisation| {
        let all = thresholds(lines, outline, reading);
        let all = all.iter().map(|(raise, threshold)| {
            let word = match threshold {
                Threshold::Below => "below",
                Threshold::Between => "between",
                Threshold::NotAbove => "not above",
                Threshold::Above => "above",
            };
            format!("{word} at {raise} σ")
        });
        let all = all.collect::<Vec<_>>().join(", ");
        (!all.is_empty()).then(|| format!("{reading}: {all}"))
    };
    READINGS
        .into_iter()
        .filter_map(of)
        .collect::<Vec<_>>()
        .join("; ")
}

/// Tips of an outline whose atoms, with a substrate that looks square, are the thesis': atoms a side, columns, rows.
fn counted(outline: TipOutline) -> Vec<[usize; 3]> {
    let mut found = Vec::new();
    for side in SIDES {
        let scene = TipScene {
            outline,
            tip_side_atoms: side,
            ..TipScene::default()
        };
        let sites = scene.shape().sites();
        let tip = sites.iter().filter(|site| site.layer >= LAYERS).count();
        let layer = ATOMS.saturating_sub(tip) / LAYERS;
        if layer * LAYERS + tip != ATOMS {
            continue;
        }
        // An even number of rows, nearer to each other than atoms in a row; the tip has to fit.
        let nearness = 3f64.sqrt() / 2.0;
        for rows in (2..=layer)
            .step_by(2)
            .filter(|rows| layer.is_multiple_of(*rows))
        {
            let columns = layer / rows;
            let sides = [columns as f64, rows as f64 * nearness];
            let fits = sides.iter().all(|&wide| wide > 2.0 * side as f64);
            if SQUARE.contains(&(sides[0] / sides[1])) && fits {
                found.push([side, columns, rows]);
            }
        }
    }
    found
}

fn count_claim() -> Claim {
    let words = |outline: TipOutline| {
        let all = counted(outline);
        let all = all
            .iter()
            .map(|[side, columns, rows]| format!("{side} on {columns} × {rows}"));
        let all = all.collect::<Vec<_>>().join(", ");
        format!("{outline}: {}", if all.is_empty() { "none" } else { &all })
    };
    let [hexagons, _, cones] = OUTLINES.map(counted);
    Claim::own_statement(
        FIGURE_5_2.said("count"),
        OUTLINES.map(words).join("; "),
        hexagons.contains(&[10, 28, 28]) && cones.is_empty(),
    )
}

/// What the choices give.
pub(super) fn claims(runs: &Runs) -> Result<Vec<Claim>> {
    let lines = kept()?;
    // The threshold passes the thesis' strengths as the driven layers are raised.
    let passes = |outline: TipOutline, reading: TorqueNormalisation| {
        let all = thresholds(&lines, outline, reading);
        let low = all
            .iter()
            .position(|(_, threshold)| *threshold != Threshold::Below);
        let high = all
            .iter()
            .rposition(|(_, threshold)| *threshold != Threshold::Above);
        matches!((low, high), (Some(low), Some(high)) if low <= high)
    };
    let [prism, others @ ..] = OUTLINES;
    let [angular, mean, _] = READINGS;
    let others = others.map(|outline| format!("{outline}: {}", words(&lines, outline)));
    let arms = READINGS
        .map(|reading| format!("{:.1}", arm(prism, reading)))
        .join(", ");
    Ok(vec![
        count_claim(),
        Claim::own_statement(
            FIGURE_5_2.said("heights").with("arms", arms),
            words(&lines, prism),
            passes(prism, angular) && passes(prism, mean),
        ),
        Claim::not_checkable(
            FIGURE_5_2
                .said("outlines")
                .with("outlines", others.join("; ")),
        ),
        Claim::not_checkable(
            FIGURE_5_2
                .said("locking")
                .with("plateaus", plateaus(&lines)),
        ),
        repeated(runs, &lines)?,
    ])
}

/// Where tips rest under λ that turns them for good, and how they end.
fn plateaus(lines: &[Line]) -> String {
    let degrees = |text: &str| {
        let angles = text
            .split_whitespace()
            .filter_map(|angle| angle.parse().ok());
        let angles = angles.map(|angle: f64| format!("{angle:.1}°"));
        angles.collect::<Vec<_>>().join(", ")
    };
    let one = |line: &Line| {
        let [driven, last] = line.angles;
        let rests = match degrees(&line.plateaus) {
            none if none.is_empty() => format!("{driven:.1}° at the end of the torque"),
            angles => angles,
        };
        format!(
            "{} raised by {} σ, λ = {} ({}): {rests}, then {last:.1}°",
            line.outline, line.raise, line.lambda, line.reading
        )
    };
    let turned = lines.iter().filter(|line| !line.has_turned_back);
    turned.map(one).collect::<Vec<_>>().join("; ")
}

/// The first line of the table, run again.
fn repeated(runs: &Runs, lines: &[Line]) -> Result<Claim> {
    /// Two runs of one scene have the same bits; this allows for the decimals of a file, in degrees.
    const SAME: f64 = 1e-9;
    let first = lines.first().context("the table has no line")?;
    let Line {
        outline,
        reading,
        raise,
        lambda,
        ..
    } = first;
    let name = format!("tip,{outline},{reading},raise={raise},lambda={lambda}");
    let run: TipSimulation = runs.session(&runs.kept().run(&name)).run(&first.scene())?;
    let [driven, _] = first.angles;
    let again = run.outcome().driven_angle_degrees;
    Ok(Claim::own(FIGURE_5_2.said("repeated"), again, driven, SAME))
}
