//! Compares batches of tables with single calls, to the bit, on 10⁷ twists each, in about two minutes:
//!
//! `cargo run --release -p tribos-tests --example batches`; panics at the first difference.

use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::round::{RoundTable32, RoundTable64};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::patch::PowerPressure;
use tribos_tests::batches::compare;

/// Twists of each comparison.
const COUNT: usize = 10_000_000;
/// Not one of the test's seeds.
const SEED: u64 = 101;
const EXPONENTS: [f64; 2] = [0.0, 0.37];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    compare::<f64, _>(&CoulombDisk, COUNT, SEED);
    compare::<f32, _>(&CoulombDisk, COUNT, SEED);
    println!("dry friction: the same bits");
    for alpha in EXPONENTS {
        compare(&DiskTable64::new(alpha)?, COUNT, SEED);
        compare(&DiskTable32::new(alpha as f32)?, COUNT, SEED);
        println!("exponent {alpha}: the same bits");
        let hertz = PowerPressure::HERTZ;
        compare(&RoundTable64::new(alpha, hertz)?, COUNT, SEED);
        compare(&RoundTable32::new(alpha as f32, hertz)?, COUNT, SEED);
        println!("exponent {alpha} under Hertz' pressure: the same bits");
    }
    Ok(())
}
