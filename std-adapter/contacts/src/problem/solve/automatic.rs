//! Which method, for how long.

use super::super::reduced::ReducedProblem;
use super::super::residual::{ProblemResidual, residual};
use super::super::squeeze::Squeeze;
use super::gradient::Gradient;
use super::interior::Interior;
use super::newton::{CostLimit, ProximalProblem, newton};
use super::options::{ProblemMethod, Solution, SolverOptions, SolverProgress, SolverStatus};
use super::prepared::Prepared;
use super::proof::squeeze;
use super::proximal::proximal;
use super::sweeps::Sweeps;
use super::system::System;

/// Sweeps between two judgements.
const BETWEEN: usize = 5;
/// Sweeps without half the residual after which sweeping on ends, beside twice those before.
const PATIENCE: usize = 2000;
/// Residual that a solution by factorisations alone aims at: light bodies under heavy ones need it.
const FINEST: f64 = 1e-14;
/// Steps of the interior point method.
const INTERIOR_STEPS: usize = 100;
/// Factorisations that the interior point method and its finish are expected to take.
const EXPECTED: f64 = 20.0;
/// Newton's method is tried below this scaled residual, and then at each further factor.
const NEAR: f64 = 0.03;
const NEARER: f64 = 0.01;
/// Steps of that trial, and halvings of each: a trial that fails costs one factorisation.
const FINISH: CostLimit = CostLimit {
    steps: 10,
    halvings: 3,
};
/// Steps without a lower residual, and steps that are short, after which the interior point method ends; and a step
/// that is none.
const MOST_IDLE: usize = 12;
const MOST_SHORT: usize = 3;
const SHORT_STEP: f64 = 0.2;
const NO_STEP: f64 = 1e-8;
const PROXIMAL_STEPS: usize = 60;
/// Rounds of sweeps and proximal points from the best point.
const ROUNDS: usize = 10;

/// Solves a contact problem. `watch` sees the work and the residual as they go.
///
/// The answer is the same on every machine. A problem that is not solved ends with the best point found: as
/// [`SolverStatus::Insoluble`] where it is proven that nothing solves it, else as [`SolverStatus::Stalled`] or
/// [`SolverStatus::OutOfWork`].
///
/// [`ReducedProblem`] has an example.
#[must_use]
pub fn solve(
    problem: &ReducedProblem,
    settings: &SolverOptions,
    watch: impl FnMut(&SolverProgress),
) -> Solution {
    let prepared = Prepared::new(problem);
    let mut run = Run::new(problem, settings, &prepared, watch);
    let factorisations = run.all();
    run.prove();
    run.end(factorisations)
}

/// Solves a problem with factorisations alone; `None` if that is foreseen to take more than `most_cost`
/// multiplications, or does not converge.
pub(crate) fn solve_directly(
    problem: &ReducedProblem,
    tolerance: f64,
    most_cost: f64,
) -> Option<Solution> {
    let prepared = Prepared::new(problem);
    if EXPECTED * System::least_cost(&prepared) > most_cost {
        return None;
    }
    let mut system = System::new(&prepared);
    let step_cost = system.cost(&prepared);
    if EXPECTED * step_cost > most_cost {
        return None;
    }
    let settings = SolverOptions {
        tolerance: FINEST.min(tolerance),
        // What was foreseen is also the most that is spent.
        most_factorisations: (most_cost / step_cost) as usize,
        ..SolverOptions::default()
    };
    let mut run = Run::new(problem, &settings, &prepared, |_: &SolverProgress| ());
    let solved =
        run.interior(&mut system) || run.proximal(&mut system, &vec![0.0; prepared.q.len()]);
    (solved || run.judged.meets(tolerance)).then(|| run.end(system.factorisations))
}

struct Run<'a, W> {
    problem: &'a ReducedProblem,
    settings: &'a SolverOptions,
    prepared: &'a Prepared,
    watch: W,
    /// The best impulses, in the units of the problem, and their residual.
    best: Vec<f64>,
    judged: ProblemResidual,
    sweeps: usize,
    factorisations: usize,
    method: ProblemMethod,
    /// Whether a proof that there is no solution was looked for, and what was found.
    is_searched: bool,
    squeeze: Option<Squeeze>,
    /// Scaled residual that the methods aim at: it falls below the tolerance where the plain one is larger.
    goal: f64,
}

