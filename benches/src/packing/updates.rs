//! Contact updates per second: plain sweeps without a watch, for every set of modes.

use super::jammed::{NotJammed, UNEVEN, jammed};
use super::problems::pressed;
use crate::clock::Clock;
use crate::timing::median;
use crate::written::{Sheet, short};
use std::hint::black_box;
use tribos::cd::internals::{
    Accelerated, Coefficients, NoMonitor, Operator, Pairs, Spheres, Visit, residual,
};
use tribos_core::contact::{
    AllModes, ContactFriction, ContactModes, Frictionless, IndependentFriction, SlidingOnly,
    SlidingRolling, SlidingTorsion,
};

/// Spheres of the packing, and width of its square.
const COUNT: usize = 1000;
const WIDTH: f64 = 18.0;
const SEED: u64 = 1;
/// Coefficients: sliding as in the thesis, small enough that some contacts roll and spin.
const MU: [f64; 3] = [0.3, 0.1, 0.1];
/// Sweeps of a sample. A cold one starts from nothing each time.
const SWEEPS: usize = 10;
/// Residual of the converged state, and sweeps that it may take.
const CONVERGED: f64 = 1e-6;
const MOST_SWEEPS: usize = 100_000;

/// Cost of one set of modes.
#[derive(Clone, Debug)]
pub struct Cost {
    /// Set of modes.
    pub modes: &'static str,
    /// Alike or unlike radii, cold or converged.
    pub state: &'static str,
    /// Unknowns of a contact.
    pub unknowns: usize,
    /// Size of a contact and the names of its bodies.
    pub bytes: usize,
    /// Contacts of the packing.
    pub contacts: usize,
    /// Median time of one update.
    pub seconds: f64,
}

/// One problem, ready to be swept over and over.
struct Sample {
    cost: Cost,
    /// Restarts, sweeps, and returns seconds per update.
    run: Box<dyn FnMut() -> f64>,
    times: Vec<f64>,
}

/// Times all sets of modes, `rounds` times in turn.
pub fn measure(rounds: usize) -> Result<Vec<Cost>, NotJammed> {
    let refused = |error: tribos_core::law::LawError| NotJammed(error.to_string());
    let [mu, mu_t, mu_n] = MU;
    let all = IndependentFriction::all(mu, mu_t, mu_n).map_err(refused)?;
    let rolling = IndependentFriction::sliding_rolling(mu, mu_t).map_err(refused)?;
    let torsion = IndependentFriction::sliding_torsion(mu, mu_n).map_err(refused)?;
    let sliding = IndependentFriction::sliding(mu).map_err(refused)?;
    let mut samples = Vec::new();
    for uneven in [0.0, UNEVEN] {
        samples.extend(sample::<_, AllModes>("all six", uneven, all)?);
        samples.extend(sample::<_, SlidingRolling>(
            "sliding, rolling",
            uneven,
            rolling,
        )?);
        samples.extend(sample::<_, SlidingTorsion>(
            "sliding, torsion",
            uneven,
            torsion,
        )?);
        samples.extend(sample::<_, SlidingOnly>("sliding", uneven, sliding)?);
        samples.extend(sample::<_, Frictionless>(
            "frictionless",
            uneven,
            IndependentFriction::none(),
        )?);
    }
    for _ in 0..rounds {
        for sample in &mut samples {
            sample.times.push((sample.run)());
        }
    }
    let finish = |sample: Sample| Cost {
        seconds: median(&sample.times),
        ..sample.cost
    };
    Ok(samples.into_iter().map(finish).collect())
}

/// The packing cold and converged, for one set of modes.
fn sample<F, M>(modes: &'static str, uneven: f64, friction: F) -> Result<[Sample; 2], NotJammed>
where
    F: ContactFriction<f64, Modes = M> + Coefficients + 'static,
    M: ContactModes<f64>,
{
    let cold = pressed(&jammed(COUNT, WIDTH, uneven, SEED)?, friction)?;
    let mut solved = cold.clone();
    Accelerated::default().solve(&mut solved, CONVERGED, MOST_SWEEPS);
    let left = residual(&solved).relative;
    if left.is_nan() || left > 10.0 * CONVERGED {
        return Err(NotJammed(format!(
            "{modes}: residual {left:e} of a solution"
        )));
    }
    let states = if uneven == 0.0 {
        ["equal, cold", "equal, converged"]
    } else {
        ["unequal, cold", "unequal, converged"]
    };
    let make = |state, problem: Spheres<F>| Sample {
        cost: Cost {
            modes,
            state,
            unknowns: M::UNKNOWNS,
            bytes: Pairs::<M>::BYTES,
            contacts: problem.contacts(),
            seconds: f64::NAN,
        },
        run: sweeps(problem),
        times: Vec::new(),
    };
    Ok([make(states[0], cold), make(states[1], solved)])
}

/// Sweeps from the same start each time; the start is made outside of the time.
fn sweeps<F: ContactFriction<f64> + 'static>(start: Spheres<F>) -> Box<dyn FnMut() -> f64> {
    let mut problem = start.clone();
    Box::new(move || {
        problem.clone_from(&start);
        let clock = Clock::start();
        for _ in 0..SWEEPS {
            black_box(&mut problem).sweep(Visit::Forward, &mut NoMonitor);
        }
        black_box(&problem);
        clock.seconds() / (SWEEPS * start.contacts()) as f64
    })
}

/// Updates per second, and the cost of a contact relative to one with all modes.
pub fn sheet(costs: &[Cost], rounds: usize) -> Sheet {
    let full = |cost: &Cost| costs.iter().find(|other| other.state == cost.state);
    let of_full = |cost: &Cost, size: fn(&Cost) -> f64| {
        short(full(cost).map_or(f64::NAN, |full| size(cost) / size(full)))
    };
    Sheet::of(
        format!(
            "Contact updates on one core: sweeps over a jammed box of 1,000 spheres under load \
             without a watch, median of {rounds} interleaved rounds"
        ),
        costs,
        &[
            ("modes", &|cost| cost.modes.replace(", ", " ")),
            ("state", &|cost| cost.state.replace(", ", " ")),
            ("unknowns", &|cost| cost.unknowns.to_string()),
            ("contacts", &|cost| cost.contacts.to_string()),
            ("ns per update", &|cost| short(1e9 * cost.seconds)),
            ("million/s", &|cost| short(1e-6 / cost.seconds)),
            ("time of all six", &|cost| {
                of_full(cost, |cost| cost.seconds)
            }),
            ("bytes", &|cost| cost.bytes.to_string()),
            ("bytes of all six", &|cost| {
                of_full(cost, |cost| cost.bytes as f64)
            }),
        ],
    )
}
