//! Speed against error of one evaluation of force and torque.
//!
//! `cargo run --release -p tribos-benches --bin front -- [--out DIR] [--quick]` writes
//! `front.csv`, `front.md` and `front.svg` to DIR (default: docs/front) and prints the ratios that matter.
//! Times come from eight mixes in a row, errors from one.
//! Errors are judged by double-double arithmetic (α = 0), by the compact tier (else).

use std::path::Path;
use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::baselines::trapezoid::Trapezoid;
use tribos_benches::catalogue;
use tribos_benches::contact::Contact;
use tribos_benches::errors::Errors;
use tribos_benches::methods::{Inputs, Kind, Method};
use tribos_benches::mix;
use tribos_benches::picture::{self, Place};
use tribos_benches::timing::{self, Samples, Task};
use tribos_benches::written::{self, Sheet, short};

/// Seed of the mix.
const SEED: u64 = 1;
/// Rounds of all methods, and of a quick look.
const ROUNDS: usize = 101;
const QUICK_ROUNDS: usize = 9;
/// Slow methods are judged on every so manieth pair.
const SLOW_STRIDE: usize = 100;
/// The accuracy at which the trapezoid rule is compared with the table.
const TRAPEZOID_ERROR: f64 = 1e-3;
/// The rule's n is found as a multiple of this.
const TRAPEZOID_GRAIN: usize = 4;
/// Its name among the tasks.
const TRAPEZOID_TASK: &str = "trapezoid at 1e-3";
/// The same with a power at every node.
const GENERAL_TASK: &str = "trapezoid at 1e-3 for any alpha";

/// One line of the front.
#[derive(Debug)]
struct Row {
    method: Method,
    nanoseconds: f64,
    errors: Errors,
}

