//! A result over the keys of a sweep.

use super::grid::Grid;
use super::table::Table;
use crate::failure::Failure;
use std::path::Path;
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;
use tribos_report::surface::Surface;

/// Draws a surface over two keys with several numbers each, or `as_lines` over the first one for each number of the
/// second; a line over one key; nothing if there are more of them, or keys with several words.
pub fn write(grid: &Grid, table: &Table, as_lines: bool, out: &Path) -> Result<(), Failure> {
    let several = |at: &usize| grid.keys[*at].values.len() > 1;
    let varied: Vec<usize> = (0..grid.keys.len()).filter(several).collect();
    let numbers: Option<Vec<Vec<f64>>> = varied.iter().map(|&at| grid.keys[at].numbers()).collect();
    let (title, label) = (table.kind().title.as_str(), table.kind().axis());
    let name = |at: usize| Axis::linear(grid.keys[varied[at]].key.clone());
    let figure = || Figure::new(title, name(0), Axis::linear(label.clone()));
    match numbers.as_deref() {
        Some([xs]) => {
            let figure = figure().series(line("", xs, |index| table.drawn(index)));
            image::write_both(out, "sweep", &figure)?;
        }
        Some([xs, ys]) if as_lines => {
            let second = &grid.keys[varied[1]];
            let curves = second.values.iter().enumerate().map(|(j, value)| {
                let label = format!("{} = {value}", second.key);
                line(&label, xs, |i| table.drawn(i * ys.len() + j))
            });
            image::write_both(out, "sweep", &curves.fold(figure(), Figure::series))?;
        }
        Some([xs, ys]) => {
            // Combinations count the second key first.
            let at = |i: usize, j: usize| table.drawn(i * ys.len() + j);
            let axes = [name(0), name(1), Axis::linear(label.clone())];
            let surface =
                Surface::new(title, axes, [xs, ys], |i, j| at(i, j).0).errors(|i, j| at(i, j).1);
            image::write_both(out, "sweep", &surface)?;
        }
        _ => {}
    }
    Ok(())
}

/// The result with its whiskers over the numbers of a key.
fn line(label: &str, xs: &[f64], drawn: impl Fn(usize) -> (f64, f64)) -> Series {
    let mut points: Vec<(f64, (f64, f64))> = xs
        .iter()
        .enumerate()
        .map(|(index, &x)| (x, drawn(index)))
        .filter(|(_, (mean, _))| mean.is_finite())
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let means = points.iter().map(|(x, (mean, _))| (*x, *mean)).collect();
    let errors = points.iter().map(|(_, (_, error))| *error).collect();
    Series::line_points(label, means).errors(errors)
}
