//! How a report was made: program, command, machine, date and time.

use crate::effort::Effort;
use crate::plan::cores;
use std::process::Command;
use std::time::Duration;
use tribos_report::page::Table;

/// Program and commit, in a few words.
pub fn program() -> String {
    let version = env!("CARGO_PKG_VERSION");
    match env!("TRIBOS_COMMIT") {
        "" => format!("tribos {version}"),
        commit => format!("tribos {version}, commit {commit}"),
    }
}

/// The command that makes an exhibit, or all of them.
pub fn command(name: Option<&str>, effort: Effort) -> String {
    let full = (effort == Effort::Full).then_some("--full");
    let words = [Some("tribos reproduce --out DIR"), name, full];
    words.into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// What an exhibit's page and files say of how they were made. The seeds are those of its random runs.
pub fn line(name: &str, effort: Effort, seeds: &[u64], source: &str) -> String {
    let seeds = match (seeds.iter().min(), seeds.iter().max()) {
        (Some(first), Some(last)) if first < last => format!("; seeds {first} to {last}"),
        (Some(seed), _) => format!("; seed {seed}"),
        _ => String::new(),
    };
    format!(
        "`{}`{seeds}; {source}; {}",
        command(Some(name), effort),
        program()
    )
}

/// The whole report's.
pub fn table(effort: Effort, wall: Duration) -> Table {
    let rows = [
        ("program", format!("{}, exact tier in f64", program())),
        ("command", format!("`{}`", command(None, effort))),
        ("made", format!("{}, in {:.0} s", date(), wall.as_secs_f64())),
        ("machine", machine()),
        (
            "seeds",
            "beside each exhibit, in the head of its CSV file, and in claims.csv".into(),
        ),
        (
            "files",
            "[claims.csv](claims.csv): every row with its numbers; a CSV, SVG and PNG file for each figure".into(),
        ),
    ];
    Table {
        id: "provenance".into(),
        heading: "How this report was made".into(),
        head: ["what", "which"].map(String::from).into(),
        rows: rows.map(|(what, which)| vec![what.into(), which]).into(),
        ..Table::default()
    }
}

/// The day, as the system tells it.
fn date() -> String {
    let output = Command::new("date")
        .args(["-u", "+%Y-%m-%d %H:%M UTC"])
        .output();
    let told = output.ok().filter(|output| output.status.success());
    let told = told.and_then(|output| String::from_utf8(output.stdout).ok());
    told.map_or("on an unknown day".into(), |text| text.trim().into())
}

/// Processor and system.
fn machine() -> String {
    use std::env::consts::{ARCH, OS};
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = told
        .lines()
        .find_map(|line| line.strip_prefix("model name"));
    let model = model
        .and_then(|line| line.split_once(':'))
        .map_or(ARCH, |(_, model)| model.trim());
    format!("{model} ({ARCH}, {OS}), {} cores", cores())
}
