//! Tips turned or slid on a substrate.

use super::frontend::Frontend;
use super::request::RunRequest;
use super::{files, resource_check};
use crate::command::digits::shown;
use crate::failure::Failure;
use std::path::Path;
use tribos::record;
use tribos::run::folder::OutputFolder;
use tribos::run::{RunError, Session, Simulation, forget_checkpoint};
use tribos::scene::TipScene;
use tribos::tip::{self, Reversal, SlidingSummary, TipError, TipSimulation, TipSummary, export};
use tribos_report::runs::tip as picture;

/// Runs the scene, on from a checkpoint if asked to, and writes its results into the folder.
pub fn run(scene: &TipScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    resource_check::check(&tip::size(scene), "atoms", order.allowed)?;
    // All refusals come before the folder is touched.
    tip::build(scene)?;
    let Some((folder, start)) = order.long(scene.json(), files::TIP)? else {
        return Ok(());
    };
    // After its end an interruption costs no more than the results.
    let run = simulate(scene, order.session(start, &folder), order.caller)
        .map_err(|error| order.failure(error))?;
    folder.remove(files::is_made_from_frames)?;
    write(scene, &run, &folder, order)?;
    folder.check()?;
    forget_checkpoint(order.out)?;
    report(&run.outcome(), order)
}

/// Runs the scene to its end and says how far it is.
fn simulate(
    scene: &TipScene,
    session: Session<'_, TipSimulation>,
    caller: Frontend<'_>,
) -> Result<TipSimulation, RunError<TipError>> {
    let size = tip::size(scene);
    caller.tell(format_args!(
        "{}",
        resource_check::describe_size(&size, "atoms")
    ));
    let mut meter = caller.meter();
    session
        .on_progress(|run: &TipSimulation| {
            if meter.is_due(run.progress()) {
                let angle = run.angle().to_degrees();
                meter.tell(
                    run.progress(),
                    format_args!("time {:9.2}  angle {angle:8.3} degrees", run.time()),
                );
            }
        })
        .run(scene)
}

/// The series as CSV.
pub fn write_series(run: &TipSimulation, out: &Path) -> Result<(), Failure> {
    let columns = run.columns();
    let names: Vec<&str> = columns.iter().map(String::as_str).collect();
    let rows = run.series().iter().map(Vec::as_slice);
    Ok(record::write_series(&out.join("series.csv"), &names, rows)?)
}

/// Writes series, pictures, the first and the last state and at last the summary.
fn write(
    scene: &TipScene,
    run: &TipSimulation,
    folder: &OutputFolder,
    order: &RunRequest<'_>,
) -> Result<(), Failure> {
    folder.add(files::TIP)?;
    let out = folder.path();
    let outcome = run.outcome();
    write_series(run, out)?;
    order.draw("angles", || Ok(picture::series(scene, run, &outcome)))?;
    order.interrupted()?;
    folder.check()?;
    order.draw("tip", || {
        picture::both_ends(scene, run).map_err(Failure::run)
    })?;
    let start = export::start(scene).map_err(Failure::input)?;
    folder.write("initial.data", start.data.as_bytes())?;
    let atoms = run.system().atoms();
    let velocities = run.system().velocities_on_step();
    let end = export::data(scene, &atoms.positions, &velocities, run.parts());
    folder.write("final.data", end.as_bytes())?;
    let summary = format!("{:#}\n", outcome.json(scene));
    Ok(folder.write("summary.json", summary.as_bytes())?)
}

/// What a slid tip shows.
fn told(slid: &SlidingSummary, outcome: &TipSummary) -> String {
    let balance = slid.heat + slid.stored;
    format!(
        "friction      {} as loop area over path, mean force {} forth and {} back, {} of {} strokes\n\
         normal force  {} on the driven layers\n\
         stick-slip    period {} ({} of the variance), {} slips from {} on average\n\
         energy        work {} of the support, {} as heat and {} stored: {} together\n\
         temperature   {} of the tip's bath\n\
         start         force {}, {}, {} and torque {} +- {} on the driven layers before the drive\n",
        shown(slid.friction),
        shown(slid.friction_forth),
        shown(slid.friction_back),
        2 * slid.loops,
        slid.strokes,
        shown(slid.normal_force),
        shown(slid.period),
        shown(slid.period_share),
        slid.slips,
        shown(slid.peak_force),
        shown(slid.work),
        shown(slid.heat),
        shown(slid.stored),
        shown(balance),
        shown(outcome.tip_temperature),
        shown(outcome.start.force[0]),
        shown(outcome.start.force[1]),
        shown(outcome.start.force[2]),
        shown(outcome.start.torque),
        shown(outcome.start.torque_error),
    )
}

/// A few lines for the person at the terminal.
fn report(outcome: &TipSummary, order: &RunRequest<'_>) -> Result<(), Failure> {
    if let Some(slid) = &outcome.slid {
        let text = told(slid, outcome) + &format!("written to    {}\n", order.out.display());
        return order.caller.report(&text);
    }
    let verdict = match outcome.verdict {
        Reversal::Reversible => "reversible: the driven layers turned back",
        Reversal::Irreversible => "irreversible: the driven layers did not turn back",
        Reversal::Open => "open: the scene ends before it shows",
    };
    let interfaces = |list: &[usize]| match list {
        [] => "none".to_owned(),
        list => list
            .iter()
            .map(usize::to_string)
            .collect::<Vec<_>>()
            .join(", "),
    };
    let angles: Vec<String> = outcome
        .layer_angles_degrees
        .iter()
        .map(|&angle| shown(angle))
        .collect();
    let mut text = format!(
        "verdict       {verdict}\n\
         angle         {} degrees driven, {} at the end, {} at most\n\
         layers        {} degrees at the end, from below\n\
         slipped       while driven {}, for good {} (0 is the contact, k above the tip's layer k)\n\
         temperature   {} eps/k_B of the tip's bath\n",
        shown(outcome.driven_angle_degrees),
        shown(outcome.final_angle_degrees),
        shown(outcome.largest_angle_degrees),
        angles.join(", "),
        interfaces(&outcome.slipped_interfaces_while_driven),
        interfaces(&outcome.slipped_interfaces),
        shown(outcome.tip_temperature),
    );
    for plateau in &outcome.plateaus {
        text += &format!(
            "locked        {} degrees from {} to {}\n",
            shown(plateau.angle_degrees),
            shown(plateau.from),
            shown(plateau.to)
        );
    }
    text += &format!("written to    {}\n", order.out.display());
    order.caller.report(&text)
}

impl From<TipError> for Failure {
    fn from(error: TipError) -> Self {
        match error {
            TipError::System(_) => Self::run(error),
            // The scene or the checkpoint cannot be used.
            _ => Self::input(error),
        }
    }
}
