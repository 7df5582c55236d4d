//! Instructions of the items on this machine, counted by callgrind.
//!
//! The program runs itself once more under Valgrind with an option that no help shows: every item once,
//! inside of a function whose calls callgrind writes down one by one.

use super::items::{self, Item, Length, Run};
use std::fs;
use std::path::Path;
use std::process::Command;

/// The option that runs all items once.
pub const OPTION: &str = "--run-batch-items";
/// The function whose calls are counted.
const COUNTED: &str = concat!(module_path!(), "::counted_run");

/// Instructions of a call and of an element of a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Counts(pub [Option<f64>; 2]);

/// Runs every item once, calls before batch.
pub fn run_once() -> Result<(), String> {
    for Item { one, batch, .. } in items::all(Length::Short)? {
        counted_run(one);
        batch.into_iter().for_each(counted_run);
    }
    Ok(())
}

/// One item. Not inlined, so that callgrind finds it.
#[inline(never)]
fn counted_run(mut run: Run) {
    run();
}

/// Counts the instructions of all items; an error tells why that is impossible here.
pub fn count() -> Result<Vec<Counts>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let here = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    let output = Command::new("valgrind")
        .arg("--tool=callgrind")
        .arg(format!("--toggle-collect={COUNTED}"))
        .arg(format!("--dump-after={COUNTED}"))
        .arg(format!(
            "--callgrind-out-file={}",
            folder.path().join("out").display()
        ))
        .arg(here)
        .arg(OPTION)
        .output()
        .map_err(|error| format!("cannot run valgrind: {error}"))?;
    if !output.status.success() {
        let told = String::from_utf8_lossy(&output.stderr);
        let last = told.lines().last().unwrap_or_default();
        return Err(format!("valgrind fails: {last}"));
    }
    let mut number = 0;
    let mut next = |elements: usize| {
        number += 1;
        total(&folder.path().join(format!("out.{number}"))).map(|total| total / elements as f64)
    };
    let items = items::all(Length::Short)?;
    let counts = items.iter().map(|item| {
        let one = next(item.elements)?;
        let batch = item.batch.as_ref().map(|_| next(item.elements));
        Ok(Counts([Some(one), batch.transpose()?]))
    });
    counts.collect()
}

/// Instructions of one dump.
fn total(path: &Path) -> Result<f64, String> {
    let text = fs::read_to_string(path)
        .map_err(|error| format!("callgrind wrote no {}: {error}", path.display()))?;
    totals(&text).ok_or_else(|| format!("{} has no total", path.display()))
}

/// The number after the word that begins callgrind's sum.
fn totals(text: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix("totals:"))?;
    line.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_total_of_a_dump_is_read() {
        let dump = "version: 1\nevents: Ir\nsummary: 12\n\nfn=(1) x\n3 12\n\ntotals: 12\n";
        assert_eq!(totals(dump), Some(12.0));
        assert_eq!(totals("events: Ir\n"), None);
    }
}
