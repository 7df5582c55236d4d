//! Forces of embedded atoms in three passes: densities, embedding energies, forces. The first keeps the slopes
//! of a pair, so that the last needs neither roots nor powers.

use super::Functions;
use crate::md::interaction::{Tally, Wanted};
use crate::md::lanes::{Lanes, across, take, ways};
use crate::md::neighbours::{Chunk, VerletList};
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;

/// Forces on all atoms. Sums run chunk by chunk and lane by lane, independent of the number of threads.
pub(super) fn forces<F: Functions>(
    law: &F,
    list: &mut VerletList,
    forces: &mut [Vector3<f64>],
    wanted: Wanted,
) -> Tally {
    let chunks = list.chunks_mut();
    let energies: Vec<f64> = chunks
        .par_iter_mut()
        .map(|chunk| densities(law, chunk))
        .collect();
    let jets = embed(law, chunks, forces.len());
    let tallies: Vec<Tally> = chunks
        .par_iter_mut()
        .map(|chunk| over_pairs::<F>(chunk, &jets, wanted))
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
        Wanted::Sums => Tally {
            energy: jets.iter().map(|[energy, _]| energy).sum::<f64>()
                + energies.iter().sum::<f64>(),
            virial: tallies.iter().map(|part| part.virial).sum(),
        },
    }
}

/// Sums the densities of a chunk's pairs at its sites, keeps the slopes of the blocks over the distance, and
/// returns the energy of the pairs.
fn densities<F: Functions>(law: &F, chunk: &mut Chunk) -> f64 {
    let cutoff_sq = Lanes::splat(law.cutoff_sq());
    let cutoff = cutoff_sq.sqrt();
    let mut energy = Lanes::ZERO;
    let mut kept = std::mem::take(&mut chunk.kept);
    kept.clear();
    let (sites, rows) = chunk.sites_and_rows();
    for (here, blocks) in rows {
        let own = sites[here];
        let mut sum = Lanes::ZERO;
        for block in blocks {
            let [x, y, z] = ways(&own, block, sites);
            let r_sq = x * x + y * y + z * z;
            let near = r_sq.simd_lt(cutoff_sq);
            // Pairs beyond the cut-off are computed there, where every function is finite, and left out.
            let r = near.select(r_sq.sqrt(), cutoff);
            let within = |values: Lanes| near.select(values, Lanes::ZERO);
            let inv = Lanes::ONE / r;
            let ([at_own, at_other], pair) = law.pairs(&own, block, sites, [r, inv]);
            sum += within(at_own[0]);
            let there = within(at_other[0]).to_array();
            for (&other, density) in block.iter().zip(there) {
                sites[other as usize].density += density;
            }
            energy += within(pair[0]);
            kept.push(within(at_own[1] * inv));
            if !F::ALIKE {
                kept.push(within(at_other[1] * inv));
            }
            kept.push(within(pair[1] * inv));
        }
        sites[here].density += across(sum);
    }
    chunk.kept = kept;
    across(energy)
}

/// F and F' of every atom at the sum of its densities.
fn embed<F: Functions>(law: &F, chunks: &[Chunk], atoms: usize) -> Vec<[f64; 2]> {
    let mut sums = vec![(0_u8, 0.0); atoms];
    for chunk in chunks {
        for (slot, site) in chunk.window().iter().zip(chunk.sites()) {
            let (species, sum) = &mut sums[slot.atom as usize];
            *species = site.species;
            *sum += site.density;
        }
    }
    sums.par_iter()
        .map(|&(species, density)| law.embedding(species, density))
        .collect()
}

/// The forces of a chunk's pairs on its sites, and their virial.
fn over_pairs<F: Functions>(chunk: &mut Chunk, jets: &[[f64; 2]], wanted: Wanted) -> Tally {
    for (slot, site) in chunk.places_mut() {
        site.density = jets[slot.atom as usize][1];
    }
    let mut virial = [[Lanes::ZERO; 3]; 3];
    let all = std::mem::take(&mut chunk.kept);
    let mut kept = all.chunks_exact(if F::ALIKE { 2 } else { 3 });
    let (sites, rows) = chunk.sites_and_rows();
    for (here, blocks) in rows {
        let own = sites[here];
        let slope_here = Lanes::splat(own.density);
        let mut force = [Lanes::ZERO; 3];
        for (block, kept) in blocks.iter().zip(&mut kept) {
            let way = ways(&own, block, sites);
            let slope_there = Lanes::new(block.map(|other| sites[other as usize].density));
            // −dE/dr of these pairs, over r.
            let slope = match *kept {
                [both, pair] => (slope_here + slope_there) * both + pair,
                [at_own, at_other, pair] => slope_here * at_own + slope_there * at_other + pair,
                _ => Lanes::ZERO,
            };
            let pull = way.map(|way| way * -slope);
            for (sum, pull) in force.iter_mut().zip(pull) {
                *sum += pull;
            }
            take(sites, block, pull);
            if wanted == Wanted::Sums {
                for (row, way) in virial.iter_mut().zip(way) {
                    for (sum, pull) in row.iter_mut().zip(pull) {
                        *sum += way * pull;
                    }
                }
            }
        }
        for (sum, lanes) in sites[here].force.iter_mut().zip(force) {
            *sum += across(lanes);
        }
    }
    chunk.kept = all;
    let virial = virial.map(|row| row.map(across));
    Tally {
        energy: f64::NAN,
        virial: Matrix3::from_fn(|row, column| virial[row][column]),
    }
}
