//! What residuals say of the machine: a constant force, an inertia, a curve that the law does not have.

use super::abrupt::is_stepped;
use super::caution::Caution;
use super::data::Measurements;
use super::residual_tests::residual_tests;
use super::result::CORRELATED;
use super::slopes::Accelerated;

/// Standard errors from which on a hint is believed.
const BELIEVED: f64 = 5.0;
/// Share of the residuals' squares that it must explain.
const SHARE: f64 = 0.05;
/// Most points whose order is looked at.
const MOST: usize = 100_000;
/// Points of each direction that tell an offset.
const ENOUGH: usize = 5;

/// Hints from residuals: measured less fitted friction. `factor` is that of their correlation, and `has` tells whether a
/// parameter is in the fit.
pub(super) fn hints(
    data: &Measurements,
    residuals: &[f64],
    factor: f64,
    has: impl Fn(&str) -> bool,
) -> Vec<Caution> {
    let mut all = Vec::new();
    let velocities = data.velocities();
    let of_sign = |sign: f64| velocities.iter().filter(|v| **v * sign > 0.0).count();
    if !has("offset") && of_sign(1.0) >= ENOUGH && of_sign(-1.0) >= ENOUGH {
        let value = explained(residuals, |_| 1.0, factor);
        all.extend(value.map(|value| Caution::Offset { value }));
    }
    if has("offset") && (of_sign(1.0) < ENOUGH || of_sign(-1.0) < ENOUGH) {
        all.push(Caution::OneWay);
    }
    // Jumps have no acceleration that rows could show.
    let is_sought = !has("inertia") && !is_stepped(velocities);
    if let (Some(record), true) = (Accelerated::of(data, residuals), is_sought) {
        let (accelerations, _) = record.slopes(|_| true);
        let value = explained(residuals, |point| accelerations[point], factor);
        all.extend(value.map(|value| Caution::Inertia { value }));
    }
    if data.times().is_none() {
        all.extend(curved(data, residuals));
    }
    all
}

/// The slope of residuals over something that they follow.
fn explained(residuals: &[f64], along: impl Fn(usize) -> f64, factor: f64) -> Option<f64> {
    let (mut product, mut squares, mut length) = (0.0, 0.0, 0.0);
    for (point, r) in residuals.iter().enumerate() {
        let x = along(point);
        product += r * x;
        squares += r * r;
        length += x * x;
    }
    let share = product * product / (squares * length);
    let points = residuals.len() as f64 / (factor * factor);
    // Of the correlation: t² = n share/(1 − share).
    let is_told = share > SHARE && points * share > BELIEVED * BELIEVED * (1.0 - share);
    is_told.then_some(product / length)
}

/// Whether residuals of steady sliding follow each other over the velocity.
fn curved(data: &Measurements, residuals: &[f64]) -> Option<Caution> {
    let velocities = data.velocities();
    let stride = residuals.len().div_ceil(MOST);
    let mut order: Vec<usize> = (0..residuals.len()).step_by(stride.max(1)).collect();
    order.sort_by(|&a, &b| velocities[a].total_cmp(&velocities[b]).then(a.cmp(&b)));
    let weighed: Vec<f64> = order
        .iter()
        .map(|&i| residuals[i] / data.sigma().map_or(1.0, |sigma| sigma[i]))
        .collect();
    let tests = residual_tests(&weighed, None)?;
    (tests.runs_p < CORRELATED && tests.runs_z < 0.0).then_some(Caution::Curved)
}
