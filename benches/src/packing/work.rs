//! Sweeps and time that a method needs to reach a residual, which is computed from the impulses
//! outside the timing.

use super::conjugate;
use crate::clock::Clock;
use tribos::cd::internals::{Accelerated, Coefficients, NoMonitor, Spheres, Sweeper, residual};
use tribos::cd::{IterationOrder, Iterations};
use tribos_core::contact::ContactFriction;

/// The compared methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Plain non-linear Gauss–Seidel.
    GaussSeidel(IterationOrder),
    /// Conjugate directions over symmetric sweeps, the baseline.
    Conjugate,
    /// Sweeps with momentum.
    Accelerated,
}

/// Plain and accelerated methods.
pub const METHODS: [Method; 5] = [
    Method::GaussSeidel(IterationOrder::Fixed),
    Method::GaussSeidel(IterationOrder::Alternating),
    Method::GaussSeidel(IterationOrder::Random { seed: 1 }),
    Method::Conjugate,
    Method::Accelerated,
];

impl Method {
    /// Name of the method in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::GaussSeidel(IterationOrder::Fixed) => "GS fixed order",
            Self::GaussSeidel(IterationOrder::Alternating) => "GS alternating",
            Self::GaussSeidel(IterationOrder::Random { .. }) => "GS random order",
            Self::Conjugate => "conjugate",
            Self::Accelerated => "accelerated",
        }
    }

    /// Solves by the method's own rule; plain sweeps are not meant here.
    pub(super) fn iterate<F: ContactFriction<f64>>(
        self,
        problem: &mut Spheres<F>,
        tolerance: f64,
        most: usize,
    ) -> Iterations {
        match self {
            Self::Accelerated => Accelerated::default().solve(problem, tolerance, most),
            _ => conjugate::solve(problem, tolerance, most),
        }
    }
}

/// Work of a solution, and the residual reached.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    /// Sweeps, extrapolations included.
    pub sweeps: usize,
    /// Time of the sweeps.
    pub seconds: f64,
    /// Residual at the end.
    pub residual: f64,
}

/// Plain sweeps between two checks of the residual: one, and one more for every `LOOKS` so far.
const LOOKS: usize = 50;
/// First tolerance tried for a residual, in its units, and the ratio to the next.
const FIRST: f64 = 2.0;
const NEXT: f64 = 0.8;

/// The work to a residual of `target`, `None` if `most` sweeps do not reach it.
pub fn work_to<F>(start: &Spheres<F>, method: Method, target: f64, most: usize) -> Option<Work>
where
    F: ContactFriction<f64> + Coefficients,
{
    match method {
        Method::GaussSeidel(order) => plain_to(start, order, target, most),
        _ => tolerances_to(start, method, target, most),
    }
}

/// Plain sweeps with occasional checks of the residual.
fn plain_to<F>(start: &Spheres<F>, order: IterationOrder, target: f64, most: usize) -> Option<Work>
where
    F: ContactFriction<f64> + Coefficients,
{
    let mut problem = start.clone();
    let mut sweeper = Sweeper::new(order, 0);
    let (mut sweeps, mut seconds) = (0, 0.0);
    while sweeps < most {
        let more = 1 + sweeps / LOOKS;
        let clock = Clock::start();
        for _ in 0..more {
            sweeper.sweep(&mut problem, &mut NoMonitor);
        }
        seconds += clock.seconds();
        sweeps += more;
        let residual = residual(&problem).relative;
        if residual <= target {
            return Some(Work {
                sweeps,
                seconds,
                residual,
            });
        }
    }
    None
}

/// The first tolerance, from coarse to fine, that reaches the residual.
fn tolerances_to<F>(start: &Spheres<F>, method: Method, target: f64, most: usize) -> Option<Work>
where
    F: ContactFriction<f64> + Coefficients,
{
    let mut tolerance = FIRST * target;
    loop {
        let mut problem = start.clone();
        let clock = Clock::start();
        let effort = method.iterate(&mut problem, tolerance, most);
        let seconds = clock.seconds();
        let residual = residual(&problem).relative;
        if residual <= target {
            return Some(Work {
                sweeps: effort.sweeps,
                seconds,
                residual,
            });
        }
        if !effort.met {
            return None;
        }
        tolerance *= NEXT;
    }
}
