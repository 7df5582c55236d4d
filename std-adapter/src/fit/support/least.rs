//! Non-negative least squares.

use nalgebra::{DMatrix, DVector};

/// Rows of an overdetermined system, as their normal equations.
#[derive(Clone, Debug)]
pub struct Normal {
    gram: DMatrix<f64>,
    moments: DVector<f64>,
}

/// Part of the largest gradient below which a variable stays zero.
const FLAT: f64 = 1e-11;

impl Normal {
    /// No rows, for so many unknowns.
    pub fn new(unknowns: usize) -> Self {
        Self {
            gram: DMatrix::zeros(unknowns, unknowns),
            moments: DVector::zeros(unknowns),
        }
    }

    /// Adds the row a·x = b.
    pub fn add(&mut self, row: &DVector<f64>, right: f64) {
        self.gram.ger(1.0, row, row, 1.0);
        self.moments.axpy(right, row, 1.0);
    }

    /// The x ≥ 0 with the least sum of squares and `ridge` times that of x in units of the mean of the
    /// diagonal.
    ///
    /// *Source*: C. L. Lawson, R. J. Hanson, Solving Least Squares Problems (1974), chapter 23.
    pub fn solve(mut self, ridge: f64) -> Vec<f64> {
        let count = self.moments.len();
        let lift = ridge * self.gram.trace() / count as f64;
        for i in 0..count {
            self.gram[(i, i)] += lift;
        }
        let mut x = DVector::zeros(count);
        let mut is_free = vec![false; count];
        let least = FLAT * self.moments.amax();
        // Each step lets one more be positive; more steps than three for each mean that rounding goes in a circle.
        for _ in 0..3 * count {
            let gradient = &self.moments - &self.gram * &x;
            let held = (0..count).filter(|&i| !is_free[i] && gradient[i] > least);
            let Some(next) = held.max_by(|&i, &j| gradient[i].total_cmp(&gradient[j])) else {
                break;
            };
            is_free[next] = true;
            self.descend(&mut x, &mut is_free);
        }
        x.iter().copied().collect()
    }

    /// Goes to the least squares of the free variables, and holds those that become negative.
    fn descend(&self, x: &mut DVector<f64>, is_free: &mut [bool]) {
        loop {
            let free: Vec<usize> = (0..is_free.len()).filter(|&i| is_free[i]).collect();
            let gram =
                DMatrix::from_fn(free.len(), free.len(), |i, j| self.gram[(free[i], free[j])]);
            let right = DVector::from_fn(free.len(), |i, _| self.moments[free[i]]);
            let Some(factors) = gram.cholesky() else {
                // The last one depends on the others.
                return;
            };
            let wanted = factors.solve(&right);
            let mut share: f64 = 1.0;
            for (&i, &to) in free.iter().zip(wanted.iter()) {
                if to <= 0.0 && x[i] - to > 0.0 {
                    share = share.min(x[i] / (x[i] - to));
                }
            }
            for (&i, &to) in free.iter().zip(wanted.iter()) {
                x[i] += share * (to - x[i]);
                if (share < 1.0 || to <= 0.0) && x[i] <= f64::EPSILON * to.abs() {
                    (x[i], is_free[i]) = (0.0, false);
                }
            }
            if share >= 1.0 {
                return;
            }
        }
    }
}
