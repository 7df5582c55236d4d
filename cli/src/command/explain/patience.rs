//! How long an explanation follows a run.

use super::{duration, line};
use std::time::{Duration, Instant};

/// The longest that an explanation follows the run, and the share of the run that tells how long the rest takes.
const PATIENCE: Duration = Duration::from_secs(1);
const TELLING: f64 = 0.01;
/// The longest that it waits for that share.
const MOST_PATIENCE: Duration = Duration::from_secs(5);

/// Does `work` for as long as an explanation may take; else a line on how long all of it takes, as far as a part tells.
pub fn within<T>(work: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> T) -> Result<T, String> {
    let begun = Instant::now();
    let mut left = None;
    let done = work(&mut |share| {
        let gone = begun.elapsed();
        let goes_on = gone < PATIENCE || (share < TELLING && gone < MOST_PATIENCE);
        if !goes_on {
            let whole = gone.div_f64(share.max(TELLING));
            let least = if share < TELLING { "more than " } else { "" };
            let time = duration(whole.as_secs_f64());
            left = Some(line(
                "run",
                format!("takes {least}{time} here; its results are not told"),
            ));
        }
        goes_on
    });
    left.map_or(Ok(done), Err)
}

/// How long the run took.
pub fn takes(time: Duration) -> String {
    line(
        "run",
        format!("takes {} here", duration(time.as_secs_f64())),
    )
}
