//! Sums of a loop over pairs: nothing, or energy and virial.

use super::{Lanes, Tally, across};
use nalgebra::Matrix3;

/// What a loop sums.
pub(super) trait Accumulator: Send {
    /// The sums while the loop runs.
    type Sums<N: Lanes>: PairSums<N>;
}

/// Accumulates the contributions of blocks of pairs.
pub(super) trait PairSums<N> {
    fn new(zero: N) -> Self;

    /// Adds a block; the energy is computed only if it is summed.
    fn add(&mut self, energy: impl FnOnce() -> N, way: &[N; 3], force: &[N; 3]);

    /// The sums.
    fn tally(&self) -> Tally;
}

/// No sums.
pub(super) struct ForcesOnly;

impl Accumulator for ForcesOnly {
    type Sums<N: Lanes> = Self;
}

impl<N: Lanes> PairSums<N> for ForcesOnly {
    #[inline(always)]
    fn new(_: N) -> Self {
        Self
    }

    #[inline(always)]
    fn add(&mut self, _: impl FnOnce() -> N, _: &[N; 3], _: &[N; 3]) {}

    fn tally(&self) -> Tally {
        Tally {
            energy: f64::NAN,
            virial: Matrix3::repeat(f64::NAN),
        }
    }
}

/// Energy and virial.
pub(super) struct Totals;

impl Accumulator for Totals {
    type Sums<N: Lanes> = LaneTotals<N>;
}

/// Energy and virial, lane by lane.
pub(super) struct LaneTotals<N> {
    energy: N,
    /// Virial components xx, yy, zz, xy, xz, yz.
    virial: [N; 6],
}

/// Axes of displacement and force in each component of the virial.
const AXES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

impl<N: Lanes> PairSums<N> for LaneTotals<N> {
    #[inline(always)]
    fn new(zero: N) -> Self {
        let (energy, virial) = (zero, [zero; 6]);
        Self { energy, virial }
    }

    #[inline(always)]
    fn add(&mut self, energy: impl FnOnce() -> N, way: &[N; 3], force: &[N; 3]) {
        self.energy = self.energy + energy();
        for (sum, [a, b]) in self.virial.iter_mut().zip(AXES) {
            *sum = *sum + way[a] * force[b];
        }
    }

    fn tally(&self) -> Tally {
        let [xx, yy, zz, xy, xz, yz] = self.virial.map(across);
        Tally {
            energy: across(self.energy),
            virial: Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
        }
    }
}
