//! Speed against error of one evaluation of force and torque.
//!
//! Times come from eight mixes in a row, errors from one.
//! References for errors are double-double arithmetic for α = 0, else the compact tier.

mod instructions;

use super::{Finding, Front, Setting};
use crate::baselines::trapezoid::Trapezoid;
use crate::catalogue;
use crate::contact::Contact;
use crate::errors::Errors;
use crate::firmware::report::Row as Priced;
use crate::methods::{Inputs, Kind, Method};
use crate::mix;
use crate::picture::{self, PicturePoint};
use crate::timing::{self, Samples, Task};
use crate::written::{Sheet, short};
use std::path::Path;
use tribos_core::coupling::coulomb::CoulombDisk;

/// Seed of the mix.
const SEED: u64 = 1;
/// Rounds of all methods, and of a quick look.
const ROUNDS: usize = 101;
const QUICK_ROUNDS: usize = 9;
/// Errors of slow methods are taken on every `SLOW_STRIDE`-th pair.
const SLOW_STRIDE: usize = 100;
/// The accuracy at which the trapezoid rule is compared with the table.
const TRAPEZOID_ERROR: f64 = 1e-3;
/// The rule's n is found as a multiple of this.
const TRAPEZOID_GRAIN: usize = 4;
/// Its name among the tasks.
const TRAPEZOID_TASK: &str = "trapezoid at 1e-3";
/// The same with a power at every node.
const GENERAL_TASK: &str = "trapezoid at 1e-3 for any alpha";

const PICTURE: &str = "kernel.svg";
const TARGETS_PICTURE: &str = "kernel_targets.svg";

/// One line of the front.
#[derive(Debug)]
struct Row {
    method: Method,
    nanoseconds: f64,
    errors: Errors,
    /// Instructions of a call on the Cortex-M4F and the Cortex-M0.
    instructions: [Option<u64>; 2],
}

/// Makes the front; `counted` are the firmware's rows of the same run, else tiers are counted here.
pub fn run(setting: &Setting<'_>, counted: Option<&[Priced]>) -> Result<Finding, String> {
    let (own, obstacle) = match counted {
        Some(_) => (Vec::new(), None),
        None => instructions::count(setting.quick)?,
    };
    let counted = counted.unwrap_or(&own);
    let inputs = Inputs::new(mix::pairs(SEED));
    let methods = all_methods()?;
    let errors: Vec<Errors> = methods.iter().map(|m| judge(m, &inputs)).collect();
    let n = trapezoid_at(TRAPEZOID_ERROR, &inputs.thinned(SLOW_STRIDE));
    let rounds = if setting.quick { QUICK_ROUNDS } else { ROUNDS };
    let samples = measure(&methods, &Inputs::new(mix::long_pairs(SEED)), n, rounds)?;

    let timed = methods.into_iter().zip(errors).zip(samples.medians());
    let row = |((method, errors), seconds)| Row {
        instructions: instructions::of(&method, counted),
        method,
        errors,
        nanoseconds: 1e9 * seconds,
    };
    let rows: Vec<Row> = timed.map(row).collect();
    let sheet = sheet(&rows, rounds);
    setting.table("kernel", &sheet)?;
    let drawn = draw_targets(setting.out, &rows)?;
    let drawn = drawn.map_or(String::new(), |name| {
        format!("![Instructions against error]({name})\n\n")
    });
    let missing = match obstacle {
        Some(reason) => format!("Instructions are not measured: {reason}.\n\n"),
        None => String::new(),
    };
    let body = format!(
        "![Time against error]({PICTURE})\n\n{drawn}{missing}{}\n{}",
        sheet.markdown(),
        ratios(&samples, n)
    );
    setting.page(Front::Kernel, &body)?;
    draw(setting.out, &rows)?;
    Ok(Finding {
        line: line(&rows, &samples),
        picture: PICTURE,
    })
}

/// Summary of the front.
fn line(rows: &[Row], samples: &Samples) -> String {
    let of = |name: &str| rows.iter().find(|row| row.method.name == name);
    let error = |name| short(of(name).map_or(f64::NAN, |row| row.errors.relative()));
    let time = |name| short(of(name).map_or(f64::NAN, |row| row.nanoseconds));
    let ratio = |name| short(samples.ratio(name, "form").unwrap_or(f64::NAN));
    let [fast, small] = of("form f32").map_or([None; 2], |row| row.instructions);
    let told = |count: Option<u64>| count.map_or("(not measured)".into(), |n| n.to_string());
    format!(
        "The form gives force and torque with a relative error of {} in {} ns here (f32: {} in {} ns, \
         {} instructions on a Cortex-M4F, {} on an M0); an AGM as usual takes {} times as long, \
         quadrature {}.",
        error("form"),
        time("form"),
        error("form f32"),
        time("form f32"),
        told(fast),
        told(small),
        ratio("agm"),
        ratio("quadrature"),
    )
}

