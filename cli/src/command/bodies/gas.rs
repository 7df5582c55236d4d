//! Granular gases.

use super::long::{LongBody, Series, series};
use crate::command::digits::shown;
use crate::command::explain::{self, after};
use crate::command::run::files;
use crate::command::run::long::{Export, write_state};
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use tribos::gas::{COLUMNS, GasSimulation, GasStopReason, GasSummary, size};
use tribos::record::{extended_xyz, particles_vtp};
use tribos::results::SweepView;
use tribos::run::RunSize;
use tribos::run::folder::OutputFolder;
use tribos::scene::GasScene;
use tribos_report::runs::gas as picture;

/// Endings of the names of the last state's files, and what they hold.
const EXPORTS: [(&str, Export); 2] = [(".xyz", extended_xyz), (".vtp", particles_vtp)];

impl LongBody for GasScene {
    type Run = GasSimulation;
    type Summary = GasSummary;

    const SPHERES: &'static str = "spheres";
    const FILES: &'static [&'static str] = files::GAS;

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "temperature",
            title: "Temperature at the end",
            share: ["collapsed", "/ending", "collapse"],
        }
    }

    fn size(&self) -> RunSize {
        size(self)
    }

    fn state(run: &GasSimulation) -> String {
        let (collisions, time) = (run.collisions(), run.time());
        format!("{collisions:9.3} collisions a sphere  time {time:9.3}")
    }

    fn outcome(run: &GasSimulation) -> GasSummary {
        run.outcome()
    }

    fn told(outcome: &GasSummary) -> String {
        format!(
            "temperature {} after {} collisions a sphere, {:.1} s",
            shown(outcome.temperature),
            shown(outcome.collisions),
            outcome.wall_seconds
        )
    }

    fn report(&self, outcome: &GasSummary) -> String {
        let ending = match outcome.ending {
            Some(GasStopReason::Time) => "duration over",
            Some(GasStopReason::Collapse) => {
                "inelastic collapse: time stands still while collisions go on; set contact_time, such as 1e-4"
            }
            Some(GasStopReason::Rest) => "no sphere will meet another one",
            _ => "collisions done",
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
        let before = shown(outcome.density_variance_initial);
        let after = shown(outcome.density_variance_final);
        text += &format!("clusters      variance over mean of counts {after} from {before}\n");
        if outcome.collisions_cured > 0 {
            text += &format!(
                "contact time  {} collisions lost no energy\n",
                outcome.collisions_cured
            );
        }
        if outcome.steps_unmet > 0 {
            text += &format!(
                "unmet         {} steps missed the tolerance of their impacts\n",
                outcome.steps_unmet
            );
        }
        text
    }

    fn series(run: &GasSimulation) -> Series<'_> {
        series(COLUMNS, run.series())
    }

    fn write(
        &self,
        run: &GasSimulation,
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure> {
        run.with_snapshot(|last| write_state(last, ("final", &EXPORTS), folder, order))??;
        order.interrupted()?;
        folder.check()?;
        order.draw("spheres", || picture::spheres(run).map_err(Failure::run))?;
        order.draw("series", || Ok(picture::series(run)))
    }

    fn explanation(&self) -> Result<String, Failure> {
        explain::gas::text(self)
    }

    fn account(&self, summary: &Value, _: &str) -> String {
        after::gas(summary)
    }
}
