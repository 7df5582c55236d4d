//! Bodies that slide, or hold and slip.

use super::request::RunRequest;
use super::{files, path};
use crate::command::bodies::motion::MotionBody;
use crate::command::digits::shown;
use crate::command::explain::lines;
use crate::failure::Failure;
use serde_json::Value;
use tribos::motion::MotionRun;
use tribos::record::write_series;
use tribos::scene::{DiskScene, Scene, Units, vocabulary};
use tribos_report::figure::{Axis, Figure, ReferenceLine, Series};

/// Runs the scene and writes its results into the folder.
pub fn run(body: &MotionBody<'_>, order: &RunRequest<'_>) -> Result<(), Failure> {
    // A disk is at rest before anybody could interrupt it.
    if !matches!(body.any, Scene::Disk(_)) {
        order.caller.watch()?;
    }
    let mut meter = order.caller.meter();
    let holds = !body.scene.carried().is_empty();
    let doing = if holds {
        "holding and slipping"
    } else {
        "sliding"
    };
    let run = body.scene.follow(&mut |done| {
        if meter.is_due(done) {
            meter.tell(done, format_args!("{doing}"));
        }
        !order.caller.is_asked()
    })?;
    let summary = run.json(body.scene);
    let (stem, files, figure) = match body.any {
        Scene::Disk(scene) => ("motion", files::MOTION, disk(scene, &run, &summary)),
        _ if holds => ("motion", files::MOTION, columns(body, &run)),
        _ => ("path", files::PATH, path::figure(&summary, &run)),
    };
    let folder = order.begin(body.scene.json(), files)?;
    let rows = run.rows.iter().map(Vec::as_slice);
    write_series(&order.out.join("series.csv"), run.columns, rows)?;
    order.draw(stem, || Ok(figure))?;
    folder.seal(&["series.csv"])?;
    // Last: a summary stands only beside complete results.
    folder.write("summary.json", format!("{summary:#}\n").as_bytes())?;
    let mut told = run.told;
    if told.is_empty() {
        told = outcome(body, &summary);
    }
    told.push(("written to", order.out.display().to_string()));
    order.caller.report(&lines(&told))
}

/// The quantities of a summary that people are shown.
fn outcome(body: &MotionBody<'_>, summary: &Value) -> Vec<(&'static str, String)> {
    let ending = summary["ending"].as_str().unwrap_or_default();
    let mut told = vec![(
        "ending",
        format!("{ending} after {} steps", summary["steps"]),
    )];
    if let Some(time) = summary["tipped_at"].as_f64() {
        told.push((
            "tips",
            format!("held at the limit of its lean from {} s on", shown(time)),
        ));
    }
    told.extend(
        body.shown_quantities()
            .map(|(label, quantity)| (label, quantity.text(summary, shown))),
    );
    let error = summary["energy_error"].as_f64().unwrap_or(f64::NAN);
    told.push(("energy error", format!("{error:.1e} of the initial energy")));
    told
}

/// The columns that tell the motion of a body that holds, over the time.
fn columns(body: &MotionBody<'_>, run: &MotionRun) -> Figure {
    let title = vocabulary(body.scene.body()).map_or("", |known| known.title);
    let (names, label) = run.drawn;
    let figure = Figure::new(title, Axis::linear("time [s]"), Axis::linear(label));
    names.iter().fold(figure, |figure, name| {
        let column = run.columns.iter().position(|known| known == name);
        let points = column.map_or(Vec::new(), |column| {
            run.rows.iter().map(|row| (row[0], row[column])).collect()
        });
        let shown = if names.len() > 1 { *name } else { "" };
        figure.series(Series::line(shown, points))
    })
}

/// Sliding and rim speed of a disk over time.
fn disk(scene: &DiskScene, run: &MotionRun, summary: &Value) -> Figure {
    let unit = match scene.units {
        Units::Si => [" [s]", " [m/s]"],
        Units::Dimensionless => ["", " [√(gR)]"],
    };
    let curve = |value: &dyn Fn(&[f64]) -> f64| {
        let points = run.rows.iter().map(|row| (row[0], value(row)));
        points.collect::<Vec<_>>()
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
    match summary["stop_time"].as_f64() {
        Some(time) => figure.guide(ReferenceLine::vertical(time, "rest")),
        None => figure,
    }
}
