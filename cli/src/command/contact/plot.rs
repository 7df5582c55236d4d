//! The residual as work goes on.

use tribos::problem::{ProblemMethod, SolverProgress};
use tribos_report::figure::{Axis, Figure, Series};

/// Most points that are drawn of a series.
const MOST_DRAWN: usize = 2000;
/// Residuals below this are rounding, and are drawn there: a logarithmic axis has no zero.
const ROUNDING: f64 = 1e-17;

/// Residual over sweeps and factorisations, each method with its own colour, and the tolerance.
pub fn convergence(history: &[SolverProgress], tolerance: f64) -> Figure {
    let stride = history.len().div_ceil(MOST_DRAWN).max(1);
    let mut drawn: Vec<(ProblemMethod, Vec<(f64, f64)>)> = Vec::new();
    for (at, progress) in history.iter().enumerate() {
        let is_drawn = at % stride == 0 || at + 1 == history.len();
        if !is_drawn || !progress.residual.is_finite() {
            continue;
        }
        let work = (progress.sweeps + progress.factorisations) as f64;
        let point = (work, progress.residual.max(ROUNDING));
        match drawn
            .iter_mut()
            .find(|(method, _)| *method == progress.method)
        {
            Some((_, points)) => points.push(point),
            None => drawn.push((progress.method, vec![point])),
        }
    }
    let most = history
        .iter()
        .map(|progress| progress.sweeps + progress.factorisations);
    let width = most.max().unwrap_or(0).max(1) as f64;
    let figure = Figure::new(
        "Convergence",
        Axis::linear("sweeps and factorisations"),
        Axis::log10("residual"),
    );
    let figure = drawn.into_iter().fold(figure, |figure, (method, points)| {
        figure.series(Series::line_points(method.name(), points))
    });
    figure.series(Series::line(
        "tolerance",
        vec![(0.0, tolerance), (width, tolerance)],
    ))
}
