//! A result over the keys of a sweep.

use super::grid::Grid;
use super::table::Table;
use crate::failure::Failure;
use std::path::Path;
use tribos::scene::Key;
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;
use tribos_report::surface::Surface;

/// Draws a surface over two keys with several numbers each, or `as_lines` over the first one for each number of the
/// second; a line over one key, or over another column; nothing if there are more of them, or keys with several words, and
/// says so.
pub fn write(
    (grid, keys): (&Grid, &[Key]),
    table: &Table,
    as_lines: bool,
    out: &Path,
) -> Result<(), Failure> {
    let several = |at: &usize| grid.keys[*at].values.len() > 1;
    let varied: Vec<usize> = (0..grid.keys.len()).filter(several).collect();
    let (kind, title) = (table.kind(), table.kind().title.as_str());
    let label = kind.axis(kind.drawn);
    let drawn = |combination| table.drawn(kind.drawn, combination);
    if let Some(over) = kind.over {
        let xs: Vec<f64> = (0..grid.len()).map(|at| table.drawn(over, at).0).collect();
        let figure = Figure::new(title, Axis::linear(kind.axis(over)), Axis::linear(label));
        return Ok(
            image::write_both(out, "sweep", &figure.series(line("", &xs, drawn))).map(drop)?,
        );
    }
    let numbers: Option<Vec<Vec<f64>>> = varied.iter().map(|&at| grid.keys[at].numbers()).collect();
    let name = |at: usize| {
        let name = &grid.keys[varied[at]].key;
        let unit = keys
            .iter()
            .find(|key| key.name == *name)
            .map(|key| key.unit);
        Axis::linear(match unit {
            None | Some("-") => name.clone(),
            Some(unit) => format!("{name} [{unit}]"),
        })
    };
    let figure = || Figure::new(title, name(0), Axis::linear(label.clone()));
    match numbers.as_deref() {
        Some([xs]) => {
            let figure = figure().series(line("", xs, drawn));
            image::write_both(out, "sweep", &figure)?;
        }
        Some([xs, ys]) if as_lines => {
            let second = &grid.keys[varied[1]];
            let curves = second.values.iter().enumerate().map(|(j, value)| {
                let label = format!("{} = {value}", second.key);
                line(&label, xs, |i| drawn(i * ys.len() + j))
            });
            image::write_both(out, "sweep", &curves.fold(figure(), Figure::series))?;
        }
        Some([xs, ys]) => {
            // Combinations count the second key first.
            let at = |i: usize, j: usize| drawn(i * ys.len() + j);
            let axes = [name(0), name(1), Axis::linear(label.clone())];
            let surface =
                Surface::new(title, axes, [xs, ys], |i, j| at(i, j).0).errors(|i, j| at(i, j).1);
            image::write_both(out, "sweep", &surface)?;
        }
        _ if as_lines => crate::command::note(format_args!(
            "no picture is drawn: it needs one or two keys with several numbers; --plot COLUMN:OVER draws any keys over a column"
        )),
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
