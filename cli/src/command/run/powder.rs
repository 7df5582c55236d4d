//! Powders under a piston.

mod output;

use super::frontend::Frontend;
use super::request::RunRequest;
use super::{files, resource_check};
use crate::command::progress::Meter;
use crate::failure::Failure;
pub use output::states;
use output::{report, write};
use tribos::powder::{self, CompactionError, PowderSimulation};
use tribos::run::{RunError, Session, Simulation, forget_checkpoint};
use tribos::scene::{ContactMethod, PowderScene};

/// Runs the scene, on from a checkpoint if asked to, and writes its results into the folder.
pub fn run(scene: &PowderScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    let size = tribos::powder::size(scene);
    resource_check::check(&size, "spheres", order.allowed)?;
    // All refusals come before the folder is touched.
    PowderSimulation::check(scene)?;
    let Some((folder, start)) = order.long(scene.json(), files::POWDER)? else {
        return Ok(());
    };
    // After its end an interruption costs no more than the results.
    let compaction = simulate(scene, order.session(start, &folder), order.caller)
        .map_err(|error| order.failure(error))?;
    folder.remove(files::is_made_from_frames)?;
    let outcome = compaction.outcome();
    write(scene, &compaction, &outcome, &folder, order)?;
    folder.check()?;
    forget_checkpoint(order.out)?;
    report(&outcome, order)
}

/// Runs the scene to its end and says how far it is.
fn simulate(
    scene: &PowderScene,
    session: Session<'_, PowderSimulation>,
    caller: Frontend<'_>,
) -> Result<PowderSimulation, RunError<CompactionError>> {
    let size = powder::size(scene);
    caller.tell(format_args!(
        "{}",
        resource_check::describe_size(&size, "spheres")
    ));
    let (mut growth, mut meter) = (caller.meter(), caller.meter());
    // Sweeps since the last line, and the step that it told.
    let (mut sweeps, mut since) = (0, None);
    session
        .on_growth(|spheres| {
            if growth.is_due(0.0) {
                growth.report_elapsed(format_args!(
                    "deposit: {spheres} spheres have fallen, about {:.0} will be below the cut",
                    size.bodies
                ));
            }
        })
        .on_progress(|run: &PowderSimulation| {
            sweeps += run.last_step().iterations.sweeps;
            let from = *since.get_or_insert(run.steps());
            if meter.is_due(run.progress()) {
                let each = sweeps as f64 / (run.steps() - from).max(1) as f64;
                tell(&mut meter, scene, run, each);
                (sweeps, since) = (0, Some(run.steps()));
            }
        })
        .run(scene)
}

/// How far a compaction is: its end is known where a time is given, or so few steps that they may
/// end it before the packing is blocked.
fn tell(meter: &mut Meter<'_>, scene: &PowderScene, compaction: &PowderSimulation, sweeps: f64) {
    /// A packing is seldom blocked within fewer steps.
    const FEW: u64 = 5_000;
    let words = format!(
        "step {:6}  height {:8.4}  porosity {:7.3} %",
        compaction.steps(),
        compaction.height(),
        100.0 * compaction.porosity()
    );
    let words = match scene.method {
        ContactMethod::ContactDynamics => format!("{words}  {sweeps:6.1} sweeps a step"),
        ContactMethod::Soft => words,
    };
    if scene.duration.is_some() || scene.max_steps <= FEW {
        meter.tell(compaction.progress(), format_args!("{words}"));
    } else {
        meter.report_elapsed(format_args!("{words}"));
    }
}
