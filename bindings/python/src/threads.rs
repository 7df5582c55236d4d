//! Batches on several threads: every element is computed by itself, so that the bits do not depend on
//! their number.

use crate::arrays::refused;
use pyo3::prelude::*;
use rayon::ThreadPool;
use rayon::prelude::*;
use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};

/// The threads of this process: those of a parent that forked do not exist here.
struct Pool {
    process: u32,
    threads: Arc<ThreadPool>,
}

static POOL: Mutex<Option<Pool>> = Mutex::new(None);
/// Number of threads asked for.
static ASKED: Mutex<Option<NonZeroUsize>> = Mutex::new(None);

/// The threads of this process.
pub fn pool() -> PyResult<Arc<ThreadPool>> {
    let process = std::process::id();
    let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = pool.as_ref().filter(|known| known.process == process) {
        return Ok(known.threads.clone());
    }
    let asked = *ASKED.lock().unwrap_or_else(PoisonError::into_inner);
    let builder = rayon::ThreadPoolBuilder::new().num_threads(asked.map_or(0, NonZeroUsize::get));
    let threads = Arc::new(builder.build().map_err(refused)?);
    let made = Pool {
        process,
        threads: threads.clone(),
    };
    // The threads of a parent cannot be joined.
    std::mem::forget(pool.replace(made));
    Ok(threads)
}

/// Does `work` without the interpreter's lock and on this process' threads.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = pool()?;
    Ok(py.detach(|| pool.install(work)))
}

/// Work that is worth a thread, in ns.
const WORTH_A_THREAD: usize = 50_000;
/// Work that is worth to give the interpreter's lock away, in ns.
const WORTH_A_LOCK: usize = 5_000;

/// Fills `out` by pieces: `work` receives the index of the first element and the piece. An element
/// takes about `cost` nanoseconds.
pub fn fill<T: Send>(
    py: Python<'_>,
    out: &mut [T],
    cost: usize,
    work: impl Fn(usize, &mut [T]) -> PyResult<()> + Sync,
) -> PyResult<()> {
    fill_together(py, out, cost, 1, work)
}

/// The same for elements of which `together` are quicker than one by one, in pieces of so many if there are enough
/// for all threads.
pub fn fill_together<T: Send>(
    py: Python<'_>,
    out: &mut [T],
    cost: usize,
    together: usize,
    work: impl Fn(usize, &mut [T]) -> PyResult<()> + Sync,
) -> PyResult<()> {
    let whole = out.len().saturating_mul(cost);
    if whole < WORTH_A_LOCK {
        return work(0, out);
    }
    if whole < 2 * WORTH_A_THREAD {
        return py.detach(|| work(0, out));
    }
    let pool = pool()?;
    let share = out.len().div_ceil(pool.current_num_threads());
    let grain = (WORTH_A_THREAD / cost.max(1))
        .max(together.min(share))
        .max(1);
    py.detach(|| {
        pool.install(|| {
            let pieces = out.par_chunks_mut(grain).enumerate();
            pieces.try_for_each(|(index, piece)| work(index * grain, piece))
        })
    })
}

/// Number of threads that batches and runs use.
#[pyfunction]
pub fn num_threads() -> PyResult<usize> {
    Ok(pool()?.current_num_threads())
}

/// Sets the number of threads; None for one a processor.
#[pyfunction]
pub fn set_num_threads(count: Option<NonZeroUsize>) {
    *ASKED.lock().unwrap_or_else(PoisonError::into_inner) = count;
    let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if pool
        .as_ref()
        .is_some_and(|known| known.process != std::process::id())
    {
        std::mem::forget(pool.take());
    }
    *pool = None;
}
