//! The clock of the samples, in a process of its own: nothing else may work meanwhile.

#![cfg(unix)]

use std::hint::black_box;
use std::thread::sleep;
use std::time::{Duration, Instant};
use tribos_benches::clock::Clock;

#[test]
fn waiting_takes_no_time_and_work_does() {
    let clock = Clock::start();
    sleep(Duration::from_millis(200));
    let waited = clock.seconds();
    assert!((0.0..0.05).contains(&waited), "{waited}");

    let (clock, day) = (Clock::start(), Instant::now());
    let mut sum = 0_u64;
    while clock.seconds() < 0.05 {
        sum = black_box(sum + 1);
    }
    assert!(day.elapsed().as_secs_f64() > 0.04 && sum > 0);
}
