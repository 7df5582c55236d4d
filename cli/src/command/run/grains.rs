//! What a run of grains leaves behind.

use super::packing::{budget, states};
use super::request::RunRequest;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::grains::{GrainsSimulation, GrainsStopReason, GrainsSummary};
use tribos::powder::STATE;
use tribos::run::folder::OutputFolder;
use tribos::scene::GrainsScene;
use tribos_report::runs::grains as picture;

/// Writes the states at both ends and the pictures.
pub fn write(
    scene: &GrainsScene,
    run: &GrainsSimulation,
    (folder, order): (&OutputFolder, &RunRequest<'_>),
) -> Result<(), Failure> {
    let start = GrainsSimulation::new(scene)?;
    start.with_snapshot(|first| run.with_snapshot(|last| states(first, last, (folder, order))))?;
    folder.write(STATE, run.state().as_bytes())?;

    order.interrupted()?;
    folder.check()?;
    order.draw("packing", || {
        picture::packing(&start, run).map_err(Failure::run)
    })?;
    folder.check()?;
    order.draw("series", || Ok(picture::series(run)))
}

/// A few lines for the person at the terminal.
pub fn report(outcome: &GrainsSummary) -> String {
    let ending = match outcome.ending {
        Some(GrainsStopReason::Rest) => "at rest",
        Some(GrainsStopReason::Time) => "duration over",
        _ => "steps done",
    };
    let column = |name: &str| shown(outcome.column(name).unwrap_or(f64::NAN));
    let mut text = format!(
        "ending        {ending}: time {} s, {} steps, {} sweeps; it took {:.1} s\n\
         grains        {}, {} kg, {} contacts, {:.2} a grain\n\
         height        {} m, solid fraction {}\n\
         forces        floor {} N, plate {} N, side x {} N\n\
         stresses      zz {} Pa, shear at the plate {} Pa\n",
        shown(outcome.time),
        outcome.steps,
        outcome.iterations,
        outcome.wall_seconds,
        outcome.grains,
        shown(outcome.mass),
        outcome.statistics.contacts,
        outcome.statistics.mean_coordination(),
        column("height"),
        column("solid_fraction"),
        column("floor_force"),
        column("plate_force"),
        column("side_force_x"),
        column("stress_zz"),
        column("shear_stress"),
    );
    if outcome.unmet > 0 {
        text += &format!(
            "unmet         {} steps missed the solver's tolerance; their forces and energies are approximate, overlaps \
             reach {} m\n",
            outcome.unmet,
            shown(outcome.statistics.max_overlap)
        );
    }
    text + &budget(&outcome.energy, &outcome.dissipation(), " J")
}
