//! Collects the runs of sweeps into a table that an exhibit reads.
//!
//! ```text
//! cargo run -p tribos-thesis --example kept_table -- thesis/src/exhibits/outlook/runs.csv out/a1 out/b1
//! ```
//!
//! The first argument is the table, all others are folders of sweeps, finished or not; runs that have not ended are
//! left out. The head of the table, which names the sweeps, and its columns stay: keys of a run's scene, or of its summary,
//! where `slid.friction` is a key within a key. Of a list it takes every entry, with blanks between.

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::path::Path;
use tribos::record::write_atomically;
use tribos::scene::with_present_names;

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let table = arguments.next().context("name the table and the sweeps")?;
    let before = std::fs::read_to_string(&table).with_context(|| format!("no table {table}"))?;
    let mut head: Vec<&str> = before
        .lines()
        .take_while(|line| line.starts_with('#'))
        .collect();
    let columns = before
        .lines()
        .nth(head.len())
        .context("the table has no columns")?;
    head.push(columns);
    let mut lines = Vec::new();
    for sweep in arguments {
        let runs = Path::new(&sweep).join("runs");
        let entries = std::fs::read_dir(&runs).with_context(|| format!("{}", runs.display()))?;
        for entry in entries {
            lines.extend(line(&entry?.path(), columns)?);
        }
    }
    ensure!(!lines.is_empty(), "no run of these sweeps has ended");
    lines.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    // Runs from an earlier state have no seed, and NaN equals nothing.
    lines.dedup_by(|a, b| a.1 == b.1);
    let head: String = head.into_iter().map(|line| format!("{line}\n")).collect();
    let lines: String = lines.into_iter().map(|(_, line)| line + "\n").collect();
    write_atomically(Path::new(&table), format!("{head}{lines}").as_bytes())?;
    Ok(())
}

/// The seed and the line of a run's folder, if the run has ended.
fn line(run: &Path, columns: &str) -> Result<Option<(f64, String)>> {
    let Ok(text) = std::fs::read_to_string(run.join("summary.json")) else {
        return Ok(None);
    };
    let summary: Value =
        serde_json::from_str(&text).with_context(|| format!("{} cannot be read", run.display()))?;
    let scene = with_present_names(&summary["scene"]);
    let words = columns.split(',').map(|key| match scene.get(key) {
        Some(value) => word(value, ""),
        None => word(&summary, key),
    });
    let words: Vec<String> = words.collect();
    let seed = scene["seed"].as_f64().unwrap_or(f64::NAN);
    Ok(Some((seed, words.join(","))))
}

/// What is found at a path of keys, as a word of the table.
fn word(value: &Value, path: &str) -> String {
    if let Value::Array(all) = value {
        let words: Vec<String> = all.iter().map(|one| word(one, path)).collect();
        return words.join(" ");
    }
    if path.is_empty() {
        let text = value.as_str().map(String::from);
        return text.unwrap_or_else(|| value.to_string());
    }
    let (key, rest) = path.split_once('.').unwrap_or((path, ""));
    word(&value[key], rest)
}
