//! The path with its frames, the speed over time, and what is left.

use tribos::fit::track::TrackFit;
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};

const WIDTH: u32 = 900;
const HEIGHT: u32 = 320;
/// Degrees in a radian.
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// The panels of a fit.
pub fn panels(fit: &TrackFit) -> Panels {
    let panels = Panels::new("Filmed and fitted motion", 1)
        .cell(WIDTH, HEIGHT)
        .figure(path(fit))
        .figure(speed(fit))
        .figure(residuals(fit));
    match turn(fit) {
        Some(turn) => panels.figure(turn),
        None => panels,
    }
}

fn pairs(x: &[f64], y: &[f64], scale: f64) -> Vec<(f64, f64)> {
    x.iter().zip(y).map(|(x, y)| (*x, scale * y)).collect()
}

/// A part of the residuals: x, y or angle.
fn part(fit: &TrackFit, index: usize) -> &[f64] {
    fit.residuals
        .chunks(fit.frames.max(1))
        .nth(index)
        .unwrap_or_default()
}

fn path(fit: &TrackFit) -> Figure {
    let (x, y) = (fit.track.x(), fit.track.y());
    let fitted = (0..fit.frames).filter_map(|i| {
        let at = |values: &[f64], left: &[f64]| Some(values.get(i)? - left.get(i)?);
        at(x, part(fit, 0)).zip(at(y, part(fit, 1)))
    });
    let dropped = fit
        .dropped
        .iter()
        .filter_map(|&i| x.get(i).copied().zip(y.get(i).copied()));
    let dropped: Vec<(f64, f64)> = dropped.collect();
    let figure = Figure::new("", Axis::linear("x [m]"), Axis::linear("y [m]"))
        .series(Series::points("frames", pairs(x, y, 1.0)))
        .series(Series::line("fitted", fitted.collect()));
    if dropped.is_empty() {
        figure
    } else {
        figure.series(Series::points("left out", dropped))
    }
}

/// The fitted speed, and differences of the frames.
fn speed(fit: &TrackFit) -> Figure {
    let (t, x, y) = (fit.track.times(), fit.track.x(), fit.track.y());
    let used: Vec<usize> = (0..fit.frames)
        .filter(|i| !fit.dropped.contains(i))
        .collect();
    let differences = used.windows(3).filter_map(|three| {
        let [before, _, after] = *three else {
            return None;
        };
        let over = |values: &[f64]| Some(values.get(after)? - values.get(before)?);
        let (dt, dx, dy) = (over(t)?, over(x)?, over(y)?);
        Some((t.get(before)? + 0.5 * dt, dx.hypot(dy) / dt))
    });
    Figure::new("", Axis::linear("time [s]"), Axis::linear("speed [m/s]"))
        .series(Series::points(
            "differences of frames",
            differences.collect(),
        ))
        .series(Series::line("fitted", pairs(t, &fit.speeds, 1.0)))
}

fn residuals(fit: &TrackFit) -> Figure {
    const MILLIMETRES: f64 = 1e3;
    let t = fit.track.times();
    Figure::new(
        "",
        Axis::linear("time [s]"),
        Axis::linear("filmed − fitted [mm]"),
    )
    .series(Series::points("x", pairs(t, part(fit, 0), MILLIMETRES)))
    .series(Series::points("y", pairs(t, part(fit, 1), MILLIMETRES)))
    .guide(ReferenceLine::horizontal(0.0, ""))
}

fn turn(fit: &TrackFit) -> Option<Figure> {
    fit.track.angle()?;
    let left = pairs(fit.track.times(), part(fit, 2), DEGREES);
    let figure = Figure::new(
        "",
        Axis::linear("time [s]"),
        Axis::linear("angle, filmed − fitted [deg]"),
    );
    let figure = figure.series(Series::points("", left));
    Some(figure.guide(ReferenceLine::horizontal(0.0, "")))
}
