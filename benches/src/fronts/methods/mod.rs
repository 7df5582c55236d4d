//! Events, contact dynamics and soft particles on problems with known answers: error against time.

mod beside;
mod cases;

use super::{Finding, Front, Setting};
use crate::clock::Clock;
use crate::written::{self, Sheet, short};
use cases::{Case, cases};
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};
use tribos_trials::Method;

const PICTURE: &str = "methods.svg";
/// Size of a panel in pixels.
const PANEL: (u32, u32) = (560, 420);
/// A row is repeated until it has taken this long, in s, but not more often than this.
const ENOUGH: f64 = 0.05;
const MOST_ROUNDS: usize = 25;
/// Names of the methods with steps.
const RIGID: &str = "contact dynamics";
const SOFT: &str = "soft particles";
/// Errors below rounding are drawn at it.
const ROUNDING: f64 = 1e-16;

/// One method on one trial.
struct Row {
    method: Method,
    errors: Vec<f64>,
    updates: f64,
    seconds: f64,
}

/// A trial and its rows.
struct MethodScore {
    case: Case,
    rows: Vec<Row>,
}

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let one = one.map_err(|error| error.to_string())?;
    let quick = setting.quick;
    let all = one.install(|| {
        let all = cases(quick)?.into_iter();
        all.map(judged).collect::<Result<Vec<_>, String>>()
    })?;
    setting.table("methods", &whole(&all))?;
    let mut body = format!("![Error against time]({PICTURE})\n\n{LEGEND}");
    for MethodScore { case, rows } in &all {
        body += &format!("\n## {}\n\n{}", case.title, sheet(case, rows).markdown());
    }
    if let Some(table) = beside::table(setting.out) {
        body += &format!("\n## LAMMPS, measured beside\n\n{table}");
    }
    setting.page(Front::Methods, &body)?;
    draw(setting, &all)?;
    Ok(Finding {
        line: line(&all),
        picture: PICTURE,
    })
}

/// What the columns mean.
const LEGEND: &str = "\
Units: radius, mass and weight of a sphere are 1, so times are in √(R/g); gas: R, m and T₀; deposit: R and F_coh. \
`CPU` is in milliseconds, the least of up to 25 runs on one thread; `x` is that over the row marked 1 of the same \
trial. `updates` are updates of contacts (contacts times sweeps, or contacts times steps), collisions of events, \
spheres moved in a gas, steps of a deposit. Contact dynamics sweeps with momentum from the forces of the last step, \
soft particles have ζ = 1 but in the gas and steps of 0.6 of the longest stable one where nothing else is said.
";

/// Runs all methods of a case.
fn judged(case: Case) -> Result<MethodScore, String> {
    let told = |error: &dyn std::fmt::Display| format!("{}: {error}", case.title);
    let mut rows = Vec::new();
    for &method in &case.methods {
        let (mut least, mut total, mut found) = (f64::INFINITY, 0.0, None);
        for _ in 0..MOST_ROUNDS {
            let ready = case.trial.ready(method).map_err(|error| told(&error))?;
            let clock = Clock::start();
            let result = ready().map_err(|error| told(&error))?;
            let seconds = clock.seconds();
            least = least.min(seconds);
            total += seconds;
            found = Some(result);
            if total > ENOUGH {
                break;
            }
        }
        let found = found.ok_or("no run")?;
        rows.push(Row {
            method,
            errors: found.errors,
            updates: found.updates,
            seconds: least,
        });
    }
    Ok(MethodScore { case, rows })
}

/// Time over that of the row with which all are compared.
fn ratio(case: &Case, rows: &[Row], row: &Row) -> f64 {
    let unit = rows.iter().find(|other| other.method == case.unit);
    row.seconds / unit.map_or(f64::NAN, |unit| unit.seconds)
}

/// The table of a trial.
fn sheet(case: &Case, rows: &[Row]) -> Sheet {
    let mut header = vec!["method", "parameters"];
    header.extend(case.trial.quantities());
    header.extend(["updates", "CPU", "x"]);
    let line = |row: &Row| {
        let mut cells = vec![row.method.name().into(), row.method.to_string()];
        cells.extend(row.errors.iter().map(|error| short(*error)));
        cells.push(short(row.updates));
        cells.push(short(1e3 * row.seconds));
        cells.push(short(ratio(case, rows, row)));
        cells
    };
    Sheet {
        about: case.about.clone(),
        header,
        rows: rows.iter().map(line).collect(),
    }
}

