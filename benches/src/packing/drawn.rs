//! Pictures of the contact front.

use super::ladder::Rung;
use super::scaling::{self, Point};
use super::work::{METHODS, Work};
use std::path::Path;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};
use tribos_report::image::{Drawing, write_both};

/// Size of a panel in pixels.
const PANEL: (u32, u32) = (640, 460);
/// Residual whose work is drawn against size.
const TARGET: f64 = 1e-6;

/// Reads sweeps or time.
type Cost = fn(&Work) -> f64;

/// Residual against sweeps and against time, a row a problem; plain sweeps after fixed numbers.
pub fn residuals(folder: &Path, rungs: &[Rung]) -> Result<(), String> {
    let mut problems: Vec<_> = rungs.iter().map(|rung| rung.problem).collect();
    problems.dedup();
    let costs: [(&str, Cost); 2] = [
        ("sweeps", |work| work.sweeps as f64),
        ("time [ms]", |work| 1e3 * work.seconds),
    ];
    let mut panels = Panels::new("Residual against work, cold starts", 2).cell(PANEL.0, PANEL.1);
    for problem in problems {
        for (label, cost) in costs {
            let axes = (Axis::log10(label), Axis::log10("relative residual"));
            let mut figure = Figure::new(problem, axes.0, axes.1).legend(Legend::Below);
            for method in METHODS {
                let of_line = |rung: &&Rung| {
                    let drawn = rung.rule.starts_with("N =") || rung.rule.starts_with("change");
                    rung.problem == problem && rung.method == method && drawn
                };
                let points = rungs.iter().filter(of_line);
                let points = points.map(|rung| (cost(&rung.work), rung.work.residual));
                figure = figure.series(Series::line_points(method.name(), points.collect()));
            }
            panels = panels.figure(figure);
        }
    }
    write(folder, "contacts_residual", &panels)
}

/// Sweeps against size, a panel a family.
pub fn sizes(folder: &Path, points: &[Point]) -> Result<(), String> {
    let mut families: Vec<&str> = Vec::new();
    for point in points {
        if !families.contains(&point.family) {
            families.push(point.family);
        }
    }
    let title = format!("Sweeps to a residual of {TARGET:.0e}");
    let mut panels = Panels::new(title, 2).cell(PANEL.0, PANEL.1);
    for family in families {
        let axes = (Axis::log10("L/d"), Axis::log10("sweeps"));
        let mut figure = Figure::new(family, axes.0, axes.1).legend(Legend::Below);
        for method in scaling::METHODS {
            let of_line = |point: &&Point| {
                point.family == family && point.method == method && point.target == TARGET
            };
            let line = points.iter().filter(of_line);
            let line = line.map(|point| (point.length, point.work.sweeps as f64));
            figure = figure.series(Series::line_points(method.name(), line.collect()));
        }
        panels = panels.figure(figure);
    }
    write(folder, "contacts_scaling", &panels)
}

fn write(folder: &Path, stem: &str, drawing: &dyn Drawing) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    let written = write_both(folder, stem, drawing);
    written.map(|_| ()).map_err(|error| error.to_string())
}
