//! What a report costs, and how much of it is left.

use std::num::NonZero;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

/// Seconds of one core, as measured on one of an AMD EPYC of 2023: other machines take so many
/// times as long, and the time that is left follows their pace.
pub type Seconds = f64;

/// Share of the work after which the pace so far tells more than the measured costs.
const PACED: f64 = 0.05;

/// Work to be done, and done.
#[derive(Debug)]
pub struct Plan {
    total: Seconds,
    done: Seconds,
    started: Instant,
}

impl Plan {
    /// Starts now.
    pub fn new(total: Seconds) -> Self {
        Self {
            total,
            done: 0.0,
            started: Instant::now(),
        }
    }

    /// About how long all of it takes on this machine.
    pub fn whole(&self) -> Duration {
        rounded(self.total / cores())
    }

    /// Counts a piece; about how long the others take.
    pub fn finish(&mut self, piece: Seconds) -> Duration {
        self.done += piece;
        left(self.total, self.done, self.started.elapsed().as_secs_f64())
    }
}

/// Seconds left at the pace so far, or by the measured costs while there is none.
pub fn left(total: Seconds, done: Seconds, elapsed: f64) -> Duration {
    let rest = (total - done).max(0.0);
    let pace = if done > PACED * total && elapsed > 0.0 {
        done / elapsed
    } else {
        cores()
    };
    rounded(rest / pace)
}

/// Cores of this machine.
pub fn cores() -> f64 {
    available_parallelism().map_or(1, NonZero::get) as f64
}

fn rounded(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds.round()).unwrap_or(Duration::MAX)
}

/// "40 s", "12 min", "3 h 20 min": as exact as a forecast is.
pub fn told(time: Duration) -> String {
    let seconds = time.as_secs();
    let minutes = (seconds + 30) / 60;
    match seconds {
        0..=99 => format!("{seconds} s"),
        100..=5999 => format!("{minutes} min"),
        _ => format!("{} h {} min", minutes / 60, minutes % 60),
    }
}
