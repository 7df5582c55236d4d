//! Levenberg–Marquardt within bounds.

use super::jacobian::{Residuals, jacobian};
use nalgebra::{DMatrix, DVector};

/// A sum of squares to be made least.
pub(super) struct Problem<'a> {
    /// r(q)
    pub residuals: &'a Residuals<'a>,
    /// Moves coordinates to the nearest that are admitted, within the bounds already.
    pub repair: &'a dyn Fn(&mut [f64]),
    /// Bounds of the coordinates.
    pub bounds: Vec<[f64; 2]>,
    /// Magnitudes of the coordinates.
    pub sizes: Vec<f64>,
    /// Sum of squares below which residuals are rounding.
    pub floor: f64,
}

/// Where a search ended.
#[derive(Clone, Debug)]
pub(super) struct Minimum {
    /// q
    pub q: Vec<f64>,
    /// r(q)
    pub residuals: Vec<f64>,
    /// Σ r²
    pub cost: f64,
    /// ∂r/∂q
    pub jacobian: DMatrix<f64>,
    /// Whether nothing but rounding is left to gain.
    pub converged: bool,
    /// Steps taken.
    pub iterations: usize,
}

/// Most steps of a search.
const MOST: usize = 400;
/// First damping, relative to squares of singular values of the scaled Jacobian.
const FIRST_DAMPING: f64 = 1e-3;
/// Damping under which steps are lost in rounding.
const LAST_DAMPING: f64 = 1e20;
/// Share of the residuals' length that a Gauss–Newton step would take off (the relative offset of
/// Bates and Watts 1981) below which a search has converged: parameters are good to this fraction of
/// their standard errors.
const OFFSET: f64 = 1e-9;
/// The same where rounding ends the descent.
const ROUGH_OFFSET: f64 = 1e-4;

/// Searches from `start`; `None` if the model refuses it.
pub(super) fn minimise(problem: &Problem<'_>, start: &[f64]) -> Option<Minimum> {
    let mut q = start.to_vec();
    admit(problem, &mut q);
    let mut here = finite((problem.residuals)(&q)?)?;
    let mut cost = square(&here);
    let (mut damping, mut growth) = (FIRST_DAMPING, 2.0);
    let mut scales = vec![0.0_f64; q.len()];
    for iterations in 0..MOST {
        let slopes = jacobian(
            problem.residuals,
            &q,
            &here,
            &problem.bounds,
            &problem.sizes,
        )?;
        let end = |q: &[f64], here: &[f64], slopes: DMatrix<f64>, converged| Minimum {
            q: q.to_vec(),
            residuals: here.to_vec(),
            cost,
            jacobian: slopes,
            converged,
            iterations,
        };
        for (scale, column) in scales.iter_mut().zip(slopes.column_iter()) {
            *scale = scale.max(column.norm());
        }
        let step = Step::new(problem, &q, &here, &slopes, &scales);
        if cost <= problem.floor || step.offset(cost) <= OFFSET {
            return Some(end(&q, &here, slopes, true));
        }
        // Shorter and shorter steps until one goes down.
        loop {
            let mut trial = q.clone();
            let predicted = step.take(damping, &mut trial);
            admit(problem, &mut trial);
            let found = (problem.residuals)(&trial).and_then(finite);
            let below = found.map(|residuals| (square(&residuals), residuals));
            if let Some((less, residuals)) = below.filter(|(sum, _)| *sum < cost) {
                // Nielsen's rule: the better the linear model, the less damping.
                let gain = (cost - less) / predicted;
                let shrink = 1.0 - (2.0 * gain - 1.0).powi(3);
                damping *= shrink.max(1.0 / 3.0);
                growth = 2.0;
                (q, here, cost) = (trial, residuals, less);
                break;
            }
            damping *= growth;
            growth *= 2.0;
            if damping > LAST_DAMPING {
                let converged = step.offset(cost) <= ROUGH_OFFSET;
                return Some(end(&q, &here, slopes, converged));
            }
        }
    }
    let slopes = jacobian(
        problem.residuals,
        &q,
        &here,
        &problem.bounds,
        &problem.sizes,
    )?;
    Some(Minimum {
        q,
        residuals: here,
        cost,
        jacobian: slopes,
        converged: false,
        iterations: MOST,
    })
}

