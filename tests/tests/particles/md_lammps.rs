//! Forces, energies and pressures of atoms are those of LAMMPS.
//!
//! A force is compared with the largest force of its table, an energy with itself, a virial with the
//! largest part of it. Both programs sum in their own order, so the bits differ.

use nalgebra::Matrix3;
use tribos::md::configuration::Configuration;
use tribos::md::eam::Tabulated;
use tribos::md::eam::file::PotentialFile;
use tribos::md::interaction::{Interaction, Tally};
use tribos::md::pair::{Mixing, Pairing, Shift};
use tribos_tests::atoms::{Expected, binary, computed, data, single, text};

const PERIODIC: [bool; 3] = [true; 3];
const SLAB: [bool; 3] = [true, true, false];

/// LAMMPS' energy of a mass at a speed, and pressure of an energy in a volume, in metal units.
const LJ_UNITS: [f64; 2] = [1.0, 1.0];
const METAL_UNITS: [f64; 2] = [1.0364269e-4, 1.6021765e6];

struct Deviation {
    force: f64,
    energy: f64,
    pressure: f64,
}

fn components(m: &Matrix3<f64>) -> [f64; 6] {
    [m.m11, m.m22, m.m33, m.m12, m.m13, m.m23]
}

/// Pressure tensor: what moves and what acts, over the volume.
fn pressure(all: &Configuration, tally: &Tally, [energy, pressure]: [f64; 2]) -> Matrix3<f64> {
    let mut sum = tally.virial;
    for (atom, velocity) in all.atoms.velocities.iter().enumerate() {
        sum += velocity * velocity.transpose() * (all.atoms.mass(atom) * energy);
    }
    sum * (pressure / all.volume())
}

fn deviation(name: &str, all: &Configuration, law: &dyn Interaction, units: [f64; 2]) -> Deviation {
    let expected = Expected::read(name);
    let (forces, tally) = computed(all, law);
    assert_eq!(forces.len(), expected.forces.len());
    let worst = forces.iter().zip(&expected.forces);
    let worst = worst
        .map(|(ours, theirs)| (ours - theirs).amax())
        .fold(0.0, f64::max);
    let tensor = pressure(all, &tally, units);
    let scale = expected
        .tensor
        .iter()
        .fold(0.0, |most: f64, p| most.max(p.abs()));
    let off = components(&tensor).into_iter().zip(expected.tensor);
    let off = off
        .map(|(ours, theirs)| (ours - theirs).abs())
        .fold(0.0, f64::max);
    assert!((all.volume() / expected.volume - 1.0).abs() < 1e-14);
    let trace = (tensor.trace() / 3.0 - expected.pressure).abs();
    let found = Deviation {
        force: worst / expected.largest(),
        energy: (tally.energy / expected.energy - 1.0).abs(),
        pressure: off.max(trace) / scale,
    };
    println!(
        "{name}: forces {:.1e} energy {:.1e} pressure {:.1e}",
        found.force, found.energy, found.pressure
    );
    found
}

fn check(name: &str, all: &Configuration, law: &dyn Interaction, units: [f64; 2], bound: f64) {
    let Deviation {
        force,
        energy,
        pressure,
    } = deviation(name, all, law, units);
    assert!(force < bound, "{name}: forces differ by {force:.1e}");
    assert!(energy < bound, "{name}: energies differ by {energy:.1e}");
    assert!(
        pressure < bound,
        "{name}: pressures differ by {pressure:.1e}"
    );
}

#[test]
fn one_species_under_all_truncations() {
    let all = data("fcc500", PERIODIC);
    for (word, shift) in Shift::WORDS {
        check(
            &format!("fcc500_{word}"),
            &all,
            &single(shift),
            LJ_UNITS,
            1e-12,
        );
    }
    let all = data("slab576", SLAB);
    for (word, shift) in [("none", Shift::None), ("force", Shift::Force)] {
        check(
            &format!("slab576_{word}"),
            &all,
            &single(shift),
            LJ_UNITS,
            1e-12,
        );
    }
}

#[test]
fn two_species_under_all_mixings() {
    let all = data("binary500", PERIODIC);
    for (word, mixing, shift) in [
        ("geometric", Mixing::Geometric, Shift::None),
        ("arithmetic", Mixing::Arithmetic, Shift::Energy),
        ("sixthpower", Mixing::SixthPower, Shift::Force),
    ] {
        let law = binary(mixing, shift);
        check(&format!("binary500_{word}"), &all, &law, LJ_UNITS, 1e-12);
    }
}

#[test]
fn pairs_with_parameters_of_their_own() {
    let mut law = binary(Mixing::Geometric, Shift::Energy);
    let pairing = |epsilon, sigma, cutoff| Pairing {
        epsilon,
        sigma,
        cutoff,
    };
    law.set(0, 1, pairing(1.5, 0.8, 2.0)).unwrap();
    law.set(1, 1, pairing(0.5, 0.88, 2.2)).unwrap();
    let all = data("binary500", PERIODIC);
    check("binary500_kobandersen", &all, &law, LJ_UNITS, 1e-12);
}

#[test]
fn embedded_atoms_of_two_elements() {
    let file = PotentialFile::read(&text("synthetic.eam.alloy")).unwrap();
    let all = data("alloy500", PERIODIC);
    let names = ["Aa", "Bb"].map(String::from);
    let elements = file.elements_of(Some(&names), 2).unwrap();
    let law = Tabulated::new(&file, &elements).unwrap();
    check("alloy500_setfl", &all, &law, METAL_UNITS, 1e-12);
}

#[test]
fn embedded_atoms_of_one_element() {
    let file = PotentialFile::read(&text("synthetic.eam")).unwrap();
    let law = Tabulated::new(&file, &[0, 0]).unwrap();
    check(
        "alloy500_funcfl",
        &data("alloy500", PERIODIC),
        &law,
        METAL_UNITS,
        1e-12,
    );
}