/// All trials in one table.
fn whole(all: &[MethodScore]) -> Sheet {
    let lines = all.iter().flat_map(|score| {
        score.rows.iter().flat_map(move |row| {
            let quantities = score.case.trial.quantities().iter().zip(&row.errors);
            quantities.map(move |(quantity, error)| (score, row, *quantity, *error))
        })
    });
    Sheet::of(
        "Events, contact dynamics and soft particles against known answers",
        lines,
        &[
            ("trial", &|(score, ..)| score.case.stem.into()),
            ("method", &|(_, row, ..)| row.method.name().into()),
            ("parameters", &|(_, row, ..)| row.method.to_string()),
            ("quantity", &|(.., quantity, _)| (*quantity).into()),
            ("error", &|(.., error)| format!("{error:e}")),
            ("updates", &|(_, row, ..)| format!("{:e}", row.updates)),
            ("cpu_s", &|(_, row, ..)| format!("{:e}", row.seconds)),
            ("x", &|(score, row, ..)| {
                format!("{:.4}", ratio(&score.case, &score.rows, row))
            }),
        ],
    )
}

/// Error over time, a panel a trial.
fn draw(setting: &Setting<'_>, all: &[MethodScore]) -> Result<(), String> {
    let mut panels = Panels::new("Error against time", 2).cell(PANEL.0, PANEL.1);
    for MethodScore { case, rows } in all {
        let quantity = case.trial.quantities()[case.drawn];
        let mut figure = Figure::new(
            case.title.clone(),
            Axis::log10("CPU time [row marked 1]"),
            Axis::log10(quantity),
        )
        .legend(Legend::Below);
        for method in ["events", RIGID, SOFT] {
            let of = rows.iter().filter(|row| row.method.name() == method);
            let place = |row: &Row| (ratio(case, rows, row), row.errors[case.drawn].max(ROUNDING));
            let points: Vec<(f64, f64)> = of.map(place).collect();
            if !points.is_empty() {
                figure = figure.series(Series::points(method, points));
            }
        }
        panels = panels.figure(figure);
    }
    let svg = panels.svg().map_err(|error| error.to_string())?;
    written::write(setting.out, PICTURE, &svg)
}

/// What soft particles cost for the error of the row marked 1, and what a gas costs without events.
fn line(all: &[MethodScore]) -> String {
    let gas = |judged: &&MethodScore| judged.case.unit == Method::Events;
    let lasting: Vec<String> = all
        .iter()
        .filter(|judged| !gas(judged))
        .map(lasting)
        .collect();
    let gases: Vec<String> = all.iter().filter(gas).map(cooling).collect();
    format!(
        "CPU time of soft particles over that of contact dynamics for the same error: {}. Over that of events: {}.",
        lasting.join("; "),
        gases.join("; ")
    )
}

/// The cheapest soft particles that are as good as the row marked 1.
fn lasting(MethodScore { case, rows }: &MethodScore) -> String {
    let error = |row: &Row| row.errors[case.drawn];
    let unit = rows.iter().find(|row| row.method == case.unit);
    let wanted = unit.map_or(f64::NAN, error).max(ROUNDING);
    let soft = || rows.iter().filter(|row| row.method.name() == SOFT);
    let good = soft().filter(|row| error(row) <= wanted);
    let cost = good.map(|row| ratio(case, rows, row));
    let cost = cost.fold(f64::INFINITY, f64::min);
    let least = soft().map(error).fold(f64::INFINITY, f64::min);
    let (name, wanted) = (case.stem, short(wanted));
    if cost.is_finite() {
        format!("{name} ({wanted}) {}", short(cost))
    } else {
        format!("{name} ({wanted}) not reached, {} at best", short(least))
    }
}

/// The cheapest rows of the methods with steps.
fn cooling(MethodScore { case, rows }: &MethodScore) -> String {
    let cost = |name| {
        let of = rows.iter().filter(|row| row.method.name() == name);
        let costs = of.map(|row| ratio(case, rows, row));
        short(costs.fold(f64::INFINITY, f64::min))
    };
    format!(
        "{}, contact dynamics {} and soft particles {} at least",
        case.stem,
        cost(RIGID),
        cost(SOFT)
    )
}
