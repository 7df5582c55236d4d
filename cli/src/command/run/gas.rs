//! What a run of a gas leaves behind.

use super::long::{Export, write_state};
use super::request::RunRequest;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::gas::{GasSimulation, GasStopReason, GasSummary};
use tribos::record::{extended_xyz, particles_vtp};
use tribos::run::folder::OutputFolder;
use tribos_report::runs::gas as picture;

/// Endings of the names of the last state's files, and what they hold.
const EXPORTS: [(&str, Export); 2] = [(".xyz", extended_xyz), (".vtp", particles_vtp)];

/// Writes the last state and the pictures.
pub fn write(
    run: &GasSimulation,
    (folder, order): (&OutputFolder, &RunRequest<'_>),
) -> Result<(), Failure> {
    run.with_snapshot(|last| write_state(last, ("final", &EXPORTS), folder, order))??;
    order.interrupted()?;
    folder.check()?;
    order.draw("spheres", || picture::spheres(run).map_err(Failure::run))?;
    order.draw("series", || Ok(picture::series(run)))
}

/// A few lines for the person at the terminal.
pub fn report(outcome: &GasSummary) -> String {
    let ending = match outcome.ending {
        Some(GasStopReason::Time) => "duration over",
        Some(GasStopReason::Collapse) => {
            "inelastic collapse: time stands still while collisions go on; set contact_time, such as 1e-4"
        }
        Some(GasStopReason::Rest) => "no sphere will meet another one",
        _ => "collisions done",
    };
    let mut text = format!(
        "ending        {ending}\n\
         collisions    {} a sphere of {}, time {}, {:.1} s\n\
         temperature   {} T0, mean field {} after as many collisions, Haff {} after the same time\n",
        shown(outcome.collisions),
        outcome.particles,
        shown(outcome.time),
        outcome.wall_seconds,
        shown(outcome.temperature),
        shown(outcome.theory),
        shown(outcome.haff),
    );
    if outcome.theory_rotational > 0.0 {
        text += &format!(
            "rotation      {} T0, mean field {}\n",
            shown(outcome.temperature_rotational),
            shown(outcome.theory_rotational)
        );
    }
    let [before, after] = outcome.density_variance.map(shown);
    text += &format!("clusters      variance over mean of counts {after} from {before}\n");
    if outcome.cured > 0 {
        text += &format!(
            "contact time  {} collisions lost no energy\n",
            outcome.cured
        );
    }
    if outcome.unmet > 0 {
        text += &format!(
            "unmet         {} steps missed the tolerance of their impacts\n",
            outcome.unmet
        );
    }
    text
}
