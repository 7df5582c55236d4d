//! The largest error of the f32 forms of round patches over *every* ratio of speeds that f32 has, Coulomb friction.
//!
//! Prints the table of docs/accuracy.md, section "Every float", over every float. The judge is the f64 tier of the same patch, whose own
//! error (2e-15 relative at most, against 25 and more digits) is 4e-8 of what is measured here.
//!
//!     cargo run --release -p tribos-tests --example every_float          # all patches: minutes on many cores
//!     cargo run --release -p tribos-tests --example every_float -- disk  # those whose name contains a word

use rayon::prelude::*;
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::coupling::{Annulus, ReducedFriction};
use tribos_tests::reference::{Reference, ulp_f32};

/// Ratios of a task: enough to hide the cost of handing it over.
const TASK: u32 = 1 << 18;
/// Floats from 0 to 1, both included, are these bits and all below.
const LAST: u32 = 1.0_f32.to_bits();

/// An error in ulp and the pair of speeds that has it.
#[derive(Clone, Copy, Default)]
struct Largest {
    error: f64,
    slide: f32,
    rim: f32,
}

impl Largest {
    /// The larger of two; the first of equals, so that no number of threads changes it.
    fn or(self, later: Self) -> Self {
        if later.error > self.error {
            later
        } else {
            self
        }
    }
}

/// Largest errors of force and torque over the ratios with these bits, whichever speed leads.
fn errors(
    single: &impl ReducedFriction<f32>,
    double: &impl ReducedFriction<f64>,
    bits: std::ops::RangeInclusive<u32>,
) -> [Largest; 2] {
    let mut largest = [Largest::default(); 2];
    for ratio in bits.map(f32::from_bits) {
        for (slide, rim) in [(ratio, 1.0), (1.0, ratio)] {
            let got = single.reduced_wrench(slide, rim);
            let wanted = double.reduced_wrench(f64::from(slide), f64::from(rim));
            let pairs = [(got.force, wanted.force), (got.torque, wanted.torque)];
            for (largest, (got, wanted)) in largest.iter_mut().zip(pairs) {
                let error = Reference::exact(wanted).over(f64::from(got), ulp_f32(wanted as f32));
                *largest = largest.or(Largest { error, slide, rim });
            }
        }
    }
    largest
}

/// One row of the table, if `name` has the word that was asked for.
fn row(
    word: &str,
    name: &str,
    single: impl ReducedFriction<f32> + Sync,
    double: impl ReducedFriction<f64> + Sync,
) {
    if !name.contains(word) {
        return;
    }
    eprintln!("{name} ...");
    let [force, torque] = (0..=LAST / TASK)
        .into_par_iter()
        .map(|task| {
            let first = task * TASK;
            errors(&single, &double, first..=LAST.min(first + (TASK - 1)))
        })
        .reduce(Default::default, |[f, t], [g, u]| [f.or(g), t.or(u)]);
    let place = |at: &Largest| format!("v = {:?}, w = {:?}", at.slide, at.rim);
    println!(
        "| {name} | {:.3} | {} | {:.3} | {} |",
        force.error,
        place(&force),
        torque.error,
        place(&torque)
    );
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let word = std::env::args().nth(1).unwrap_or_default();
    println!("| f32 | F, ulp | at | T, ulp | at |\n|---|---|---|---|---|");
    row(&word, "disk", CoulombDisk, CoulombDisk);
    row(&word, "ring", CoulombRing, CoulombRing);
    row(&word, "flat punch", CoulombPunch, CoulombPunch);
    row(&word, "Hertz", CoulombHertz, CoulombHertz);
    row(&word, "paraboloid", CoulombParaboloid, CoulombParaboloid);
    for inner in [0.25_f32, 0.5, 0.9] {
        let single = Annulus::new(CoulombDisk, inner)?;
        let double = Annulus::new(CoulombDisk, f64::from(inner))?;
        row(&word, &format!("annulus, k = {inner}"), single, double);
    }
    Ok(())
}
