//! Grains in a box.

use super::kind::{RunKind, first};
use super::long::{LongBody, Series, series};
use crate::command::digits::{shown, with_error};
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::packing::{budget, states};
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use tribos::grains::{
    COLUMNS, GrainsLine, GrainsSimulation, GrainsStopReason, GrainsSummary, size,
};
use tribos::powder::STATE;
use tribos::results::{Summary, SweepView, averaged, swept};
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::{ContactMethod, Container, EndBoundary, GrainsScene};
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
        "stress_ratio",
        "inertial_number",
        "flow_rate",
        "flow_left",
    ];
    const KEEPS_SERIES: bool = true;

    /// Means over time in place of the last instant; people are shown those of the loads that there are.
    fn kind(&self) -> RunKind {
        let mut quantities = averaged(swept(GrainsSummary::QUANTITIES), GrainsLine::QUANTITIES);
        for quantity in &mut quantities {
            if quantity.column == "flow_rate" {
                quantity.error = Some(vec!["flow", "error"]);
            }
            quantity.label = quantity.label.filter(|_| has(self, quantity.column));
        }
        RunKind::of(first(Self::FIRST, quantities), self.sweep_view())
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "solid_fraction",
            title: "Solid fraction, mean over time",
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
        text += &means(self, outcome);
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

/// Columns that a run tells as means over time, with their labels and units.
/// Share of the mass that a hopper keeps from which on it is told.
const LEFT: f64 = 0.01;
const MEANS: [(&str, &str, &str); 4] = [
    ("solid_fraction", "solid fraction", ""),
    ("floor_force", "floor", " N"),
    ("stress_ratio", "stress ratio", ""),
    ("inertial_number", "inertial number", ""),
];

/// Whether a column says something of this scene.
fn has(scene: &GrainsScene, column: &str) -> bool {
    match column {
        "floor_force" => scene.boundary_z != EndBoundary::Periodic,
        "surface_angle" => {
            scene.boundary_z == EndBoundary::Floor && scene.container != Container::Hopper
        }
        "shear_stress" | "stress_ratio" | "inertial_number" => {
            scene.shear_rate.is_some() || scene.lid_speed_x.range() != [0.0; 2]
        }
        "flow_rate" | "flow_left" => scene.container == Container::Hopper,
        _ => true,
    }
}

/// Means over time, the slope of the surface and the flow out of a hopper.
fn means(scene: &GrainsScene, outcome: &GrainsSummary) -> String {
    let mean = |(column, label, unit): &(&str, &str, &str)| {
        let found = outcome
            .averages
            .get(column)
            .filter(|_| has(scene, column))?;
        let drifts = if found.settled { "" } else { " (not settled)" };
        let value = with_error(found.mean, found.error);
        let from = shown(found.from);
        Some(format!("{label} {value}{unit} from {from} s on{drifts}"))
    };
    let told: Vec<String> = MEANS.iter().filter_map(mean).collect();
    let mut text = format!("means         {}\n", told.join(",\n              "));
    let surface = outcome.surface_angle_error;
    if let Some(error) = surface.filter(|_| has(scene, "surface_angle")) {
        let angle = with_error(outcome.end.surface_angle, error);
        text += &format!("surface       falls by {angle} degrees\n");
    }
    if let Some(flow) = outcome.flow {
        text += &format!("discharged    {} kg", shown(outcome.end.discharged));
        if flow.rate > 0.0 {
            let rate = with_error(flow.rate, flow.error);
            let [from, until] = [flow.from, flow.until].map(shown);
            text += &format!(", {rate} kg/s from {from} to {until} s");
            if flow.error.is_nan() {
                text += "; a smaller `sample_every` gives the rate an error";
            }
        }
        text += "\n";
        let share = flow.left / outcome.mass;
        if share > LEFT {
            let [left, last] = [flow.left, flow.last].map(shown);
            let percent = 100.0 * share;
            text += &format!(
                "left          {left} kg, {percent:.0} %; the last flowed out at {last} s\n"
            );
        }
    }
    text
}
