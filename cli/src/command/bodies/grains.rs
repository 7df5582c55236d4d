//! Grains in a box.

use super::long::{LongBody, Series, series};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::packing::{budget, states};
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use tribos::grains::{COLUMNS, GrainsSimulation, GrainsStopReason, GrainsSummary, size};
use tribos::powder::STATE;
use tribos::results::SweepView;
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{ContactMethod, GrainsScene};
use tribos_report::runs::grains as picture;

impl LongBody for GrainsScene {
    type Run = GrainsSimulation;
    type Summary = GrainsSummary;

    const SPHERES: &'static str = "grains";
    const FILES: &'static [&'static str] = files::POWDER;
    const FIRST: &'static [&'static str] = &[
        "solid_fraction",
        "height",
        "coordination",
        "floor_force",
        "plate_stress",
        "shear_stress",
        "stress_xx",
        "stress_zz",
        "stress_xz",
        "surface_angle",
    ];

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "solid_fraction",
            title: "Final solid fraction",
            share: ["rest", "/ending", "rest"],
        }
    }

    fn size(&self) -> RunSize {
        size(self)
    }

    fn refuse(&self) -> Result<(), Failure> {
        Ok(GrainsSimulation::check(self)?)
    }

    fn sweeps(&self, run: &GrainsSimulation) -> Option<usize> {
        let sweeps = run.last_step().iterations.sweeps;
        (self.method == ContactMethod::ContactDynamics).then_some(sweeps)
    }

    fn state(run: &GrainsSimulation) -> String {
        format!("step {:7}  time {:9.4}", run.steps(), run.time())
    }

    fn outcome(run: &GrainsSimulation) -> GrainsSummary {
        run.outcome()
    }

    fn told(outcome: &GrainsSummary) -> String {
        format!(
            "solid fraction {} after {} steps, {:.1} s",
            shown(outcome.end.solid_fraction),
            outcome.steps,
            outcome.wall_seconds
        )
    }

    fn report(&self, outcome: &GrainsSummary) -> String {
        let ending = match outcome.ending {
            Some(GrainsStopReason::Rest) => "at rest",
            Some(GrainsStopReason::Time) => "duration over",
            _ => "steps done",
        };
        let mut text = format!(
            "ending        {ending}: time {} s, {} steps, {} sweeps; it took {:.1} s\n\
             grains        {}, {} kg, {} contacts, {:.2} a grain\n\
             height        {} m, solid fraction {}\n\
             forces        floor {} N, plate {} N, side x {} N\n\
             stresses      zz {} Pa, shear at the plate {} Pa\n",
            shown(outcome.time),
            outcome.steps,
            outcome.iterations_total,
            outcome.wall_seconds,
            outcome.grains,
            shown(outcome.mass),
            outcome.contacts,
            outcome.statistics.mean_coordination,
            shown(outcome.end.height),
            shown(outcome.end.solid_fraction),
            shown(outcome.end.floor_force),
            shown(outcome.end.plate_force),
            shown(outcome.end.side_force_x),
            shown(outcome.end.stress_zz),
            shown(outcome.end.shear_stress),
        );
        if outcome.steps_unmet > 0 {
            text += &format!(
                "unmet         {} steps missed the solver's tolerance; their forces and energies are approximate, overlaps \
                 reach {} m\n",
                outcome.steps_unmet,
                shown(outcome.max_overlap)
            );
        }
        text + &budget(&outcome.energy, &outcome.dissipation, " J")
    }

    fn series(run: &GrainsSimulation) -> Series<'_> {
        series(COLUMNS, run.series())
    }

    fn write(
        &self,
        run: &GrainsSimulation,
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        let start = GrainsSimulation::new(run.scene())?;
        start.with_snapshot(|first| {
            run.with_snapshot(|last| states(first, last, (folder, order)))
        })?;
        folder.write(STATE, run.state().as_bytes())?;

        order.interrupted()?;
        folder.check()?;
        order.draw("packing", || {
            picture::packing(&start, run).map_err(Failure::run)
        })?;
        folder.check()?;
        order.draw("series", || Ok(picture::series(run)))
    }

    fn explanation(&self) -> Result<String, Failure> {
        explain::grains::text(self)
    }

    fn account(&self, summary: &Value, command: &str) -> String {
        after::packing(summary, &self.material(), command)
    }
}
