//! What the machine's memory allows: bytes a second of a copy.

use super::Pools;
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Numbers copied, far more than any cache holds.
const LENGTH: usize = 16 << 20;
/// Numbers that a thread copies at a time.
const PART: usize = 1 << 16;
/// Copies, the quickest of which counts.
const ROUNDS: usize = 7;

/// Bytes read and written a second on one thread and on two, by the time of day.
pub fn measure(pools: &Pools) -> [f64; 2] {
    let source = vec![1.0_f64; LENGTH];
    let mut target = vec![0.0_f64; LENGTH];
    let mut quickest = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        for (pool, quickest) in pools.iter().zip(&mut quickest) {
            let clock = Instant::now();
            pool.install(|| {
                let parts = target.par_chunks_mut(PART).zip(source.par_chunks(PART));
                parts.for_each(|(to, from)| to.copy_from_slice(black_box(from)));
            });
            black_box(&mut target);
            *quickest = quickest.min(clock.elapsed().as_secs_f64());
        }
    }
    quickest.map(|seconds| 2.0 * size_of_val(&source[..]) as f64 / seconds)
}
