//! `tribos fit --support`: the pressure under a foot from measured pushes.

use crate::command::digits::shown;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::Path;
use tribos::fit::FitError;
use tribos::fit::support::{MeasuredPush, SupportFit};
use tribos::friction::Patch;
use tribos::record::{LogOptions, Rows, write_atomically, write_series};
use tribos::run::folder::{Contents, OutputFolder};
use tribos_core::twist::{Twist, Wrench};
use tribos_report::figure::{Axis, Figure, Legend, Series};
use tribos_report::image;

const COLUMNS: [&str; 6] = ["dx", "dy", "dtheta", "fx", "fy", "torque"];
const FILES: [&str; 4] = [
    "pressure.csv",
    "pressure.svg",
    "pressure.png",
    "summary.json",
];
/// Shares of the load that are drawn alike, in percent, from the largest down.
const CLASSES: [(f64, &str); 3] = [(5.0, "5 % and more"), (1.0, "1 to 5 %"), (0.0, "below 1 %")];
/// Room around the picture, of its side.
const MARGIN: f64 = 0.08;
/// Side of the picture, in pixels.
const SIDE: u32 = 700;
/// Room of its legend.
const LEGEND: u32 = 60;

/// Fits, writes and prints.
pub fn execute(
    file: &Path,
    options: &LogOptions,
    patch: Option<&Patch>,
    out: Option<&Path>,
) -> Result<(), Failure> {
    let (pushes, refusals) = read(file, options)?;
    let fit = SupportFit::new(&pushes, patch).map_err(|error| match error {
        FitError::Push { push, message } => refusals(push, &message),
        FitError::Pushes(message) => Failure::input(format!("{}: {message}", file.display())),
        FitError::Support(refusal) => refusal.into(),
        other => Failure::input(other),
    })?;
    if let Some(out) = out {
        let _folder = OutputFolder::begin(out, &Contents::of("fit", &FILES))?;
        image::write_both(out, "pressure", &figure(&fit))?;
        let rows: Vec<[f64; 3]> = shares(&fit).collect();
        let rows = rows.iter().map(<[f64; 3]>::as_slice);
        write_series(&out.join("pressure.csv"), &["x", "y", "share"], rows)?;
        let summary = format!("{:#}\n", summary(&fit, pushes.len()));
        write_atomically(&out.join("summary.json"), summary.as_bytes())?;
    }
    crate::command::print(&text(&fit, pushes.len()))?;
    match out {
        Some(out) => crate::command::print(&format!("written to    {}\n", out.display())),
        None => Ok(()),
    }
}

/// The pushes of a file, and the refusal of one of them.
#[expect(clippy::type_complexity, reason = "a list and what to say of it")]
fn read(
    file: &Path,
    options: &LogOptions,
) -> Result<(Vec<MeasuredPush>, impl Fn(usize, &str) -> Failure + use<>), Failure> {
    let mut rows = Rows::with_options(file, options, |_| &COLUMNS)?;
    let (mut pushes, mut lines, mut row) = (Vec::new(), Vec::new(), [0.0; 6]);
    while let Some(line) = rows.next(&mut row)? {
        let [dx, dy, turn, fx, fy, torque] = row;
        let (motion, wrench) = (Twist::new(dx, dy, turn), Wrench::new(fx, fy, torque));
        pushes.push(MeasuredPush { motion, wrench });
        lines.push(line);
    }
    let name = file.display().to_string();
    let refusal = move |push: usize, message: &str| {
        let line = lines.get(push).copied().unwrap_or_default();
        Failure::input(format!("{name}:{line}: {message}"))
    };
    Ok((pushes, refusal))
}

/// Place and share of the load of every point.
fn shares(fit: &SupportFit) -> impl Iterator<Item = [f64; 3]> + '_ {
    let share = |weight: f64| weight / fit.force_limit;
    fit.pressure
        .iter()
        .map(move |node| [node.x, node.y, share(node.weight)])
}

fn summary(fit: &SupportFit, pushes: usize) -> Value {
    let models = fit.models.iter().map(|score| {
        json!({
            "name": score.name,
            "median_angle_deg": score.median,
            "mean_angle_deg": score.mean,
        })
    });
    json!({
        "pushes": pushes,
        "models": models.collect::<Vec<_>>(),
        "centre_of_pressure": fit.centre_of_pressure,
        "force_limit": fit.force_limit,
        "length": fit.length,
        "points": fit.pressure.len(),
        "version": env!("CARGO_PKG_VERSION"),
    })
}

fn text(fit: &SupportFit, pushes: usize) -> String {
    let [x, y] = fit.centre_of_pressure.map(|x| shown(1e3 * x));
    let mut text = format!(
        "pushes        {pushes}\n\
         pressure      centre at ({x}, {y}) mm, on {} points; force limit {} N\n\
         length        {} mm, by which spins are multiplied in angles\n\
         model         median and mean angle between foretold and measured motion [deg]\n",
        fit.pressure.len(),
        shown(fit.force_limit),
        shown(1e3 * fit.length),
    );
    for score in &fit.models {
        let how = match score.name {
            "known" => "the given support under uniform pressure or with its weights, no fit",
            _ => "fitted, cross-validated in 5 parts",
        };
        let (median, mean) = (score.median, score.mean);
        text += &format!("  {:<11} {median:6.2} {mean:6.2}   {how}\n", score.name);
    }
    text
}

/// Points by their share of the load, and the centre of pressure.
fn figure(fit: &SupportFit) -> Figure {
    let millimetres = |x: f64| 1e3 * x;
    let [x, y] = fit.centre_of_pressure.map(millimetres);
    let reach = shares(fit)
        .flat_map(|[x, y, _]| [x, y])
        .fold(0.0, |most: f64, x| most.max(millimetres(x).abs()));
    let half = reach * (1.0 + MARGIN);
    let axis = |name: &str| Axis::linear(format!("{name} [mm]")).range(-half, half);
    let mut figure = Figure::new("Pressure from pushes", axis("x"), axis("y"))
        .legend(Legend::Below)
        .size(SIDE, SIDE + LEGEND);
    let mut above = f64::INFINITY;
    for (least, label) in CLASSES {
        let is_mine = |share: f64| 100.0 * share >= least && 100.0 * share < above;
        let points = shares(fit).filter(|[.., share]| is_mine(*share));
        let points = points.map(|[x, y, _]| (millimetres(x), millimetres(y)));
        figure = figure.series(Series::points(label, points.collect()));
        above = least;
    }
    figure.series(Series::points("centre of pressure", vec![(x, y)]))
}
