//! Forces of embedded atoms in three passes: densities, embedding energies, forces. The first keeps the slopes
//! of a pair, so that the last needs neither roots nor powers.

use super::Functions;
use crate::md::interaction::{Evaluation, Tally};
use crate::md::lanes::{self, LaneLoop, Lanes, across, spread, ways};
use crate::md::neighbours::{Chunk, LANES, Site, VerletList};
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;
use std::marker::PhantomData;

/// Forces on all atoms. Sums run chunk by chunk and lane by lane, independent of the number of threads.
pub(super) fn forces<F: Functions>(
    law: &F,
    list: &mut VerletList,
    forces: &mut [Vector3<f64>],
    wanted: Evaluation,
) -> Tally {
    let energies: Vec<f64> = list
        .chunks_mut()
        .par_iter_mut()
        .with_max_len(1)
        .map(|chunk| lanes::run(DensityPass { law, chunk }))
        .collect();
    let jets = embed(law, list, forces.len());
    let tallies: Vec<Tally> = list
        .chunks_mut()
        .par_iter_mut()
        .with_max_len(1)
        .map(|chunk| {
            set_slopes(chunk, &jets);
            lanes::run(ForcePass::<F>::new(chunk, wanted))
        })
        .collect();
    list.gather_forces(forces);
    match wanted {
        Evaluation::Forces => Tally {
            energy: f64::NAN,
            virial: Matrix3::repeat(f64::NAN),
        },
        Evaluation::Sums => Tally {
            energy: jets.iter().map(|[energy, _]| energy).sum::<f64>()
                + energies.iter().sum::<f64>(),
            virial: tallies.iter().map(|part| part.virial).sum(),
        },
    }
}

/// The first pass over a chunk's pairs.
pub(super) struct DensityPass<'a, F> {
    pub(super) law: &'a F,
    pub(super) chunk: &'a mut Chunk,
}

impl<F: Functions> LaneLoop for DensityPass<'_, F> {
    type Out = f64;

    /// Sums the densities of a chunk's pairs at its sites, keeps the slopes of the blocks over the distance, and
    /// returns the energy of the pairs.
    #[inline(always)]
    fn go<N: Lanes>(self, key: N::Key) -> f64 {
        let Self { law, chunk } = self;
        let [zero, one] = [0.0, 1.0].map(|number| N::splat(key, number));
        let cutoff_sq = N::splat(key, law.cutoff_sq());
        let cutoff = cutoff_sq.sqrt();
        let mut energy = zero;
        let mut kept = std::mem::take(&mut chunk.kept);
        kept.clear();
        let mut near = std::mem::take(&mut chunk.near);
        near.clear();
        let (sites, rows) = chunk.sites_and_rows();
        for (here, blocks) in rows {
            let own = sites[here];
            let place = spread::<N>(key, &own);
            let mut sum = zero;
            for block in blocks {
                let [x, y, z] = ways(key, &place, block, sites);
                let r_sq = x * x + y * y + z * z;
                // Blocks beyond the cut-off would add zeros.
                let is_near = r_sq.less_mask(cutoff_sq) != 0;
                near.push(is_near);
                if !is_near {
                    continue;
                }
                // Pairs beyond the cut-off are computed there, where every function is finite, and left out.
                let r = r_sq.if_below(cutoff_sq, r_sq.sqrt(), cutoff);
                let within = |values: N| r_sq.if_below(cutoff_sq, values, zero);
                let inv = one / r;
                let kinds = || block.map(|other| [&own, &sites[other as usize]].map(species));
                let ([at_own, at_other], pair) = law.pairs(key, kinds, [r, inv]);
                sum = sum + within(at_own[0]);
                let there = within(at_other[0]).to_array();
                for (&other, density) in block.iter().zip(there) {
                    *sites[other as usize].density_mut() += density;
                }
                energy = energy + within(pair[0]);
                kept.push(within(at_own[1] * inv).to_array());
                if !F::ALIKE {
                    kept.push(within(at_other[1] * inv).to_array());
                }
                kept.push(within(pair[1] * inv).to_array());
            }
            *sites[here].density_mut() += across(sum);
        }
        chunk.kept = kept;
        chunk.near = near;
        across(energy)
    }
}

