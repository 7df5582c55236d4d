//! Every patch × law × tier: error, time and size.

use super::{Finding, Front, Setting};
use crate::patches::{Entry, Label, Refused, Worst, points, round, surface, tall};
use crate::picture::{self, PicturePoint};
use crate::timing::{self, Samples, Task};
use crate::written::{Sheet, short};
use std::path::Path;

/// Rounds of all rows, and of a quick look.
const ROUNDS: usize = 31;
const QUICK_ROUNDS: usize = 3;
/// Errors below rounding are drawn at it.
const ROUNDING: f64 = 1e-17;
/// Times are also given in units of this row's: Coulomb's table of the disk in f64.
const UNIT: usize = 0;
const PICTURE: &str = "patches.svg";

/// The part of an entry that is not its task.
#[derive(Debug)]
struct Row {
    label: Label,
    precision: &'static str,
    bytes: usize,
    worst: Worst,
}

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, Refused> {
    let (rows, tasks) = split(entries()?);
    let rounds = if setting.quick { QUICK_ROUNDS } else { ROUNDS };
    let samples = timing::interleaved(tasks, rounds);
    let nanoseconds: Vec<f64> = samples.medians().iter().map(|s| 1e9 * s).collect();
    let full = full(&rows, &nanoseconds, &samples, rounds);
    setting.table("patches", &full)?;
    let body = format!(
        "![Time against error]({PICTURE})\n\n{}\n{LEGEND}\n{}",
        summary(&rows, &nanoseconds).markdown(),
        full.markdown()
    );
    setting.page(Front::Patches, &body)?;
    draw(setting.out, &rows, &nanoseconds)?;
    Ok(Finding {
        line: line(&rows, &samples),
        picture: PICTURE,
    })
}

/// Summary of the front: the forms and tables of all round patches and laws in f64.
fn line(rows: &[Row], samples: &Samples) -> String {
    let of_tables = |index: &usize| {
        ["form", "table"].contains(&rows[*index].label.tier) && rows[*index].precision == "f64"
    };
    let tables: Vec<usize> = (0..rows.len()).filter(of_tables).collect();
    let ratio = |&index: &usize| samples.ratio(&index.to_string(), &UNIT.to_string());
    let ratios: Vec<f64> = tables.iter().filter_map(ratio).collect();
    let worst = tables.iter().map(|&index| rows[index].worst.of_larger);
    format!(
        "Forms and tables serve {} combinations of patch and power law in f64 with errors up to {} of the larger \
         of force and torque, in {} to {} times the time of the disk's Coulomb form (powers of the \
         speed included); {} rows of other tiers and precisions tell the price of everything else.",
        tables.len(),
        short(worst.fold(0.0, f64::max)),
        short(ratios.iter().copied().fold(f64::INFINITY, f64::min)),
        short(ratios.iter().copied().fold(0.0, f64::max)),
        rows.len() - tables.len(),
    )
}

/// All rows; Coulomb's table of the disk in f64 is the first.
fn entries() -> Result<Vec<Entry>, Refused> {
    let mut all = round::powers::<f64>()?;
    all.extend(round::powers::<f32>()?);
    all.extend(round::polynomial()?);
    all.extend(round::quadratures::<f64>()?);
    all.extend(round::quadratures::<f32>()?);
    all.extend(points::rules_for_pressures::<f64>()?);
    all.extend(points::rules_for_pressures::<f32>()?);
    all.extend(points::given::<f64>()?);
    all.extend(points::given::<f32>()?);
    all.extend(tall::rows::<f64>()?);
    all.extend(tall::rows::<f32>()?);
    all.extend(surface::rows::<f64>()?);
    all.extend(surface::rows::<f32>()?);
    Ok(all)
}

fn split(entries: Vec<Entry>) -> (Vec<Row>, Vec<Task<'static>>) {
    let part = |(index, entry): (usize, Entry)| {
        let row = Row {
            label: entry.label,
            precision: entry.precision,
            bytes: entry.bytes,
            worst: entry.worst,
        };
        // Names only have to differ.
        let task = Task::new(index.to_string(), entry.elements, entry.run);
        (row, task)
    };
    entries.into_iter().enumerate().map(part).unzip()
}

/// Meaning of the columns, and what is missing.
const LEGEND: &str = "\
Errors are the largest over fixed speeds: `rel F` and `rel T` relative, `of larger` the larger of \
the two (and of the lateral force) over the larger of F and T, which is the load's scale where T or \
F passes through zero. `x` is the time in units of the disk's Coulomb form in f64, the median of \
the rounds' own ratios. `bytes` is what the value holds, with its table; \
the quadrature and all code are in [firmware.md](firmware.md). Surfaces: the gauge of a \
point on the surface, the unit normal there, and the projection of a point half a force limit \
outside.

