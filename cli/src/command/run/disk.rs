//! Disks on a straight path.

use super::files;
use super::request::RunRequest;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::record::write_series;
use tribos::scene::{DiskScene, Units};
use tribos::slide::{self, COLUMNS, SlideRun};
use tribos_report::figure::{Axis, Figure, ReferenceLine, Series};

/// Runs the scene and writes its results into the folder.
pub fn run(scene: &DiskScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    let mut meter = order.caller.meter();
    let result = slide::run(scene, |done| {
        if meter.is_due(done) {
            meter.tell(done, format_args!("sliding"));
        }
    })?;
    let folder = order.begin(scene.json(), files::DISK)?;
    let rows = result.series.iter().map(<[f64; COLUMNS.len()]>::as_slice);
    write_series(&order.out.join("series.csv"), &COLUMNS, rows)?;
    order.draw("motion", || Ok(figure(scene, &result)))?;
    folder.seal(&["series.csv"])?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", result.outcome.json(scene));
    folder.write("summary.json", summary.as_bytes())?;
    report(scene, &result, order)
}

/// A few lines for the person at the terminal.
fn report(scene: &DiskScene, result: &SlideRun, order: &RunRequest<'_>) -> Result<(), Failure> {
    let outcome = &result.outcome;
    let (s, m) = match scene.units {
        Units::Si => (" s", " m"),
        Units::Dimensionless => ("", ""),
    };
    order.caller.report(&format!(
        "ending        {:?} after {} steps\n\
         time          {}{s}\n\
         distance      {}{m}\n\
         angle         {} rad\n\
         final ratio   {}\n\
         energy error  {:.1e} of the initial energy\n\
         written to    {}\n",
        outcome.ending,
        outcome.steps,
        shown(outcome.time),
        shown(outcome.distance),
        shown(outcome.angle),
        shown(outcome.ratio),
        outcome.energy_error,
        order.out.display()
    ))
}

/// Sliding and rim speed over time.
fn figure(scene: &DiskScene, result: &SlideRun) -> Figure {
    let unit = match scene.units {
        Units::Si => [" [s]", " [m/s]"],
        Units::Dimensionless => ["", " [√(gR)]"],
    };
    let curve = |value: &dyn Fn(&[f64; COLUMNS.len()]) -> f64| {
        result
            .series
            .iter()
            .map(|row| (row[0], value(row)))
            .collect::<Vec<_>>()
    };
    let figure = Figure::new(
        match scene.law {
            Some(law) => format!("Sliding and spinning to rest, {law}"),
            None => format!("Sliding and spinning to rest, α = {}", scene.alpha),
        },
        Axis::linear(format!("time{}", unit[0])),
        Axis::linear(format!("speed{}", unit[1])),
    )
    .series(Series::line("sliding, v", curve(&|row| row[1])))
    .series(Series::line(
        "rim, |ω|R",
        curve(&|row| (row[2] * scene.radius).abs()),
    ));
    match result.outcome.ending {
        slide::SlideStopReason::Rest => {
            figure.guide(ReferenceLine::vertical(result.outcome.time, "rest"))
        }
        _ => figure,
    }
}