impl<'a, W: FnMut(&SolverProgress)> Run<'a, W> {
    fn new(
        problem: &'a ReducedProblem,
        settings: &'a SolverOptions,
        prepared: &'a Prepared,
        watch: W,
    ) -> Self {
        let best = vec![0.0; problem.q.len()];
        Self {
            judged: residual(problem, &best),
            problem,
            settings,
            prepared,
            watch,
            best,
            sweeps: 0,
            factorisations: 0,
            method: settings.method,
            is_searched: false,
            squeeze: None,
            goal: settings.tolerance,
        }
    }

    fn end(self, factorisations: usize) -> Solution {
        let settings = self.settings;
        let ending = if self.judged.meets(settings.tolerance) {
            SolverStatus::Converged
        } else if self.squeeze.is_some() {
            SolverStatus::Insoluble
        } else if self.sweeps >= settings.most_sweeps
            || factorisations >= settings.most_factorisations
        {
            SolverStatus::OutOfWork
        } else {
            SolverStatus::Stalled
        };
        Solution {
            velocities: self.problem.velocities(&self.best),
            impulses: self.best,
            residual: self.judged,
            ending,
            squeeze: self.squeeze,
            method: self.method,
            sweeps: self.sweeps,
            factorisations,
        }
    }

    /// Runs the methods; returns the number of factorisations.
    fn all(&mut self) -> usize {
        let given = self.settings.start.as_ref().filter(|start| {
            start.len() == self.problem.q.len() && start.iter().all(|r| r.is_finite())
        });
        let start = match given {
            Some(start) => self.prepared.scaled(start, self.problem),
            None => vec![0.0; self.prepared.q.len()],
        };
        // No impulses have been judged already.
        let solved = match given {
            Some(_) => self.accept_iterate(&start, self.settings.method),
            None => self.judged.meets(self.settings.tolerance),
        };
        if solved {
            return 0;
        }
        let asked = self.settings.method;
        if asked == ProblemMethod::Gradient {
            self.gradient(start);
            return 0;
        }
        let mut sweeps = Sweeps::new(self.prepared, start);
        let mut system = None;
        if matches!(asked, ProblemMethod::Automatic | ProblemMethod::Sweeps)
            && (self.sweep(&mut sweeps, &mut system) || asked == ProblemMethod::Sweeps)
        {
            return system.map_or(0, |system: System| system.factorisations);
        }
        let mut system = system.unwrap_or_else(|| System::new(self.prepared));
        let solved = (asked != ProblemMethod::Proximal && self.interior(&mut system))
            || (asked != ProblemMethod::Interior && self.proximal(&mut system, &sweeps.r));
        if !solved && asked == ProblemMethod::Automatic && !self.prove() {
            // Slow, but some problems yield to nothing else: unsymmetric ones to gradients alone.
            if !self.alternate(&mut system) && !self.sweep_on(&mut sweeps) {
                self.gradient(vec![0.0; self.prepared.q.len()]);
            }
        }
        system.factorisations
    }

    /// Looks once for a proof that a problem that is not solved has no solution. Tells whether there is one.
    fn prove(&mut self) -> bool {
        let tolerance = self.settings.tolerance;
        if !self.is_searched && !self.judged.meets(tolerance) {
            self.is_searched = true;
            // Methods without factorisations may be asked for because these are too dear.
            let most_cost = match self.settings.method {
                ProblemMethod::Sweeps | ProblemMethod::Gradient => {
                    self.sweeps as f64 * Sweeps::cost(self.prepared)
                }
                ProblemMethod::Automatic | ProblemMethod::Interior | ProblemMethod::Proximal => {
                    f64::INFINITY
                }
            };
            self.squeeze = squeeze(self.problem, tolerance, most_cost);
        }
        self.squeeze.is_some()
    }

