//! Entries sorted by a small number.

/// Pairs of numbers, bucket by bucket; within a bucket they keep their order.
#[derive(Clone, Debug, Default)]
pub(super) struct Buckets {
    entries: Vec<[u32; 2]>,
    /// First entry of each bucket, and the end of the last.
    starts: Vec<u32>,
}

impl Buckets {
    /// Sorts entries into `count` buckets.
    pub(super) fn sort(
        &mut self,
        entries: impl DoubleEndedIterator<Item = [u32; 2]> + ExactSizeIterator + Clone,
        count: usize,
        bucket: impl Fn([u32; 2]) -> usize,
    ) {
        let starts = &mut self.starts;
        starts.clear();
        starts.resize(count + 1, 0);
        for entry in entries.clone() {
            starts[bucket(entry)] += 1;
        }
        accumulate(starts, 0);
        self.entries.resize(entries.len(), [0; 2]);
        // From the last entry back, ends become starts.
        for entry in entries.rev() {
            let start = &mut starts[bucket(entry)];
            *start -= 1;
            self.entries[*start as usize] = entry;
        }
    }

    /// The entries of a bucket.
    pub(super) fn get(&self, bucket: usize) -> &[[u32; 2]] {
        match self.starts.get(bucket..) {
            Some(&[start, end, ..]) => &self.entries[start as usize..end as usize],
            _ => &[],
        }
    }
}

/// Turns counts into their running sums from `start` on.
pub(super) fn accumulate(counts: &mut [u32], start: u32) {
    let mut sum = start;
    for count in counts {
        sum += *count;
        *count = sum;
    }
}
