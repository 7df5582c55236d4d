//! Eight numbers of single precision side by side, for tests that may be too generous.

use std::ops::{Add, Mul, Sub};
#[cfg(target_arch = "x86_64")]
use tribos_avx2::Avx2;

/// Numbers in a register.
pub(in crate::md) const ROUGH_LANES: usize = 8;

/// One number of single precision for each of eight sites.
pub(in crate::md) trait Rough:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// What allows to make them.
    type Key: Copy;

    fn new(key: Self::Key, lanes: &[f32; ROUGH_LANES]) -> Self;

    /// The same number for all.
    fn splat(key: Self::Key, number: f32) -> Self;

    /// A bit for each lane, from the lowest: whether it is not above that of the others. NaN is not.
    fn which_not_above(self, others: Self) -> usize;

    /// A bit for each lane, from the lowest: whether it is above that of the others. NaN is not.
    #[inline(always)]
    fn which_above(self, others: Self) -> usize {
        !self.which_not_above(others) & ((1 << ROUGH_LANES) - 1)
    }

    /// These numbers in some lanes, each below eight.
    fn pick(self, lanes: &[u32; ROUGH_LANES]) -> [f32; ROUGH_LANES];

    /// Whole numbers in some lanes, each below eight.
    #[inline(always)]
    fn pick_whole(
        _: Self::Key,
        numbers: &[u32; ROUGH_LANES],
        lanes: &[u32; ROUGH_LANES],
    ) -> [u32; ROUGH_LANES] {
        std::array::from_fn(|lane| numbers[lanes[lane] as usize % ROUGH_LANES])
    }
}

impl Rough for wide::f32x8 {
    type Key = ();

    #[inline(always)]
    fn new((): (), lanes: &[f32; ROUGH_LANES]) -> Self {
        Self::new(*lanes)
    }

    #[inline(always)]
    fn splat((): (), number: f32) -> Self {
        Self::splat(number)
    }

    #[inline(always)]
    fn which_not_above(self, others: Self) -> usize {
        let above = self.simd_gt(others).to_bitmask() as usize;
        !above & ((1 << ROUGH_LANES) - 1)
    }

    #[inline(always)]
    fn pick(self, lanes: &[u32; ROUGH_LANES]) -> [f32; ROUGH_LANES] {
        let numbers = self.to_array();
        std::array::from_fn(|lane| numbers[lanes[lane] as usize % ROUGH_LANES])
    }
}

#[cfg(target_arch = "x86_64")]
impl Rough for tribos_avx2::F32x8 {
    type Key = Avx2;

    #[inline(always)]
    fn new(key: Avx2, lanes: &[f32; ROUGH_LANES]) -> Self {
        Self::new(key, lanes)
    }

    #[inline(always)]
    fn splat(key: Avx2, number: f32) -> Self {
        Self::splat(key, number)
    }

    #[inline(always)]
    fn which_not_above(self, others: Self) -> usize {
        self.not_above(others)
    }

    #[inline(always)]
    fn pick(self, lanes: &[u32; ROUGH_LANES]) -> [f32; ROUGH_LANES] {
        self.pick(lanes)
    }

    #[inline(always)]
    fn pick_whole(
        key: Avx2,
        numbers: &[u32; ROUGH_LANES],
        lanes: &[u32; ROUGH_LANES],
    ) -> [u32; ROUGH_LANES] {
        tribos_avx2::pick(key, numbers, lanes)
    }
}
