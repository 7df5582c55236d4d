//! Data with the fitted curve, and what is left.

use crate::failure::Failure;
use tribos::fit::{Fit, FitLaw, Measurements, Motion};
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};

/// Most measurements that are drawn: more of them hide each other, and fill files.
const MOST_DRAWN: usize = 4000;
/// Points of a curve.
const POINTS: usize = 400;

/// Friction above, residuals below.
pub fn panels(law: FitLaw, data: &Measurements, fit: &Fit) -> Result<Panels, Failure> {
    let (x, axis): (&[f64], fn() -> Axis) = match data.motion() {
        Motion::Steady { speeds } => (speeds, || Axis::log10("speed [m/s]")),
        Motion::Series { times, .. } => (times, || Axis::linear("time [s]")),
    };
    let stride = x.len().div_ceil(MOST_DRAWN);
    let drawn = |values: &[f64]| values.iter().copied().step_by(stride).collect::<Vec<f64>>();
    let at = |values: &[f64]| {
        let pairs = drawn(x).into_iter().zip(drawn(values));
        pairs.collect::<Vec<(f64, f64)>>()
    };
    let name = match stride {
        1 => "measured".to_owned(),
        _ => format!("measured, one point of {stride}"),
    };
    let measured = Series::points(name, at(data.friction()));
    let measured = match data.sigma() {
        Some(sigma) => measured.errors(drawn(sigma)),
        None => measured,
    };
    let curve = match data.motion() {
        Motion::Steady { .. } => curve(law, data, fit)?,
        Motion::Series { .. } => at(&fit.predictions),
    };
    let above = Figure::new("", axis(), Axis::linear("friction"))
        .series(measured)
        .series(Series::line(law.steady(), curve));
    let pairs = data.friction().iter().zip(&fit.predictions);
    let residuals: Vec<f64> = pairs.map(|(f, p)| f - p).collect();
    let left = Series::points("", at(&residuals));
    let left = match data.sigma() {
        Some(sigma) => left.errors(drawn(sigma)),
        None => left,
    };
    let below = Figure::new("", axis(), Axis::linear("measured − fitted"))
        .series(left)
        .guide(ReferenceLine::horizontal(0.0, ""));
    Ok(Panels::new("Measured and fitted friction", 1)
        .cell(900, 380)
        .figure(above)
        .figure(below))
}

/// The law between the slowest and the fastest speed.
fn curve(law: FitLaw, data: &Measurements, fit: &Fit) -> Result<Vec<(f64, f64)>, Failure> {
    let speeds = data.velocities();
    let low = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    let high = speeds.iter().copied().fold(0.0, f64::max);
    let at = |k: usize| low * (high / low).powf(k as f64 / POINTS as f64);
    let all: Vec<f64> = (0..=POINTS).map(at).collect();
    let values: Vec<f64> = fit
        .parameters
        .iter()
        .map(|estimate| estimate.value)
        .collect();
    let places =
        Measurements::steady(all.clone(), vec![1.0; all.len()], None).map_err(Failure::run)?;
    let model = law.model(&places).map_err(Failure::run)?;
    let friction = model.predict(&values).unwrap_or_default();
    Ok(all.into_iter().zip(friction).collect())
}