    /// Sweeps and proximal points in turn from the best point: packings with weak friction stall under each alone.
    fn alternate(&mut self, system: &mut System) -> bool {
        for _ in 0..ROUNDS {
            let best = self.prepared.scaled(&self.best, self.problem);
            let mut sweeps = Sweeps::new(self.prepared, best);
            for _ in 0..PATIENCE / BETWEEN {
                if self.sweeps >= self.settings.most_sweeps {
                    return false;
                }
                if self.run_sweep_batch(&mut sweeps).1 {
                    return true;
                }
            }
            self.accept_iterate(&sweeps.r, ProblemMethod::Sweeps);
            let best = self.prepared.scaled(&self.best, self.problem);
            if self.approach(system, best) {
                return true;
            }
            if system.factorisations >= self.settings.most_factorisations {
                break;
            }
        }
        false
    }

    /// Proximal points from the best point, then from where sweeps ended.
    fn proximal(&mut self, system: &mut System, swept: &[f64]) -> bool {
        let best = self.prepared.scaled(&self.best, self.problem);
        self.approach(system, best) || self.approach(system, swept.to_vec())
    }

    /// Judges a point, keeps it if it is the best, and tells whether it solves the problem.
    fn accept_iterate(&mut self, r: &[f64], method: ProblemMethod) -> bool {
        let impulses = self.prepared.unscaled(r, self.problem);
        let judged = residual(self.problem, &impulses);
        let meets = judged.meets(self.settings.tolerance);
        self.tell(method, judged.largest());
        if meets || judged.worst() < self.judged.worst() || self.judged.worst().is_nan() {
            self.best = impulses;
            self.judged = judged;
            self.method = method;
        }
        if meets {
            return true;
        }
        // The scaled residual is small enough, the plain one is not: aim lower.
        if judged.scaled <= self.goal {
            self.goal =
                (0.3 * judged.scaled * (self.settings.tolerance / judged.relative).min(1.0))
                    .max(1e-16);
        }
        false
    }

    /// Sweeps until they solve the problem, or until something else is cheaper. Tells whether they do.
    fn sweep(&mut self, sweeps: &mut Sweeps, system: &mut Option<System>) -> bool {
        let problem = self.prepared;
        let mut history: Vec<f64> = Vec::new();
        let cost = Sweeps::cost(problem);
        while self.sweeps < self.settings.most_sweeps {
            let (residual, solved) = self.run_sweep_batch(sweeps);
            if solved {
                return true;
            }
            history.push(residual);
            if self.settings.method == ProblemMethod::Automatic {
                let left = predicted_sweeps(&history, self.goal) * cost;
                // The pattern's factors are worth looking at.
                if left > EXPECTED * System::least_cost(problem) {
                    let other = system.get_or_insert_with(|| System::new(problem));
                    if left > EXPECTED * other.cost(problem) {
                        break;
                    }
                }
            }
        }
        self.accept_iterate(&sweeps.r, ProblemMethod::Sweeps)
    }

    /// Sweeps for as long as the residual falls. Tells whether they solve the problem.
    fn sweep_on(&mut self, sweeps: &mut Sweeps) -> bool {
        let (mut lowest, mut since) = (f64::INFINITY, self.sweeps);
        while self.sweeps < self.settings.most_sweeps && self.sweeps < 2 * since + PATIENCE {
            let (residual, solved) = self.run_sweep_batch(sweeps);
            if solved {
                return true;
            }
            if residual < 0.5 * lowest {
                (lowest, since) = (residual, self.sweeps);
            }
        }
        self.accept_iterate(&sweeps.r, ProblemMethod::Sweeps)
    }

    /// Projected gradients for as long as the residual falls.
    fn gradient(&mut self, start: Vec<f64>) {
        let mut gradient = Gradient::new(self.prepared, start);
        let mut u = vec![0.0; gradient.r.len()];
        let (mut lowest, begun) = (f64::INFINITY, self.sweeps);
        let mut since = 0;
        while self.sweeps < self.settings.most_sweeps && self.sweeps - begun < 2 * since + PATIENCE
        {
            for _ in 0..BETWEEN {
                gradient.advance(self.prepared);
            }
            self.sweeps += BETWEEN;
            self.prepared.velocities(&gradient.r, &mut u);
            let residual = self.prepared.residual(&gradient.r, &u);
            self.tell(ProblemMethod::Gradient, residual);
            if residual <= self.goal && self.accept_iterate(&gradient.r, ProblemMethod::Gradient) {
                return;
            }
            if residual < 0.5 * lowest {
                (lowest, since) = (residual, self.sweeps - begun);
            }
        }
        self.accept_iterate(&gradient.r, ProblemMethod::Gradient);
    }

