//! Forces between pairs: the loop, and the laws in it.

mod coefficients;
mod lennard_jones;
mod mixing;
mod sums;

pub use coefficients::{Coefficients, Shift};
pub use lennard_jones::{LennardJones, LennardJonesError, Pairing};
pub use mixing::Mixing;

use super::interaction::{Tally, Wanted};
use super::neighbours::{Chunk, LANES, Site, VerletList};
use nalgebra::Vector3;
use rayon::prelude::*;
use sums::{ForcesOnly, Sums, Totals};

/// A number for each of the pairs computed side by side.
type Lanes = [f64; LANES];

/// A force along the line of two atoms that ends at a cut-off.
trait PairLaw: Sync {
    /// What the law needs to know of a pair's species.
    type Kinds: Copy;

    /// Of the site `here` and the sites of a block.
    fn kinds(&self, here: &Site, block: &[u32; LANES], sites: &[Site]) -> Self::Kinds;

    /// −U'(r)/r at these squares of r; 0 beyond the cut-off.
    fn force_over_distance(&self, kinds: Self::Kinds, r_sq: &Lanes) -> Lanes;

    /// U(r); 0 beyond the cut-off.
    fn energy(&self, kinds: Self::Kinds, r_sq: &Lanes) -> Lanes;
}

/// Forces of a law on all atoms, with the sums that are wanted.
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

/// The forces of a chunk's pairs on its sites: for each owned site four neighbours at a time.
fn over_pairs<L: PairLaw, S: Sums>(law: &L, chunk: &mut Chunk) -> Tally {
    let mut sums = S::default();
    let (sites, rows) = chunk.sites_and_rows();
    for (here, blocks) in rows {
        let own = sites[here];
        let mut force = [[0.0; LANES]; 3];
        for block in blocks {
            let way = ways(&own, block, sites);
            let r_sq = squares(&way);
            let kinds = law.kinds(&own, block, sites);
            let strength = law.force_over_distance(kinds, &r_sq);
            let pull = way.map(|way| product(&strength, &way));
            for axis in 0..3 {
                for lane in 0..LANES {
                    force[axis][lane] += pull[axis][lane];
                }
            }
            for (lane, &other) in block.iter().enumerate() {
                let other = &mut sites[other as usize].force;
                for axis in 0..3 {
                    other[axis] -= pull[axis][lane];
                }
            }
            sums.add(|| law.energy(kinds, &r_sq), &way, &pull);
        }
        for (sum, lanes) in sites[here].force.iter_mut().zip(force) {
            *sum += across(&lanes);
        }
    }
    sums.tally()
}

/// From each site of a block to `own`, axis by axis.
#[inline(always)]
fn ways(own: &Site, block: &[u32; LANES], sites: &[Site]) -> [Lanes; 3] {
    let mut ways = [[0.0; LANES]; 3];
    for (lane, &other) in block.iter().enumerate() {
        let there = &sites[other as usize].place;
        for axis in 0..3 {
            ways[axis][lane] = own.place[axis] - there[axis];
        }
    }
    ways
}

#[inline(always)]
fn squares([x, y, z]: &[Lanes; 3]) -> Lanes {
    std::array::from_fn(|lane| x[lane] * x[lane] + y[lane] * y[lane] + z[lane] * z[lane])
}

#[inline(always)]
fn product(a: &Lanes, b: &Lanes) -> Lanes {
    std::array::from_fn(|lane| a[lane] * b[lane])
}

/// Sum over the lanes, halves first.
#[inline(always)]
fn across([a, b, c, d]: &Lanes) -> f64 {
    (a + c) + (b + d)
}
