//! Forces of embedded atoms in three passes: densities, embedding energies, forces.

use super::Functions;
use crate::md::interaction::{Tally, Wanted};
use crate::md::neighbours::{Chunk, Site, VerletList};
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;

/// Forces on all atoms. Sums run chunk by chunk, independent of the number of threads.
pub(super) fn forces<F: Functions>(
    law: &F,
    list: &mut VerletList,
    forces: &mut [Vector3<f64>],
    wanted: Wanted,
) -> Tally {
    let chunks = list.chunks_mut();
    let parts: Vec<Vec<f64>> = chunks
        .par_iter_mut()
        .map(|chunk| densities(law, chunk))
        .collect();
    let jets = embed(law, chunks, &parts, forces.len());
    let tallies: Vec<Tally> = chunks
        .par_iter_mut()
        .map(|chunk| over_pairs(law, chunk, &jets))
        .collect();
    for chunk in &*chunks {
        for (slot, site) in chunk.window().iter().zip(chunk.sites()) {
            forces[slot.atom as usize] += Vector3::from(site.force);
        }
    }
    match wanted {
        Wanted::Forces => Tally {
            energy: f64::NAN,
            virial: Matrix3::repeat(f64::NAN),
        },
        Wanted::Sums => {
            let embedded = Tally {
                energy: jets.iter().map(|[energy, _]| energy).sum(),
                virial: Matrix3::zeros(),
            };
            tallies.into_iter().fold(embedded, |sum, part| Tally {
                energy: sum.energy + part.energy,
                virial: sum.virial + part.virial,
            })
        }
    }
}

/// Densities that a chunk's pairs contribute to its sites.
fn densities<F: Functions>(law: &F, chunk: &mut Chunk) -> Vec<f64> {
    let (sites, rows) = chunk.sites_and_rows();
    let mut densities = vec![0.0; sites.len()];
    for (here, blocks) in rows {
        let own = sites[here];
        let mut sum = 0.0;
        for &other in blocks.as_flattened() {
            let there = &sites[other as usize];
            let r_sq = way(&own, there).norm_squared();
            if r_sq < law.cutoff_sq() {
                let [at_own, at_other] = law.densities([own.species, there.species], r_sq.sqrt());
                sum += at_own;
                densities[other as usize] += at_other;
            }
        }
        densities[here] += sum;
    }
    densities
}

/// F and F' of every atom at the sum of its densities.
fn embed<F: Functions>(
    law: &F,
    chunks: &[Chunk],
    parts: &[Vec<f64>],
    atoms: usize,
) -> Vec<[f64; 2]> {
    let mut sums = vec![(0_u8, 0.0); atoms];
    for (chunk, densities) in chunks.iter().zip(parts) {
        let places = chunk.window().iter().zip(chunk.sites());
        for ((slot, site), density) in places.zip(densities) {
            let (species, sum) = &mut sums[slot.atom as usize];
            *species = site.species;
            *sum += density;
        }
    }
    sums.par_iter()
        .map(|&(species, density)| law.embedding(species, density))
        .collect()
}

/// The forces of a chunk's pairs on its sites.
fn over_pairs<F: Functions>(law: &F, chunk: &mut Chunk, jets: &[[f64; 2]]) -> Tally {
    let of = |atom: u32| jets[atom as usize][1];
    let slopes: Vec<f64> = chunk.window().iter().map(|slot| of(slot.atom)).collect();
    let mut tally = Tally::default();
    let (sites, rows) = chunk.sites_and_rows();
    for (here, blocks) in rows {
        let own = sites[here];
        let mut sum = Vector3::zeros();
        for &other in blocks.as_flattened() {
            let other = other as usize;
            let way = way(&own, &sites[other]);
            let r_sq = way.norm_squared();
            if r_sq < law.cutoff_sq() {
                let r = r_sq.sqrt();
                let ([at_own, at_other], energy) = law.pair([own.species, sites[other].species], r);
                // −dE/dr of this pair, over r.
                let slope = slopes[here] * at_own[1] + slopes[other] * at_other[1] + energy[1];
                let force = way * (-slope / r);
                sum += force;
                for axis in 0..3 {
                    sites[other].force[axis] -= force[axis];
                }
                tally.energy += energy[0];
                tally.virial += way * force.transpose();
            }
        }
        for axis in 0..3 {
            sites[here].force[axis] += sum[axis];
        }
    }
    tally
}

/// Displacement from `there` to `here`.
#[inline]
fn way(here: &Site, there: &Site) -> Vector3<f64> {
    Vector3::from(here.place) - Vector3::from(there.place)
}
