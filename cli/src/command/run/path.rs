//! The picture of a path in the plane.

use serde_json::Value;
use tribos::motion::MotionRun;
use tribos_report::figure::{Axis, Figure, Series};

/// Width of the figure, and what frame and labels take of both sides, in pixels.
const WIDTH: f64 = 900.0;
const FRAME: [f64; 2] = [100.0, 105.0];
/// Bounds of the height.
const HEIGHTS: [f64; 2] = [360.0, 900.0];
/// Paths flatter than this are stretched across.
const FLAT: f64 = 0.15;
/// Lengths too small for an axis, in m.
const INVISIBLE: f64 = 1e-200;
/// Free part of a span at each end.
const MARGIN: f64 = 0.06;

/// The path, in equal scales unless it is very flat.
pub fn figure(summary: &Value, run: &MotionRun) -> Figure {
    let visible = |length: f64| {
        if length.abs() < INVISIBLE {
            0.0
        } else {
            length
        }
    };
    let points: Vec<(f64, f64)> = run
        .rows
        .iter()
        .map(|row| (visible(row[1]), visible(row[2])))
        .collect();
    let xs = span(points.iter().map(|point| point.0));
    let ys = span(points.iter().map(|point| point.1));
    let (long, across) = (xs[1] - xs[0], ys[1] - ys[0]);
    let spin = summary["scene"]["spin"].as_f64();
    let direction = if spin.is_some_and(|spin| spin < 0.0) {
        "clockwise"
    } else {
        "counterclockwise"
    };
    let title = format!("Path of a body that spins {direction}");
    let axes = [Axis::linear("forward [m]"), Axis::linear("to the left [m]")];
    let [x, y] = axes;
    if across < FLAT * long || long == 0.0 {
        return Figure::new(format!("{title} (scales differ)"), x, y)
            .series(Series::line("", points));
    }
    // Equal scales: the picture's shape follows the path, what is left over goes to the margins.
    let wide = WIDTH - FRAME[0];
    let high = (wide * across / long + FRAME[1]).clamp(HEIGHTS[0], HEIGHTS[1]) - FRAME[1];
    let scale = (long / wide).max(across / high) * (1.0 + 2.0 * MARGIN);
    let around = |[low, high]: [f64; 2], pixels: f64| {
        let (middle, half) = (0.5 * (low + high), 0.5 * pixels * scale);
        [middle - half, middle + half]
    };
    let ([x0, x1], [y0, y1]) = (around(xs, wide), around(ys, high));
    Figure::new(title, x.range(x0, x1), y.range(y0, y1))
        .series(Series::line("", points))
        .size(WIDTH as u32, (high + FRAME[1]) as u32)
}

fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}
