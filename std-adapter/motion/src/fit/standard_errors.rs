//! Standard errors of the fitted parameters.

use super::estimate::Uncertainty;
use super::linearised::Linearised;
use super::unknowns::Unknowns;
use nalgebra::DMatrix;

/// What the data tell of each parameter.
pub(super) struct Certainties {
    /// Of each parameter of the model.
    pub known: Vec<Uncertainty>,
    /// Covariance of the values that have a standard error, in their order.
    pub covariance: DMatrix<f64>,
}

/// Share of its largest part below which a value's change along a direction cancels.
const CANCELS: f64 = 0.05;

impl Certainties {
    /// Near a minimum with these values; `deviation` is the standard deviation of a residual.
    pub fn of(at: &Linearised, unknowns: &Unknowns<'_>, values: &[f64], deviation: f64) -> Self {
        let (slopes, sizes) = unit_rows(unknowns.slopes(values));
        let all = &slopes * at.covariance(unknowns) * slopes.transpose();
        let loose: Vec<Vec<usize>> = at
            .certainty()
            .loose
            .iter()
            .map(|direction| moved(at, &slopes, direction))
            .collect();
        let parameters = unknowns.model.parameters();
        let mut known = vec![Uncertainty::Fixed; parameters.len()];
        let mut firm = Vec::new();
        for (k, &j) in unknowns.sought.iter().enumerate() {
            let groups = || loose.iter().filter(|group| group.contains(&k));
            known[j] = if !at.free.contains(&k) {
                Uncertainty::AtBound
            } else if groups().next().is_some() {
                let others = groups().flatten().filter(|&&other| other != k);
                let names = others.map(|&other| parameters[unknowns.sought[other]].name);
                let mut names: Vec<_> = names.collect();
                names.dedup();
                Uncertainty::Undetermined(names)
            } else {
                firm.push(k);
                Uncertainty::StandardError(all[(k, k)].sqrt() * sizes[k] * deviation)
            };
        }
        Self {
            known,
            covariance: DMatrix::from_fn(firm.len(), firm.len(), |a, b| {
                let (a, b) = (firm[a], firm[b]);
                all[(a, b)] * (deviation * sizes[a]) * (deviation * sizes[b])
            }),
        }
    }
}

/// Rows whose largest element is 1, and that element: squares of the slopes could overflow.
fn unit_rows(mut slopes: DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let mut sizes = Vec::with_capacity(slopes.nrows());
    for mut row in slopes.row_iter_mut() {
        let size = row.amax();
        if size > 0.0 {
            row /= size;
        }
        sizes.push(size);
    }
    (slopes, sizes)
}

/// Sought parameters whose values change along a direction of the free coordinates.
fn moved(at: &Linearised, slopes: &DMatrix<f64>, direction: &[f64]) -> Vec<usize> {
    let changes = |row: &usize| {
        let parts = at.free.iter().zip(direction);
        let parts: Vec<f64> = parts.map(|(&k, d)| slopes[(*row, k)] * d).collect();
        let largest = parts
            .iter()
            .fold(0.0, |most: f64, part| most.max(part.abs()));
        largest > 0.0 && parts.iter().sum::<f64>().abs() > CANCELS * largest
    };
    (0..slopes.nrows()).filter(changes).collect()
}
