//! Sparse matrices of FCLib.

use super::super::error::{Fault, LocatedFault};
use super::store::Store;
use crate::problem::SparseMatrix;
use hdf5_pure::GroupBuilder;

/// Values of nz that mean compressed columns and rows.
const COLUMNS: i64 = -1;
const ROWS: i64 = -2;

/// Reads a matrix whose shape the vectors have told.
pub(super) fn read(
    store: &Store,
    name: &str,
    shape: [usize; 2],
) -> Result<SparseMatrix, LocatedFault> {
    let part = |part: &str| format!("{name}/{part}");
    let sizes = [("m", "the number of rows"), ("n", "the number of columns")];
    for ((size, what), wanted) in sizes.into_iter().zip(shape) {
        let found = store.integer(&part(size))?;
        if found != wanted as i64 {
            return Err(store.wrong_count(&part(size), what, found, wanted));
        }
    }
    let nz = store.integer(&part("nz"))?;
    let values = store.numbers(&part("x"))?;
    let indices = store.integers(&part("i"))?;
    let pointers = store.integers(&part("p"))?;
    let [rows, columns] = shape.map(|size| size as i64);
    let triplets = match nz {
        0.. => {
            // There may be room for more entries than there are.
            for (part_name, found) in [
                ("i", indices.len()),
                ("p", pointers.len()),
                ("x", values.len()),
            ] {
                if (found as i64) < nz {
                    let wanted = format!("at least nz = {nz}");
                    return Err(store.wrong_count(
                        &part(part_name),
                        "the number of elements",
                        found,
                        wanted,
                    ));
                }
            }
            let rows = checked(store, &part("i"), &indices[..nz as usize], rows)?;
            let columns = checked(store, &part("p"), &pointers[..nz as usize], columns)?;
            let places = rows.into_iter().zip(columns);
            places
                .zip(values)
                .map(|((row, column), value)| (row, column, value))
                .collect()
        }
        COLUMNS => lines(store, name, [columns, rows], [&pointers, &indices], &values)?
            .into_iter()
            .map(|(column, row, value)| (row, column, value))
            .collect(),
        ROWS => lines(store, name, [rows, columns], [&pointers, &indices], &values)?,
        _ => {
            let wanted = "a number of triplets, −1 (columns) or −2 (rows)";
            return Err(store.wrong_count(&part("nz"), "nz", nz, wanted));
        }
    };
    SparseMatrix::from_triplets(shape, &triplets)
        .map_err(|error| (store.place(&part("x")), Fault::Problem(error)))
}

/// Indices below a size.
fn checked(
    store: &Store,
    name: &str,
    indices: &[i64],
    size: i64,
) -> Result<Vec<usize>, LocatedFault> {
    let index = |&index: &i64| {
        if (0..size).contains(&index) {
            return Ok(index as usize);
        }
        Err(store.wrong_count(name, "an index", index, format!("from 0 to below {size}")))
    };
    indices.iter().map(index).collect()
}

/// Entries (line, index, value) of compressed lines: starts of the lines, and the index of each entry.
fn lines(
    store: &Store,
    name: &str,
    [number, size]: [i64; 2],
    [starts, indices]: [&[i64]; 2],
    values: &[f64],
) -> Result<Vec<(usize, usize, f64)>, LocatedFault> {
    let [p, i, x] = ["p", "i", "x"].map(|part| format!("{name}/{part}"));
    if starts.len() as i64 != number + 1 {
        return Err(store.wrong_count(&p, "the number of elements", starts.len(), number + 1));
    }
    let count = starts.last().copied().unwrap_or(0);
    let rising = starts.first() == Some(&0) && starts.windows(2).all(|pair| pair[0] <= pair[1]);
    if !rising {
        return Err((
            store.place(&p),
            Fault::Unsupported("the starts of lines must rise from 0"),
        ));
    }
    for (part, found) in [(&i, indices.len()), (&x, values.len())] {
        if (found as i64) < count {
            let wanted = format!("at least {count}, the last element of p");
            return Err(store.wrong_count(part, "the number of elements", found, wanted));
        }
    }
    let indices = checked(store, &i, &indices[..count as usize], size)?;
    let mut triplets = Vec::with_capacity(indices.len());
    for (line, pair) in starts.windows(2).enumerate() {
        for at in pair[0] as usize..pair[1] as usize {
            triplets.push((line, indices[at], values[at]));
        }
    }
    Ok(triplets)
}

/// Adds a matrix in triplets to a group; `None` if a size exceeds the integers of FCLib.
pub(super) fn write(group: &mut GroupBuilder, name: &str, matrix: &SparseMatrix) -> Option<()> {
    let integer = |size: usize| i32::try_from(size).ok();
    let sizes = [
        ("m", integer(matrix.rows())?),
        ("n", integer(matrix.columns())?),
        ("nz", integer(matrix.stored())?),
        ("nzmax", integer(matrix.stored())?),
    ];
    let mut part = group.create_group(name);
    for (size, number) in sizes {
        part.create_dataset(size).with_i32_data(&[number]);
    }
    // Below the sizes, which fit.
    let rows: Vec<i32> = matrix.triplets().map(|(row, _, _)| row as i32).collect();
    let columns: Vec<i32> = matrix
        .triplets()
        .map(|(_, column, _)| column as i32)
        .collect();
    let values: Vec<f64> = matrix.triplets().map(|(_, _, value)| value).collect();
    part.create_dataset("i").with_i32_data(&rows);
    part.create_dataset("p").with_i32_data(&columns);
    part.create_dataset("x").with_f64_data(&values);
    group.add_group(part.finish());
    Some(())
}
