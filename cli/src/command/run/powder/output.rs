//! What a compaction leaves behind.

use crate::command::digits::shown;
use crate::command::run::files;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use tribos::powder::{COLUMNS, PowderSimulation, PowderStopReason, PowderSummary, STATE};
use tribos::record::{
    Snapshot, SnapshotError, contacts_vtp, extended_xyz, particles_vtp, write_series,
};
use tribos::run::folder::OutputFolder;
use tribos::scene::PowderScene;
use tribos_report::runs::powder as picture;

/// A format of a state: text of a snapshot.
type Export = fn(&Snapshot<'_>) -> Result<String, SnapshotError>;

/// Endings of the names of a state's files, and what they hold.
const EXPORTS: [(&str, Export); 3] = [
    (".xyz", extended_xyz),
    (".vtp", particles_vtp),
    ("-contacts.vtp", contacts_vtp),
];

/// Writes series, states, pictures and at last the summary.
pub fn write(
    scene: &PowderScene,
    compaction: &PowderSimulation,
    outcome: &PowderSummary,
    folder: &OutputFolder,
    order: &RunRequest<'_>,
) -> Result<(), Failure> {
    folder.add(files::POWDER)?;
    let out = folder.path();
    let rows = compaction.series().iter();
    let rows = rows.map(<[f64; COLUMNS.len()]>::as_slice);
    write_series(&out.join("series.csv"), &COLUMNS, rows)?;

    let deposit = compaction.deposit();
    compaction.with_snapshot(|last| {
        // Spheres are of the same materials all the time.
        let first = Snapshot {
            materials: last.materials,
            densities: last.densities,
            ..deposit.snapshot(compaction.first_contacts())
        };
        states(&first, "initial", folder, order)?;
        states(last, "final", folder, order)
    })?;
    folder.write(STATE, compaction.state().as_bytes())?;

    order.interrupted()?;
    folder.check()?;
    order.draw("packing", || {
        let states = picture::State::both(compaction);
        picture::packing(scene, &states, outcome).map_err(Failure::run)
    })?;
    folder.check()?;
    order.draw("series", || Ok(picture::series(compaction, outcome)))?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", outcome.json(scene));
    Ok(folder.write("summary.json", summary.as_bytes())?)
}

/// A state in all formats.
pub fn states(
    snapshot: &Snapshot<'_>,
    stem: &str,
    folder: &OutputFolder,
    order: &RunRequest<'_>,
) -> Result<(), Failure> {
    for (ending, export) in EXPORTS {
        order.interrupted()?;
        let text = export(snapshot).map_err(Failure::run)?;
        folder.write(&format!("{stem}{ending}"), text.as_bytes())?;
    }
    Ok(())
}

/// A few lines for the person at the terminal.
pub fn report(outcome: &PowderSummary, order: &RunRequest<'_>) -> Result<(), Failure> {
    let ending = match outcome.ending {
        Some(PowderStopReason::Blocked) => "blocked",
        Some(PowderStopReason::Time) => "duration over before the packing was blocked",
        Some(PowderStopReason::Steps) | None => "steps done before the packing was blocked",
    };
    let [before, after] = outcome.porosity.map(|porosity| shown(100.0 * porosity));
    let [total, plus, minus] = outcome.stress_zz();
    let sign = if minus < 0.0 { '-' } else { '+' };
    let [total, plus, minus] = [total, plus, minus.abs()].map(shown);
    let mut text = format!(
        "ending        {ending}: {} steps, {} sweeps, {:.1} s\n\
         particles     {}, {} contacts, {:.2} a sphere\n\
         porosity      {after} % from {before} %\n\
         stress_zz     {total} = {plus} {sign} {minus} of the pressure\n\
         residual      {:.1e}, overlap {:.1e} R\n",
        outcome.steps,
        outcome.iterations,
        outcome.wall_seconds,
        outcome.particles,
        outcome.statistics.contacts,
        outcome.statistics.mean_coordination(),
        outcome.residual,
        outcome.statistics.max_overlap,
    );
    text += &unmet(outcome);
    text += &budget(outcome);
    text += &format!("written to    {}\n", order.out.display());
    order.caller.report(&text)
}

/// Steps that did not end as they should, and what that means.
fn unmet(outcome: &PowderSummary) -> String {
    let mut text = String::new();
    if outcome.impacts_cut > 0 {
        text += &format!(
            "impacts       cut in {} steps after 100 rounds: the rest was stopped without rebound, \
             its energy is in normal\n",
            outcome.impacts_cut
        );
    }
    if outcome.impacts_unmet > 0 {
        text += &format!(
            "impacts       unmet in {} steps: a reflection, or friction under it, missed its tolerance after \
             1000 sweeps; its impulses are approximate\n",
            outcome.impacts_unmet
        );
    }
    if outcome.handed_over > 0 {
        text += &format!(
            "handed over   {} steps, in which sweeps missed the tolerance, to an interior point method\n",
            outcome.handed_over
        );
    }
    if outcome.solver_unmet > 0 {
        text += &format!(
            "unmet         {} steps missed the solver's tolerance; their forces and energies are approximate\n",
            outcome.solver_unmet
        );
    }
    text
}

/// Where the work went.
fn budget(outcome: &PowderSummary) -> String {
    let work = outcome.energy.work;
    let mut text = format!("work          {}, of which\n", shown(work));
    for (name, energy) in outcome.dissipation() {
        let percent = 100.0 * energy / work;
        // No work, no share of it.
        let share = if percent.is_finite() {
            format!(" ({percent:.1} %)")
        } else {
            String::new()
        };
        text += &format!("  {name:<11} {}{share}\n", shown(energy));
    }
    if outcome.energy.elastic != 0.0 {
        text += &format!("  elastic     {}\n", shown(outcome.energy.elastic));
    }
    text += &format!("  imbalance   {:.1e}\n", outcome.energy.imbalance());
    text
}
