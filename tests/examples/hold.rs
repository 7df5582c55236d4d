//! Ten bodies that friction holds, for ten million steps each, and the loads at which they slip.
//!
//! `cargo run --release -p tribos-tests --example hold [STEPS]`
//!
//! The table docs/tables/creep.csv. The same bodies in engines: `bindings/python/benches/hold.py`,
//! `engines/rapier/examples/grip.rs`.

use rayon::prelude::*;
use tribos_core::coupling::{DryReducedFriction, coulomb::CoulombDisk};
use tribos_core::real::Real;
use tribos_tests::holds::{Case, cases};

const STEPS: u64 = 10_000_000;
/// Steps in s.
const DT: [f64; 4] = [1e-4, 1e-3, 1.0 / 240.0, 1.0 / 60.0];
/// Bisections of the load that slips: the last bracket is below all rounding.
const BISECTIONS: usize = 45;

/// The load that breaks bonds, over the one that the set carries, minus 1.
fn released<R: Real + 'static>(case: &Case<R>, dt: R) -> R {
    let right = case.margin();
    let [mut held, mut slips] = [0.5, 2.0].map(|share| right * R::from_f64(share));
    for _ in 0..BISECTIONS {
        let middle = R::HALF * (held + slips);
        if case.is_released(middle, dt) {
            slips = middle;
        } else {
            held = middle;
        }
    }
    slips / right - R::ONE
}

fn lines<R: Real + 'static>(precision: &str, dts: &[f64], steps: u64) -> Vec<String>
where
    CoulombDisk: DryReducedFriction<R>,
{
    let cases = cases::<R>();
    let pairs: Vec<(&Case<R>, f64)> = cases
        .iter()
        .flat_map(|case| dts.iter().map(move |&dt| (case, dt)))
        .collect();
    let line = |(case, dt): &(&Case<R>, f64)| {
        let held = case.held(R::from_f64(*dt), steps);
        let [shift, turn] = held.drift.map(R::to_f64);
        format!(
            "| {} | {precision} | {dt:.2e} | {:.3} | {:.3} | {shift:.1e} | {turn:.1e} | {} | {:+.1e} |",
            case.name,
            case.margin().to_f64(),
            held.elastic.to_f64() * 1e6,
            if held.anchored { "kept" } else { "moved" },
            released(case, R::from_f64(*dt)).to_f64(),
        )
    };
    pairs.par_iter().map(line).collect()
}

fn main() {
    let steps = std::env::args()
        .nth(1)
        .map_or(STEPS, |given| given.parse().expect("a number of steps"));
    println!("{steps} steps each.\n");
    println!(
        "| case | precision | step, s | load carried / load | displacement, µm | drift, m | drift, rad | anchor | slips at, relative error |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for line in lines::<f64>("f64", &DT, steps) {
        println!("{line}");
    }
    for line in lines::<f32>("f32", &DT[2..3], steps) {
        println!("{line}");
    }
}
