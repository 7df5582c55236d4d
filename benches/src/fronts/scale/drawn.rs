//! Pictures of the scale front.

use super::THREADS;
use super::packing::Order;
use super::sweeps::{ALL_MODES, Point, weak};
use std::path::Path;
use tribos_report::figure::{Axis, Figure, Legend, Panels, ReferenceLine, Series};
use tribos_report::image::write_both;

/// Size of a panel in pixels.
const PANEL: (u32, u32) = (640, 460);

/// Reads the time of an update.
type Seconds = fn(&Point) -> f64;

/// Contacts a second and the gain of two threads over the number of spheres, with all six modes.
pub fn scales(folder: &Path, stem: &str, points: &[Point], copied: f64) -> Result<(), String> {
    let panels = Panels::new("Sweeps with all six modes", 2)
        .cell(PANEL.0, PANEL.1)
        .figure(speeds(points, copied))
        .figure(gains(points));
    std::fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    let written = write_both(folder, stem, &panels);
    written.map(|_| ()).map_err(|error| error.to_string())
}

/// Lines of an order and a way: their name, and their points.
fn lines(points: &[Point]) -> Vec<(String, Vec<&Point>)> {
    let mut ways: Vec<&str> = points.iter().map(|point| point.way).collect();
    ways.sort_unstable();
    ways.dedup();
    let mut lines = Vec::new();
    for order in Order::ALL {
        for way in &ways {
            let of_line = |point: &&Point| {
                point.modes == ALL_MODES && point.order == order && point.way == *way
            };
            let name = format!("{}, {way}", order.name());
            lines.push((name, points.iter().filter(of_line).collect()));
        }
    }
    lines
}

/// Contacts a second, and as many as a copy would read and write back.
fn speeds(points: &[Point], copied: f64) -> Figure {
    let axes = (Axis::log10("spheres"), Axis::log10("million contacts/s"));
    let mut figure = Figure::new("Contacts a second", axes.0, axes.1).legend(Legend::Below);
    for (name, line) in lines(points) {
        let times: [(usize, Seconds); 2] = [
            (THREADS[0], |point| point.processor),
            (THREADS[1], |point| point.day[1]),
        ];
        for (threads, seconds) in times {
            let speed = |point: &&Point| (point.spheres as f64, 1e-6 / seconds(point));
            let name = format!("{name}, threads: {threads}");
            figure = figure.series(Series::line_points(name, line.iter().map(speed).collect()));
        }
    }
    let bytes = points.iter().find(|point| point.modes == ALL_MODES);
    match bytes.map(|point| point.bytes as f64) {
        Some(bytes) => {
            let roof = 1e-6 * copied / (2.0 * bytes);
            figure.guide(ReferenceLine::horizontal(
                roof,
                "copy of the contacts, one thread",
            ))
        }
        None => figure,
    }
}

/// Strong and weak scaling.
fn gains(points: &[Point]) -> Figure {
    let axes = (Axis::log10("spheres"), Axis::linear("two threads over one"));
    let mut figure = Figure::new("Strong scaling, and weak scaling times two", axes.0, axes.1)
        .legend(Legend::Below);
    for (name, line) in lines(points) {
        let at = |point: &Point, gain: f64| (point.spheres as f64, gain);
        let strong = line
            .iter()
            .map(|point| at(point, point.speedup()))
            .collect();
        let double = |point: &&Point| Some(at(point, 2.0 * weak(points, point)?));
        let double: Vec<(f64, f64)> = line.iter().filter_map(double).collect();
        figure = figure
            .series(Series::line_points(format!("{name}, strong"), strong))
            .series(Series::line_points(format!("{name}, weak"), double));
    }
    figure
}
