//! `tribos fit --strokes`: a tribometer's record, stroke by stroke.

use super::log::Format;
use super::strokes_picture;
use crate::command::digits::shown;
use crate::failure::Failure;
use serde_json::{Map, Value, json};
use std::path::Path;
use tribos::fit::FitError;
use tribos::fit::strokes::{
    Stroke, StrokeOptions, StrokeQuantity, StrokeRecord, StrokeSummary, Strokes,
};
use tribos::record::{
    LogOptions, LogRole, TableError, json_number, read_log, write_atomically, write_series,
};
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;

/// Options of `--strokes`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct StrokeArguments {
    /// Take a record over time apart into strokes: columns t,f and v or x, perhaps load; without v and x strokes are
    /// divided by the sign of f.
    #[arg(long, requires = "data", conflicts_with_all = ["law", "fixed", "starts"])]
    pub strokes: bool,
}

const FILES: [&str; 4] = ["strokes.csv", "strokes.svg", "strokes.png", "summary.json"];
/// Strokes that are printed: the first and the last ones of more than that.
const MOST_PRINTED: usize = 20;
/// Quantities that are printed of each stroke: all but those by which it is found in the record.
const NOT_PRINTED: [&str; 3] = ["duration", "peak_time", "cut_off"];
const EXPECTED: &str = "(columns are t,f with v or x, perhaps load)";

/// Takes apart, writes and prints.
pub fn execute(
    file: &Path,
    log: &LogOptions,
    load: Option<f64>,
    (format, out): (Format, Option<&Path>),
) -> Result<(), Failure> {
    let (record, told) = read(file, log, load)?;
    let refusal = |error: FitError| Failure::input(format!("{}: {error}", file.display()));
    let found = Strokes::new(&record, &StrokeOptions::default()).map_err(refusal)?;
    if let Some(out) = out {
        let picture = strokes_picture::panels(&record, &found);
        let _folder = OutputFolder::begin(out, &Contents::of("fit", &FILES))?;
        image::write_both(out, "strokes", &picture)?;
        let names = Stroke::QUANTITIES.map(|quantity| quantity.name);
        let row = |stroke: &Stroke| Stroke::QUANTITIES.map(|quantity| (quantity.value)(stroke));
        let rows: Vec<[f64; 14]> = found.strokes.iter().map(row).collect();
        let rows = rows.iter().map(<[f64; 14]>::as_slice);
        write_series(&out.join("strokes.csv"), &names, rows)?;
        let summary = format!("{:#}\n", summary(&found));
        write_atomically(&out.join("summary.json"), summary.as_bytes())?;
    }
    match format {
        Format::Text => {
            let read: String = told
                .iter()
                .map(|line| format!("read          {line}\n"))
                .collect();
            crate::command::print(&(read + &text(&found)))?;
            match out {
                Some(out) => crate::command::print(&format!("written to    {}\n", out.display())),
                None => Ok(()),
            }
        }
        Format::Json => crate::command::print(&format!("{:#}\n", everything(&found))),
    }
}

/// The record of a file: its columns by their roles, friction divided by the load; and what was understood.
fn read(
    file: &Path,
    options: &LogOptions,
    load: Option<f64>,
) -> Result<(StrokeRecord, Vec<String>), Failure> {
    const ROLES: [LogRole; 5] = [
        LogRole::TIME.needed(),
        LogRole::FRICTION.needed(),
        LogRole::VELOCITY,
        LogRole::POSITION,
        LogRole::LOAD.by_own_name(),
    ];
    let explained = |failure: TableError| Failure::input(format!("{failure} {EXPECTED}"));
    let mut log = read_log(file, &ROLES, options).map_err(explained)?;
    let (times, friction) = (log.take("t"), log.take("f"));
    let (velocities, positions) = (log.take("v"), log.take("x"));
    let (loads, lines) = (log.take("load"), &log.lines);
    if load.is_some() && loads.is_some() {
        return Err(Failure::input(format!(
            "{}: the column load and --load are both given; leave one out",
            file.display()
        )));
    }
    let loads = loads.or_else(|| load.map(|load| vec![load; lines.len()]));
    let record = StrokeRecord::new(times.unwrap_or_default(), friction.unwrap_or_default());
    let record = record
        .and_then(|record| match velocities {
            Some(velocities) => record.with_velocities(velocities),
            None => Ok(record),
        })
        .and_then(|record| match positions {
            Some(positions) => record.with_positions(positions),
            None => Ok(record),
        })
        .and_then(|record| match loads {
            Some(loads) => record.per_load(&loads),
            None => Ok(record),
        });
    let record = record.map_err(|error| super::table::refusal(file, lines, &log.brief, error))?;
    Ok((record, log.brief))
}