/// Into the bounds, then to what the model admits.
fn admit(problem: &Problem<'_>, q: &mut [f64]) {
    for (x, [low, high]) in q.iter_mut().zip(&problem.bounds) {
        *x = x.max(*low).min(*high);
    }
    (problem.repair)(q);
}

/// Indices of coordinates that may move: all but those at a bound over which the descent points.
pub(super) fn free(q: &[f64], bounds: &[[f64; 2]], gradient: &[f64]) -> Vec<usize> {
    let is_held = |j: usize| {
        let [low, high] = bounds[j];
        (q[j] <= low && gradient[j] >= 0.0) || (q[j] >= high && gradient[j] <= 0.0)
    };
    (0..q.len()).filter(|&j| !is_held(j)).collect()
}

/// Steps from one point for any damping: J D⁻¹ = Q R, R = U Σ Vᵀ.
struct Step {
    free: Vec<usize>,
    scales: Vec<f64>,
    /// Uᵀ Qᵀ r
    shares: DVector<f64>,
    sigma: DVector<f64>,
    v_t: DMatrix<f64>,
}

impl Step {
    fn new(
        problem: &Problem<'_>,
        q: &[f64],
        here: &[f64],
        slopes: &DMatrix<f64>,
        scales: &[f64],
    ) -> Self {
        let r = DVector::from_column_slice(here);
        let gradient: Vec<f64> = slopes.column_iter().map(|column| column.dot(&r)).collect();
        let free = free(q, &problem.bounds, &gradient);
        let scale = |j: usize| if scales[j] > 0.0 { scales[j] } else { 1.0 };
        let scaled = DMatrix::from_fn(here.len(), free.len(), |i, k| {
            slopes[(i, free[k])] / scale(free[k])
        });
        let qr = scaled.qr();
        let mut turned = r;
        qr.q_tr_mul(&mut turned);
        let svd = qr.r().svd(true, true);
        let rows = svd.singular_values.len();
        let top = turned.rows(0, rows).into_owned();
        // Both are there: they were asked for.
        let shares = svd.u.map_or(top.clone(), |u| u.tr_mul(&top));
        let v_t = svd
            .v_t
            .unwrap_or_else(|| DMatrix::identity(rows, free.len()));
        Self {
            scales: free.iter().map(|&j| scale(j)).collect(),
            free,
            shares,
            sigma: svd.singular_values,
            v_t,
        }
    }

    /// Moves `q`; returns by how much the linear model says that the cost falls.
    fn take(&self, damping: f64, q: &mut [f64]) -> f64 {
        let mut predicted = 0.0;
        let damped = self.sigma.zip_map(&self.shares, |s, c| {
            let share = s * s + damping;
            let kept = damping / share;
            predicted += c * c * (1.0 - kept * kept);
            -s * c / share
        });
        let step = self.v_t.tr_mul(&damped);
        for ((&j, y), scale) in self.free.iter().zip(step.iter()).zip(&self.scales) {
            q[j] += y / scale;
        }
        predicted
    }

    /// Length of what a full step would take off, over that of the residuals.
    fn offset(&self, cost: f64) -> f64 {
        /// Directions in which nothing changes gain nothing.
        const FLAT: f64 = 1e-10;
        let most = self.sigma.iter().copied().fold(0.0, f64::max);
        let pairs = self.sigma.iter().zip(self.shares.iter());
        let gained: f64 = pairs
            .filter(|(s, _)| **s > FLAT * most)
            .map(|(_, c)| c * c)
            .sum();
        (gained / cost).sqrt()
    }
}

fn square(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

fn finite(residuals: Vec<f64>) -> Option<Vec<f64>> {
    residuals.iter().all(|r| r.is_finite()).then_some(residuals)
}
