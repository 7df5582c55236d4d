//! Calls one by one against one call for many: time and instructions of both.

mod instructions;
mod items;

use super::{Finding, Front, Setting};
use crate::timing::{self, Task};
use crate::written::{Sheet, short};
use instructions::Counts;
use items::{Item, Run};
use std::path::Path;
use tribos_report::figure::{Axis, Figure, Legend, Series};

pub use instructions::run_once;

/// Rounds of all items, and of a quick look.
const ROUNDS: usize = 101;
const QUICK_ROUNDS: usize = 9;
const PICTURE: &str = "batch.svg";

/// Names of an item's two tasks.
const ONE: &str = "one by one";
const BATCH: &str = "batch";

/// One line of the front.
#[derive(Debug)]
struct Row {
    /// Name, exponent and type of the item.
    label: items::Label,
    /// Nanoseconds of a call, and of an element of a batch.
    nanoseconds: [Option<f64>; 2],
    /// Time of an element of a batch over that of a call.
    ratio: Option<f64>,
    /// Instructions of both.
    counts: Counts,
}

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let (counted, obstacle) = match instructions::count() {
        Ok(counted) => (counted, String::new()),
        Err(reason) => (
            Vec::new(),
            format!("Instructions are not counted: {reason}.\n\n"),
        ),
    };
    let rounds = if setting.quick { QUICK_ROUNDS } else { ROUNDS };
    let rows = measure(rounds, &counted)?;
    let sheet = sheet(&rows, rounds);
    setting.table("batch", &sheet)?;
    draw(setting.out, &rows)?;
    let body = format!(
        "![Time of a batch over that of calls]({PICTURE})\n\n{obstacle}{}\n{LEGEND}",
        sheet.markdown()
    );
    setting.page(Front::Batch, &body)?;
    Ok(Finding {
        line: line(&rows),
        picture: PICTURE,
    })
}

/// Interpretation of the columns.
const LEGEND: &str = "\
Both columns of a row evaluate the same inputs, each call hidden from the optimiser; a batch must give the \
bits of the calls, or nothing is timed. Where no batch exists its columns are empty. Wrenches within 3 % of \
the limit surface are near it.
";

/// Times all items in turn, calls and batches interleaved.
fn measure(rounds: usize, counted: &[Counts]) -> Result<Vec<Row>, String> {
    let items = items::all(items::Length::Long)?;
    let (mut tasks, mut labels) = (Vec::new(), Vec::new());
    for Item {
        label,
        elements,
        one,
        batch,
    } in items
    {
        let task = |kind: &str, run: Run| Task::new(format!("{label} {kind}"), elements, run);
        tasks.push(task(ONE, one));
        tasks.extend(batch.map(|run| task(BATCH, run)));
        labels.push(label);
    }
    let names: Vec<String> = tasks.iter().map(|task| task.name.clone()).collect();
    let samples = timing::interleaved(tasks, rounds);
    let medians = samples.medians();
    let rows = labels.into_iter().enumerate().map(|(number, label)| {
        let [one, batch] = [ONE, BATCH].map(|kind| format!("{label} {kind}"));
        let time = |name: &String| {
            let place = names.iter().position(|known| known == name)?;
            medians.get(place).map(|seconds| 1e9 * seconds)
        };
        Row {
            nanoseconds: [time(&one), time(&batch)],
            ratio: samples.ratio(&batch, &one),
            counts: counted.get(number).copied().unwrap_or_default(),
            label,
        }
    });
    Ok(rows.collect())
}

/// Summary of the front: the batches of wrenches.
fn line(rows: &[Row]) -> String {
    let told = |row: &Row| Some(format!("{} {}", row.label, short(row.ratio?)));
    let told: Vec<String> = rows.iter().filter_map(told).collect();
    format!(
        "Time of one element of a batch over that of a call, to the same bits: {}.",
        told.join("; ")
    )
}

/// The table of the front.
fn sheet(rows: &[Row], rounds: usize) -> Sheet {
    let told = |value: Option<f64>| value.map_or("-".into(), short);
    let fewer = |row: &Row| {
        let [one, batch] = row.counts.0;
        batch.zip(one).map(|(batch, one)| batch / one)
    };
    Sheet::of(
        format!(
            "Calls one by one and one call for all: median of {rounds} interleaved rounds; instructions \
             of x86-64 by callgrind, all of them a call or an element"
        ),
        rows,
        &[
            ("call", &|row| row.label.name.into()),
            ("alpha", &|row| row.label.alpha.to_string()),
            ("type", &|row| row.label.precision.into()),
            ("ns one by one", &|row| told(row.nanoseconds[0])),
            ("ns batch", &|row| told(row.nanoseconds[1])),
            ("batch / one", &|row| told(row.ratio)),
            ("instructions one by one", &|row| told(row.counts.0[0])),
            ("instructions batch", &|row| told(row.counts.0[1])),
            ("batch / one (instructions)", &|row| told(fewer(row))),
        ],
    )
}

/// Nanoseconds of calls and batches, an item a place.
fn draw(folder: &Path, rows: &[Row]) -> Result<(), String> {
    let names = rows.iter().map(|row| row.label.to_string()).collect();
    let axes = (Axis::named("", names), Axis::log10("ns an element"));
    let mut figure = Figure::new("Calls and batches", axes.0, axes.1)
        .legend(Legend::Below)
        .size(1400, 640);
    for (column, name) in [ONE, BATCH].into_iter().enumerate() {
        let point = |(place, row): (usize, &Row)| Some((place as f64, row.nanoseconds[column]?));
        let points: Vec<(f64, f64)> = rows.iter().enumerate().filter_map(point).collect();
        figure = figure.series(Series::points(name, points));
    }
    let svg = figure.svg().map_err(|error| error.to_string())?;
    crate::written::write(folder, PICTURE, &svg)
}
