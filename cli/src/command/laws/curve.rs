//! Local laws drawn over speed.

use crate::failure::Failure;
use std::path::Path;
use tribos::friction::Law;
use tribos::record::series_csv;
use tribos_core::law::LocalLaw;
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;

/// Points a curve.
const POINTS: usize = 400;

/// Writes the curves in the format that the file's ending names.
pub fn write(path: &Path, laws: &[Law], [from, to]: [f64; 2]) -> Result<(), Failure> {
    if from >= to {
        return Err(Failure::input(format!(
            "--from {from} must be below --to {to}"
        )));
    }
    let speeds: Vec<f64> = (0..=POINTS)
        .map(|i| from * (to / from).powf(i as f64 / POINTS as f64))
        .collect();
    let mut rows: Vec<Vec<f64>> = speeds.iter().map(|&v| vec![v]).collect();
    let mut figure = Figure::new(
        "Friction of a surface element",
        Axis::log10("sliding speed [m/s]"),
        Axis::linear("friction per load"),
    );
    let names: Vec<String> = laws.iter().map(Law::to_string).collect();
    for (law, name) in laws.iter().zip(&names) {
        let law = law.build::<f64>()?;
        let friction: Vec<f64> = speeds.iter().map(|&v| law.friction(v)).collect();
        for (row, f) in rows.iter_mut().zip(&friction) {
            row.push(*f);
        }
        let points = speeds.iter().copied().zip(friction).collect();
        figure = figure.series(Series::line(name, points));
    }
    let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    let mut columns = vec!["speed"];
    columns.extend(quoted.iter().map(String::as_str));
    let csv = || series_csv(&columns, rows.iter().map(Vec::as_slice));
    Ok(image::write_as_named(path, &figure, csv)?)
}
