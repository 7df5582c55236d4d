//! Gauss–Seidel with momentum: symmetric sweeps, extrapolated.

use super::nsgs::Effort;
use super::operator::{Change, Impulse, Operator, Visit};

/// Buffers of the iteration.
#[derive(Clone, Debug)]
pub struct Momentum<I> {
    last: Vec<I>,
    start: Vec<I>,
}

impl<I: Impulse> Default for Momentum<I> {
    fn default() -> Self {
        Self {
            last: Vec::new(),
            start: Vec::new(),
        }
    }
}

impl<I: Impulse> Momentum<I> {
    /// Sweeps forwards and backwards until the relative change of one sweep is below `tolerance`.
    pub fn solve<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        tolerance: f64,
        most: usize,
    ) -> Effort {
        let n = problem.contacts();
        self.last.clear();
        self.last.extend((0..n).map(|c| problem.impulse(c)));
        self.start.clone_from(&self.last);
        let mut t = 1.0_f64;
        let mut sweeps = 0;
        while sweeps < most {
            problem.sweep(Visit::Forward, &mut super::operator::Blind);
            let mut change = Change::default();
            problem.sweep(Visit::Backward, &mut change);
            sweeps += 2;
            if change.relative() <= tolerance {
                return Effort { sweeps, met: true };
            }
            // Momentum against the direction of progress starts anew (O'Donoghue and Candès 2015).
            let mut along = 0.0;
            for c in 0..n {
                let x = problem.impulse(c);
                let progress = x.plus_scaled(-1.0, &self.start[c]);
                let step = x.plus_scaled(-1.0, &self.last[c]);
                along += problem.dot(c, &progress, &step);
            }
            let beta = if along < 0.0 {
                t = 1.0;
                0.0
            } else {
                let next = 0.5 * (1.0 + (1.0 + 4.0 * t * t).sqrt());
                let beta = (t - 1.0) / next;
                t = next;
                beta
            };
            for c in 0..n {
                let x = problem.impulse(c);
                let step = x.plus_scaled(-1.0, &self.last[c]);
                self.last[c] = x;
                let y = x.plus_scaled(beta, &step);
                if beta > 0.0 {
                    problem.guess(c, &y);
                }
                self.start[c] = problem.impulse(c);
            }
            if beta > 0.0 {
                problem.refresh();
                sweeps += 1;
            }
        }
        Effort { sweeps, met: false }
    }
}
