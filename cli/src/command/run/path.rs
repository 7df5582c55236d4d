//! Bodies that slide along a path in the plane.

use super::files;
use super::request::RunRequest;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::record::write_series;
use tribos::slide::planar::PlanarStopReason;
use tribos::slide::{PATH_COLUMNS, PathRun, PlanarScene, follow_path};
use tribos_report::figure::{Axis, Figure, Series};

/// Runs the scene and writes its results into the folder.
pub fn run(scene: &dyn PlanarScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    let out = order.out;
    order.caller.watch()?;
    let mut meter = order.caller.meter();
    let result = follow_path(scene, &mut |done| {
        if meter.is_due(done) {
            meter.tell(done, format_args!("sliding"));
        }
        !order.caller.is_asked()
    })?;
    let folder = order.begin(scene.json(), files::PATH)?;
    let rows = result
        .series
        .iter()
        .map(<[f64; PATH_COLUMNS.len()]>::as_slice);
    write_series(&out.join("series.csv"), &PATH_COLUMNS, rows)?;
    order.draw("path", || Ok(figure(scene, &result)))?;
    folder.seal(&["series.csv"])?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", result.outcome.json(scene));
    folder.write("summary.json", summary.as_bytes())?;
    report(&result, order)
}

/// A few lines for the person at the terminal.
fn report(result: &PathRun, order: &RunRequest<'_>) -> Result<(), Failure> {
    let arrival = &result.outcome.arrival;
    let [x, y] = arrival.point.position.map(shown);
    let ending = match arrival.ending {
        PlanarStopReason::Rest => "Rest",
        PlanarStopReason::Faded => "Faded",
    };
    let lean = match arrival.tips_at {
        Some(time) => format!(
            "lean          held at its limit from {} s on\n",
            shown(time)
        ),
        None if arrival.most_lean == 0.0 => String::new(),
        None => {
            let most = shown(arrival.most_lean);
            format!("lean          at most {most} of its limit\n")
        }
    };
    order.caller.report(&format!(
        "ending        {ending} after {} steps\n\
         time          {} s\n\
         forward       {x} m\n\
         curl          {y} m, to the left if positive\n\
         angle         {} rad\n\
         final ratio   {}\n\
         {lean}\
         energy error  {:.1e} of the initial energy\n\
         written to    {}\n",
        arrival.steps,
        shown(arrival.point.time),
        shown(arrival.point.angle),
        shown(arrival.point.ratio),
        result.outcome.energy_error,
        order.out.display()
    ))
}

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
fn figure(scene: &dyn PlanarScene, result: &PathRun) -> Figure {
    let visible = |length: f64| {
        if length.abs() < INVISIBLE {
            0.0
        } else {
            length
        }
    };
    let points: Vec<(f64, f64)> = result
        .series
        .iter()
        .map(|row| (visible(row[1]), visible(row[2])))
        .collect();
    let xs = span(points.iter().map(|point| point.0));
    let ys = span(points.iter().map(|point| point.1));
    let (long, across) = (xs[1] - xs[0], ys[1] - ys[0]);
    let direction = if scene.course().spin < 0.0 {
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
