//! Times on a noisy machine: interleaved rounds, medians, ratios within a round.
//!
//! All tasks run once per round, so that a slow second of the machine affects them alike. A ratio
//! is the median of the rounds' ratios, not the ratio of two medians.

use crate::clock::Clock;

/// A sample shorter than this is lost in the clock and the scheduler; in s.
const SHORTEST_SAMPLE: f64 = 250e-6;
/// The shortest time that a run can take; in s.
const SHORTEST_RUN: f64 = 1e-9;

/// Something to time.
pub struct Task<'a> {
    /// Name of the task in reports.
    pub name: String,
    /// Evaluations in one run.
    pub elements: usize,
    /// One run. Inputs and results belong behind `black_box`.
    pub run: Box<dyn FnMut() + 'a>,
}

impl core::fmt::Debug for Task<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Task")
            .field("name", &self.name)
            .field("elements", &self.elements)
            .finish_non_exhaustive()
    }
}

impl<'a> Task<'a> {
    /// Names a closure that evaluates `elements` times.
    pub fn new(name: impl Into<String>, elements: usize, run: impl FnMut() + 'a) -> Self {
        Self {
            name: name.into(),
            elements,
            run: Box::new(run),
        }
    }

    /// Runs it `repeats` times; seconds per evaluation.
    fn sample(&mut self, repeats: u32) -> f64 {
        let clock = Clock::start();
        for _ in 0..repeats {
            (self.run)();
        }
        clock.seconds() / (f64::from(repeats) * self.elements as f64)
    }

    /// Runs that fill the shortest sample, from a warm second run.
    fn repeats(&mut self) -> u32 {
        (self.run)();
        let clock = Clock::start();
        (self.run)();
        let once = clock.seconds().max(SHORTEST_RUN);
        (SHORTEST_SAMPLE / once) as u32 + 1
    }
}

/// Samples of all tasks, round by round.
#[derive(Clone, Debug)]
pub struct Samples {
    names: Vec<String>,
    /// Seconds per evaluation, one list a task.
    seconds: Vec<Vec<f64>>,
}

/// Times all tasks `rounds` times in turn.
pub fn interleaved(mut tasks: Vec<Task<'_>>, rounds: usize) -> Samples {
    let repeats: Vec<u32> = tasks.iter_mut().map(Task::repeats).collect();
    let mut seconds = vec![Vec::with_capacity(rounds); tasks.len()];
    for _ in 0..rounds {
        for ((task, &repeats), list) in tasks.iter_mut().zip(&repeats).zip(&mut seconds) {
            list.push(task.sample(repeats));
        }
    }
    let names = tasks.into_iter().map(|task| task.name).collect();
    Samples { names, seconds }
}

impl Samples {
    /// Median seconds per evaluation of every task, in the order given.
    pub fn medians(&self) -> Vec<f64> {
        self.seconds.iter().map(|list| median(list)).collect()
    }

    /// Median of time(`numerator`)/time(`denominator`) over the rounds; `None` for an unknown
    /// name.
    pub fn ratio(&self, numerator: &str, denominator: &str) -> Option<f64> {
        let (above, below) = (self.of(numerator)?, self.of(denominator)?);
        let ratios: Vec<f64> = above.iter().zip(below).map(|(a, b)| a / b).collect();
        Some(median(&ratios))
    }

    fn of(&self, name: &str) -> Option<&[f64]> {
        let index = self.names.iter().position(|n| n == name)?;
        Some(&self.seconds[index])
    }
}

/// The middle value; NaN of nothing.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_and_ratios_come_in_order() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
        assert!(median(&[]).is_nan());
        let tasks = vec![Task::new("a", 1, || ()), Task::new("b", 1, || ())];
        let samples = interleaved(tasks, 3);
        assert_eq!(samples.medians().len(), 2);
        assert!(samples.ratio("a", "b").is_some());
        assert!(samples.ratio("a", "c").is_none());
    }
}
