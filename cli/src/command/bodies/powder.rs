//! Powders under a piston.

use super::long::{LongBody, Series, series};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::packing::{budget, states};
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use tribos::powder::{COLUMNS, PowderSimulation, PowderStopReason, PowderSummary, STATE, size};
use tribos::record::Snapshot;
use tribos::results::SweepView;
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{ContactMethod, PowderScene};
use tribos_report::runs::powder as picture;

/// A packing is seldom blocked within fewer steps.
const FEW: u64 = 5_000;

impl LongBody for PowderScene {
    type Run = PowderSimulation;
    type Summary = PowderSummary;

    const SPHERES: &'static str = "spheres";
    const FILES: &'static [&'static str] = files::POWDER;
    const FIRST: &'static [&'static str] = &[
        "porosity_final",
        "porosity_bulk",
        "porosity_initial",
        "particles",
        "contacts",
        "coordination",
        "stress_zz",
        "stress_zz_plus",
        "stress_zz_minus",
    ];

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "porosity_final",
            title: "Final porosity",
            share: ["blocked", "/ending", "blocked"],
        }
    }

    fn size(&self) -> RunSize {
        size(self)
    }

    fn refuse(&self) -> Result<(), Failure> {
        Ok(PowderSimulation::check(self)?)
    }

    fn growth(placed: usize, expected: f64) -> Option<String> {
        Some(format!(
            "deposit: {placed} spheres have fallen, about {expected:.0} will be below the cut"
        ))
    }

    fn sweeps(&self, run: &PowderSimulation) -> Option<usize> {
        let sweeps = run.last_step().iterations.sweeps;
        (self.method == ContactMethod::ContactDynamics).then_some(sweeps)
    }

    fn state(run: &PowderSimulation) -> String {
        format!(
            "step {:6}  height {:8.4}  porosity {:7.3} %",
            run.steps(),
            run.height(),
            100.0 * run.porosity()
        )
    }

    /// Where a time is given, or so few steps that they may end it before the packing is blocked.
    fn is_end_known(&self) -> bool {
        self.duration.is_some() || self.max_steps <= FEW
    }

    fn outcome(run: &PowderSimulation) -> PowderSummary {
        run.outcome()
    }

    fn told(outcome: &PowderSummary) -> String {
        format!(
            "porosity {} % after {} steps, {:.1} s",
            shown(100.0 * outcome.porosity_final),
            outcome.steps,
            outcome.wall_seconds
        )
    }

    fn report(&self, outcome: &PowderSummary) -> String {
        let ending = match outcome.ending {
            Some(PowderStopReason::Blocked) => "blocked",
            Some(PowderStopReason::Time) => "duration over before the packing was blocked",
            _ => "steps done before the packing was blocked",
        };
        let porosity = [outcome.porosity_initial, outcome.porosity_final];
        let [before, after] = porosity.map(|porosity| shown(100.0 * porosity));
        let sign = if outcome.stress_zz_minus < 0.0 {
            '-'
        } else {
            '+'
        };
        let stress = [
            outcome.stress_zz,
            outcome.stress_zz_plus,
            outcome.stress_zz_minus.abs(),
        ];
        let [total, plus, minus] = stress.map(shown);
        let text = format!(
            "ending        {ending}: {} steps, {} sweeps, {:.1} s\n\
             particles     {}, {} contacts, {:.2} a sphere\n\
             porosity      {after} % from {before} %\n\
             stress_zz     {total} = {plus} {sign} {minus} of the pressure\n\
             residual      {:.1e}, overlap {:.1e} R\n",
            outcome.steps,
            outcome.iterations_total,
            outcome.wall_seconds,
            outcome.particles,
            outcome.contacts,
            outcome.statistics.mean_coordination,
            outcome.residual_final,
            outcome.max_overlap,
        );
        text + &unmet(outcome) + &budget(&outcome.energy, &outcome.dissipation, "")
    }

    fn series(run: &PowderSimulation) -> Series<'_> {
        series(COLUMNS, run.series())
    }

    fn write(
        &self,
        run: &PowderSimulation,
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        let deposit = run.deposit();
        run.with_snapshot(|last| {
            // Spheres are of the same materials all the time.
            let first = Snapshot {
                materials: last.materials,
                densities: last.densities,
                ..deposit.snapshot(run.first_contacts())
            };
            states(&first, last, (folder, order))
        })?;
        folder.write(STATE, run.state().as_bytes())?;

        order.interrupted()?;
        folder.check()?;
        order.draw("packing", || {
            let states = picture::State::both(run);
            picture::packing(run.scene(), &states, &run.outcome()).map_err(Failure::run)
        })?;
        folder.check()?;
        order.draw("series", || Ok(picture::series(run)))
    }

    fn explanation(&self) -> Result<String, Failure> {
        explain::powder::text(self)
    }

    fn account(&self, summary: &Value, command: &str) -> String {
        after::packing(summary, &self.material(), command)
    }
}

/// Steps that did not end as they should, and what that means.
fn unmet(outcome: &PowderSummary) -> String {
    // Without restitution no step misses anything but the solver's rule.
    let solver = outcome.steps_solver_unmet.or(Some(outcome.steps_unmet));
    let told = [
        (
            "impacts       cut in",
            outcome.steps_impacts_cut,
            "steps after 100 rounds: the rest was stopped without rebound, its energy is in normal",
        ),
        (
            "impacts       unmet in",
            outcome.steps_impacts_unmet,
            "steps: a reflection, or friction under it, missed its tolerance after 1000 sweeps; its impulses are \
             approximate",
        ),
        (
            "handed over  ",
            outcome.steps_handed_over,
            "steps, in which sweeps missed the tolerance, to an interior point method",
        ),
        (
            "unmet        ",
            solver,
            "steps missed the solver's tolerance; their forces and energies are approximate",
        ),
    ];
    let line = |(head, steps, text): (&str, Option<u64>, &str)| {
        let steps = steps.filter(|steps| *steps > 0)?;
        Some(format!("{head} {steps} {text}\n"))
    };
    told.into_iter().filter_map(line).collect()
}
