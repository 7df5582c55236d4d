//! What a sweep that is complete leaves: its tables and their picture.

use super::body::Body;
use super::frame::{self, Column};
use super::jobs::Task;
use super::plan::Plan;
use super::table::Table;
use super::{plot, runs};
use crate::command::bodies::RunKind;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::record::write_atomically;

/// Most names of runs in a message.
const MOST_NAMES: usize = 10;

/// What is drawn of the runs: of one that is possible, with the column that was asked for.
pub fn kind(tasks: &[Task], plot: Option<&str>) -> Result<RunKind, Failure> {
    let kind = possible(tasks)?.kind();
    match plot {
        Some(column) => kind.drawing(column),
        None => Ok(kind),
    }
}

/// The first body that can be run.
fn possible(tasks: &[Task]) -> Result<&Body, Failure> {
    let body = tasks.iter().find_map(|task| task.body.as_ref().ok());
    body.ok_or_else(|| Failure::input("every combination is refused"))
}

/// Writes all tables and pictures of a complete sweep.
pub fn write(
    plan: &Plan,
    tasks: &[Task],
    summaries: &[Value],
    (out, plot): (&Path, Option<&str>),
) -> Result<Table, Failure> {
    let seeds = plan.seeds as usize;
    let keys = possible(tasks)?.keys();
    let grid = &plan.grid.with_present_names(keys);
    let table = Table::new(kind(tasks, plot)?, grid, summaries, seeds);
    let csv = frame::csv(&table.columns()).map_err(Failure::run)?;
    write_atomically(&out.join("sweep.csv"), &csv)?;
    let runs = runs::columns(grid, seeds, tasks, summaries);
    let csv = frame::csv(&runs).map_err(Failure::run)?;
    write_atomically(&out.join("runs.csv"), &csv)?;
    parquet(&table.columns(), &out.join("sweep.parquet"))?;
    parquet(&runs, &out.join("runs.parquet"))?;
    plot::write((grid, keys), &table, plot.is_some(), out)?;
    Ok(table)
}

#[cfg(feature = "parquet")]
fn parquet(columns: &[Column], file: &Path) -> Result<(), Failure> {
    let bytes = super::parquet::bytes(columns).map_err(Failure::run)?;
    Ok(write_atomically(file, &bytes)?)
}

/// Built without Parquet: the CSV files hold the same.
#[cfg(not(feature = "parquet"))]
fn parquet(_: &[Column], _: &Path) -> Result<(), Failure> {
    Ok(())
}

/// All summaries, or which runs are missing.
pub fn complete(
    tasks: &[Task],
    kept: Vec<Option<Value>>,
    out: &Path,
) -> Result<Vec<Value>, Failure> {
    let missing: Vec<&Task> = tasks
        .iter()
        .zip(&kept)
        .filter(|(_, kept)| kept.is_none())
        .map(|(task, _)| task)
        .collect();
    if missing.is_empty() {
        return Ok(kept.into_iter().flatten().collect());
    }
    let mut text = format!("{} of {} runs are missing:", missing.len(), tasks.len());
    for task in missing.iter().take(MOST_NAMES) {
        text += &format!("\n  {}", task.name);
        if task.is_changed() {
            text += " (its summary was changed after the run)";
        }
    }
    if let Some(more) = missing
        .len()
        .checked_sub(MOST_NAMES)
        .filter(|&more| more > 0)
    {
        text += &format!("\n  and {more} more");
    }
    text += &format!(
        "\nRun them here with `tribos sweep --plan {}`, or start their part again.",
        out.display()
    );
    Err(Failure::run(text))
}
