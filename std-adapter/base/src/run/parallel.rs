//! Independent pieces of work on several threads.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Results of `work` for 0, 1, … `count` − 1 in that order, independent of `threads`; `None` for a
/// piece that panicked.
pub fn in_order<T: Send>(
    count: usize,
    threads: usize,
    work: impl Fn(usize) -> T + Sync,
) -> Vec<Option<T>> {
    let next = AtomicUsize::new(0);
    let results: Vec<_> = (0..count).map(|_| Mutex::new(None)).collect();
    std::thread::scope(|scope| {
        for _ in 0..threads.min(count) {
            scope.spawn(|| {
                while let Some((index, slot)) = {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    results.get(index).map(|slot| (index, slot))
                } {
                    let result = work(index);
                    if let Ok(mut slot) = slot.lock() {
                        *slot = Some(result);
                    }
                }
            });
        }
    });
    let results = results.into_iter();
    results
        .map(|slot| slot.into_inner().ok().flatten())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn results_keep_their_order_whatever_ends_first() {
        let work = |index: usize| {
            // The first takes longest.
            std::thread::sleep(Duration::from_millis(20 - 5 * index as u64));
            index * index
        };
        for threads in [1, 2, 9] {
            let expected = [0, 1, 4, 9].map(Some);
            assert_eq!(in_order(4, threads, work), expected);
        }
        assert!(in_order(0, 2, work).is_empty());
    }
}
