//! Measuring time of every bench.

use criterion::Criterion;
use std::time::Duration;

/// Short enough for all benches in a few minutes, long enough for medians within some per cent.
pub fn criterion() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .sample_size(40)
}
