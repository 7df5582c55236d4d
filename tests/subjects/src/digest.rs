//! One number for the bits of a subject's answers, to compare platforms with.

use crate::{RUN, Subject, seed_of};

/// Inputs in a digest per unit of a subject's share.
const INPUTS: u64 = 32;
/// What stands in a digest for an input that breaks a property.
const BROKEN: u64 = u64::MAX;
const DIGESTS: &str = include_str!("../digests.txt");

/// 64-bit Fowler–Noll–Vo hash, version 1a.
#[derive(Clone, Copy, Debug)]
struct Fnv(u64);

const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const FNV_PRIME: u64 = 0x0000_0100_0000_01b3;

impl Fnv {
    fn feed(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(FNV_PRIME);
        }
    }
}

impl Subject {
    /// The digest of its answers to the first inputs of the run [`RUN`].
    pub fn digest(&self) -> u64 {
        let mut hash = Fnv(FNV_OFFSET);
        for index in 0..INPUTS * self.share {
            if self
                .take(seed_of(RUN, index), &mut |bits| hash.feed(bits))
                .is_err()
            {
                hash.feed(BROKEN);
            }
        }
        hash.0
    }

    /// The digest that it has to have on every platform.
    pub fn pinned(&self) -> Option<u64> {
        let of = |line: &'static str| line.rsplit_once(' ');
        let mut lines = DIGESTS.lines().filter_map(of);
        let (_, digest) = lines.find(|(of, _)| *of == self.name)?;
        u64::from_str_radix(digest.strip_prefix("0x")?, 16).ok()
    }
}

/// One digest over those of several subjects, in their order.
pub fn whole(digests: impl IntoIterator<Item = u64>) -> u64 {
    let mut hash = Fnv(FNV_OFFSET);
    for digest in digests {
        hash.feed(digest);
    }
    hash.0
}
