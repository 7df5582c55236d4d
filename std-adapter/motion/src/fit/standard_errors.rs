//! Standard errors of the fitted parameters.

use super::covariance::{CovarianceAnalysis, certainty};
use super::estimate::{Estimate, Fit, Uncertainty};
use super::minimise::{free, gradient};
use super::search::Search;
use super::unknowns::Unknowns;
use nalgebra::DMatrix;

/// The coordinates that have an error, with their covariance.
struct FreeCoordinates {
    /// Indices of the coordinates among the free parameters.
    places: Vec<usize>,
    certain: CovarianceAnalysis,
}

impl Search {
    /// The fit with its standard errors.
    pub fn with_standard_errors(self, unknowns: &Unknowns<'_>, is_weighted: bool) -> Fit {
        let values = unknowns.values(&self.best.q);
        let freedoms = self.residuals.len() - unknowns.sought.len();
        let scatter = (self.best.cost / freedoms as f64).sqrt();
        // Without known deviations their size is estimated from the residuals.
        let deviation = if is_weighted { self.unit } else { scatter };
        let inside = self.inside();
        let known = inside.known(unknowns, &values, deviation);
        let all = unknowns.model.parameters().iter().zip(&values).zip(known);
        let parameters = all.map(|((parameter, &value), known)| Estimate {
            parameter: *parameter,
            value,
            known,
        });
        let nothing = vec![f64::NAN; self.residuals.len()];
        Fit {
            parameters: parameters.collect(),
            covariance: inside.covariance(unknowns, &values, deviation),
            predictions: unknowns.model.predict(&values).unwrap_or(nothing),
            cost: self.best.cost / self.unit / self.unit,
            deviation: scatter / self.unit,
            freedoms,
            is_weighted,
            converged: self.best.converged,
            starts: self.starts,
            at_best: self.at_best,
            iterations: self.best.iterations,
            searched: self.searched,
        }
    }

    /// Coordinates that are not at a bound; those at a bound have no error.
    fn inside(&self) -> FreeCoordinates {
        let gradient = gradient(&self.jacobian, &self.residuals);
        let places = free(&self.best.q, &self.bounds, &gradient);
        let sizes: Vec<f64> = places.iter().map(|&k| self.lengths[k].least()).collect();
        FreeCoordinates {
            certain: certainty(&self.jacobian, &places, &sizes, self.size),
            places,
        }
    }
}

impl FreeCoordinates {
    /// Certainty of each parameter of the model.
    fn known(&self, unknowns: &Unknowns<'_>, values: &[f64], deviation: f64) -> Vec<Uncertainty> {
        let parameters = unknowns.model.parameters();
        let number = |k: usize| unknowns.sought[self.places[k]];
        let mut known = vec![Uncertainty::Fixed; parameters.len()];
        for &j in &unknowns.sought {
            known[j] = Uncertainty::AtBound;
        }
        for k in 0..self.places.len() {
            let j = number(k);
            known[j] = if self.is_loose(k) {
                let groups = self.certain.loose.iter().filter(|group| group.contains(&k));
                let others = groups.flatten().filter(|&&other| other != k);
                let mut others: Vec<_> = others.map(|&k| parameters[number(k)].name).collect();
                others.dedup();
                Uncertainty::Undetermined(others)
            } else {
                let slope = parameters[j].range.derivative(values[j]);
                Uncertainty::StandardError(
                    self.certain.covariance[(k, k)].sqrt() * deviation * slope,
                )
            };
        }
        known
    }

    /// Whether the data do not determine this coordinate.
    fn is_loose(&self, k: usize) -> bool {
        self.certain.loose.iter().any(|group| group.contains(&k))
    }

    /// Covariance of the values that have a standard error.
    fn covariance(&self, unknowns: &Unknowns<'_>, values: &[f64], deviation: f64) -> DMatrix<f64> {
        let firm: Vec<usize> = (0..self.places.len())
            .filter(|&k| !self.is_loose(k))
            .collect();
        let slope = |k: usize| {
            let j = unknowns.sought[self.places[k]];
            unknowns.model.parameters()[j].range.derivative(values[j])
        };
        DMatrix::from_fn(firm.len(), firm.len(), |a, b| {
            let (a, b) = (firm[a], firm[b]);
            self.certain.covariance[(a, b)] * (deviation * slope(a)) * (deviation * slope(b))
        })
    }
}
