//! Grains in a box.

use super::kind::{ListedQuantity, RunKind, listed};
use super::long::{LongBody, RunResults};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::packing::{budget, states};
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use tribos::grains::{COLUMNS, GrainsSimulation, GrainsStopReason, GrainsSummary, size};
use tribos::powder::STATE;
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{ContactMethod, GrainsScene};
use tribos_report::runs::grains as picture;

/// Grains.
const QUANTITIES: &[ListedQuantity] = &[
    ("solid_fraction", "solid_fraction", "solid fraction", "-"),
    ("height", "height", "", "-"),
    ("coordination", "coordination", "contacts a grain", "-"),
    ("floor_force", "floor_force", "floor force", "N"),
    ("plate_stress", "plate_stress", "", "-"),
    ("shear_stress", "shear_stress", "shear stress", "Pa"),
    ("stress_xx", "stress_xx", "", "-"),
    ("stress_zz", "stress_zz", "", "-"),
    ("stress_xz", "stress_xz", "", "-"),
    ("surface_angle", "surface_angle", "angle", "deg"),
    ("time", "time", "", "-"),
    ("steps", "steps", "", "-"),
    ("iterations_total", "iterations_total", "", "-"),
    ("dissipation_normal", "dissipation.normal", "", "-"),
    ("dissipation_sliding", "dissipation.sliding", "", "-"),
    ("dissipation_rolling", "dissipation.rolling", "", "-"),
    ("dissipation_torsion", "dissipation.torsion", "", "-"),
];

impl LongBody for GrainsScene {
    type Run = GrainsSimulation;

    const SPHERES: &'static str = "grains";
    const FILES: &'static [&'static str] = files::POWDER;

    fn kind() -> RunKind {
        RunKind::of(
            listed(QUANTITIES),
            ["Final solid fraction", "solid_fraction"],
            ["rest", "/ending", "rest"],
        )
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

    fn results<'a>(&self, run: &'a GrainsSimulation) -> RunResults<'a> {
        let summary = run.outcome();
        RunResults {
            summary: summary.json(self),
            told: format!(
                "solid fraction {} after {} steps, {:.1} s",
                shown(summary.column("solid_fraction").unwrap_or(f64::NAN)),
                summary.steps,
                summary.wall_seconds
            ),
            report: report(&summary),
            columns: &COLUMNS,
            rows: run.series().iter().map(|row| &row[..]).collect(),
        }
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

/// A few lines for the person at the terminal.
fn report(outcome: &GrainsSummary) -> String {
    let ending = match outcome.ending {
        Some(GrainsStopReason::Rest) => "at rest",
        Some(GrainsStopReason::Time) => "duration over",
        _ => "steps done",
    };
    let column = |name: &str| shown(outcome.column(name).unwrap_or(f64::NAN));
    let mut text = format!(
        "ending        {ending}: time {} s, {} steps, {} sweeps; it took {:.1} s\n\
         grains        {}, {} kg, {} contacts, {:.2} a grain\n\
         height        {} m, solid fraction {}\n\
         forces        floor {} N, plate {} N, side x {} N\n\
         stresses      zz {} Pa, shear at the plate {} Pa\n",
        shown(outcome.time),
        outcome.steps,
        outcome.iterations,
        outcome.wall_seconds,
        outcome.grains,
        shown(outcome.mass),
        outcome.statistics.contacts,
        outcome.statistics.mean_coordination(),
        column("height"),
        column("solid_fraction"),
        column("floor_force"),
        column("plate_force"),
        column("side_force_x"),
        column("stress_zz"),
        column("shear_stress"),
    );
    if outcome.unmet > 0 {
        text += &format!(
            "unmet         {} steps missed the solver's tolerance; their forces and energies are approximate, overlaps \
             reach {} m\n",
            outcome.unmet,
            shown(outcome.statistics.max_overlap)
        );
    }
    text + &budget(&outcome.energy, &outcome.dissipation(), " J")
}
