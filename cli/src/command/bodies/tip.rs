//! Tips turned or slid on a substrate.

use super::kind::RunKind;
use super::long::{LongBody, Series};
use crate::command::digits::shown;
use crate::command::explain::{after, tip as text};
use crate::command::run::files;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use tribos::results::{Summary, SweepView, SweptQuantity, swept};
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{DriveKind, TipScene};
use tribos::tip::{Reversal, SlidingSummary, TipSimulation, TipSummary, build, export, size};
use tribos_report::runs::tip as picture;

impl LongBody for TipScene {
    type Run = TipSimulation;
    type Summary = TipSummary;

    const SPHERES: &'static str = "atoms";
    const FILES: &'static [&'static str] = files::TIP;
    const KEEPS_SERIES: bool = true;

    fn kind(&self) -> RunKind {
        let is_slid = self.drive == DriveKind::Slide;
        let belongs = |quantity: &SweptQuantity| match quantity.path[0] {
            "tip_temperature" => true,
            "slid" => is_slid,
            _ => !is_slid,
        };
        let mut quantities = swept(TipSummary::QUANTITIES);
        quantities.retain(belongs);
        for quantity in &mut quantities {
            quantity.unit = text::unit(self, quantity.unit);
        }
        RunKind::of(quantities, self.sweep_view())
    }

    fn sweep_view(&self) -> SweepView {
        if self.drive == DriveKind::Slide {
            SweepView {
                drawn: "friction",
                title: "Friction of the tip",
                share: ["periodic", "/slid/motion", "periodic"],
            }
        } else {
            SweepView {
                drawn: "final_angle",
                title: "Angle after the drive",
                share: ["reversible", "/verdict", "reversible"],
            }
        }
    }

    fn size(&self) -> RunSize {
        size(self)
    }

    fn refuse(&self) -> Result<(), Failure> {
        Ok(build(self).map(drop)?)
    }

    fn state(run: &TipSimulation) -> String {
        let angle = run.angle().to_degrees();
        format!("time {:9.2}  angle {angle:8.3} degrees", run.time())
    }

    fn outcome(run: &TipSimulation) -> TipSummary {
        run.outcome()
    }

    fn told(outcome: &TipSummary) -> String {
        if let Some(slid) = &outcome.slid {
            let (friction, normal) = (shown(slid.friction), shown(slid.normal_force));
            return format!("friction {friction} at a normal force of {normal}");
        }
        format!(
            "{} degrees driven, {} after it",
            shown(outcome.driven_angle_degrees),
            shown(outcome.final_angle_degrees)
        )
    }

    fn report(&self, outcome: &TipSummary) -> String {
        match &outcome.slid {
            Some(slid) => slid_report(slid, outcome),
            None => turned_report(outcome, text::unit(self, "eps/k_B")),
        }
    }

    fn series(run: &TipSimulation) -> Series<'_> {
        let rows = run.series().iter().map(Vec::as_slice);
        (run.columns(), rows.collect())
    }

    /// Pictures, and the first and the last state.
    fn write(
        &self,
        run: &TipSimulation,
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        order.draw("angles", || Ok(picture::series(self, run, &run.outcome())))?;
        order.interrupted()?;
        folder.check()?;
        order.draw("tip", || {
            picture::both_ends(self, run).map_err(Failure::run)
        })?;
        let start = export::start(self).map_err(Failure::input)?;
        folder.write("initial.data", start.data.as_bytes())?;
        let atoms = run.system().atoms();
        let velocities = run.system().velocities_on_step();
        let end = export::data(self, &atoms.positions, &velocities, run.parts());
        Ok(folder.write("final.data", end.as_bytes())?)
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self)
    }

    fn account(&self, summary: &Value, _: &str) -> String {
        after::tip(self, summary)
    }
}

/// What a slid tip shows.
fn slid_report(slid: &SlidingSummary, outcome: &TipSummary) -> String {
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

/// What a turned tip shows.
fn turned_report(outcome: &TipSummary, kelvin: &str) -> String {
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
         temperature   {} {kelvin} of the tip's bath\n",
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
    text
}
