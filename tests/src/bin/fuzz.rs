//! Runs the fuzzer for all targets or one.
//!
//! `cargo run --release -p tribos-tests --bin fuzz -- --help`

use clap::Parser;
use std::collections::VecDeque;
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::Instant;
use tribos_tests::fuzz::{Report, Target, run, take, targets};

/// Number of inputs that a thread takes at a time.
const BATCH: u64 = 5_000;

/// Takes seeded inputs for every target and reports what is found: panics, broken properties, slow
/// inputs.
#[derive(Parser)]
#[command(after_help = "Exit codes: 0 nothing found, 1 something found, 2 bad usage.")]
struct Arguments {
    /// Inputs in all
    #[arg(long, default_value_t = 200_000)]
    inputs: u64,
    /// Seed of the run
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// This target only
    #[arg(long, value_name = "NAME", value_parser = names())]
    only: Option<String>,
    /// The one input that a finding names
    #[arg(long, value_name = "SEED", requires = "only")]
    repeat: Option<u64>,
}

fn names() -> Vec<&'static str> {
    targets().map(|target| target.name).collect()
}

fn main() -> ExitCode {
    let wanted = Arguments::parse();
    let is_wanted = |target: &Target| wanted.only.as_ref().is_none_or(|only| target.name == only);
    let targets: Vec<Target> = targets().filter(is_wanted).collect();
    // The report describes panics itself.
    std::panic::set_hook(Box::new(|_| ()));
    match wanted.repeat {
        Some(seed) => repeat(&targets[0], seed),
        None => all(&targets, &wanted),
    }
}

fn repeat(target: &Target, seed: u64) -> ExitCode {
    match take(target, seed) {
        Ok(()) => {
            println!("{}: nothing found", target.name);
            ExitCode::SUCCESS
        }
        Err(broken) => {
            println!("{}: {broken}", target.name);
            ExitCode::FAILURE
        }
    }
}

fn all(targets: &[Target], wanted: &Arguments) -> ExitCode {
    let start = Instant::now();
    let shares: u64 = targets.iter().map(|target| target.share).sum();
    let mut jobs = VecDeque::new();
    for (index, target) in targets.iter().enumerate() {
        let inputs = (wanted.inputs * target.share).div_ceil(shares);
        for from in (0..inputs).step_by(BATCH as usize) {
            jobs.push_back((index, from..inputs.min(from + BATCH)));
        }
    }
    let (jobs, reports) = (
        Mutex::new(jobs),
        Mutex::new(vec![Report::default(); targets.len()]),
    );
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((index, range)) =
                    jobs.lock().ok().and_then(|mut jobs| jobs.pop_front())
                {
                    let report = run(&targets[index], wanted.seed, range);
                    if let Ok(mut reports) = reports.lock() {
                        reports[index] = std::mem::take(&mut reports[index]).merged(report);
                    }
                }
            });
        }
    });
    let reports = reports.into_inner().unwrap_or_default();
    let told = tell(targets, &reports);
    println!("{:.1} s, {threads} threads", start.elapsed().as_secs_f64());
    told
}

/// One line per target, followed by its findings.
fn tell(targets: &[Target], reports: &[Report]) -> ExitCode {
    let mut found = 0;
    for (target, report) in targets.iter().zip(reports) {
        let (time, seed) = report.slowest;
        println!(
            "{:18} {:9} inputs  {:6} found  slowest {:9.3} ms (seed {seed})",
            target.name,
            report.inputs,
            report.found,
            1e3 * time.as_secs_f64()
        );
        for finding in &report.findings {
            println!(
                "    --only \"{}\" --repeat {}\n      {}",
                target.name, finding.seed, finding.broken
            );
        }
        found += report.found;
    }
    let inputs: u64 = reports.iter().map(|report| report.inputs).sum();
    println!("{inputs} inputs, {found} found");
    ExitCode::from(u8::from(found > 0))
}
