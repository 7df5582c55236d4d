//! How sure the parameters of the best minimum are.

use super::covariance::{Certainty, certainty};
use super::estimate::{Estimate, Fit, Known};
use super::minimise::free;
use super::search::{Search, Unknowns};
use nalgebra::DMatrix;

/// The coordinates that have an error, with what the Jacobian says of them.
struct Inside {
    /// Their places among those that are sought.
    places: Vec<usize>,
    certain: Certainty,
}

impl Search {
    /// The fit with its standard errors.
    pub fn judged(self, unknowns: &Unknowns<'_>, is_weighted: bool) -> Fit {
        let values = unknowns.values(&self.best.q);
        let freedoms = self.best.residuals.len() - unknowns.sought.len();
        // Without known deviations the residuals tell how large they are.
        let variance = if is_weighted {
            1.0
        } else {
            self.best.cost / freedoms as f64
        };
        let inside = self.inside();
        let known = inside.known(unknowns, &values, variance);
        let all = unknowns.model.parameters().iter().zip(&values).zip(known);
        let parameters = all.map(|((parameter, &value), known)| Estimate {
            parameter: *parameter,
            value,
            known,
        });
        let nothing = vec![f64::NAN; self.best.residuals.len()];
        Fit {
            parameters: parameters.collect(),
            covariance: inside.covariance(unknowns, &values, variance),
            predictions: unknowns.model.predict(&values).unwrap_or(nothing),
            cost: self.best.cost,
            freedoms,
            is_weighted,
            converged: self.best.converged,
            starts: self.starts,
            at_best: self.at_best,
            iterations: self.best.iterations,
        }
    }

    /// Coordinates that are not held at a bound, which have no error of their own.
    fn inside(&self) -> Inside {
        let best = &self.best;
        let along = |column: nalgebra::DVectorView<'_, f64>| -> f64 {
            column.iter().zip(&best.residuals).map(|(a, b)| a * b).sum()
        };
        let gradient: Vec<f64> = best.jacobian.column_iter().map(along).collect();
        let places = free(&best.q, &self.bounds, &gradient);
        let columns = DMatrix::from_fn(best.residuals.len(), places.len(), |i, k| {
            best.jacobian[(i, places[k])]
        });
        let sizes: Vec<f64> = places.iter().map(|&k| self.lengths[k].least()).collect();
        Inside {
            certain: certainty(&columns, &sizes, self.size),
            places,
        }
    }
}

impl Inside {
    /// How each parameter of the model is known.
    fn known(&self, unknowns: &Unknowns<'_>, values: &[f64], variance: f64) -> Vec<Known> {
        let parameters = unknowns.model.parameters();
        let number = |k: usize| unknowns.sought[self.places[k]];
        let mut known = vec![Known::Fixed; parameters.len()];
        for &j in &unknowns.sought {
            known[j] = Known::AtBound;
        }
        for k in 0..self.places.len() {
            let j = number(k);
            known[j] = if self.is_loose(k) {
                let groups = self.certain.loose.iter().filter(|group| group.contains(&k));
                let others = groups.flatten().filter(|&&other| other != k);
                let mut others: Vec<_> = others.map(|&k| parameters[number(k)].name).collect();
                others.dedup();
                Known::Undetermined(others)
            } else {
                let slope = parameters[j].range.derivative(values[j]);
                Known::StandardError((self.certain.covariance[(k, k)] * variance).sqrt() * slope)
            };
        }
        known
    }

    /// Whether nothing determines it.
    fn is_loose(&self, k: usize) -> bool {
        self.certain.loose.iter().any(|group| group.contains(&k))
    }

    /// Covariance of the values that have a standard error.
    fn covariance(&self, unknowns: &Unknowns<'_>, values: &[f64], variance: f64) -> DMatrix<f64> {
        let firm: Vec<usize> = (0..self.places.len())
            .filter(|&k| !self.is_loose(k))
            .collect();
        let slope = |k: usize| {
            let j = unknowns.sought[self.places[k]];
            unknowns.model.parameters()[j].range.derivative(values[j])
        };
        DMatrix::from_fn(firm.len(), firm.len(), |a, b| {
            let (a, b) = (firm[a], firm[b]);
            self.certain.covariance[(a, b)] * variance * slope(a) * slope(b)
        })
    }
}
