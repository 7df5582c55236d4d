//! Grains in a box.

mod output;

use super::frontend::Frontend;
use super::request::RunRequest;
use super::{files, resource_check};
use crate::failure::Failure;
use output::{report, write};
use tribos::grains::{self, GrainsError, GrainsSimulation};
use tribos::run::{RunError, Session, Simulation, forget_checkpoint};
use tribos::scene::{ContactMethod, GrainsScene};

/// Runs the scene, on from a checkpoint if asked to, and writes its results into the folder.
pub fn run(scene: &GrainsScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    resource_check::check(&grains::size(scene), "grains", order.allowed)?;
    // All refusals come before the folder is touched.
    GrainsSimulation::check(scene)?;
    let Some((folder, start)) = order.long(scene.json(), files::GRAINS)? else {
        return Ok(());
    };
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
    scene: &GrainsScene,
    session: Session<'_, GrainsSimulation>,
    caller: Frontend<'_>,
) -> Result<GrainsSimulation, RunError<GrainsError>> {
    let size = grains::size(scene);
    caller.tell(format_args!(
        "{}",
        resource_check::describe_size(&size, "grains")
    ));
    let mut meter = caller.meter();
    session
        .on_progress(|run: &GrainsSimulation| {
            if meter.is_due(run.progress()) {
                let words = format!("step {:7}  time {:9.4}", run.steps(), run.time());
                let words = match scene.method {
                    ContactMethod::ContactDynamics => {
                        let sweeps = run.last_step().iterations.sweeps;
                        format!("{words}  {sweeps:4} sweeps")
                    }
                    ContactMethod::Soft => words,
                };
                meter.tell(run.progress(), format_args!("{words}"));
            }
        })
        .run(scene)
}
