//! Registers of four numbers give the bits of registers of two.

use super::passes::{DensityPass, ForcePass, set_slopes};
use super::*;
use crate::md::interaction::Evaluation;
use crate::md::lanes::{self, LaneLoop};
use crate::md::neighbours::VerletList;
use nalgebra::Vector3;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;

/// Bits of densities, energies, forces and virials, in lanes of a kind or of the processor.
fn bits(law: &SuttonChen, is_plain: bool) -> Vec<u64> {
    fn go<W: LaneLoop>(work: W, is_plain: bool) -> W::Out {
        if is_plain {
            work.go::<wide::f64x4>(())
        } else {
            lanes::run(work)
        }
    }
    let mut random = Random::new(22, 1);
    let places: Vec<_> = (0..900)
        .map(|_| Vector3::from_fn(|_, _| 29.0 * random.unit()))
        .collect();
    let space = PeriodicBox::new([Some(29.0); 3]).expect("the edge is positive");
    let mut list = VerletList::new(space, 7.2, 0.5).expect("the box is large");
    list.update(&places, &[0; 900]).expect("few atoms");
    let jets: Vec<_> = (0..900).map(|_| [0.0, -random.unit()]).collect();
    let mut bits = Vec::new();
    for chunk in list.chunks_mut() {
        let energy = go(DensityPass { law, chunk }, is_plain);
        bits.push(energy.to_bits());
        bits.extend(chunk.sites().iter().map(|site| site.density().to_bits()));
        set_slopes(chunk, &jets);
        let tally = go(
            ForcePass::<SuttonChen>::new(chunk, Evaluation::Sums),
            is_plain,
        );
        let forces = chunk.sites().iter().flat_map(|site| site.force);
        bits.extend(forces.chain(tally.virial.iter().copied()).map(f64::to_bits));
    }
    bits
}

#[test]
fn the_processor_does_not_change_the_bits() {
    let law = SuttonChen::new(SuttonChenParameters {
        epsilon: 0.012382,
        a: 3.61,
        c: 39.432,
        n: 9,
        m: 6,
        cutoff: 7.2,
        taper: 6.5,
    })
    .expect("in the domain");
    let plain = bits(&law, true);
    assert_eq!(bits(&law, false), plain);
    assert!(plain.iter().filter(|&&bits| bits << 1 != 0).count() > 3000);
}
