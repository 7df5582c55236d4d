//! Writes what Siconos reads: W in blocks, M and H in triplets.

use super::super::ContactProblem;
use super::super::error::{Fault, FilePosition, LocatedFault};
use crate::problem::{ContactComponents, ContactThresholds, Friction, SparseMatrix};
use std::fmt::Write as _;

/// Text of a problem.
pub(in super::super) fn write(problem: &ContactProblem) -> Result<String, LocatedFault> {
    let (layout, laws) = (problem.layout(), problem.laws());
    check(layout, laws)?;
    let mut text = format!("{}\n{}\n", layout.size(), laws.len());
    match problem {
        ContactProblem::Reduced(reduced) => {
            blocks(&mut text, reduced.w(), layout.size());
            numbers(&mut text, reduced.q().iter().copied());
        }
        ContactProblem::Global(global) => {
            triplets(&mut text, global.m());
            triplets(&mut text, global.h());
            numbers(&mut text, global.f().iter().copied());
            numbers(&mut text, global.w().iter().copied());
        }
    }
    numbers(&mut text, laws.iter().map(|law| law.sliding));
    if !layout.rolling().is_empty() {
        numbers(&mut text, laws.iter().map(|law| law.rolling));
    }
    Ok(text)
}

/// Refuses what the format has no place for.
fn check(layout: ContactComponents, laws: &[ContactThresholds]) -> Result<(), LocatedFault> {
    if !layout.torsion().is_empty() {
        return Err((FilePosition::File, Fault::Layout(layout.size())));
    }
    for (contact, law) in laws.iter().enumerate() {
        let absent = [
            ("the torsion threshold", law.torsion != 0.0),
            ("the cohesion", law.cohesion != 0.0),
            ("the ellipsoid", law.friction == Friction::Ellipsoid),
            (
                "the rolling threshold",
                layout.rolling().is_empty() && law.rolling != 0.0,
            ),
        ];
        if let Some((what, _)) = absent.into_iter().find(|(_, needed)| *needed) {
            return Err((FilePosition::File, Fault::NoPlace { what, contact }));
        }
    }
    Ok(())
}

/// Adds numbers and an end of the line. Writing to a string cannot fail.
fn numbers(text: &mut String, numbers: impl Iterator<Item = f64>) {
    for number in numbers {
        let _ = write!(text, "{number:e} ");
    }
    text.push('\n');
}

fn counts(text: &mut String, counts: impl Iterator<Item = usize>) {
    for count in counts {
        let _ = write!(text, "{count}\t");
    }
    text.push('\n');
}

/// W in blocks of a contact each; those on the diagonal are always there.
fn blocks(text: &mut String, w: &SparseMatrix, size: usize) {
    let contacts = w.rows() / size;
    let _ = write!(text, "1\n{0}\n{0}\n", w.rows());
    let rows: Vec<Vec<usize>> = (0..contacts)
        .map(|contact| columns(w, size, contact))
        .collect();
    let count: usize = rows.iter().map(Vec::len).sum();
    let _ = writeln!(text, "{count}");
    if count == 0 {
        return;
    }
    let _ = write!(text, "{contacts}\n{contacts}\n");
    counts(text, (1..=contacts).map(|contact| size * contact));
    counts(text, (1..=contacts).map(|contact| size * contact));
    let _ = write!(text, "{}\n{count}\n", contacts + 1);
    let mut start = 0;
    let ends = rows.iter().map(|row| {
        start += row.len();
        start
    });
    counts(text, std::iter::once(0).chain(ends));
    counts(text, rows.iter().flatten().copied());
    let mut number = 0;
    for (contact, row) in rows.iter().enumerate() {
        for &column in row {
            let _ = writeln!(text, "{number}");
            number += 1;
            block(text, w, size, [contact, column]);
        }
    }
}

/// Contacts whose impulses act at a contact, itself among them, rising.
fn columns(w: &SparseMatrix, size: usize, contact: usize) -> Vec<usize> {
    let rows = size * contact..size * (contact + 1);
    let entries = rows.flat_map(|row| w.row(row));
    let mut columns: Vec<usize> = entries.map(|&(column, _)| column / size).collect();
    columns.push(contact);
    columns.sort_unstable();
    columns.dedup();
    columns
}

/// A block column by column.
fn block(text: &mut String, w: &SparseMatrix, size: usize, [above, left]: [usize; 2]) {
    for column in size * left..size * (left + 1) {
        for row in size * above..size * (above + 1) {
            let row = w.row(row);
            let value = row
                .binary_search_by_key(&column, |entry| entry.0)
                .map_or(0.0, |at| row[at].1);
            let _ = writeln!(text, "{value:e}");
        }
    }
}

/// A matrix as CSparse prints triplets; Siconos skips the first line and reads the sizes in the second.
fn triplets(text: &mut String, matrix: &SparseMatrix) {
    let (rows, columns, stored) = (matrix.rows(), matrix.columns(), matrix.stored());
    let _ = write!(text, "2\n{rows}\n{columns}\n1\n");
    text.push_str(
        "CSparse Version 3.2.0, Sept 12, 2017.  Copyright (c) Timothy A. Davis, 2006-2016\n",
    );
    let _ = writeln!(
        text,
        "triplet: {rows}-by-{columns}, nzmax: {stored} nnz: {stored}"
    );
    for (row, column, value) in matrix.triplets() {
        let _ = writeln!(text, "    {row} {column} : {value:e}");
    }
}
