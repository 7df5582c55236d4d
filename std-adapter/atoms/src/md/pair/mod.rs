//! Pair forces: the loop over pairs, and the pair potentials.

mod coefficients;
mod lennard_jones;
mod mixing;
mod sums;
#[cfg(test)]
mod tests;

#[doc(hidden)]
pub use coefficients::Coefficients;
pub use coefficients::Shift;
pub use lennard_jones::{LennardJones, LennardJonesError, Pairing};
#[doc(hidden)]
pub use mixing::Mixing;

use super::interaction::{Evaluation, Tally};
use super::lanes::{self, LaneLoop, Lanes, across, spread, ways};
use super::neighbours::{Chunk, LANES, Site, VerletList};
use nalgebra::Vector3;
use rayon::prelude::*;
use std::marker::PhantomData;
use sums::{Accumulator, ForcesOnly, PairSums, Totals};

/// A central force with a cut-off.
trait PairLaw: Sync {
    /// The information on a pair's species that the law needs.
    type Kinds: Copy;

    /// Species information of the site `here` and the sites of a block.
    fn kinds(&self, here: &Site, block: &[u32; LANES], sites: &[Site]) -> Self::Kinds;

    /// Square of the largest cut-off.
    fn reach_sq(&self) -> f64;

    /// −U'(r)/r at these squares of r; 0 beyond the cut-off.
    fn force_over_distance<N: Lanes>(&self, key: N::Key, kinds: Self::Kinds, r_sq: N) -> N;

    /// U(r); 0 beyond the cut-off.
    fn energy<N: Lanes>(&self, key: N::Key, kinds: Self::Kinds, r_sq: N) -> N;
}

/// Forces of a law on all atoms, with the requested sums.
fn forces<L: PairLaw>(
    law: &L,
    list: &mut VerletList,
    forces: &mut [Vector3<f64>],
    wanted: Evaluation,
) -> Tally {
    let chunks = list.chunks_mut();
    let tallies: Vec<Tally> = chunks
        .par_iter_mut()
        .with_max_len(1)
        .map(|chunk| match wanted {
            Evaluation::Forces => lanes::run(Loop::<L, ForcesOnly>::new(law, chunk)),
            Evaluation::Sums => lanes::run(Loop::<L, Totals>::new(law, chunk)),
        })
        .collect();
    list.gather_forces(forces);
    tallies
        .into_iter()
        .fold(Tally::default(), |sum, part| Tally {
            energy: sum.energy + part.energy,
            virial: sum.virial + part.virial,
        })
}

/// The loop over a chunk's pairs.
struct Loop<'a, L, S> {
    law: &'a L,
    chunk: &'a mut Chunk,
    sums: PhantomData<S>,
}

impl<'a, L, S> Loop<'a, L, S> {
    fn new(law: &'a L, chunk: &'a mut Chunk) -> Self {
        let sums = PhantomData;
        Self { law, chunk, sums }
    }
}

impl<L: PairLaw, S: Accumulator> LaneLoop for Loop<'_, L, S> {
    type Out = Tally;

    /// Adds the forces of a chunk's pairs to its sites, four neighbours of an owned site at a time.
    #[inline(always)]
    fn go<N: Lanes>(self, key: N::Key) -> Tally {
        let Self { law, chunk, .. } = self;
        let zero = N::splat(key, 0.0);
        let reach_sq = N::splat(key, law.reach_sq());
        let mut sums = S::Sums::new(zero);
        let (sites, rows) = chunk.sites_and_rows();
        for (here, blocks) in rows {
            let own = sites[here];
            let place = spread::<N>(key, &own);
            let mut force = [zero; 3];
            for block in blocks {
                let way = ways(key, &place, block, sites);
                let [x, y, z] = way;
                let r_sq = x * x + y * y + z * z;
                // Blocks beyond the cut-off would add zeros.
                if r_sq.less_mask(reach_sq) == 0 {
                    continue;
                }
                let kinds = law.kinds(&own, block, sites);
                let strength = law.force_over_distance(key, kinds, r_sq);
                let pull = way.map(|way| strength * way);
                for (sum, pull) in force.iter_mut().zip(pull) {
                    *sum = *sum + pull;
                }
                N::take(key, sites, block, pull);
                sums.add(|| law.energy(key, kinds, r_sq), &way, &pull);
            }
            for (sum, lanes) in sites[here].force.iter_mut().zip(force) {
                *sum += across(lanes);
            }
        }
        sums.tally()
    }
}