fn main() -> ExitCode {
    match Options::read(std::env::args().skip(1)).and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("front: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let inputs = Inputs::new(mix::pairs(SEED));
    let methods = all_methods()?;
    let errors: Vec<Errors> = methods.iter().map(|m| judge(m, &inputs)).collect();
    let n = trapezoid_at(TRAPEZOID_ERROR, &inputs.thinned(SLOW_STRIDE));
    let rounds = if options.quick { QUICK_ROUNDS } else { ROUNDS };
    let samples = measure(&methods, &Inputs::new(mix::long_pairs(SEED)), n, rounds)?;
    let ratios = ratios(&samples, n);

    let timed = methods.into_iter().zip(errors).zip(samples.medians());
    let row = |((method, errors), seconds)| Row {
        method,
        errors,
        nanoseconds: 1e9 * seconds,
    };
    let rows: Vec<Row> = timed.map(row).collect();
    let sheet = sheet(&rows, rounds);
    let report = format!("{}\n{ratios}", sheet.markdown());
    written::write(&options.out, "front.csv", &sheet.csv())?;
    written::write(&options.out, "front.md", &report)?;
    draw(&options.out, &rows)?;
    print!("{report}");
    Ok(())
}

/// Time against the larger relative error of force and torque, α = 0.
fn draw(out: &Path, rows: &[Row]) -> Result<(), String> {
    let places = rows
        .iter()
        .filter(|row| row.method.alpha == 0.0)
        .map(|row| Place {
            label: row.method.name.clone(),
            group: row.method.kind.name().into(),
            at: (row.nanoseconds, row.errors.relative()),
        });
    let axes = ["time per pair [ns]", "largest relative error of F and T"];
    picture::scatter(
        out,
        "front",
        "Speed against error, α = 0",
        axes,
        places.collect(),
    )
}

/// Tiers, baselines and exponents.
fn all_methods() -> Result<Vec<Method>, String> {
    let mut all = catalogue::tiers().map_err(|error| error.to_string())?;
    all.extend(catalogue::baselines());
    all.extend(catalogue::exponents().map_err(|error| error.to_string())?);
    Ok(all)
}

/// Errors over the mix, or over a part of it where an evaluation takes microseconds.
fn judge(method: &Method, inputs: &Inputs) -> Errors {
    if method.kind == Kind::Integration {
        method.errors(&inputs.thinned(SLOW_STRIDE))
    } else {
        method.errors(inputs)
    }
}

/// The smallest n (to the grain) whose trapezoid rule errs by `bound` at most.
fn trapezoid_at(bound: f64, inputs: &Inputs) -> usize {
    let good = |n: usize| {
        let rule = Trapezoid::new(n, 0.0);
        let evaluate = move |slide, rim| rule.wrench(slide, rim);
        Method::wide("", Kind::Integration, bound, evaluate)
            .errors(inputs)
            .relative()
            <= bound
    };
    let (mut low, mut high) = (TRAPEZOID_GRAIN, 2 * TRAPEZOID_GRAIN);
    while !good(high) {
        (low, high) = (high, 2 * high);
    }
    while high - low > TRAPEZOID_GRAIN {
        let middle = low.midpoint(high) / TRAPEZOID_GRAIN * TRAPEZOID_GRAIN;
        if good(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// Times the methods, then the trapezoid rule of `n` and the contact's two ways, all interleaved.
fn measure(
    methods: &[Method],
    inputs: &Inputs,
    n: usize,
    rounds: usize,
) -> Result<Samples, String> {
    // A few evaluations of the large rule are enough: their cost hardly depends on the ratio.
    let large = [
        (TRAPEZOID_TASK, Trapezoid::new(n, 0.0)),
        (GENERAL_TASK, Trapezoid::for_any_exponent(n, 0.0)),
    ]
    .map(|(name, rule)| {
        let evaluate = move |slide, rim| rule.wrench(slide, rim);
        Method::wide(name, Kind::Integration, TRAPEZOID_ERROR, evaluate)
    });
    let few = inputs.thinned(inputs.wide.len() / 4);

    let thinned: Vec<Inputs> = methods.iter().map(|m| inputs.thinned(m.stride)).collect();
    let task = |(method, inputs): (_, _)| method_task(method, inputs);
    let mut tasks: Vec<Task<'_>> = methods.iter().zip(&thinned).map(task).collect();
    tasks.extend(large.iter().map(|method| method_task(method, &few)));
    let pairs = &inputs.wide;
    for single in [true, false] {
        let mut wide = contact::<f64>(pairs)?;
        let mut narrow = contact::<f32>(pairs)?;
        let name = if single { "contact" } else { "contact batch" };
        tasks.push(Task::new(name, pairs.len(), move || {
            sweep(&mut wide, single)
        }));
        let name = format!("{name} f32");
        tasks.push(Task::new(name, pairs.len(), move || {
            sweep(&mut narrow, single)
        }));
    }
    Ok(timing::interleaved(tasks, rounds))
}

fn method_task<'a>(method: &'a Method, inputs: &'a Inputs) -> Task<'a> {
    Task::new(
        method.name.clone(),
        inputs.wide.len(),
        method.runner(inputs),
    )
}

fn contact<R: tribos_core::coupling::table::CoulombTable>(
    pairs: &[[f64; 2]],
) -> Result<Contact<R>, String> {
    Contact::new(pairs, SEED).map_err(|error| error.to_string())
}

fn sweep<R: tribos_core::coupling::table::CoulombTable>(contact: &mut Contact<R>, single: bool) {
    std::hint::black_box(if single {
        contact.one_by_one()
    } else {
        contact.batch()
    });
}

/// The table of the front.
fn sheet(rows: &[Row], rounds: usize) -> Sheet {
    let cells = |row: &Row| {
        let Row {
            method,
            nanoseconds,
            errors,
        } = row;
        // Absolute errors have a scale of their own for every other exponent.
        let absolute = |error| {
            if method.alpha == 0.0 {
                short(error)
            } else {
                "-".into()
            }
        };
        vec![
            method.name.clone(),
            method.kind.name().into(),
            method.precision().into(),
            method.alpha.to_string(),
            short(*nanoseconds),
            short(errors.relative_force),
            short(errors.relative_torque),
            absolute(errors.absolute_force),
            absolute(errors.absolute_torque),
        ]
    };
    Sheet {
        about: format!(
            "Force and torque of the uniform disk: median of {rounds} interleaved rounds and \
             largest errors over the mix of 3800 velocity ratios (integration: every 100th); by \
             `cargo run --release -p tribos-benches --bin front`"
        ),
        header: vec![
            "method", "kind", "type", "alpha", "ns", "rel F", "rel T", "abs F", "abs T/T0",
        ],
        rows: rows.iter().map(cells).collect(),
    }
}

/// The ratios that matter, each the median of the rounds' own ratios.
fn ratios(samples: &Samples, n: usize) -> String {
    let ratio = |above: &str, below: &str| samples.ratio(above, below).unwrap_or(f64::NAN);
    let agm = ratio("table", "agm").max(ratio("table", "agm libm"));
    let bare = |alpha: &f64| ratio(&format!("table alpha {alpha} unscaled"), "table");
    let costs: Vec<f64> = catalogue::EXPONENTS.iter().map(bare).chain([1.0]).collect();
    let slowest = costs.iter().copied().fold(0.0, f64::max);
    let quickest = costs.iter().copied().fold(f64::INFINITY, f64::min);
    let trapezoid = ratio(TRAPEZOID_TASK, "table");
    let lines = [
        ("table / quicker AGM".into(), agm),
        ("table / Bulirsch".into(), ratio("table", "bulirsch")),
        (
            format!("trapezoid {n} (error 1e-3), root at every node / table"),
            trapezoid,
        ),
        (
            format!("trapezoid {n} (error 1e-3), power at every node / table"),
            ratio(GENERAL_TASK, "table"),
        ),
        ("table f64 / f32".into(), ratio("table", "table f32")),
        (
            "contact f64, batch / single".into(),
            ratio("contact batch", "contact"),
        ),
        (
            "contact f32, batch / single".into(),
            ratio("contact batch f32", "contact f32"),
        ),
        (
            "slowest / quickest exponent, power left out".into(),
            slowest / quickest,
        ),
        ("alpha 0.5 without power / Coulomb".into(), bare(&0.5)),
        (
            "alpha 0.5 with power (a root) / Coulomb".into(),
            ratio("table alpha 0.5", "table"),
        ),
        (
            "alpha 1.5 with power / Coulomb".into(),
            ratio("table alpha 1.5", "table"),
        ),
    ];
    let line = |(name, value): &(String, f64)| format!("- {name}: {}\n", short(*value));
    lines.iter().map(line).collect()
}
