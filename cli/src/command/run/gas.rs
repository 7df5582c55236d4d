//! Granular gases.

use super::frontend::Frontend;
use super::request::RunRequest;
use super::{files, resource_check};
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::gas::{self, COLUMNS, GasError, GasSimulation, GasStopReason, GasSummary};
use tribos::record::{Snapshot, SnapshotError, extended_xyz, particles_vtp, write_series};
use tribos::run::folder::OutputFolder;
use tribos::run::{RunError, Session, Simulation, forget_checkpoint};
use tribos::scene::GasScene;
use tribos_report::runs::gas as picture;

/// A format of a state: text of a snapshot.
type Export = fn(&Snapshot<'_>) -> Result<String, SnapshotError>;

/// Files of the last state.
const EXPORTS: [(&str, Export); 2] = [("final.xyz", extended_xyz), ("final.vtp", particles_vtp)];

/// Runs the scene, on from a checkpoint if asked to, and writes its results into the folder.
pub fn run(scene: &GasScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    resource_check::check(&gas::size(scene), "spheres", order.allowed)?;
    let Some((folder, start)) = order.long(scene.json(), files::GAS)? else {
        return Ok(());
    };
    // After its end an interruption costs no more than the results.
    let run = simulate(scene, order.session(start, &folder), order.caller)
        .map_err(|error| order.failure(error))?;
    folder.remove(files::is_made_from_frames)?;
    let outcome = run.outcome();
    write(scene, &run, &outcome, &folder, order)?;
    folder.check()?;
    forget_checkpoint(order.out)?;
    report(&outcome, order)
}

/// Runs the scene to its end and says how far it is.
fn simulate(
    scene: &GasScene,
    session: Session<'_, GasSimulation>,
    caller: Frontend<'_>,
) -> Result<GasSimulation, RunError<GasError>> {
    caller.tell(format_args!(
        "{}",
        resource_check::describe_size(&gas::size(scene), "spheres")
    ));
    let mut meter = caller.meter();
    session
        .on_progress(|run: &GasSimulation| {
            if meter.is_due(run.progress()) {
                let (collisions, time) = (run.collisions(), run.time());
                meter.tell(
                    run.progress(),
                    format_args!("{collisions:9.3} collisions a sphere  time {time:9.3}"),
                );
            }
        })
        .run(scene)
}

/// Writes series, the last state, pictures and at last the summary.
fn write(
    scene: &GasScene,
    run: &GasSimulation,
    outcome: &GasSummary,
    folder: &OutputFolder,
    order: &RunRequest<'_>,
) -> Result<(), Failure> {
    folder.add(files::GAS)?;
    let rows = run.series().iter();
    let rows = rows.map(<[f64; COLUMNS.len()]>::as_slice);
    write_series(&folder.path().join("series.csv"), &COLUMNS, rows)?;
    for (name, export) in EXPORTS {
        order.interrupted()?;
        let text = run.with_snapshot(export)?.map_err(Failure::run)?;
        folder.write(name, text.as_bytes())?;
    }
    folder.check()?;
    order.draw("spheres", || picture::spheres(run).map_err(Failure::run))?;
    order.draw("series", || Ok(picture::series(run)))?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", outcome.json(scene));
    Ok(folder.write("summary.json", summary.as_bytes())?)
}

/// A few lines for the person at the terminal.
fn report(outcome: &GasSummary, order: &RunRequest<'_>) -> Result<(), Failure> {
    let ending = match outcome.ending {
        Some(GasStopReason::Time) => "duration over",
        Some(GasStopReason::Collapse) => {
            "inelastic collapse: time stands still while collisions go on; set contact_time, such as 1e-4"
        }
        Some(GasStopReason::Rest) => "no sphere will meet another one",
        Some(GasStopReason::Collisions) | None => "collisions done",
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
    text += &format!("written to    {}\n", order.out.display());
    order.caller.report(&text)
}

impl From<GasError> for Failure {
    fn from(error: GasError) -> Self {
        match error {
            GasError::World(_) | GasError::Touch { .. } | GasError::NotFinite { .. } => {
                Self::run(error)
            }
            // The scene or the checkpoint cannot be used.
            _ => Self::input(error),
        }
    }
}
