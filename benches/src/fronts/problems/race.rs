//! The race: our automatic policy and Siconos' fastest solvers in turn.

use super::Extent;
use super::ours::{self, Run};
use super::search::{Outcome, Trial};
use super::siconos::{Answer, SiconosProblem};

/// Solvers of Siconos in the race, the fastest of the search.
const BEST: usize = 3;
/// Time that repetitions of one round aim at, in s, and bounds of their number. In a new process the first one is
/// slow.
const ROUND: f64 = 5e-3;
const REPETITIONS: [usize; 2] = [2, 20];
/// A run longer than this is not repeated within a round, in s.
const LONG: f64 = 0.3;
/// Time of all rounds of a problem, in s, and the fewest rounds.
const BUDGET: f64 = 30.0;
const FEWEST: usize = 2;

/// No limit of time: what runs again is known to end.
const UNLIMITED: f64 = 0.0;
/// A run longer than this is not timed again outside the race, in s.
const LONGEST: f64 = 2.0;

/// Times again, one by one and by the processor's clock, what the search found while cores were shared.
pub fn time_again(posed: &SiconosProblem<'_>, trials: &mut [Trial]) -> Result<(), String> {
    for trial in trials {
        if let Outcome::Solved(answer) = &mut trial.outcome
            && answer.seconds < LONGEST
        {
            let ran = posed.run(&trial.job, UNLIMITED, repetitions(answer.seconds))?;
            faster(answer, ran.least());
        }
    }
    Ok(())
}

/// Runs the rounds; `run` and the trials in the race keep their least times.
pub fn race(
    posed: &SiconosProblem<'_>,
    run: &mut Run,
    trials: &mut [Trial],
    extent: &Extent,
) -> Result<(), String> {
    let in_race = candidates(trials);
    let seconds = |&at: &usize| trials[at].seconds().unwrap_or(0.0);
    let total = run.seconds + in_race.iter().map(seconds).sum::<f64>();
    let rounds = (BUDGET / total) as usize;
    for _ in 0..rounds.clamp(FEWEST, extent.rounds.max(FEWEST)) {
        let least = ours::least(posed.problem, run.method, repetitions(run.seconds));
        run.seconds = run.seconds.min(least);
        for &at in &in_race {
            let trial = &mut trials[at];
            if let Outcome::Solved(answer) = &mut trial.outcome {
                let ran = posed.run(&trial.job, UNLIMITED, repetitions(answer.seconds))?;
                faster(answer, ran.least());
            }
        }
    }
    Ok(())
}

/// The fastest, and the fastest with default options if it is none of them.
fn candidates(trials: &[Trial]) -> Vec<usize> {
    let solved = |at: &usize| trials[*at].seconds().is_some();
    let mut order: Vec<usize> = (0..trials.len()).filter(solved).collect();
    let seconds = |at: &usize| trials[*at].seconds().unwrap_or(f64::INFINITY);
    order.sort_by(|a, b| seconds(a).total_cmp(&seconds(b)));
    let usual = order.iter().position(|&at| trials[at].job.is_usual());
    let usual = usual
        .filter(|&place| place >= BEST)
        .map(|place| order[place]);
    order.truncate(BEST);
    order.extend(usual);
    order
}

fn repetitions(seconds: f64) -> usize {
    if seconds > LONG {
        return 1;
    }
    ((ROUND / seconds) as usize).clamp(REPETITIONS[0], REPETITIONS[1])
}

fn faster(answer: &mut Answer, seconds: f64) {
    answer.seconds = answer.seconds.min(seconds);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fronts::problems::siconos::{Job, Storage};

    #[test]
    fn the_fastest_race_and_the_fastest_with_default_options() {
        let trial = |solver: &str, seconds: f64| Trial {
            job: Job {
                solver: solver.into(),
                storage: Storage::Blocks,
                tolerance: 1e-8,
            },
            outcome: Outcome::Solved(Answer {
                seconds,
                residual: 0.0,
            }),
        };
        let mut trials = vec![
            trial("a+x", 3.0),
            trial("b+x", 1.0),
            trial("c", 5.0),
            trial("d", 4.0),
            trial("e+x", 2.0),
        ];
        assert_eq!(candidates(&trials), [1, 4, 0, 3]);
        trials[0].outcome = Outcome::Crashed;
        assert_eq!(candidates(&trials), [1, 4, 3]);
    }
}