/// For the person at the terminal.
fn text(found: &Strokes) -> String {
    let mut text = format!(
        "strokes       {}, divided by the {}\n{}",
        found.strokes.len(),
        found.divided_by(),
        table(&found.strokes)
    );
    let summary = &found.summary;
    let or_none = |value: Option<f64>| value.map_or("none".to_owned(), shown);
    text += &format!("run-in        {}\n", found.run_in());
    text += &format!(
        "mean          {} ± {} over {} strokes, which scatter by {}\n",
        shown(summary.mean),
        or_none(summary.standard_error),
        summary.strokes,
        or_none(summary.deviation)
    );
    if let Some(peak) = summary.static_peak {
        let scatter = or_none(summary.static_peak_deviation);
        text += &format!(
            "static peak   {}, which scatters by {scatter}\n",
            shown(peak)
        );
    }
    if let Some(offset) = summary.offset {
        let error = or_none(summary.standard_error);
        text += &format!(
            "offset        {} ± {error}: half of forward less backward\n",
            shown(offset)
        );
    }
    text += &match (summary.drop, summary.period) {
        (Some(drop), Some(period)) => format!(
            "stick-slip    {} slips of {}, one every {} s\n",
            summary.slips,
            shown(drop),
            shown(period)
        ),
        _ => "stick-slip    none\n".to_owned(),
    };
    text += &format!(
        "noise         {} of the friction, row by row\n",
        shown(found.noise)
    );
    if let Some(distance) = summary.distance {
        text += &format!("distance      {} m in all strokes\n", shown(distance));
    }
    let notes = found.notes();
    let notes = notes.iter().map(|note| format!("note          {note}\n"));
    text + &notes.collect::<String>()
}

/// A line for each stroke, the first and the last ones of many.
fn table(strokes: &[Stroke]) -> String {
    let columns = Stroke::QUANTITIES.iter();
    let columns = columns.filter(|quantity| !NOT_PRINTED.contains(&quantity.name));
    let columns: Vec<&StrokeQuantity<Stroke>> = columns.collect();
    let head = columns.iter().map(|quantity| match quantity.unit {
        "" | "f" => quantity.name.to_owned(),
        unit => format!("{} [{unit}]", quantity.name),
    });
    let mut lines: Vec<Vec<String>> = vec![head.collect()];
    let half = MOST_PRINTED / 2;
    for (at, stroke) in strokes.iter().enumerate() {
        let is_inside = at >= half && at + half < strokes.len();
        if is_inside && strokes.len() > MOST_PRINTED {
            if at == half {
                lines.push(vec!["…".to_owned(); columns.len()]);
            }
            continue;
        }
        let cells = columns
            .iter()
            .map(|quantity| match (quantity.value)(stroke) {
                value if value.is_nan() => "-".to_owned(),
                value => shown(value),
            });
        lines.push(cells.collect());
    }
    let width = |k: usize| {
        let cells = lines.iter().filter_map(|line| line.get(k));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns.len()).map(width).collect();
    let row = |line: &Vec<String>| {
        let cells = line.iter().zip(&widths);
        let cells: Vec<String> = cells
            .map(|(cell, width)| format!("{cell:>width$}"))
            .collect();
        format!("  {}\n", cells.join("  "))
    };
    lines.iter().map(row).collect()
}

/// Name and value of each quantity; null where there is none.
fn object<T>(quantities: &[StrokeQuantity<T>], of: &T) -> Map<String, Value> {
    let one = |quantity: &StrokeQuantity<T>| {
        let value = (quantity.value)(of);
        let value = match quantity.unit {
            _ if value.is_nan() => Value::Null,
            "" => Value::from(value as i64), // Counts and signs are whole.
            _ => json_number(value),
        };
        (quantity.name.to_owned(), value)
    };
    quantities.iter().map(one).collect()
}

/// The summary with what was assumed.
fn summary(found: &Strokes) -> Value {
    json!({
        "summary": object(&StrokeSummary::QUANTITIES, &found.summary),
        "run_in": { "after": found.run_in.after(), "told": found.run_in() },
        "divided_by": found.divided_by(),
        "noise": json_number(found.noise),
        "notes": found.notes(),
        "version": env!("CARGO_PKG_VERSION"),
    })
}

/// The summary with all strokes.
fn everything(found: &Strokes) -> Value {
    let rows = found.strokes.iter();
    let rows = rows.map(|stroke| Value::Object(object(&Stroke::QUANTITIES, stroke)));
    let mut all = summary(found);
    if let Some(all) = all.as_object_mut() {
        all.insert("strokes".to_owned(), Value::Array(rows.collect()));
    }
    all
}
