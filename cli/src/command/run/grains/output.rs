//! What a run of grains leaves behind.

use crate::command::digits::shown;
use crate::command::run::files;
use crate::command::run::powder::states;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use tribos::grains::{COLUMNS, GrainsSimulation, GrainsStopReason, GrainsSummary};
use tribos::powder::STATE;
use tribos::record::write_series;
use tribos::run::folder::OutputFolder;
use tribos::scene::GrainsScene;
use tribos_report::runs::grains as picture;

/// Writes series, states, pictures and at last the summary.
pub fn write(
    scene: &GrainsScene,
    run: &GrainsSimulation,
    outcome: &GrainsSummary,
    folder: &OutputFolder,
    order: &RunRequest<'_>,
) -> Result<(), Failure> {
    folder.add(files::GRAINS)?;
    let rows = run.series().iter();
    let rows = rows.map(<[f64; COLUMNS.len()]>::as_slice);
    write_series(&folder.path().join("series.csv"), &COLUMNS, rows)?;

    let start = GrainsSimulation::new(scene)?;
    start.with_snapshot(|snapshot| states(snapshot, "initial", folder, order))?;
    run.with_snapshot(|snapshot| states(snapshot, "final", folder, order))?;
    folder.write(STATE, run.state().as_bytes())?;

    order.interrupted()?;
    folder.check()?;
    order.draw("packing", || {
        picture::packing(&start, run).map_err(Failure::run)
    })?;
    folder.check()?;
    order.draw("series", || Ok(picture::series(run)))?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", outcome.json(scene));
    Ok(folder.write("summary.json", summary.as_bytes())?)
}

/// A few lines for the person at the terminal.
pub fn report(outcome: &GrainsSummary, order: &RunRequest<'_>) -> Result<(), Failure> {
    let ending = match outcome.ending {
        Some(GrainsStopReason::Rest) => "at rest",
        Some(GrainsStopReason::Time) => "duration over",
        Some(GrainsStopReason::Steps) | None => "steps done",
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
    text += &format!("work          {} J, of which\n", shown(outcome.energy.work));
    for (name, energy) in outcome.dissipation() {
        text += &format!("  {name:<11} {}\n", shown(energy));
    }
    if outcome.energy.elastic != 0.0 {
        text += &format!("  elastic     {}\n", shown(outcome.energy.elastic));
    }
    text += &format!("  imbalance   {:.1e}\n", outcome.energy.imbalance());
    text += &format!("written to    {}\n", order.out.display());
    order.caller.report(&text)
}
