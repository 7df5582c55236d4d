//! The sum of squares near its minimum.

use super::covariance::{CovarianceAnalysis, certainty};
use super::jacobian::Order;
use super::minimise::{Problem, free, gradient};
use super::reduce::reduced;
use super::unknowns::Unknowns;
use nalgebra::{DMatrix, DVector};

/// Residuals and their derivatives at a minimum.
pub(super) struct Linearised {
    /// r
    pub residuals: Vec<f64>,
    /// ∂r/∂q
    pub jacobian: DMatrix<f64>,
    /// Coordinates that are not held at a bound.
    pub free: Vec<usize>,
    /// Least sizes of the coordinates.
    sizes: Vec<f64>,
    /// Size of the data.
    size: f64,
}

impl Linearised {
    /// At coordinates; `None` where the model refuses them.
    pub fn at(problem: &Problem<'_>, q: &[f64], order: Order) -> Option<Self> {
        let residuals = (problem.residuals)(q)?;
        let jacobian = problem.slopes(q, &residuals, order)?;
        let free = free(q, &problem.bounds, &gradient(&jacobian, &residuals));
        Some(Self {
            free,
            sizes: problem
                .lengths
                .iter()
                .map(|length| length.least())
                .collect(),
            size: problem.floor.sqrt() / f64::EPSILON,
            residuals,
            jacobian,
        })
    }

    /// √(Σ r²/freedoms)
    pub fn deviation(&self) -> f64 {
        let freedoms = self.residuals.len() - self.jacobian.ncols();
        let cost: f64 = self.residuals.iter().map(|r| r * r).sum();
        (cost / freedoms as f64).sqrt()
    }

    /// Certainty of the free coordinates.
    pub fn certainty(&self) -> CovarianceAnalysis {
        let sizes: Vec<f64> = self.free.iter().map(|&k| self.sizes[k]).collect();
        certainty(&self.jacobian, &self.free, &sizes, self.size)
    }

    /// (JᵀJ)⁻¹ of all coordinates, 0 for those at a bound.
    pub fn covariance(&self, unknowns: &Unknowns<'_>) -> DMatrix<f64> {
        let certain = self.certainty();
        let count = unknowns.sought.len();
        let mut all = DMatrix::zeros(count, count);
        for (a, &i) in self.free.iter().enumerate() {
            for (b, &j) in self.free.iter().enumerate() {
                all[(i, j)] = certain.covariance[(a, b)];
            }
        }
        all
    }

    /// The least sum of squares of other residuals with the same slopes.
    pub fn least(&self, residuals: &[f64]) -> f64 {
        let whole: f64 = residuals.iter().map(|r| r * r).sum();
        if self.free.is_empty() {
            return whole;
        }
        let system = reduced(&self.jacobian, &self.free, residuals);
        (whole - system.turned.norm_squared()).max(0.0)
    }

    /// Change of the minimum's coordinates where residuals change: −(JᵀJ)⁻¹Jᵀ Δr.
    pub fn response(&self, change: &[f64]) -> DVector<f64> {
        /// Singular value over the largest of a combination that the data do not determine.
        const FLAT: f64 = 1e-7;
        let mut all = DVector::zeros(self.jacobian.ncols());
        if self.free.is_empty() {
            return all;
        }
        let system = reduced(&self.jacobian, &self.free, change);
        let svd = system.triangle.svd(true, true);
        let most = svd.singular_values.iter().copied().fold(0.0, f64::max);
        if let Ok(step) = svd.solve(&system.turned, FLAT * most) {
            for (k, &j) in self.free.iter().enumerate() {
                all[j] = -step[k] / system.norms[k];
            }
        }
        all
    }
}
