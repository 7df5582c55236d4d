//! Baseline: Gauss–Seidel sweeps as steps of non-linear conjugate gradients.
//!
//! Silcowitz-Hansen, Niebe and Erleben, Vis. Comput. 26 (2010) 893, with β of Fletcher and Reeves
//! and a restart when a displacement grows. Differences: a sweep goes forwards and backwards, which
//! is a gradient in a fixed metric where everything sticks; extrapolated impulses are projected
//! onto those that the contact admits.

use tribos::cd::Iterations;
use tribos::cd::internals::{GlobalChange, Impulse, NoMonitor, Operator, Visit};

/// Iterates until a backward sweep changes the impulses by less than `tolerance`·P in the root mean
/// square, or for `most` sweeps. An extrapolation counts as one.
pub fn solve<O: Operator>(problem: &mut O, tolerance: f64, most: usize) -> Iterations {
    let contacts = problem.contacts();
    let mut start: Vec<_> = (0..contacts).map(|c| problem.impulse(c)).collect();
    let mut direction = vec![O::Impulse::default(); contacts];
    let mut last_sq = f64::INFINITY;
    let mut sweeps = 0;
    while sweeps < most {
        let mut change = GlobalChange::default();
        problem.sweep(Visit::Forward, &mut NoMonitor);
        problem.sweep(Visit::Backward, &mut change);
        sweeps += 2;
        if change.relative() <= tolerance {
            return Iterations { sweeps, met: true };
        }
        let moved_sq = moved_sq(problem, &start);
        let beta = moved_sq / last_sq;
        last_sq = moved_sq;
        let goes_on = beta <= 1.0;
        for (contact, (start, direction)) in start.iter_mut().zip(&mut direction).enumerate() {
            let swept = problem.impulse(contact);
            if goes_on {
                let moved = swept.plus_scaled(-1.0, start);
                problem.guess(contact, &swept.plus_scaled(beta, direction));
                *direction = moved.plus_scaled(beta, direction);
            } else {
                *direction = O::Impulse::default();
            }
            *start = problem.impulse(contact);
        }
        if goes_on {
            problem.refresh();
            sweeps += 1;
        }
    }
    Iterations { sweeps, met: false }
}

/// |displacement|²
fn moved_sq<O: Operator>(problem: &O, start: &[O::Impulse]) -> f64 {
    let mut sum = 0.0;
    for (contact, start) in start.iter().enumerate() {
        let moved = problem.impulse(contact).plus_scaled(-1.0, start);
        sum += problem.dot(contact, &moved, &moved);
    }
    sum
}
