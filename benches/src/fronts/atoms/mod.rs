//! Molecular dynamics: atom-steps a second beside LAMMPS, conserved energy against the time step.

mod drift;
mod gromacs;
mod lammps;
pub mod melt;
mod parts;
mod problems;
mod race;
mod threads;

use super::{Finding, Front, Setting};
use crate::written::{self, short};
use drift::{CASES, Run};
use problems::Problem;
use race::{Peers, Race};
use std::path::Path;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

const PICTURE: &str = "atoms.svg";
/// Size of a panel in pixels.
const PANEL: (u32, u32) = (640, 460);

/// Reads a figure of a run.
type RunQuantity = fn(&Run) -> f64;

/// Length of the measurements.
struct Extent {
    rounds: usize,
    /// Steps from the crystal to the melt.
    melting: usize,
    /// Cubes along an edge of the melts, and steps timed.
    melts: [(usize, u64); 2],
}

const FULL: Extent = Extent {
    rounds: 7,
    melting: 400,
    melts: [(10, 400), (20, 100)],
};
const QUICK: Extent = Extent {
    rounds: 1,
    melting: 100,
    melts: [(10, 40), (20, 10)],
};

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let extent = if setting.quick { QUICK } else { FULL };
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let one = one.map_err(|error| error.to_string())?;
    let (races, speeds) = one.install(|| speeds(setting, &extent))?;
    let runs = drift::measure(setting.quick)?;
    let drifts = drift::sheet(&runs, setting.quick);
    setting.table("atoms_drift", &drifts)?;
    draw(setting.out, &runs)?;
    let body = format!(
        "## Speed\n\n{speeds}\n{SPEED_LEGEND}\n## Conserved energy\n\n\
         ![Fluctuation and drift against the time step]({PICTURE})\n\n{}\n{}\n{DRIFT_LEGEND}",
        drifts.markdown(),
        orders(&runs),
    );
    setting.page(Front::Atoms, &body)?;
    Ok(Finding {
        line: line(&races, &runs),
        picture: PICTURE,
    })
}

/// Description of the problems and the columns.
const SPEED_LEGEND: &str = "\
The melt is LAMMPS' bench: density 0.8442, a crystal warmed to 1.44 and left to melt before anything is \
timed, velocity Verlet in steps of 0.005, cut-off 2.5 without a shift, skin 0.3, lists built as soon as an \
atom could have crossed the skin (`neigh_modify delay 0 every 1 check yes`). The tip is the scene of that \
name with its thermostats (leap-frog here, velocity Verlet in LAMMPS: the same path), timed while it is \
driven. LAMMPS runs one process on one thread with the pair styles of its package OPT; its time is that of \
its loop times its share of the processor, the shares of forces and lists are those that it prints (lists \
without the exchange of atoms, which it counts apart). Ours of forces and lists are timed alone on the last \
places. The potential energy at the start must agree to 1e-10, or nothing is compared. Where GROMACS is \
installed in double precision (Debian: `gromacs`, built for SSE4.1), it runs the melts on one thread with the same \
cut-off, lists of the same reach that live as many steps as ours, and no thermostat; its log has six digits of the energy.
";

/// Interpretation of the drift.
const DRIFT_LEGEND: &str = "\
A step costs the same whatever its length and whatever is done at the cut-off (a force that is shifted takes \
a square root more), so atom-steps per time are the price. Runs of the truncated and the energy-shifted \
potential follow the same path; they differ in what is called energy. A truncated energy jumps whenever a \
pair crosses the cut-off: no smaller step mends that. A shifted energy has no jump, a shifted force no kink. \
With a thermostat the conserved energy includes that of the thermostat. \
Drifts below their error are none that this time could show.
";

/// Ours and theirs, and ours on two threads.
fn speeds(setting: &Setting<'_>, extent: &Extent) -> Result<(Vec<Race>, String), String> {
    let release = lammps::release();
    let peers = Peers {
        lammps: release.is_some(),
        gromacs: gromacs::is_installed(),
    };
    let mut problems = Vec::new();
    for (cubes, steps) in extent.melts {
        problems.push(Problem::melt(cubes, extent.melting, steps)?);
    }
    problems.push(Problem::tip(setting.quick));
    let races: Result<Vec<Race>, String> = problems
        .iter()
        .map(|problem| race::race(problem, extent.rounds, peers))
        .collect();
    let races = races?;
    let sheet = race::sheet(&races, extent.rounds, release.as_deref());
    setting.table("atoms", &sheet)?;
    let mut text = sheet.markdown();
    if let Problem::Melt { melt, steps } = &problems[1] {
        let times = threads::measure(melt, *steps as usize, extent.rounds)?;
        text += "\n";
        text += &threads::sheet(&times, melt.atoms.len(), extent.rounds).markdown();
    }
    Ok((races, text))
}

/// Exponents of the time step in the fluctuation, in one line.
fn orders(runs: &[Run]) -> String {
    let told = CASES.map(|(case, ..)| format!("{case} {:.2}", drift::order(runs, case)));
    let told = told.join(", ");
    format!("Exponent of the time step in the rms fluctuation: {told}.\n")
}

/// Fluctuation and drift over the time step.
fn draw(folder: &Path, runs: &[Run]) -> Result<(), String> {
    let mut panels = Panels::new("Energy of an atom in a melt", 2).cell(PANEL.0, PANEL.1);
    let quantities: [(&str, RunQuantity); 2] = [
        ("rms fluctuation [ε]", |run| run.rms),
        ("drift, either way [ε/τ]", |run| run.drift.abs()),
    ];
    for (label, read) in quantities {
        let axes = (Axis::log10("time step [τ]"), Axis::log10(label));
        let mut figure = Figure::new(label, axes.0, axes.1).legend(Legend::Below);
        for (case, ..) in CASES {
            let of = runs.iter().filter(|run| run.case == case);
            let line = of.map(|run| (run.time_step, read(run))).collect();
            figure = figure.series(Series::line_points(case, line));
        }
        panels = panels.figure(figure);
    }
    let svg = panels.svg().map_err(|error| error.to_string())?;
    written::write(folder, PICTURE, &svg)
}

/// Summary of the front.
fn line(races: &[Race], runs: &[Run]) -> String {
    let speed = |race: &Race| {
        let beside = match race.theirs {
            Some(_) => format!(", {} times LAMMPS' speed", short(race.ratio)),
            None => String::new(),
        };
        let beside = match race.gromacs {
            Some(anchor) => format!(
                "{beside}, {} times GROMACS' in double precision",
                short(anchor.ratio)
            ),
            None => beside,
        };
        let speed = short(1e-6 / race.ours.per_atom_step);
        format!(
            "{speed} million in the {} of {}{beside}",
            race.name, race.atoms
        )
    };
    let speeds: Vec<String> = races.iter().map(speed).collect();
    let usual = |run: &&Run| run.case == "force shifted" && run.time_step == melt::TIME_STEP;
    let usual = runs.iter().find(usual);
    let told = |read: RunQuantity| short(usual.map_or(f64::NAN, read));
    format!(
        "One core makes this many Lennard-Jones atom-steps a second: {}; in steps of {} the \
         energy of an atom fluctuates by {} and drifts by {} per time where the force is shifted \
         (order {:.2}).",
        speeds.join("; "),
        melt::TIME_STEP,
        told(|run| run.rms),
        told(|run| run.drift),
        drift::order(runs, "force shifted"),
    )
}
