//! How far a fit of many points is, on standard error.

use std::time::{Duration, Instant};
use tribos::fit::{FitLaw, FitProgress};

/// Time from one line to the next; what ends before the first needs none.
const PAUSE: Duration = Duration::from_secs(2);

/// Tells where a search is, now and then.
pub struct Progress {
    told: Instant,
}

impl Default for Progress {
    fn default() -> Self {
        Self {
            told: Instant::now(),
        }
    }
}

impl Progress {
    /// A step begins.
    pub fn at(&mut self, law: FitLaw, progress: FitProgress) {
        if self.told.elapsed() < PAUSE {
            return;
        }
        self.told = Instant::now();
        let FitProgress {
            points,
            search: [search, of],
            steps,
        } = progress;
        crate::command::note(format_args!(
            "{}: search {search} of {of} on {points} points, step {}",
            law.name(),
            steps + 1
        ));
    }
}
