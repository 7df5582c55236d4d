//! Anderson acceleration of symmetric Gauss–Seidel sweeps.

use super::nsgs::Effort;
use super::operator::{Blind, Change, Impulse, Operator, Visit};

/// Differences of the last iterates.
#[derive(Clone, Debug)]
pub struct Anderson<I> {
    window: usize,
    /// Images and residuals, the newest last.
    images: Vec<Vec<I>>,
    residuals: Vec<Vec<I>>,
    start: Vec<I>,
}

impl<I: Impulse> Anderson<I> {
    /// Remembers `window` differences.
    pub fn new(window: usize) -> Self {
        Self {
            window,
            images: Vec::new(),
            residuals: Vec::new(),
            start: Vec::new(),
        }
    }

    /// Sweeps forwards and backwards until the relative change of one sweep is below `tolerance`.
    pub fn solve<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        tolerance: f64,
        most: usize,
    ) -> Effort {
        let n = problem.contacts();
        self.images.clear();
        self.residuals.clear();
        self.start.clear();
        self.start.extend((0..n).map(|c| problem.impulse(c)));
        let mut sweeps = 0;
        let mut best = f64::INFINITY;
        while sweeps < most {
            problem.sweep(Visit::Forward, &mut Blind);
            let mut change = Change::default();
            problem.sweep(Visit::Backward, &mut change);
            sweeps += 2;
            if change.relative() <= tolerance {
                return Effort { sweeps, met: true };
            }
            if change.relative() > 2.0 * best {
                // Worse than before: forget.
                self.images.clear();
                self.residuals.clear();
            }
            best = best.min(change.relative());
            let image: Vec<I> = (0..n).map(|c| problem.impulse(c)).collect();
            let residual: Vec<I> = (0..n)
                .map(|c| image[c].plus_scaled(-1.0, &self.start[c]))
                .collect();
            self.images.push(image);
            self.residuals.push(residual);
            if self.images.len() > self.window + 1 {
                self.images.remove(0);
                self.residuals.remove(0);
            }
            let k = self.images.len() - 1;
            if k > 0 {
                let gamma = self.mix(problem, k);
                for c in 0..n {
                    let mut y = self.images[k][c];
                    for (j, g) in gamma.iter().enumerate() {
                        let d = self.images[k][c].plus_scaled(-1.0, &self.images[j][c]);
                        y = y.plus_scaled(-g, &d);
                    }
                    problem.guess(c, &y);
                }
                problem.refresh();
                sweeps += 1;
            }
            for c in 0..n {
                self.start[c] = problem.impulse(c);
            }
        }
        Effort { sweeps, met: false }
    }

    fn mix<O: Operator<Impulse = I>>(&self, problem: &O, k: usize) -> Vec<f64> {
        let n = self.start.len();
        let diffs: Vec<Vec<I>> = (0..k)
            .map(|j| {
                (0..n)
                    .map(|c| self.residuals[k][c].plus_scaled(-1.0, &self.residuals[j][c]))
                    .collect()
            })
            .collect();
        let mut a = vec![vec![0.0; k]; k];
        let mut b = vec![0.0; k];
        for i in 0..k {
            for j in 0..=i {
                let mut s = 0.0;
                for c in 0..n {
                    s += problem.dot(c, &diffs[i][c], &diffs[j][c]);
                }
                a[i][j] = s;
            }
            for c in 0..n {
                b[i] += problem.dot(c, &diffs[i][c], &self.residuals[k][c]);
            }
        }
        let trace: f64 = (0..k).map(|i| a[i][i]).sum();
        for (i, row) in a.iter_mut().enumerate() {
            row[i] += 1e-13 * trace;
        }
        // Cholesky
        for i in 0..k {
            for j in 0..=i {
                let mut s = a[i][j];
                for l in 0..j {
                    s -= a[i][l] * a[j][l];
                }
                if i == j {
                    if s <= 0.0 {
                        return vec![0.0; k];
                    }
                    a[i][i] = s.sqrt();
                } else {
                    a[i][j] = s / a[j][j];
                }
            }
        }
        for i in 0..k {
            for l in 0..i {
                b[i] -= a[i][l] * b[l];
            }
            b[i] /= a[i][i];
        }
        for i in (0..k).rev() {
            for l in i + 1..k {
                b[i] -= a[l][i] * b[l];
            }
            b[i] /= a[i][i];
        }
        b
    }
}
