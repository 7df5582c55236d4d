//! Bodies that hold, let go and hold again.

use super::files;
use super::request::RunRequest;
use crate::command::explain::held::lines;
use crate::failure::Failure;
use tribos::record::write_series;
use tribos::scene::vocabulary;
use tribos::stick::{StickSlipRun, StickSlipScene};
use tribos_report::figure::{Axis, Figure, Series};

/// Runs the scene and writes its results into the folder.
pub fn run(scene: &dyn StickSlipScene, order: &RunRequest<'_>) -> Result<(), Failure> {
    order.caller.watch()?;
    let mut meter = order.caller.meter();
    let result = scene.follow(&mut |done| {
        if meter.is_due(done) {
            meter.tell(done, format_args!("holding and slipping"));
        }
        !order.caller.is_asked()
    })?;
    let folder = order.begin(scene.json(), files::HELD)?;
    let rows = result.rows.iter().map(Vec::as_slice);
    write_series(&order.out.join("series.csv"), result.columns, rows)?;
    order.draw("motion", || Ok(figure(scene, &result)))?;
    folder.seal(&["series.csv"])?;
    // Last: a summary stands only beside complete results.
    let summary = format!("{:#}\n", result.json(scene));
    folder.write("summary.json", summary.as_bytes())?;
    let written = ("written to", order.out.display().to_string());
    order
        .caller
        .report(&(lines(&result.told) + &lines(&[written])))
}

/// The columns that tell the motion, over the time.
fn figure(scene: &dyn StickSlipScene, result: &StickSlipRun) -> Figure {
    let title = vocabulary(scene.body()).map_or("", |known| known.title);
    let (names, label) = result.drawn;
    let figure = Figure::new(title, Axis::linear("time [s]"), Axis::linear(label));
    names.iter().fold(figure, |figure, name| {
        let column = result.columns.iter().position(|known| known == name);
        let points = column.map_or(Vec::new(), |column| {
            result
                .rows
                .iter()
                .map(|row| (row[0], row[column]))
                .collect()
        });
        let shown = if names.len() > 1 { *name } else { "" };
        figure.series(Series::line(shown, points))
    })
}
