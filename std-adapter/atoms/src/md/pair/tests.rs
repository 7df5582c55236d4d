//! Registers of four numbers give the bits of registers of two.

use super::lennard_jones::{MultiSpecies, Shifted, SingleSpecies, Unshifted, law};
use super::*;
use crate::md::interaction::Interaction;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;

/// Random atoms of two species in a periodic cube, some of them farther apart than the cut-off.
fn list(cutoff: f64) -> VerletList {
    let edge = 4.0 * cutoff;
    let mut random = Random::new(22, 0);
    let places: Vec<_> = (0..700)
        .map(|_| Vector3::from_fn(|_, _| edge * random.unit()))
        .collect();
    let species: Vec<u8> = (0..700).map(|atom| (atom % 2) as u8).collect();
    let space = PeriodicBox::new([Some(edge); 3]).expect("the edge is positive");
    let mut list = VerletList::new(space, cutoff, 0.3).expect("the box is large");
    list.update(&places, &species).expect("few atoms");
    list
}

/// Bits of all forces and sums of a law.
fn bits<L: PairLaw, S: Accumulator, N: Lanes>(
    law: &L,
    key: Option<N::Key>,
    cutoff: f64,
) -> Vec<u64> {
    let mut list = list(cutoff);
    let mut bits = Vec::new();
    for chunk in list.chunks_mut() {
        let work = Loop::<L, S>::new(law, chunk);
        let tally = match key {
            Some(key) => work.go::<N>(key),
            None => lanes::run(work),
        };
        let forces = chunk.sites().iter().flat_map(|site| site.force);
        bits.extend(forces.map(f64::to_bits));
        bits.extend(tally.virial.iter().map(|sum| sum.to_bits()));
        bits.push(tally.energy.to_bits());
    }
    bits
}

fn assert_same_bits<L: PairLaw, S: Accumulator>(law: &L, cutoff: f64) {
    let plain = bits::<L, S, wide::f64x4>(law, Some(()), cutoff);
    assert_eq!(bits::<L, S, wide::f64x4>(law, None, cutoff), plain);
    assert!(plain.iter().filter(|&&bits| bits << 1 != 0).count() > 2000);
}

#[test]
fn the_processor_does_not_change_the_bits() {
    let cutoff = 2.5;
    let shifts = [Shift::None, Shift::Energy, Shift::Force];
    for shift in shifts {
        let pairs = [0.9, 1.0, 1.0, 1.1].map(|size| Coefficients::new(1.0, size, cutoff, shift));
        let many = MultiSpecies {
            species: 2,
            table: &pairs,
        };
        let one = || SingleSpecies(pairs[0]);
        if shift == Shift::Force {
            assert_same_bits::<_, Totals>(&law(one(), Shifted), cutoff);
            assert_same_bits::<_, Totals>(&law(many, Shifted), cutoff);
        } else {
            assert_same_bits::<_, ForcesOnly>(&law(one(), Unshifted), cutoff);
            assert_same_bits::<_, Totals>(&law(one(), Unshifted), cutoff);
            assert_same_bits::<_, Totals>(&law(many, Unshifted), cutoff);
        }
    }
}

/// Forces of all atoms, pair by pair without a list, after each moved almost as far as the list allows.
#[test]
fn forces_are_those_of_all_pairs() {
    let pairing = Pairing {
        epsilon: 1.0,
        sigma: 1.0,
        cutoff: 2.5,
    };
    let law = LennardJones::single(pairing, Shift::Energy).expect("in the domain");
    let mut list = list(2.5);
    let mut random = Random::new(22, 1);
    let mut places = list.reference().to_vec();
    for place in &mut places {
        let way = Vector3::from_fn(|_, _| random.unit() - 0.5);
        *place += way * (0.14 / way.norm());
    }
    assert!(!list.update(&places, &[0; 700]).expect("few atoms"));
    let mut forces = vec![Vector3::zeros(); places.len()];
    law.forces(&mut list, &mut forces, Evaluation::Forces);
    for (atom, force) in forces.iter().enumerate() {
        let (mut sum, mut size) = (Vector3::zeros(), 0.0);
        for other in (0..places.len()).filter(|&other| other != atom) {
            let way = (places[atom] - places[other]).map(|x| x - 10.0 * (x / 10.0).round());
            let r = way.norm();
            if r < 2.5 {
                let inv6 = 1.0 / (r * r * r * r * r * r);
                let pull = way * (inv6 * (48.0 * inv6 - 24.0) / (r * r));
                sum += pull;
                size += pull.norm();
            }
        }
        assert!(
            (sum - force).norm() <= 1e-12 * size,
            "{atom}: {sum} {force}"
        );
    }
}
