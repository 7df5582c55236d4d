//! Contact dynamics: cost of an update, work against residual, work against size.
//!
//! `cargo run --release -p tribos-benches --bin contact_front -- [--out DIR] [--quick]
//! [--only PART]` writes a CSV for every part and `contact_front.md` for all of them to DIR
//! (default: docs/front). Parts: `updates`.

use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::packing::updates::{self, Cost};
use tribos_benches::written::{self, Sheet, short};

/// Rounds of all updates, and of a quick look.
const ROUNDS: usize = 101;
const QUICK_ROUNDS: usize = 15;

fn main() -> ExitCode {
    match arguments().and_then(|(options, only)| run(&options, only.as_deref())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("contact_front: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The options of all fronts, and the part that is wanted.
fn arguments() -> Result<(Options, Option<String>), String> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let mut only = None;
    if let Some(at) = words.iter().position(|word| word == "--only") {
        let part = words.drain(at..(at + 2).min(words.len())).nth(1);
        only = Some(part.ok_or("--only needs a part after it")?);
    }
    Ok((Options::read(words.into_iter())?, only))
}

fn run(options: &Options, only: Option<&str>) -> Result<(), String> {
    match only {
        None | Some("updates") => {}
        Some(other) => return Err(format!("unknown part {other}; known: updates")),
    }
    let rounds = if options.quick { QUICK_ROUNDS } else { ROUNDS };
    let costs = updates::measure(rounds).map_err(|error| error.to_string())?;
    let sheet = updates_sheet(&costs, rounds);
    written::write(&options.out, "contact_updates.csv", &sheet.csv())?;
    print!("{}", sheet.markdown());
    Ok(())
}

/// Updates a second, and what a contact costs beside one with all modes.
fn updates_sheet(costs: &[Cost], rounds: usize) -> Sheet {
    let cells = |cost: &Cost| {
        let full = costs.iter().find(|other| other.state == cost.state);
        let of_full = full.map_or(f64::NAN, |full| cost.seconds / full.seconds);
        let bytes = full.map_or(f64::NAN, |full| cost.bytes as f64 / full.bytes as f64);
        vec![
            cost.modes.into(),
            cost.state.replace(", ", " "),
            cost.unknowns.to_string(),
            cost.contacts.to_string(),
            short(1e9 * cost.seconds),
            short(1e-6 / cost.seconds),
            short(of_full),
            cost.bytes.to_string(),
            short(bytes),
        ]
    };
    Sheet {
        about: format!(
            "Contact updates on one core: sweeps over a jammed box of 1,000 spheres under load \
             without a watch, median of {rounds} interleaved rounds; by `cargo run --release -p \
             tribos-benches --bin contact_front -- --only updates`"
        ),
        header: vec![
            "modes",
            "state",
            "unknowns",
            "contacts",
            "ns per update",
            "million/s",
            "time of all six",
            "bytes",
            "bytes of all six",
        ],
        rows: costs.iter().map(cells).collect(),
    }
}
