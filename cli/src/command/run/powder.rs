//! What a compaction leaves behind.

use super::packing::{budget, states};
use super::request::RunRequest;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::powder::{PowderSimulation, PowderStopReason, PowderSummary, STATE};
use tribos::record::Snapshot;
use tribos::run::folder::OutputFolder;
use tribos::scene::PowderScene;
use tribos_report::runs::powder as picture;

/// Writes the states at both ends and the pictures.
pub fn write(
    scene: &PowderScene,
    compaction: &PowderSimulation,
    (folder, order): (&OutputFolder, &RunRequest<'_>),
    outcome: &PowderSummary,
) -> Result<(), Failure> {
    let deposit = compaction.deposit();
    compaction.with_snapshot(|last| {
        // Spheres are of the same materials all the time.
        let first = Snapshot {
            materials: last.materials,
            densities: last.densities,
            ..deposit.snapshot(compaction.first_contacts())
        };
        states(&first, last, (folder, order))
    })?;
    folder.write(STATE, compaction.state().as_bytes())?;

    order.interrupted()?;
    folder.check()?;
    order.draw("packing", || {
        let states = picture::State::both(compaction);
        picture::packing(scene, &states, outcome).map_err(Failure::run)
    })?;
    folder.check()?;
    order.draw("series", || Ok(picture::series(compaction, outcome)))
}

/// A few lines for the person at the terminal.
pub fn report(outcome: &PowderSummary) -> String {
    let ending = match outcome.ending {
        Some(PowderStopReason::Blocked) => "blocked",
        Some(PowderStopReason::Time) => "duration over before the packing was blocked",
        _ => "steps done before the packing was blocked",
    };
    let [before, after] = outcome.porosity.map(|porosity| shown(100.0 * porosity));
    let [total, plus, minus] = outcome.stress_zz();
    let sign = if minus < 0.0 { '-' } else { '+' };
    let [total, plus, minus] = [total, plus, minus.abs()].map(shown);
    let text = format!(
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
    text + &unmet(outcome) + &budget(&outcome.energy, &outcome.dissipation(), "")
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
