//! Prints docs/tables/restitution.csv: the energy balance of a box of rough spheres for each restitution and friction.

use tribos_tests::rebounds::{Cell, run};

/// Steps, each run for the same time.
const STEPS: [f64; 3] = [0.02, 0.01, 0.005];
/// Time of a run.
const TIME: f64 = 5.0;

fn main() {
    println!(
        "e,mu,mu_rolling_and_torsion,collisions_percent,sliding_percent,rolling_percent,\
         torsion_percent,kept_percent,least_in_a_step,largest_impulse_0.02,largest_impulse_0.01,\
         largest_impulse_0.005"
    );
    for restitution in [0.0, 0.5, 0.9, 1.0] {
        for mu in [0.0, 0.3, 1.0, 10.0] {
            for rolling in [0.0, 0.3] {
                let answers = STEPS.map(|dt| {
                    let cell = Cell {
                        restitution,
                        mu,
                        rolling,
                        dt,
                    };
                    run(cell, TIME)
                });
                let [normal, sliding, turning, torsion] =
                    answers[2].lost.map(|share| 100.0 * share + 0.0);
                let least = answers.map(|answer| answer.least);
                let least = least.into_iter().fold(0.0, f64::min);
                let [first, second, third] = answers.map(|answer| answer.largest);
                println!(
                    "{restitution},{mu},{rolling},{normal:.1},{sliding:.1},{turning:.1},{torsion:.1},\
                     {:.1},{least:.0e},{first:.1},{second:.1},{third:.1}",
                    100.0 * answers[2].kept,
                );
            }
        }
    }
}
