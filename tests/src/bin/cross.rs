//! Checks that every platform computes the same bits: builds the digests for each, runs them on
//! the platform or its emulator, and compares.
//!
//! `cargo run -p tribos-tests --bin cross -- --help`

use clap::Parser;
use std::process::ExitCode;
use std::sync::mpsc;
use std::{fs, thread};
use tribos_tests::cross::options::Options;
use tribos_tests::cross::platforms::PLATFORMS;
use tribos_tests::cross::report::{Outcome, Row, table};
use tribos_tests::cross::work;

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("cross: {message}");
            ExitCode::FAILURE
        }
    }
}

/// True if every requested row gave the promised result.
fn run(options: &Options) -> Result<bool, String> {
    let rows = rows(options);
    let table = table(&rows);
    print!("\n{table}");
    if let Some(path) = &options.out {
        fs::write(path, &table).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    let incomplete = options.require_all && rows.iter().any(Row::is_lacking);
    Ok(!incomplete && !rows.iter().any(Row::is_broken))
}

/// Builds one row after the other; each runs while the next is being built.
fn rows(options: &Options) -> Vec<Row> {
    let wanted = PLATFORMS.into_iter().filter(|p| options.wants(p.name));
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for (index, platform) in wanted.enumerate() {
            let end = |outcome| (index, Row { platform, outcome });
            let lacking = work::missing(&platform);
            let sender = sender.clone();
            if !lacking.is_empty() {
                // The receiver lives as long as this function.
                let _ = sender.send(end(Outcome::Missing(lacking)));
                continue;
            }
            eprintln!("building {}", platform.name);
            match work::build(&platform) {
                Err(message) => drop(sender.send(end(Outcome::Failed(message)))),
                Ok(images) => drop(scope.spawn(move || {
                    let outcome = match work::run(&platform, &images, options) {
                        Err(message) => Outcome::Failed(message),
                        Ok((answers, time)) => Outcome::Ran {
                            answers,
                            images: images.len(),
                            time,
                        },
                    };
                    let row = Row { platform, outcome };
                    eprintln!("{}", row.line());
                    let _ = sender.send((index, row));
                })),
            }
        }
    });
    drop(sender);
    let mut rows: Vec<(usize, Row)> = receiver.into_iter().collect();
    rows.sort_by_key(|(index, _)| *index);
    rows.into_iter().map(|(_, row)| row).collect()
}
