//! Spheres in files of VTK: centres as points, the rest as arrays of points.

mod blocks;
mod legacy;
mod xml;

use super::found::{FoundSpheres, RowName};
use super::{Assembly, AssemblyError, Source};
use tribos_base::exchange::sphere_columns::SphereColumn::{self, X};
use tribos_base::exchange::spheres::Cell;

/// What is said of files without an array of radii.
const CURE: &str = "give the point data radius or diameter, or name it by --columns (key `columns`), such as radius=ARRAY or \
                    radius=all:0.5";

/// An array: its name, numbers a point, and all numbers.
struct Array {
    name: String,
    width: usize,
    numbers: Vec<f64>,
}

/// Points with their arrays.
#[derive(Default)]
struct Points {
    places: Vec<f64>,
    arrays: Vec<Array>,
}

/// The spheres of a file; several pieces are one packing.
pub(super) fn read(source: &Source<'_>, bytes: &[u8]) -> Result<Assembly, AssemblyError> {
    let refused = |reason: String| source.content(reason);
    let (pieces, cell) = match bytes.first() {
        Some(b'<') => xml::read(bytes, source.columns).map_err(refused)?,
        _ => (
            vec![legacy::read(bytes, source.columns).map_err(refused)?],
            None,
        ),
    };
    let mut found = FoundSpheres::new(RowName::Numbered("point"));
    for points in pieces {
        found.append(columns(source, points).map_err(refused)?);
    }
    found.cell = cell.unwrap_or(Cell {
        is_silent: true,
        ..Cell::default()
    });
    found.checked(source.name, source.columns, CURE)
}

/// Whether an array is read.
fn is_wanted(name: &str, chosen: Option<&super::PackingColumns>) -> bool {
    chosen.is_some() || SphereColumn::scalar(name).is_some() || SphereColumn::vector(name).is_some()
}

/// The arrays as columns, by their names or as the user says.
fn columns(source: &Source<'_>, points: Points) -> Result<FoundSpheres, String> {
    let mut found = FoundSpheres::new(RowName::Numbered("point"));
    found.set_vector(X as usize, &points.places);
    let count = points.places.len() / 3;
    let names: Vec<String> = points
        .arrays
        .iter()
        .map(|array| array.name.clone())
        .collect();
    let usual: Vec<Option<SphereColumn>> = names
        .iter()
        .map(|name| SphereColumn::scalar(name))
        .collect();
    let chosen = match source.columns {
        Some(columns) if columns.has_places() => {
            return Err(format!(
                "the arrays have names; give --columns (key `columns`) as NAME=ARRAY, not {columns}"
            ));
        }
        Some(columns) => columns.assign(&usual, &names, names.len())?,
        None => usual,
    };
    for (array, column) in points.arrays.into_iter().zip(chosen) {
        let first =
            SphereColumn::vector(&array.name).filter(|first| *first > 0 && array.width == 3);
        match (column, first) {
            (Some(column), _) if array.width == 1 && !found.has(column) => {
                found.set(column, array.numbers)
            }
            (_, Some(first)) => {
                if array.numbers.len() != 3 * count {
                    let (name, given) = (array.name, array.numbers.len() / 3);
                    return Err(format!(
                        "{count} points need as many values of {name}, not {given}"
                    ));
                }
                found.set_vector(first, &array.numbers);
            }
            _ => {}
        }
    }
    Ok(found)
}
