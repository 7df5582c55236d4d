//! Sums of a loop over pairs: nothing, or energy and virial.

use super::{Lanes, Tally, across};
use nalgebra::Matrix3;

/// Accumulates the contributions of blocks of pairs.
pub(super) trait Sums: Default {
    /// Adds a block; the energy is computed only if it is summed.
    fn add(&mut self, energy: impl FnOnce() -> Lanes, way: &[Lanes; 3], force: &[Lanes; 3]);

    /// The sums.
    fn tally(&self) -> Tally;
}

/// No sums.
#[derive(Default)]
pub(super) struct ForcesOnly;

impl Sums for ForcesOnly {
    #[inline(always)]
    fn add(&mut self, _: impl FnOnce() -> Lanes, _: &[Lanes; 3], _: &[Lanes; 3]) {}

    fn tally(&self) -> Tally {
        Tally {
            energy: f64::NAN,
            virial: Matrix3::repeat(f64::NAN),
        }
    }
}

/// Energy and virial, lane by lane.
#[derive(Default)]
pub(super) struct Totals {
    energy: Lanes,
    /// Virial components xx, yy, zz, xy, xz, yz.
    virial: [Lanes; 6],
}

/// Axes of displacement and force in each component of the virial.
const AXES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

impl Sums for Totals {
    #[inline(always)]
    fn add(&mut self, energy: impl FnOnce() -> Lanes, way: &[Lanes; 3], force: &[Lanes; 3]) {
        self.energy += energy();
        for (sum, [a, b]) in self.virial.iter_mut().zip(AXES) {
            *sum += way[a] * force[b];
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