Judges. `tables`: power laws in f64 on the reference tables of the tests (25 digits and more; ratios \
1e-10 to 1e12, to 1e-12 beside equal speeds; annulus and polynomial fewer), at rim speeds from 1/64 \
to 64. `f64`: power laws in f32 on 3800 pairs, by the compact tier in f64 at the rounded speeds. \
`area`: 48 pairs with ratios 1e-3 to 1e3 and gaps down to 1e-15, by double-exponential integration \
around the centre of rotation, good to 1e-12 of the larger and to 2e-10 of a small T (its own test \
compares it with the tables). `sum`: 3800 \
pairs, the same sum over the same points with 30 digits. Nodes judged by `area` stand for the \
pressure; judged by `sum` they stand for themselves.

Not there, because no such combination exists: closed forms for the paraboloid, the polynomial and \
any law but Coulomb's; compact, quadrature and f32 tables for the polynomial; tables and compact \
forms for laws that are no power; quadrature for pressures other than uniform (nodes serve them); \
nodes for the annulus. The tripod and the nodes that stand for themselves have a 30-digit judge for \
power laws only, the tall cylinder a table for power laws only.
";

/// By tier and precision: the span of times, the largest errors.
fn summary(rows: &[Row], nanoseconds: &[f64]) -> Sheet {
    let mut keys: Vec<(&str, &str, &str)> = rows.iter().map(key).collect();
    keys.sort_unstable();
    keys.dedup();
    let line = |wanted: (&'static str, &'static str, &'static str)| {
        let of_key = |i: &usize| key(&rows[*i]) == wanted;
        let members: Vec<usize> = (0..rows.len()).filter(of_key).collect();
        let times = members.iter().map(|&i| nanoseconds[i]);
        let most = |of: fn(&Worst) -> f64| {
            let errors = members.iter().map(|&i| of(&rows[i].worst));
            short(errors.fold(0.0, f64::max))
        };
        let (tier, precision, judge) = wanted;
        vec![
            tier.into(),
            precision.into(),
            judge.into(),
            members.len().to_string(),
            short(times.clone().fold(f64::INFINITY, f64::min)),
            short(times.fold(0.0, f64::max)),
            most(|worst| worst.force.max(worst.torque)),
            most(|worst| worst.of_larger),
        ]
    };
    Sheet {
        about: "By tier, over its patches and laws".into(),
        header: vec![
            "tier",
            "type",
            "judge",
            "rows",
            "ns from",
            "to",
            "worst rel",
            "worst of larger",
        ],
        rows: keys.into_iter().map(line).collect(),
    }
}

fn key(row: &Row) -> (&'static str, &'static str, &'static str) {
    (row.label.tier, row.precision, row.label.judge)
}

/// The whole table.
fn full(rows: &[Row], nanoseconds: &[f64], samples: &Samples, rounds: usize) -> Sheet {
    let ratio = |index: usize| samples.ratio(&index.to_string(), &UNIT.to_string());
    Sheet::of(
        format!("Patch, law and tier: medians of {rounds} interleaved rounds"),
        rows.iter().enumerate(),
        &[
            ("patch", &|(_, row)| row.label.patch.into()),
            ("law", &|(_, row)| row.label.law.into()),
            ("tier", &|(_, row)| row.label.tier.into()),
            ("type", &|(_, row)| row.precision.into()),
            ("ns", &|(index, _)| short(nanoseconds[*index])),
            ("x", &|(index, _)| short(ratio(*index).unwrap_or(f64::NAN))),
            ("rel F", &|(_, row)| short(row.worst.force)),
            ("rel T", &|(_, row)| short(row.worst.torque)),
            ("of larger", &|(_, row)| short(row.worst.of_larger)),
            ("bytes", &|(_, row)| row.bytes.to_string()),
            ("judge", &|(_, row)| row.label.judge.into()),
        ],
    )
}

/// Coulomb friction in f64, without surfaces.
fn draw(out: &Path, rows: &[Row], nanoseconds: &[f64]) -> Result<(), String> {
    let is_drawn = |row: &Row| {
        row.label.law == "Coulomb"
            && row.precision == "f64"
            && !row.label.patch.ends_with("surface")
    };
    let places = rows
        .iter()
        .zip(nanoseconds)
        .filter(|(row, _)| is_drawn(row));
    let place = |(row, &time): (&Row, &f64)| PicturePoint {
        label: row.label.patch.into(),
        group: row.label.tier.into(),
        at: (time, row.worst.of_larger.max(ROUNDING)),
    };
    let axes = [
        "time per pair [ns]",
        "largest error, of the larger of F and T",
    ];
    let title = "Patches under Coulomb friction, f64";
    picture::scatter(out, "patches", title, axes, places.map(place).collect())
}
