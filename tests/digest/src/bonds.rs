//! Bits of bonds: their forces, the stiffness of a patch, the onset of sliding.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, speed, twist};
use tribos_core::bond::{
    BondLaw, Bonds, BrittleBond, ExponentialBond, FailureMode, PlasticBond, ReformingBond,
    WeibullBond,
};
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Displacements of each law.
const DISPLACEMENTS: usize = 24;

/// Digest of bonds, f64 and f32.
pub fn bonds() -> u64 {
    in_both(bonds_of::<f64>, bonds_of::<f32>)
}

fn bonds_of<R: Real>(hash: &mut Fnv) {
    let (k, x0) = (R::from_f64(3.0), R::from_f64(0.375));
    let exponential = ExponentialBond::new(k, x0).expect("positive");
    let brittle = BrittleBond::new(k, x0).expect("positive");
    let plastic = PlasticBond::new(k, x0).expect("positive");
    for strain in ends::<R>() {
        hash.numbers([exponential.energy(strain), brittle.energy(strain)]);
        hash.number(plastic.energy(strain));
    }
    law(hash, &exponential);
    law(hash, &brittle);
    law(hash, &plastic);
    for exponent in [0.5, 2.0, 8.0] {
        law(
            hash,
            &WeibullBond::new(k, x0, R::from_f64(exponent)).expect("positive"),
        );
    }
    for stages in [1, 2, 7, 40] {
        law(hash, &ReformingBond::new(k, x0, stages).expect("in range"));
    }
    law(hash, &ReformingBond::one_strength(k, x0).expect("positive"));
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&ExponentialBond::new(x, y));
        hash.verdict(&BrittleBond::new(x, y));
        hash.verdict(&PlasticBond::new(x, y));
        hash.verdict(&WeibullBond::new(k, x, y));
        hash.verdict(&ReformingBond::one_strength(x, y));
        hash.verdict(&ReformingBond::new(x, y, 3));
    }
    for stages in [0, 1, 1000, 1001] {
        hash.verdict(&ReformingBond::new(k, x0, stages));
    }
}

/// A law alone, and under three feet.
fn law<R: Real, L: BondLaw<R>>(hash: &mut Fnv, law: &L) {
    hash.numbers([law.stiffness(), law.peak(), law.plateau()]);
    hash.feed(u64::from(law.is_brittle()));
    let mut rng = Lcg::new(97);
    let strains = (0..DISPLACEMENTS).map(|_| speed::<R>(&mut rng));
    for strain in strains.chain(ends()) {
        hash.numbers([
            law.friction(strain),
            law.slope(strain),
            law.transverse_stiffness(strain),
        ]);
    }
    let feet = [[0.0, 0.0], [0.75, 0.125], [0.25, 0.5]].map(|foot| foot.map(R::from_f64));
    let stool = Nodes::tripod(feet, [0.3, 0.2].map(R::from_f64)).expect("it stands");
    let bonds = Bonds::new(law, stool).expect("three places");
    hash.number(bonds.patch().total_weight());
    hash.number(bonds.law().stiffness());
    onsets(hash, &bonds);
    for radius in ends::<R>() {
        hash.verdict(&bonds.with_rim(radius));
    }
    onsets(hash, &bonds.with_rim(R::TWO).expect("positive"));
}

fn onsets<R: Real, L: BondLaw<R>, P: NodePatch<R>>(hash: &mut Fnv, bonds: &Bonds<R, L, P>) {
    let mut rng = Lcg::new(98);
    let load = R::from_f64(1.5);
    for _ in 0..DISPLACEMENTS {
        let displacement: Twist<R> = twist(&mut rng);
        hash.wrench(&bonds.wrench(load, &displacement));
        hash.numbers(bonds.stiffness(load, &displacement).iter().copied());
        if let Some(onset) = bonds.onset(load, &displacement) {
            hash.twist(&onset.displacement);
            hash.wrench(&onset.push);
            hash.feed(match onset.release {
                FailureMode::Breaks => 1,
                FailureMode::Softens => 2,
                FailureMode::Yields => 3,
                FailureMode::Holds => 4,
            });
        }
    }
}
