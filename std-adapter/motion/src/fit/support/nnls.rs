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
/// Part of it that a variable above zero may leave: far above the rounding of normal equations with a ridge.
const LEFT: f64 = 1e-7;

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
    /// diagonal; `None` unless it meets the conditions of Kuhn and Tucker, which prove it the least.
    ///
    /// *Source*: C. L. Lawson, R. J. Hanson, Solving Least Squares Problems (1974), chapter 23.
    pub fn solve(mut self, ridge: f64) -> Option<Vec<f64>> {
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
        self.is_least(&x).then(|| x.iter().copied().collect())
    }

    /// No variable that is zero would fall by growing, and the others are at the bottom.
    fn is_least(&self, x: &DVector<f64>) -> bool {
        let gradient = &self.moments - &self.gram * x;
        let left = LEFT * self.moments.amax();
        let each = x.iter().zip(gradient.iter());
        each.into_iter()
            .all(|(&x, &g)| g <= left && x >= 0.0 && (x == 0.0 || g >= -left))
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

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_base::random::Random;

    fn error(rows: &[(DVector<f64>, f64)], x: &DVector<f64>) -> f64 {
        let each = rows.iter().map(|(row, right)| row.dot(x) - right);
        each.map(|left| left * left).sum()
    }

    /// The least sum of squares over all choices of unknowns that may be positive.
    fn enumerated(rows: &[(DVector<f64>, f64)], unknowns: usize) -> f64 {
        let mut least = error(rows, &DVector::zeros(unknowns));
        for choice in 1_u32..1 << unknowns {
            let free: Vec<usize> = (0..unknowns).filter(|i| choice >> i & 1 == 1).collect();
            let system = DMatrix::from_fn(rows.len(), free.len(), |i, j| rows[i].0[free[j]]);
            let right = DVector::from_fn(rows.len(), |i, _| rows[i].1);
            let found = system.svd(true, true).solve(&right, 1e-12).unwrap();
            if found.iter().all(|x| *x >= 0.0) {
                let mut x = DVector::zeros(unknowns);
                for (&i, &value) in free.iter().zip(found.iter()) {
                    x[i] = value;
                }
                least = least.min(error(rows, &x));
            }
        }
        least
    }

    #[test]
    fn loads_have_the_least_squares_of_all_choices_or_are_none() {
        let mut random = Random::new(1, 0);
        let mut drawn = || 2.0 * random.unit() - 1.0;
        for _ in 0..50 {
            let rows: Vec<(DVector<f64>, f64)> = (0..9)
                .map(|_| (DVector::from_fn(5, |_, _| drawn()), drawn()))
                .collect();
            let mut normal = Normal::new(5);
            rows.iter().for_each(|(row, right)| normal.add(row, *right));
            let x = DVector::from_vec(normal.solve(0.0).unwrap());
            let (found, least) = (error(&rows, &x), enumerated(&rows, 5));
            assert!((found / least - 1.0).abs() < 1e-12, "{found} {least}");
            // One row that is no number leaves no least.
            let mut lost = Normal::new(5);
            rows.iter().for_each(|(row, right)| lost.add(row, *right));
            lost.add(&DVector::from_element(5, f64::NAN), 1.0);
            assert_eq!(lost.solve(0.0), None);
        }
    }
}
