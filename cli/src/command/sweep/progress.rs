//! How far a sweep is, on standard error.

use crate::command::progress::{in_words, show};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Counts runs as they end.
#[derive(Debug)]
pub struct Progress {
    started: Instant,
    total: usize,
    kept: usize,
    jobs: usize,
    ended: Mutex<Ended>,
}

/// Runs that ended since the start.
#[derive(Debug, Default)]
struct Ended {
    runs: usize,
    /// Sum of their times.
    spent: Duration,
}

impl Progress {
    /// Of `total` runs, of which some were `kept` and the others go `jobs` at a time.
    pub fn start(total: usize, kept: usize, jobs: usize) -> Self {
        if kept > 0 {
            crate::command::note(format_args!("{kept} of {total} runs kept"));
        }
        Self {
            started: Instant::now(),
            total,
            kept,
            jobs,
            ended: Mutex::default(),
        }
    }

    /// One run took so long; one line about it and about what is left.
    pub fn ended(&self, name: &str, told: &str, took: Duration) {
        let mut ended = self.counts();
        ended.runs += 1;
        ended.spent += took;
        let done = self.kept + ended.runs;
        let gone = in_words(self.started.elapsed());
        let left = match self.total - done {
            0 => "all done".to_owned(),
            left => format!("about {} left", in_words(ended.left(left, self.jobs))),
        };
        let total = self.total;
        show(
            done as f64 / total as f64,
            format_args!("{done}/{total} {name}: {told}; {gone} gone, {left}"),
        );
    }

    /// Runs that are done, those before the start among them.
    pub fn done(&self) -> usize {
        self.kept + self.counts().runs
    }

    fn counts(&self) -> MutexGuard<'_, Ended> {
        self.ended.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Ended {
    /// What the others take if each takes the mean of those that ended: what is under way is
    /// counted as just begun, so that the estimate errs to the long side.
    fn left(&self, runs: usize, jobs: usize) -> Duration {
        let mean = self.spent.as_secs_f64() / self.runs.max(1) as f64;
        let rounds = runs as f64 / jobs.clamp(1, runs) as f64;
        Duration::try_from_secs_f64(rounds * mean).unwrap_or(Duration::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_follows_from_the_runs_that_ended() {
        let ended = Ended {
            runs: 2,
            spent: Duration::from_secs(20),
        };
        assert_eq!(ended.left(6, 2), Duration::from_secs(30));
        // One run cannot be shared.
        assert_eq!(ended.left(1, 8), Duration::from_secs(10));
    }
}
