//! Runs of spheres or atoms, from the request to their results.

use super::frontend::Frontend;
use super::request::RunRequest;
use super::{files, resource_check};
use crate::command::bodies::LongBody;
use crate::failure::Failure;
use std::path::Path;
use tribos::record::{self, Snapshot, SnapshotError};
use tribos::results::{Summary, file};
use tribos::run::folder::OutputFolder;
use tribos::run::{LongRun, RunError, Session, Simulation, forget_checkpoint};

/// A format of a state: text of a snapshot.
pub type Export = fn(&Snapshot<'_>) -> Result<String, SnapshotError>;

/// Runs the scene, on from a checkpoint if asked to, and writes its results into the folder.
pub fn run<S: LongBody>(scene: &S, order: &RunRequest<'_>) -> Result<(), Failure> {
    resource_check::check(&scene.size(), S::SPHERES, order.allowed)?;
    // All refusals come before the folder is touched.
    scene.refuse()?;
    let Some((folder, start)) = order.long(scene.json(), S::FILES)? else {
        return Ok(());
    };
    // After its end an interruption costs no more than the results.
    let run = simulate(scene, order.session(start, &folder), order.caller)
        .map_err(|error| order.failure(error))?;
    folder.remove(files::is_made_from_frames)?;
    let outcome = S::outcome(&run);
    folder.add(S::FILES)?;
    write_series::<S>(&run, order.out)?;
    scene.write(&run, &folder, order)?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", file(outcome.entries(), scene));
    folder.write("summary.json", summary.as_bytes())?;
    folder.check()?;
    forget_checkpoint(order.out)?;
    let written = format!("written to    {}\n", order.out.display());
    order.caller.report(&(scene.report(&outcome) + &written))
}

/// The series of a run as CSV.
pub fn write_series<S: LongBody>(run: &S::Run, out: &Path) -> Result<(), Failure> {
    let (columns, rows) = S::series(run);
    let names: Vec<&str> = columns.iter().map(String::as_str).collect();
    Ok(record::write_series(&out.join("series.csv"), &names, rows)?)
}

/// Runs the scene to its end and says how far it is.
fn simulate<S: LongBody>(
    scene: &S,
    session: Session<'_, S::Run>,
    caller: Frontend<'_>,
) -> Result<S::Run, RunError<<S::Run as Simulation>::Error>> {
    let size = scene.size();
    caller.tell(format_args!(
        "{}",
        resource_check::describe_size(&size, S::SPHERES)
    ));
    let (mut growth, mut meter) = (caller.meter(), caller.meter());
    // Sweeps since the last line, and the step that it told.
    let (mut sweeps, mut since) = (0, None);
    session
        .on_growth(|placed| {
            if growth.is_due(0.0)
                && let Some(words) = S::growth(placed, size.bodies)
            {
                growth.report_elapsed(format_args!("{words}"));
            }
        })
        .on_progress(|run: &S::Run| {
            let last = scene.sweeps(run);
            sweeps += last.unwrap_or(0);
            let from = *since.get_or_insert(run.steps());
            if !meter.is_due(run.progress()) {
                return;
            }
            let mut words = S::state(run);
            if last.is_some() {
                let each = sweeps as f64 / (run.steps() - from).max(1) as f64;
                words += &format!("  {each:6.1} sweeps a step");
            }
            if scene.is_end_known() {
                meter.tell(run.progress(), format_args!("{words}"));
            } else {
                meter.report_elapsed(format_args!("{words}"));
            }
            (sweeps, since) = (0, Some(run.steps()));
        })
        .run(scene)
}

/// A state in all formats: endings of the files' names and what they hold.
pub fn write_state(
    snapshot: &Snapshot<'_>,
    (stem, exports): (&str, &[(&str, Export)]),
    folder: &OutputFolder,
    order: &RunRequest<'_>,
) -> Result<(), Failure> {
    for (ending, export) in exports {
        order.interrupted()?;
        let text = export(snapshot).map_err(Failure::run)?;
        folder.write(&format!("{stem}{ending}"), text.as_bytes())?;
    }
    Ok(())
}
