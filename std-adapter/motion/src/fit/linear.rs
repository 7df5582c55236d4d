//! Starts that linear least squares improve: in most parameters of a law friction is linear.

use super::parameter::Range;
use super::reduce::reduced;
use super::sample::WeightedData;
use super::unknowns::Unknowns;
use nalgebra::DMatrix;

/// Change of a parameter for its column, over the parameter.
const CHANGE: f64 = 0.01;
/// Singular value over the largest below which a combination is left as it is.
const FLAT: f64 = 1e-8;
/// Share of a positive parameter that is left where least squares give none.
const LEFT: f64 = 0.1;

/// Coordinates with the least sum of squares over the linear parameters, if that is less than at the start.
pub(super) fn improved(unknowns: &Unknowns<'_>, target: &WeightedData, start: &[f64]) -> Vec<f64> {
    better(unknowns, target, start).unwrap_or_else(|| start.to_vec())
}

fn better(unknowns: &Unknowns<'_>, target: &WeightedData, start: &[f64]) -> Option<Vec<f64>> {
    let model = unknowns.model;
    let values = unknowns.values(start);
    let here = target.residuals_of(model, &values)?;
    let sought = unknowns.sought.iter().copied();
    let linear: Vec<usize> = sought.filter(|&j| model.is_linear(j)).collect();
    if linear.is_empty() {
        return None;
    }
    let mut columns = DMatrix::zeros(here.len(), linear.len());
    for (k, &j) in linear.iter().enumerate() {
        let size = if values[j] == 0.0 {
            target.largest()
        } else {
            CHANGE * values[j].abs()
        };
        let shifted = |change: f64| {
            let mut moved = values.clone();
            moved[j] += change;
            target
                .residuals_of(model, &moved)
                .map(|there| (change, there))
        };
        let (change, there) = shifted(size).or_else(|| shifted(-size))?;
        for i in 0..here.len() {
            columns[(i, k)] = (there[i] - here[i]) / change;
        }
    }
    let all: Vec<usize> = (0..linear.len()).collect();
    let system = reduced(&columns, &all, &here);
    let svd = system.triangle.svd(true, true);
    let most = svd.singular_values.iter().copied().fold(0.0, f64::max);
    let step = svd.solve(&system.turned, FLAT * most).ok()?;
    let mut moved = values.clone();
    for (k, &j) in linear.iter().enumerate() {
        let wanted = values[j] - step[k] / system.norms[k];
        moved[j] = match model.parameters()[j].range {
            Range::Positive if wanted > LEFT * values[j] => wanted,
            Range::Positive => LEFT * values[j],
            Range::NotNegative => wanted.max(0.0),
            range if range.admits(wanted) => wanted,
            _ => values[j],
        };
    }
    let size = |r: &[f64]| r.iter().map(|r| r * r).sum::<f64>();
    let q = unknowns.coordinates(&moved);
    let there = target.residuals(unknowns, &q)?;
    (size(&there) < size(&here)).then_some(q)
}
