//! Runs the fuzzer for every target or one.
//!
//! `cargo run --release -p tribos-tests --bin fuzz -- [--inputs N] [--seed S] [--only NAME] [--repeat SEED]`

use std::collections::VecDeque;
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::Instant;
use tribos_tests::fuzz::{Report, TARGETS, Target, run, take};

const HELP: &str = "\
Takes seeded inputs for every target and reports what is found: panics, broken properties, slow inputs.

  --inputs N      inputs in all (default 200000)
  --seed S        seed of the run (default 1)
  --only NAME     this target only
  --repeat SEED   with --only: the one input that a finding names
  --list          names of the targets

Exit codes: 0 nothing found, 1 something found, 2 bad usage.";

/// Inputs that a thread takes at once.
const BATCH: u64 = 5_000;

/// What was asked for.
struct Wanted {
    inputs: u64,
    seed: u64,
    targets: Vec<Target>,
    repeat: Option<u64>,
}

fn main() -> ExitCode {
    match wanted(std::env::args().skip(1)) {
        Ok(Some(wanted)) => {
            // The report tells panics.
            std::panic::set_hook(Box::new(|_| ()));
            match wanted.repeat {
                Some(seed) => repeat(&wanted.targets[0], seed),
                None => all(&wanted),
            }
        }
        Ok(None) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

fn wanted(mut arguments: impl Iterator<Item = String>) -> Result<Option<Wanted>, String> {
    let mut wanted = Wanted {
        inputs: 200_000,
        seed: 1,
        targets: TARGETS.to_vec(),
        repeat: None,
    };
    while let Some(name) = arguments.next() {
        if name == "--help" || name == "-h" {
            println!("{HELP}");
            return Ok(None);
        }
        if name == "--list" {
            TARGETS
                .iter()
                .for_each(|target| println!("{}", target.name));
            return Ok(None);
        }
        let value = arguments
            .next()
            .ok_or(format!("{name} needs a value, or is unknown"))?;
        let number = || {
            value
                .parse()
                .map_err(|_| format!("{name} {value}: not a whole number"))
        };
        match name.as_str() {
            "--inputs" => wanted.inputs = number()?,
            "--seed" => wanted.seed = number()?,
            "--repeat" => wanted.repeat = Some(number()?),
            "--only" => wanted.targets.retain(|target| target.name == value),
            _ => return Err(format!("{name} is unknown")),
        }
    }
    match (wanted.targets.len(), wanted.repeat) {
        (0, _) => Err("--only: no such target; --list tells them".into()),
        (2.., Some(_)) => Err("--repeat needs --only".into()),
        _ => Ok(Some(wanted)),
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

fn all(wanted: &Wanted) -> ExitCode {
    let start = Instant::now();
    let shares: u64 = wanted.targets.iter().map(|target| target.share).sum();
    let mut jobs = VecDeque::new();
    for (index, target) in wanted.targets.iter().enumerate() {
        let inputs = (wanted.inputs * target.share).div_ceil(shares);
        for from in (0..inputs).step_by(BATCH as usize) {
            jobs.push_back((index, from..inputs.min(from + BATCH)));
        }
    }
    let (jobs, reports) = (
        Mutex::new(jobs),
        Mutex::new(vec![Report::default(); wanted.targets.len()]),
    );
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((index, range)) =
                    jobs.lock().ok().and_then(|mut jobs| jobs.pop_front())
                {
                    let report = run(&wanted.targets[index], wanted.seed, range);
                    if let Ok(mut reports) = reports.lock() {
                        reports[index] = std::mem::take(&mut reports[index]).merged(report);
                    }
                }
            });
        }
    });
    let reports = reports.into_inner().unwrap_or_default();
    let told = tell(wanted, &reports);
    println!("{:.1} s, {threads} threads", start.elapsed().as_secs_f64());
    told
}

/// A line a target, and its findings.
fn tell(wanted: &Wanted, reports: &[Report]) -> ExitCode {
    let mut found = 0;
    for (target, report) in wanted.targets.iter().zip(reports) {
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
