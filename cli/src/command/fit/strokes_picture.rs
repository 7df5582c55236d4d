//! Friction over strokes, and the loop of the last two.

use tribos::fit::strokes::{Stroke, StrokeRecord, Strokes};
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};

/// Most strokes and most rows of a loop that are drawn: more of them hide each other.
const MOST_STROKES: usize = 1000;
const MOST_ROWS: usize = 4000;
/// Metres in millimetres.
const MILLI: f64 = 1e3;

/// Mean friction with its scatter and the static peaks above, friction over the way below.
pub fn panels(record: &StrokeRecord, found: &Strokes) -> Panels {
    Panels::new("Friction, stroke by stroke", 1)
        .cell(900, 380)
        .figure(over_strokes(found))
        .figure(last_loop(record, found))
}

fn over_strokes(found: &Strokes) -> Figure {
    let step = found.strokes.len().div_ceil(MOST_STROKES).max(1);
    let drawn = || found.strokes.iter().step_by(step);
    let means = drawn().map(|stroke| (stroke.number as f64, stroke.mean));
    let scatter = drawn().map(|stroke| stroke.deviation);
    let peaks = drawn().filter_map(|s| Some((s.number as f64, s.static_peak?.value)));
    let figure = Figure::new("", Axis::linear("stroke"), Axis::linear("friction"))
        .series(Series::points("mean, scatter within", means.collect()).errors(scatter.collect()))
        .series(Series::points("static peak", peaks.collect()))
        .guide(ReferenceLine::horizontal(found.summary.mean, "mean"));
    match found.run_in.after() {
        0 => figure,
        after => figure.guide(ReferenceLine::vertical(after as f64 + 0.5, "run-in")),
    }
}

/// The last complete stroke and the one before it, over the way or, without motion, over time.
fn last_loop(record: &StrokeRecord, found: &Strokes) -> Figure {
    let complete: Vec<&Stroke> = found.strokes.iter().filter(|s| !s.is_cut_off).collect();
    let last = match complete.as_slice() {
        [.., before, last] => before.rows.start..last.rows.end,
        [one] => one.rows.clone(),
        [] => 0..record.times().len(),
    };
    let path = record.path();
    let (x, scale, axis) = match &path {
        Some(path) => (path.as_slice(), MILLI, "position [mm]"),
        None => (record.times(), 1.0, "time [s]"),
    };
    let step = last.len().div_ceil(MOST_ROWS).max(1);
    let pairs = x.iter().zip(record.friction());
    let rows = pairs.skip(last.start).take(last.len()).step_by(step);
    let rows = rows.map(|(x, f)| (scale * x, *f)).collect();
    Figure::new("", Axis::linear(axis), Axis::linear("friction as measured"))
        .series(Series::line("last two strokes", rows))
}