fn species(site: &Site) -> u8 {
    site.species() as u8
}

/// F and F' of every atom at the sum of its densities.
fn embed<F: Functions>(law: &F, list: &VerletList, atoms: usize) -> Vec<[f64; 2]> {
    let nothing = (0_u8, 0.0);
    let mut sums = vec![nothing; atoms];
    list.gather(&mut sums, nothing, |(species, sum), site| {
        *species = site.species() as u8;
        *sum += site.density();
    });
    sums.par_iter()
        .map(|&(species, density)| law.embedding(species, density))
        .collect()
}

/// Puts the slopes of the embedding energies at the sites of a chunk.
pub(super) fn set_slopes(chunk: &mut Chunk, jets: &[[f64; 2]]) {
    for (slot, site) in chunk.places_mut() {
        *site.density_mut() = jets[slot.atom as usize][1];
    }
}

/// The last pass over a chunk's pairs.
pub(super) struct ForcePass<'a, F> {
    law: PhantomData<F>,
    chunk: &'a mut Chunk,
    wanted: Evaluation,
}

impl<'a, F> ForcePass<'a, F> {
    pub(super) fn new(chunk: &'a mut Chunk, wanted: Evaluation) -> Self {
        let law = PhantomData;
        Self { law, chunk, wanted }
    }
}

impl<F: Functions> LaneLoop for ForcePass<'_, F> {
    type Out = Tally;

    /// The forces of a chunk's pairs on its sites, and their virial.
    #[inline(always)]
    fn go<N: Lanes>(self, key: N::Key) -> Tally {
        let Self { chunk, wanted, .. } = self;
        let zero = N::splat(key, 0.0);
        let mut virial = [[zero; 3]; 3];
        let all = std::mem::take(&mut chunk.kept);
        let near = std::mem::take(&mut chunk.near);
        let mut is_near = near.iter();
        let mut kept = all.chunks_exact(if F::ALIKE { 2 } else { 3 });
        let (sites, rows) = chunk.sites_and_rows();
        for (here, blocks) in rows {
            let own = sites[here];
            let place = spread::<N>(key, &own);
            let slope_here = N::splat(key, own.density());
            let mut force = [zero; 3];
            let near = |_: &&[u32; LANES]| is_near.next().is_some_and(|is_near| *is_near);
            for (block, kept) in blocks.iter().filter(near).zip(&mut kept) {
                let way = ways(key, &place, block, sites);
                let slope_there = N::new(key, block.map(|other| sites[other as usize].density()));
                let lanes = |kept: [f64; LANES]| N::new(key, kept);
                // −dE/dr of these pairs, over r.
                let slope = match *kept {
                    [both, pair] => (slope_here + slope_there) * lanes(both) + lanes(pair),
                    [at_own, at_other, pair] => {
                        slope_here * lanes(at_own) + slope_there * lanes(at_other) + lanes(pair)
                    }
                    _ => zero,
                };
                let strength = zero - slope;
                let pull = way.map(|way| way * strength);
                for (sum, pull) in force.iter_mut().zip(pull) {
                    *sum = *sum + pull;
                }
                N::take(key, sites, block, pull);
                if wanted == Evaluation::Sums {
                    for (row, way) in virial.iter_mut().zip(way) {
                        for (sum, pull) in row.iter_mut().zip(pull) {
                            *sum = *sum + way * pull;
                        }
                    }
                }
            }
            for (sum, lanes) in sites[here].force.iter_mut().zip(force) {
                *sum += across(lanes);
            }
        }
        chunk.kept = all;
        chunk.near = near;
        let virial = virial.map(|row| row.map(across));
        Tally {
            energy: f64::NAN,
            virial: Matrix3::from_fn(|row, column| virial[row][column]),
        }
    }
}
