//! Four pairs of an atom side by side.

mod rough;

pub(super) use rough::{ROUGH_LANES, Rough};

use super::neighbours::site::{LANES, Site};
use std::ops::{Add, Div, Mul, Sub};
use tribos_avx2::Avx2;

/// One number for each of the pairs computed at once; every operation rounds as the scalar one
/// does, so all kinds of lanes give the same bits.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// What allows to make them.
    type Key: Copy;

    /// Registers of the same processor with eight rough numbers.
    type Rough: Rough<Key = Self::Key>;

    fn new(key: Self::Key, lanes: [f64; LANES]) -> Self;

    /// The same number for all.
    fn splat(key: Self::Key, number: f64) -> Self;

    fn to_array(self) -> [f64; LANES];

    fn sqrt(self) -> Self;

    /// A bit for each lane, from the lowest: whether it is less than that of the others.
    fn less_mask(self, others: Self) -> usize;

    /// `chosen` where these are less than `others`, `other` elsewhere.
    fn if_below(self, others: Self, chosen: Self, other: Self) -> Self;

    /// Places of a block of sites, axis by axis.
    #[inline(always)]
    fn places(key: Self::Key, block: [&[f64; 4]; LANES]) -> [Self; 3] {
        let [a, b, c, d] = block;
        std::array::from_fn(|axis| Self::new(key, [a[axis], b[axis], c[axis], d[axis]]))
    }

    /// Takes a force from the sites of a block.
    #[inline(always)]
    fn take(_: Self::Key, sites: &mut [Site], block: &[u32; LANES], pull: [Self; 3]) {
        let [x, y, z] = pull.map(Self::to_array);
        for (lane, &other) in block.iter().enumerate() {
            let other = &mut sites[other as usize].force;
            other[0] -= x[lane];
            other[1] -= y[lane];
            other[2] -= z[lane];
        }
    }
}

impl Lanes for wide::f64x4 {
    type Key = ();
    type Rough = wide::f32x8;

    #[inline(always)]
    fn new((): (), lanes: [f64; LANES]) -> Self {
        Self::new(lanes)
    }

    #[inline(always)]
    fn splat((): (), number: f64) -> Self {
        Self::splat(number)
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        self.to_array()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn less_mask(self, others: Self) -> usize {
        self.simd_lt(others).to_bitmask() as usize
    }

    #[inline(always)]
    fn if_below(self, others: Self, chosen: Self, other: Self) -> Self {
        self.simd_lt(others).select(chosen, other)
    }
}

#[cfg(target_arch = "x86_64")]
impl Lanes for tribos_avx2::F64x4 {
    type Key = Avx2;
    type Rough = tribos_avx2::F32x8;

    #[inline(always)]
    fn new(key: Avx2, lanes: [f64; LANES]) -> Self {
        Self::new(key, &lanes)
    }

    #[inline(always)]
    fn splat(key: Avx2, number: f64) -> Self {
        Self::splat(key, number)
    }

    #[inline(always)]
    fn to_array(self) -> [f64; LANES] {
        self.to_array()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn less_mask(self, others: Self) -> usize {
        self.below(others).bits()
    }

    #[inline(always)]
    fn if_below(self, others: Self, chosen: Self, other: Self) -> Self {
        self.below(others).select(chosen, other)
    }

    #[inline(always)]
    fn places(key: Avx2, block: [&[f64; 4]; LANES]) -> [Self; 3] {
        let [x, y, z, _] = Self::transpose(block.map(|place| Self::new(key, place)));
        [x, y, z]
    }

    #[inline(always)]
    fn take(key: Avx2, sites: &mut [Site], block: &[u32; LANES], [x, y, z]: [Self; 3]) {
        // The fourth number of a force stays as it is.
        let pulls = Self::transpose([x, y, z, Self::splat(key, 0.0)]);
        for (&other, pull) in block.iter().zip(pulls) {
            let force = &mut sites[other as usize].force;
            (Self::new(key, force) - pull).store(force);
        }
    }
}

/// A loop for any lanes.
pub(super) trait LaneLoop {
    /// What the loop computes.
    type Out;

    /// The loop.
    fn go<N: Lanes>(self, key: N::Key) -> Self::Out;
}

/// Runs a loop in the widest registers of the processor.
#[inline]
pub(super) fn run<W: LaneLoop>(work: W) -> W::Out {
    tribos_avx2::run(Dispatched(work))
}

/// The loop for both kinds of processors.
struct Dispatched<W>(W);

impl<W: LaneLoop> tribos_avx2::Work for Dispatched<W> {
    type Out = W::Out;

    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn with_avx2(self, proof: Avx2) -> W::Out {
        self.0.go::<tribos_avx2::F64x4>(proof)
    }

    #[cfg(not(target_arch = "x86_64"))]
    fn with_avx2(self, _: Avx2) -> W::Out {
        self.without()
    }

    #[inline(always)]
    fn without(self) -> W::Out {
        self.0.go::<wide::f64x4>(())
    }
}

/// Displacements from each site of a block to `own`, axis by axis.
#[inline(always)]
pub(super) fn ways<N: Lanes>(
    key: N::Key,
    own: &[N; 3],
    block: &[u32; LANES],
    sites: &[Site],
) -> [N; 3] {
    let there = N::places(key, block.map(|other| &sites[other as usize].place));
    std::array::from_fn(|axis| own[axis] - there[axis])
}

/// Place of a site in all lanes.
#[inline(always)]
pub(super) fn spread<N: Lanes>(key: N::Key, site: &Site) -> [N; 3] {
    std::array::from_fn(|axis| N::splat(key, site.place[axis]))
}

/// Sum over the lanes, halves first.
#[inline(always)]
pub(super) fn across<N: Lanes>(lanes: N) -> f64 {
    let [a, b, c, d] = lanes.to_array();
    (a + c) + (b + d)
}
