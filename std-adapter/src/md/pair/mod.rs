//! Pair forces: the loop over pairs, and the pair potentials.

mod coefficients;
mod lennard_jones;
mod mixing;
mod sums;

#[doc(hidden)]
pub use coefficients::Coefficients;
pub use coefficients::Shift;
pub use lennard_jones::{LennardJones, LennardJonesError, Pairing};
#[doc(hidden)]
pub use mixing::Mixing;

use super::interaction::{Tally, Wanted};
use super::lanes::{Lanes, across, take, ways};
use super::neighbours::{Chunk, LANES, Site, VerletList};
use nalgebra::Vector3;
use rayon::prelude::*;
use sums::{ForcesOnly, Sums, Totals};

/// A central force with a cut-off.
trait PairLaw: Sync {
    /// The information on a pair's species that the law needs.
    type Kinds: Copy;

    /// Species information of the site `here` and the sites of a block.
    fn kinds(&self, here: &Site, block: &[u32; LANES], sites: &[Site]) -> Self::Kinds;

    /// −U'(r)/r at these squares of r; 0 beyond the cut-off.
    fn force_over_distance(&self, kinds: Self::Kinds, r_sq: Lanes) -> Lanes;

    /// U(r); 0 beyond the cut-off.
    fn energy(&self, kinds: Self::Kinds, r_sq: Lanes) -> Lanes;
}

/// Forces of a law on all atoms, with the requested sums.
fn forces<L: PairLaw>(
    law: &L,
    list: &mut VerletList,
    forces: &mut [Vector3<f64>],
    wanted: Wanted,
) -> Tally {
    let chunks = list.chunks_mut();
    let tallies: Vec<Tally> = chunks
        .par_iter_mut()
        .map(|chunk| match wanted {
            Wanted::Forces => over_pairs::<L, ForcesOnly>(law, chunk),
            Wanted::Sums => over_pairs::<L, Totals>(law, chunk),
        })
        .collect();
    for chunk in &*chunks {
        for (slot, site) in chunk.window().iter().zip(chunk.sites()) {
            forces[slot.atom as usize] += Vector3::from(site.force);
        }
    }
    tallies
        .into_iter()
        .fold(Tally::default(), |sum, part| Tally {
            energy: sum.energy + part.energy,
            virial: sum.virial + part.virial,
        })
}

/// Adds the forces of a chunk's pairs to its sites, four neighbours of an owned site at a time.
fn over_pairs<L: PairLaw, S: Sums>(law: &L, chunk: &mut Chunk) -> Tally {
    let mut sums = S::default();
    let (sites, rows) = chunk.sites_and_rows();
    for (here, blocks) in rows {
        let own = sites[here];
        let mut force = [Lanes::ZERO; 3];
        for block in blocks {
            let way = ways(&own, block, sites);
            let [x, y, z] = way;
            let r_sq = x * x + y * y + z * z;
            let kinds = law.kinds(&own, block, sites);
            let strength = law.force_over_distance(kinds, r_sq);
            let pull = way.map(|way| strength * way);
            for (sum, pull) in force.iter_mut().zip(pull) {
                *sum += pull;
            }
            take(sites, block, pull);
            sums.add(|| law.energy(kinds, r_sq), &way, &pull);
        }
        for (sum, lanes) in sites[here].force.iter_mut().zip(force) {
            *sum += across(lanes);
        }
    }
    sums.tally()
}
