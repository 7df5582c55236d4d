//! Our methods on a contact problem: time, ending, and the residual on the way.

use super::TOLERANCE;
use crate::clock::Clock;
use std::hint::black_box;
use std::time::Instant;
use tribos::problem::{
    ProblemMethod, ReducedProblem, Solution, SolverOptions, SolverStatus, solve,
};

/// A run is repeated until it has taken this long, in s, but not more often than this.
const ENOUGH: f64 = 0.05;
const MOST_RUNS: usize = 25;
/// Times of two points of a curve differ by this factor at least.
const APART: f64 = 1.02;

/// One method on one problem.
#[derive(Clone, Debug)]
pub struct Run {
    /// The method asked for.
    pub method: ProblemMethod,
    /// The method that found the impulses.
    pub found_by: ProblemMethod,
    /// How it ended.
    pub ending: SolverStatus,
    /// The larger of both residuals.
    pub residual: f64,
    /// Least time of a run, in s.
    pub seconds: f64,
}

impl Run {
    /// Whether the residuals are at most the tolerance.
    pub fn is_solved(&self) -> bool {
        self.ending == SolverStatus::Converged
    }
}

fn once(problem: &ReducedProblem, method: ProblemMethod) -> Solution {
    let settings = SolverOptions {
        tolerance: TOLERANCE,
        method,
        ..SolverOptions::default()
    };
    solve(black_box(problem), &settings, |_| ())
}

/// The least time of some runs.
pub fn least(problem: &ReducedProblem, method: ProblemMethod, runs: usize) -> f64 {
    let one = || {
        let clock = Clock::start();
        black_box(once(problem, method));
        clock.seconds()
    };
    (0..runs).map(|_| one()).fold(f64::INFINITY, f64::min)
}

/// Runs a method, short runs again.
pub fn measure(problem: &ReducedProblem, method: ProblemMethod) -> Run {
    let clock = Clock::start();
    let end = once(problem, method);
    let first = clock.seconds();
    let again = ((ENOUGH / first) as usize).min(MOST_RUNS);
    Run {
        method,
        found_by: end.method,
        ending: end.ending,
        residual: end.residual.largest(),
        seconds: first.min(least(problem, method, again)),
    }
}

/// Seconds and the scaled residual as a method goes; the last point is that of its answer.
pub fn trace(problem: &ReducedProblem, method: ProblemMethod) -> Vec<(f64, f64)> {
    let settings = SolverOptions {
        tolerance: TOLERANCE,
        method,
        ..SolverOptions::default()
    };
    let mut points: Vec<(f64, f64)> = Vec::new();
    let clock = Instant::now();
    let end = solve(problem, &settings, |progress| {
        let now = clock.elapsed().as_secs_f64();
        if points.last().is_none_or(|last| now > APART * last.0) {
            points.push((now, progress.residual));
        }
    });
    points.push((clock.elapsed().as_secs_f64(), end.residual.scaled));
    points
}