    /// A few sweeps; returns the scaled residual, and whether the problem is solved.
    fn run_sweep_batch(&mut self, sweeps: &mut Sweeps) -> (f64, bool) {
        for _ in 0..BETWEEN {
            sweeps.sweep(self.prepared);
        }
        self.sweeps += BETWEEN;
        let mut u = vec![0.0; sweeps.r.len()];
        self.prepared.velocities(&sweeps.r, &mut u);
        let residual = self.prepared.residual(&sweeps.r, &u);
        self.tell(ProblemMethod::Sweeps, residual);
        let solved = residual <= self.goal && self.accept_iterate(&sweeps.r, ProblemMethod::Sweeps);
        (residual, solved)
    }

    /// The interior point method from one start, and from another one if steps are short.
    fn interior(&mut self, system: &mut System) -> bool {
        let cold = Interior::start_at_unit(self.prepared);
        if self.follow(system, cold, true) {
            return true;
        }
        let laden = Interior::start_at_stopping_impulse(self.prepared, system);
        self.follow(system, laden, false)
    }

    /// Follows the interior point method, and tries Newton's where it is near. Ends without an answer after a few
    /// short steps if `impatient`.
    fn follow(&mut self, system: &mut System, mut point: Interior, impatient: bool) -> bool {
        let problem = self.prepared;
        let mut next = NEAR;
        let mut lowest = f64::INFINITY;
        let (mut idle, mut short) = (0, 0);
        for _ in 0..INTERIOR_STEPS {
            if system.factorisations >= self.settings.most_factorisations
                || !point.advance(problem, system)
            {
                break;
            }
            let residual = problem.residual(&point.r, &point.u);
            self.factorisations = system.factorisations;
            self.tell(ProblemMethod::Interior, residual);
            if residual <= self.goal && self.accept_iterate(&point.r, ProblemMethod::Interior) {
                return true;
            }
            if residual < next {
                next = NEARER * residual;
                let mut trial = point.r.clone();
                let goal = 0.5 * self.goal;
                let solved = newton(
                    problem,
                    system,
                    ProximalProblem::NOTHING,
                    &mut trial,
                    (goal, FINISH),
                );
                self.factorisations = system.factorisations;
                if solved && self.accept_iterate(&trial, ProblemMethod::Interior) {
                    return true;
                }
            }
            idle = if residual < 0.9 * lowest { 0 } else { idle + 1 };
            lowest = lowest.min(residual);
            short = if point.step < SHORT_STEP {
                short + 1
            } else {
                0
            };
            if idle > MOST_IDLE || point.step < NO_STEP || (impatient && short > MOST_SHORT) {
                break;
            }
        }
        self.accept_iterate(&point.r, ProblemMethod::Interior)
    }

    /// Proximal points.
    fn approach(&mut self, system: &mut System, mut r: Vec<f64>) -> bool {
        let problem = self.prepared;
        for _ in 0..3 {
            let most = self.settings.most_factorisations;
            let goal = (0.5 * self.goal, PROXIMAL_STEPS);
            let solved = proximal(problem, system, &mut r, goal, |residual, system| {
                self.factorisations = system.factorisations;
                self.tell(ProblemMethod::Proximal, residual);
                system.factorisations >= most
            });
            if self.accept_iterate(&r, ProblemMethod::Proximal) {
                return true;
            }
            if !solved {
                return false;
            }
        }
        false
    }

    fn tell(&mut self, method: ProblemMethod, residual: f64) {
        (self.watch)(&SolverProgress {
            sweeps: self.sweeps,
            factorisations: self.factorisations,
            residual,
            method,
        });
    }
}

/// Sweeps that remain if the residual falls as it did over the second half of its history.
fn predicted_sweeps(history: &[f64], goal: f64) -> f64 {
    let [.., now] = history else { return 0.0 };
    if history.len() < 3 {
        return 0.0;
    }
    let middle = history.len() / 2;
    let before = history[middle.min(history.len() - 2)];
    let steps = (history.len() - 1 - middle.min(history.len() - 2)) as f64;
    let rate = libm::log(before / now) / steps;
    let left = libm::log(now / goal);
    if rate > 0.0 {
        left / rate * BETWEEN as f64
    } else {
        f64::INFINITY
    }
}
