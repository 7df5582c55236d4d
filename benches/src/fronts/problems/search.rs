//! Which solver of Siconos solves a problem, with which storage and with which tolerance of its own.

use super::Extent;
use super::siconos::{Answer, Job, SiconosProblem, SolverRun, Storage, is_usual};
use rayon::prelude::*;

/// Exponents of a solver's own tolerance: the first, the strictest and the loosest.
const FIRST: i32 = 8;
const STRICTEST: i32 = 13;
const LOOSEST: i32 = 5;
/// Crashes after which a solver is given up.
const MOST_CRASHES: usize = 2;
/// Part of the time allowed after which a solver that ends above the tolerance is not asked for more.
const SLOW: f64 = 0.1;
/// Time that another storage may take over that of blocks, and time that it always may, in s.
const SLOWER: f64 = 5.0;
const ALWAYS: f64 = 1.0;
/// Contacts times components up to which matrices are stored dense.
const LARGEST_DENSE: usize = 2000;

/// How a job ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Both residuals are at most the tolerance.
    Solved(Answer),
    /// The residual is larger, whatever the solver's own tolerance.
    Above(f64),
    /// It took too long.
    OutOfTime,
    /// The solver crashed.
    Crashed,
}

/// A solver with a storage, and how it ended.
#[derive(Clone, Debug)]
pub struct Trial {
    /// Solver, storage, and the tolerance with which it ended.
    pub job: Job,
    /// How it ended.
    pub outcome: Outcome,
}

impl Trial {
    /// Seconds of one that solves the problem.
    pub fn seconds(&self) -> Option<f64> {
        match self.outcome {
            Outcome::Solved(answer) => Some(answer.seconds),
            _ => None,
        }
    }
}

/// All solvers with all storages.
pub fn search(posed: &SiconosProblem<'_>, extent: &Extent) -> Result<Vec<Trial>, String> {
    let size = posed.problem.layout().size();
    let wanted = |name: &&str| !extent.usual_only || is_usual(name);
    let solvers: Vec<&str> = posed.siconos.solvers(size).filter(wanted).collect();
    let trials: Result<Vec<Vec<Trial>>, String> = solvers
        .into_par_iter()
        .with_max_len(1)
        .map(|solver| storages(posed, solver, extent))
        .collect();
    Ok(trials?.concat())
}

/// One solver with all storages: blocks first, then others near the time and the tolerance of blocks.
fn storages(
    posed: &SiconosProblem<'_>,
    solver: &str,
    extent: &Extent,
) -> Result<Vec<Trial>, String> {
    let (mut trials, mut first, mut limit) = (Vec::new(), FIRST, extent.seconds);
    for &storage in extent.storages {
        if storage == Storage::Dense && posed.problem.q().len() > LARGEST_DENSE {
            continue;
        }
        let seek = Seek {
            posed,
            solver,
            storage,
            limit,
        };
        let trial = seek.tolerance(first)?;
        if let Outcome::Solved(answer) = trial.outcome {
            first = -trial.job.tolerance.log10().round() as i32;
            limit = limit.min(ALWAYS + SLOWER * answer.seconds);
        }
        trials.push(trial);
    }
    Ok(trials)
}

/// A solver that looks for a tolerance.
struct Seek<'a> {
    posed: &'a SiconosProblem<'a>,
    solver: &'a str,
    storage: Storage,
    limit: f64,
}

impl Seek<'_> {
    fn job(&self, exponent: i32) -> Job {
        Job {
            solver: self.solver.into(),
            storage: self.storage,
            tolerance: 10_f64.powi(-exponent),
        }
    }

    fn run(&self, job: &Job) -> Result<SolverRun, String> {
        self.posed.run(job, self.limit, 1)
    }

    /// Tightens the solver's own tolerance until the residual is small, or loosens it for as long as it is.
    fn tolerance(&self, first: i32) -> Result<Trial, String> {
        let (mut last, mut crashes) = (None, 0);
        for exponent in first..=STRICTEST {
            let job = self.job(exponent);
            let ran = self.run(&job)?;
            let outcome = outcome(&ran);
            let trial = Trial { job, outcome };
            match outcome {
                Outcome::Solved(_) if exponent == first => return self.loosen(trial, exponent),
                Outcome::Solved(_) | Outcome::OutOfTime => return Ok(last_above(last, trial)),
                Outcome::Crashed => crashes += 1,
                Outcome::Above(_) => (),
            }
            let is_slow = |answer: &Answer| answer.seconds > SLOW * self.limit;
            let is_over = crashes == MOST_CRASHES || ran.answers.iter().any(is_slow);
            last = Some(trial);
            if is_over {
                break;
            }
        }
        last.ok_or_else(|| "no tolerance to begin with".into())
    }

    /// The loosest tolerance that still does, if it saves time.
    fn loosen(&self, mut best: Trial, from: i32) -> Result<Trial, String> {
        for exponent in (LOOSEST..from).rev() {
            let job = self.job(exponent);
            let outcome = outcome(&self.run(&job)?);
            let Outcome::Solved(answer) = outcome else {
                break;
            };
            if best.seconds().is_some_and(|least| answer.seconds < least) {
                best = Trial { job, outcome };
            }
        }
        Ok(best)
    }
}

/// A trial that took too long after one that ended says less than that one.
fn last_above(last: Option<Trial>, now: Trial) -> Trial {
    match (last, now.outcome) {
        (Some(last), Outcome::OutOfTime) if matches!(last.outcome, Outcome::Above(_)) => last,
        _ => now,
    }
}

fn outcome(ran: &SolverRun) -> Outcome {
    match ran.answers.first() {
        Some(answer) if answer.is_solved() => Outcome::Solved(*answer),
        Some(answer) => Outcome::Above(answer.residual),
        None if ran.is_out_of_time => Outcome::OutOfTime,
        None => Outcome::Crashed,
    }
}
