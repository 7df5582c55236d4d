//! Blocks of atoms that threads share.
//!
//! What is computed for an atom does not depend on the other atoms of its block, so that any number of threads gives
//! the same bits.

use std::ops::Range;

/// Atoms of a block at least, as a power of 2: some microseconds of work, far more than handing it to a thread.
const LEAST_BITS: u32 = 11;
/// Blocks at most, as a power of 2: every chunk of a list keeps a range of its sites for each.
const MOST_BITS: u32 = 8;

/// Consecutive entries in blocks of equal length, the last of which may be shorter.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Blocks {
    bits: u32,
}

impl Blocks {
    /// Blocks of some atoms.
    pub(super) fn new(atoms: usize) -> Self {
        let Self { bits } = Self::at_most(1 << MOST_BITS, atoms);
        Self {
            bits: bits.max(LEAST_BITS),
        }
    }

    /// At most `count` blocks of some entries.
    pub(super) fn at_most(count: usize, entries: usize) -> Self {
        let len = entries.div_ceil(count.max(1)).next_power_of_two();
        Self {
            bits: len.trailing_zeros(),
        }
    }

    /// Entries of a block.
    pub(super) fn len(self) -> usize {
        1 << self.bits
    }

    /// Block of an entry.
    pub(super) fn of(self, entry: usize) -> usize {
        entry >> self.bits
    }

    /// The entries of a block of this length.
    pub(super) fn entries(self, block: usize, len: usize) -> Range<usize> {
        let start = block << self.bits;
        start..start + len
    }
}

/// The atoms of a block among ascending `members`, each with its number among them.
pub(super) fn within(
    members: &[usize],
    block: &Range<usize>,
) -> impl Iterator<Item = (usize, usize)> {
    let [first, end] = [block.start, block.end].map(|end| members.partition_point(|&a| a < end));
    (first..end).zip(members[first..end].iter().copied())
}
