//! The residual as work goes on.

use tribos::problem::Progress;
use tribos_report::figure::{Axis, Figure, Series};

/// Most points that are drawn of a series.
const MOST_DRAWN: usize = 2000;

/// Scaled residual over sweeps and factorisations, each with its own colour.
pub fn convergence(history: &[Progress]) -> Figure {
    let stride = history.len().div_ceil(MOST_DRAWN).max(1);
    let mut sweeps = Vec::new();
    let mut factorisations = Vec::new();
    for (at, progress) in history.iter().enumerate() {
        let is_drawn = at % stride == 0 || at + 1 == history.len();
        // A logarithmic axis has no place for others.
        if !is_drawn || !progress.residual.is_finite() || progress.residual <= 0.0 {
            continue;
        }
        let work = (progress.sweeps + progress.factorisations) as f64;
        let series = match progress.factorisations {
            0 => &mut sweeps,
            _ => &mut factorisations,
        };
        series.push((work, progress.residual));
    }
    let figure = Figure::new(
        "Convergence",
        Axis::linear("sweeps and factorisations"),
        Axis::log10("scaled residual"),
    );
    let named = [("sweeps", sweeps), ("factorisations", factorisations)];
    let drawn = named.into_iter().filter(|(_, points)| !points.is_empty());
    drawn.fold(figure, |figure, (name, points)| {
        figure.series(Series::line_points(name, points))
    })
}
