//! The melt on one thread and on two, by wall time.

use super::melt::{Melt, TIME_STEP};
use crate::timing::median;
use crate::written::{Sheet, short};
use std::time::Instant;
use tribos::md::interaction::Evaluation;
use tribos::md::pair::Shift;

/// Numbers of threads.
const THREADS: [usize; 2] = [1, 2];

/// Seconds per atom and step for each number of threads.
pub fn measure(melt: &Melt, steps: usize, rounds: usize) -> Result<Vec<f64>, String> {
    let mut times = THREADS.map(|_| Vec::with_capacity(rounds));
    for _ in 0..rounds {
        for (threads, times) in THREADS.into_iter().zip(&mut times) {
            times.push(time(melt, steps, threads)?);
        }
    }
    Ok(times.iter().map(|times| median(times)).collect())
}

fn time(melt: &Melt, steps: usize, threads: usize) -> Result<f64, String> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    let pool = pool.build().map_err(|error| error.to_string())?;
    pool.install(|| {
        let mut system = melt.system(Shift::None, TIME_STEP)?;
        let clock = Instant::now();
        for _ in 0..steps {
            let done = system.step(Evaluation::Forces);
            done.map_err(|error| error.to_string())?;
        }
        Ok(clock.elapsed().as_secs_f64() / (steps * melt.atoms.len()) as f64)
    })
}

/// A row for each number of threads.
pub fn sheet(times: &[f64], atoms: usize, rounds: usize) -> Sheet {
    let row = |(threads, &time): (usize, &f64)| {
        let speedup = short(times[0] / time);
        vec![threads.to_string(), short(1e-6 / time), speedup]
    };
    Sheet {
        about: format!(
            "Threads: the melt of {atoms} atoms by the time of day, median of {rounds} rounds in turn; \
             other work on the machine shows"
        ),
        header: vec!["threads", "million atom-steps/s", "speed over one"],
        rows: THREADS.into_iter().zip(times).map(row).collect(),
    }
}
