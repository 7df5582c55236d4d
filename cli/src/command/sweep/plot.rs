//! A result over the keys of a sweep.

use super::grid::Grid;
use super::table::Table;
use crate::failure::Failure;
use std::path::Path;
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;
use tribos_report::surface::Surface;

/// Draws a surface over two keys with several numbers each, a line over one; nothing if there are
/// more of them, or keys with several words.
pub fn write(grid: &Grid, table: &Table, out: &Path) -> Result<(), Failure> {
    let several = |at: &usize| grid.keys[*at].values.len() > 1;
    let varied: Vec<usize> = (0..grid.keys.len()).filter(several).collect();
    let numbers: Option<Vec<Vec<f64>>> = varied.iter().map(|&at| grid.keys[at].numbers()).collect();
    let (title, label) = (table.kind().title, table.kind().axis());
    let name = |at: usize| Axis::linear(grid.keys[varied[at]].key.clone());
    match numbers.as_deref() {
        Some([xs]) => {
            let figure = line(name(0), xs, table);
            image::write_both(out, "sweep", &figure)?;
        }
        Some([xs, ys]) => {
            // Combinations count the second key first.
            let at = |i: usize, j: usize| table.drawn(i * ys.len() + j);
            let axes = [name(0), name(1), Axis::linear(label)];
            let surface =
                Surface::new(title, axes, [xs, ys], |i, j| at(i, j).0).errors(|i, j| at(i, j).1);
            image::write_both(out, "sweep", &surface)?;
        }
        _ => {}
    }
    Ok(())
}

/// The result with whiskers of one standard deviation.
fn line(axis: Axis, xs: &[f64], table: &Table) -> Figure {
    let mut points: Vec<(f64, (f64, f64))> = xs
        .iter()
        .enumerate()
        .map(|(index, &x)| (x, table.drawn(index)))
        .filter(|(_, (mean, _))| mean.is_finite())
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let means = points.iter().map(|(x, (mean, _))| (*x, *mean)).collect();
    let errors = points.iter().map(|(_, (_, error))| *error).collect();
    let (title, label) = (table.kind().title, table.kind().axis());
    Figure::new(title, axis, Axis::linear(label))
        .series(Series::line_points("", means).errors(errors))
}
