//! How often the 95 % intervals of `tribos fit` cover the truth, how often a search ends at a wrong minimum, and how long
//! fits take: records with a known truth, integrated apart from the code of the fit.
//!
//! `cargo run --release -p tribos-motion --example coverage -- [LAW…] [--records N] [--rows N] [--seed N] [--verbose]`
//!
//! Each record has random parameters, motion, sampling and noise. Times are those of the processor where one processor is
//! used (`taskset -c 0`), else of the clock.

mod course;
mod design;
mod report;
mod truth;

use design::{CASES, Form, Record};
use report::Outcome;
use std::time::Instant;
use tribos_base::run::in_order;
use tribos_motion::fit::{Between, Fit, FitError, FitLaw, FitOptions, FitParameter, Model};

/// The model of a law whose only start is the truth.
struct AtTruth<'a>(Box<dyn Model + 'a>, &'a [f64]);

impl Model for AtTruth<'_> {
    fn parameters(&self) -> &[FitParameter] {
        self.0.parameters()
    }
    fn reference(&self, parameter: usize) -> Option<f64> {
        self.0.reference(parameter)
    }
    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        self.0.predict(values)
    }
    fn start(&self, _: &[f64]) -> Vec<f64> {
        self.1.to_vec()
    }
    fn is_linear(&self, parameter: usize) -> bool {
        self.0.is_linear(parameter)
    }
    fn above(&self, parameter: usize) -> Option<usize> {
        self.0.above(parameter)
    }
    fn limits(&self, parameter: usize) -> [f64; 2] {
        self.0.limits(parameter)
    }
    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(AtTruth(self.0.along(path)?, self.1)))
    }
}

/// What the command line asks for.
struct Options {
    laws: Vec<String>,
    records: u64,
    rows: Option<usize>,
    seed: u64,
    is_verbose: bool,
}

fn options() -> Result<Options, String> {
    let mut all = Options {
        laws: Vec::new(),
        records: 200,
        rows: None,
        seed: 1,
        is_verbose: false,
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number = || {
            let next = words.next().ok_or(format!("{word} needs a number"))?;
            next.parse::<u64>()
                .map_err(|error| format!("{word} {next}: {error}"))
        };
        match word.as_str() {
            "--records" => all.records = number()?,
            "--rows" => all.rows = Some(number()? as usize),
            "--seed" => all.seed = number()?,
            "--verbose" => all.is_verbose = true,
            _ => all.laws.push(word),
        }
    }
    Ok(all)
}

/// Seconds of this thread on the processor, or of the clock.
fn seconds(begin: Instant) -> f64 {
    let is_alone = std::thread::available_parallelism().map_or(1, usize::from) == 1;
    let used = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let used = used.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    match used {
        Some(nanoseconds) if is_alone => 1e-9 * nanoseconds,
        _ => begin.elapsed().as_secs_f64(),
    }
}

fn fit(record: &Record, law: FitLaw, at_truth: bool, starts: usize) -> Result<Fit, FitError> {
    let model = law.model_on(&record.data, record.apparatus)?;
    let options = FitOptions {
        fixed: record.fixed.clone(),
        starts,
    };
    if at_truth {
        record.data.fit(&AtTruth(model, &record.truth), &options)
    } else {
        record.data.fit(model.as_ref(), &options)
    }
}

fn outcome(case: (FitLaw, Form), seed: u64, options: &Options) -> Result<Outcome, String> {
    let record = design::record(case, seed, options.rows).map_err(|e| format!("{seed}: {e}"))?;
    let begin = Instant::now();
    let before = seconds(begin);
    let found = fit(&record, case.0, false, FitOptions::default().starts);
    let time = seconds(begin) - before;
    let found = found.map_err(|e| format!("seed {seed}: {e}"))?;
    let near = if options.rows.is_some_and(|rows| rows > 100_000) {
        None
    } else {
        fit(&record, case.0, true, 1).ok()
    };
    let made = Outcome::of(&record, &found, near.as_ref(), time);
    if options.is_verbose && (made.is_wrong || made.misses() > 0) {
        let rows = record.data.friction().len();
        eprintln!(
            "{} {:?} seed {seed} rows {rows} cost {:.6e} near {:?} starts {}/{}",
            case.0.name(),
            case.1,
            found.cost,
            near.as_ref().map(|near| near.cost),
            found.at_best,
            found.starts
        );
        for (k, (e, truth)) in found.parameters.iter().zip(&record.truth).enumerate() {
            let there = near.as_ref().map(|near| near.parameters[k].value);
            eprintln!(
                "   {:8} {:.5e} {:?} [{:.5e} {:.5e}] truth {truth:.5e} near {there:?}",
                e.parameter.name, e.value, e.known, e.interval[0], e.interval[1]
            );
        }
        for caution in &found.cautions {
            eprintln!("   - {caution}");
        }
    }
    Ok(made)
}

fn main() -> Result<(), String> {
    let options = options()?;
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    println!("{}", report::HEAD);
    for case in CASES {
        let name = format!("{}:{:?}", case.0.name(), case.1).to_lowercase();
        let is_asked = |word: &String| *word == name || *word == case.0.name();
        if !options.laws.is_empty() && !options.laws.iter().any(is_asked) {
            continue;
        }
        let seeds = options.records as usize;
        let all = in_order(seeds, threads, |k| {
            outcome(case, options.seed + k as u64, &options)
        });
        let names: Vec<&str> = match design::record(case, options.seed, Some(200)) {
            Ok(record) => {
                let model = case.0.model_on(&record.data, record.apparatus);
                model.map_or(Vec::new(), |m| {
                    m.parameters().iter().map(|p| p.name).collect()
                })
            }
            Err(_) => Vec::new(),
        };
        println!("{}", report::line(&name, &names, &all));
    }
    if let Ok(text) = std::fs::read_to_string("/proc/self/status") {
        let peak = text.lines().find(|line| line.starts_with("VmHWM"));
        println!(
            "\npeak memory   {}",
            peak.map_or("unknown", |line| line[6..].trim())
        );
    }
    Ok(())
}