/// Time against the larger relative error of force and torque, α = 0.
fn draw(out: &Path, rows: &[Row]) -> Result<(), String> {
    let places = rows
        .iter()
        .filter(|row| row.method.alpha == 0.0)
        .map(|row| PicturePoint {
            label: row.method.name.clone(),
            group: row.method.kind.name().into(),
            at: (row.nanoseconds, row.errors.relative()),
        });
    let axes = ["time per pair [ns]", "largest relative error of F and T"];
    picture::scatter(
        out,
        "kernel",
        "Speed against error, α = 0",
        axes,
        places.collect(),
    )
}

/// Instructions against the same error, by target and precision; the picture's name, if there is
/// something to draw.
fn draw_targets(out: &Path, rows: &[Row]) -> Result<Option<&'static str>, String> {
    let places = rows.iter().flat_map(|row| {
        let place = |(count, target): (Option<u64>, &str)| {
            Some(PicturePoint {
                label: row.method.name.clone(),
                group: format!("{target}, {}", row.method.precision()),
                at: (count? as f64, row.errors.relative()),
            })
        };
        let targets = row
            .instructions
            .into_iter()
            .zip(["Cortex-M4F", "Cortex-M0"]);
        targets.filter_map(place).collect::<Vec<_>>()
    });
    let places: Vec<PicturePoint> = places.collect();
    if places.is_empty() {
        return Ok(None);
    }
    let axes = [
        "instructions of a call, mean",
        "largest relative error of F and T",
    ];
    let title = "Tiers on microcontrollers";
    picture::scatter(out, "kernel_targets", title, axes, places)?;
    Ok(Some(TARGETS_PICTURE))
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

fn contact<R: tribos_core::Real>(pairs: &[[f64; 2]]) -> Result<Contact<R, CoulombDisk>, String> {
    Contact::new(CoulombDisk, pairs, SEED).map_err(|error| error.to_string())
}

fn sweep<R: tribos_core::Real>(contact: &mut Contact<R, CoulombDisk>, single: bool) {
    std::hint::black_box(if single {
        contact.one_by_one()
    } else {
        contact.batch()
    });
}

/// The table of the front.
fn sheet(rows: &[Row], rounds: usize) -> Sheet {
    let counted = |count: Option<u64>| count.map_or("-".into(), |count| count.to_string());
    // Absolute errors have a scale of their own for every other exponent.
    let absolute = |row: &Row, error: f64| match row.method.alpha {
        0.0 => short(error),
        _ => "-".into(),
    };
    Sheet::of(
        format!(
            "Force and torque of the uniform disk: median of {rounds} interleaved rounds and \
             largest errors over the mix of 3800 velocity ratios (integration: every 100th); M4F and \
             M0: mean instructions of a call over the 256 inputs of the firmware front, - where not \
             counted"
        ),
        rows,
        &[
            ("method", &|row| row.method.name.clone()),
            ("kind", &|row| row.method.kind.name().into()),
            ("type", &|row| row.method.precision().into()),
            ("alpha", &|row| row.method.alpha.to_string()),
            ("ns", &|row| short(row.nanoseconds)),
            ("M4F", &|row| counted(row.instructions[0])),
            ("M0", &|row| counted(row.instructions[1])),
            ("rel F", &|row| short(row.errors.relative_force)),
            ("rel T", &|row| short(row.errors.relative_torque)),
            ("abs F", &|row| absolute(row, row.errors.absolute_force)),
            ("abs T/T0", &|row| absolute(row, row.errors.absolute_torque)),
        ],
    )
}

/// The ratios that matter, each the median of the rounds' own ratios.
fn ratios(samples: &Samples, n: usize) -> String {
    let ratio = |above: &str, below: &str| samples.ratio(above, below).unwrap_or(f64::NAN);
    let agm = ratio("form", "agm").max(ratio("form", "agm libm"));
    let bare = |alpha: &f64| ratio(&format!("table alpha {alpha} unscaled"), "form");
    let costs: Vec<f64> = catalogue::EXPONENTS.iter().map(bare).chain([1.0]).collect();
    let slowest = costs.iter().copied().fold(0.0, f64::max);
    let quickest = costs.iter().copied().fold(f64::INFINITY, f64::min);
    let trapezoid = ratio(TRAPEZOID_TASK, "form");
    let lines = [
        ("form / quicker AGM".into(), agm),
        ("form / Bulirsch".into(), ratio("form", "bulirsch")),
        (
            format!("trapezoid {n} (error 1e-3), root at every node / form"),
            trapezoid,
        ),
        (
            format!("trapezoid {n} (error 1e-3), power at every node / form"),
            ratio(GENERAL_TASK, "form"),
        ),
        ("form f64 / f32".into(), ratio("form", "form f32")),
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
            ratio("table alpha 0.5", "form"),
        ),
        (
            "alpha 1.5 with power / Coulomb".into(),
            ratio("table alpha 1.5", "form"),
        ),
    ];
    let line = |(name, value): &(String, f64)| format!("- {name}: {}\n", short(*value));
    lines.iter().map(line).collect()
}
