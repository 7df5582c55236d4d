//! Energy that should be conserved: its drift and its fluctuation against the time step.

use super::melt::Melt;
use crate::power_law::{exponent, slope};
use crate::written::{Sheet, short};
use rayon::prelude::*;
use tribos::md::group::Group;
use tribos::md::interaction::Evaluation;
use tribos::md::observe::{conserved_energy, kinetic_energies, temperature};
use tribos::md::pair::Shift;
use tribos::md::thermostat::{NoseHoover, RotationBias, Thermostat};

/// Cubes of four atoms along an edge: 864 atoms.
const CUBES: usize = 6;
/// Steps from the crystal to the melt.
const MELTING: usize = 2000;
/// Time steps in σ√(m/ε).
const TIME_STEPS: [f64; 6] = [0.001, 0.002, 0.004, 0.005, 0.008, 0.01];
/// Time between samples of the energy: a multiple of all time steps.
const BETWEEN: f64 = 0.04;
/// Number of samples, and that of a quick run.
const LOOKS: usize = 500;
const QUICK_LOOKS: usize = 25;

/// Temperature of the thermostat in ε/k_B, near that of the melt, and its relaxation time in τ, as the tip has it.
const BATH: [f64; 2] = [0.72, 0.5];

/// A case: its name in tables and pictures, what is done at the cut-off, temperature and relaxation time of a thermostat.
type DriftCase = (&'static str, Shift, Option<[f64; 2]>);

/// All cases.
pub const CASES: [DriftCase; 4] = [
    ("truncated", Shift::None, None),
    ("energy shifted", Shift::Energy, None),
    ("force shifted", Shift::Force, None),
    ("force shifted; Nose-Hoover", Shift::Force, Some(BATH)),
];

/// One run at constant energy, that of a thermostat included; energies of an atom in ε, times in τ = σ√(m/ε).
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// Name of the case.
    pub case: &'static str,
    /// Time step.
    pub time_step: f64,
    /// Slope of the energy over time.
    pub drift: f64,
    /// Standard error of the drift, with samples treated as independent.
    pub drift_error: f64,
    /// Root mean square of the residuals.
    pub rms: f64,
    /// Mean temperature.
    pub temperature: f64,
}

/// All runs, from the same melt.
pub fn measure(is_quick: bool) -> Result<Vec<Run>, String> {
    let melt = Melt::after(CUBES, MELTING, Shift::Force)?;
    let looks = if is_quick { QUICK_LOOKS } else { LOOKS };
    // Long runs first, so that no core waits for the last.
    let pairs = TIME_STEPS
        .into_iter()
        .flat_map(|dt| CASES.map(|case| (dt, case)));
    let cases: Vec<_> = pairs.collect();
    let runs: Result<Vec<Run>, String> = cases
        .into_par_iter()
        .with_max_len(1)
        .map(|(time_step, case)| run(&melt, case, time_step, looks))
        .collect();
    runs
}

fn run(melt: &Melt, (case, shift, bath): DriftCase, dt: f64, looks: usize) -> Result<Run, String> {
    let thermostat = match bath {
        Some([heat, time]) => NoseHoover::new(heat, time, RotationBias::Counts)
            .map(Thermostat::NoseHoover)
            .map_err(|error| error.to_string())?,
        None => Thermostat::None,
    };
    let group = Group {
        thermostat,
        ..Group::default()
    };
    let mut system = melt.moved_as(group, shift, dt)?;
    let atoms = melt.atoms.len() as f64;
    let steps = (BETWEEN / dt).round() as usize;
    let (mut curve, mut heat) = (Vec::with_capacity(looks), 0.0);
    for _ in 0..looks {
        for step in 1..=steps {
            let wanted = if step == steps {
                Evaluation::Sums
            } else {
                Evaluation::Forces
            };
            system.step(wanted).map_err(|error| error.to_string())?;
        }
        curve.push([system.time(), conserved_energy(&system) / atoms]);
        heat += temperature(kinetic_energies(&system)[0], system.heat_freedoms(0));
    }
    let [drift, drift_error, rms] = straight(&curve);
    Ok(Run {
        case,
        time_step: dt,
        drift,
        drift_error,
        rms,
        temperature: heat / looks as f64,
    })
}

/// Slope of the nearest straight line, its standard error, and the rms distance from it.
fn straight(curve: &[[f64; 2]]) -> [f64; 3] {
    let count = curve.len() as f64;
    // Energies from the first on, so that their fluctuation is not lost in their size.
    let curve: Vec<[f64; 2]> = curve.iter().map(|[t, e]| [*t, e - curve[0][1]]).collect();
    let drift = slope(&curve);
    let mean = [0, 1].map(|axis| curve.iter().map(|point| point[axis]).sum::<f64>() / count);
    let square = |sum: f64, [t, e]: &[f64; 2]| {
        let left = e - mean[1] - drift * (t - mean[0]);
        sum + left * left
    };
    let rms = (curve.iter().fold(0.0, square) / count).sqrt();
    let spread = curve.iter().map(|[t, _]| (t - mean[0]).powi(2));
    [drift, rms / spread.sum::<f64>().sqrt(), rms]
}

/// Exponent of the time step in the fluctuation.
pub fn order(runs: &[Run], case: &str) -> f64 {
    let of = runs.iter().filter(|run| run.case == case);
    exponent(of.map(|run| [run.time_step, run.rms]))
}

/// A row for every run.
pub fn sheet(runs: &[Run], is_quick: bool) -> Sheet {
    let looks = if is_quick { QUICK_LOOKS } else { LOOKS };
    let atoms = 4 * CUBES.pow(3);
    let rows = CASES
        .iter()
        .flat_map(|&(case, ..)| runs.iter().filter(move |run| run.case == case));
    Sheet::of(
        format!(
            "Energy of an atom of {atoms} in a melt over a time of {}: fluctuation about the nearest \
             straight line, and its slope",
            looks as f64 * BETWEEN
        ),
        rows,
        &[
            ("cut-off", &|run| run.case.into()),
            ("dt", &|run| run.time_step.to_string()),
            ("atom-steps per time", &|run| {
                short(atoms as f64 / run.time_step)
            }),
            ("rms fluctuation", &|run| short(run.rms)),
            ("drift per time", &|run| short(run.drift)),
            ("error of the drift", &|run| short(run.drift_error)),
            ("temperature", &|run| short(run.temperature)),
        ],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drift_is_told_from_a_fluctuation() {
        let swing = |index: i32| if index % 2 == 0 { 0.1 } else { -0.1 };
        let curve: Vec<[f64; 2]> = (0..1000)
            .map(|index| {
                let time = 0.01 * f64::from(index);
                [time, 1e3 - 0.25 * time + swing(index)]
            })
            .collect();
        let [drift, error, rms] = straight(&curve);
        assert!((drift + 0.25).abs() < 3.0 * error, "{drift} {error}");
        assert!((rms - 0.1).abs() < 1e-4, "{rms}");
        // rms over the root of the sum of squared times, 10²/12 each.
        assert!(
            (error - 0.1 * (12.0_f64 / 1e5).sqrt()).abs() < 1e-5,
            "{error}"
        );
    }
}
