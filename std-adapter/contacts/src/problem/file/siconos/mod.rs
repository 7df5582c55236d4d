//! Text of Siconos: dimension, number of contacts, matrices, vectors, coefficients.

mod compressed;
mod matrix;
mod words;
mod write;

pub(super) use write::write;

use super::ContactProblem;
use super::error::{Fault, FilePosition, LocatedFault};
use crate::problem::{
    ContactComponents, ContactThresholds, GlobalProblem, ProblemError, ReducedProblem, SparseMatrix,
};
use words::TokenReader;

/// What precedes the vectors in both kinds of problems.
struct Head {
    layout: ContactComponents,
    contacts: usize,
    first: SparseMatrix,
}

/// Reads a problem. The two kinds have different numbers of words for the same first matrix, so that at most one of
/// the readings ends with the file; if both fail, the one that got further tells what is wrong.
pub(super) fn read(text: &str) -> Result<ContactProblem, LocatedFault> {
    let mut words = TokenReader::new(text);
    let head = head(&mut words)?;
    let local = match reduced(&head, words.clone()) {
        Err(refusal) if matrix::may_follow(words.clone()) => refusal,
        other => return other,
    };
    global(&head, words).map_err(|global| match reached(&local) >= reached(&global) {
        true => local,
        false => global,
    })
}

/// The line that a reading reached; a refusal without one came after the last.
fn reached((place, _): &LocatedFault) -> usize {
    match place {
        FilePosition::Line(line) => *line,
        FilePosition::File | FilePosition::Dataset(_) => usize::MAX,
    }
}

fn head(words: &mut TokenReader) -> Result<Head, LocatedFault> {
    let size = words.count("the number of components of a contact", usize::MAX)?;
    let layout = match size {
        2 | 3 | 5 => ContactComponents::of_size(size),
        _ => None,
    };
    let Some(layout) = layout else {
        let what = "the number of components of a contact";
        return Err(words.wrong_count(what, size, "2, 3 or 5".to_string()));
    };
    let contacts = words.amount("the number of contacts")?;
    let first = matrix::read(words)?;
    Ok(Head {
        layout,
        contacts,
        first,
    })
}

/// W, then q and the coefficients.
fn reduced(head: &Head, mut words: TokenReader) -> Result<ContactProblem, LocatedFault> {
    let size = head.layout.size() * head.contacts;
    for (what, found) in [
        ("rows", head.first.rows()),
        ("columns", head.first.columns()),
    ] {
        if found != size {
            return Err(words.not_a_problem(ProblemError::Size {
                what: "W",
                of: what,
                found,
                wanted: size,
            }));
        }
    }
    let q = words.numbers("an element of q", size)?;
    let laws = laws(head, &mut words)?;
    let problem = ReducedProblem::new(head.layout, head.first.clone(), q, laws);
    problem
        .map(ContactProblem::Reduced)
        .map_err(|error| (FilePosition::File, Fault::Problem(error)))
}

/// M, then H, f, w and the coefficients.
fn global(head: &Head, mut words: TokenReader) -> Result<ContactProblem, LocatedFault> {
    let m = head.first.clone();
    let h = matrix::read(&mut words)?;
    let f = words.numbers("an element of f", m.rows())?;
    let w = words.numbers("an element of w", h.columns())?;
    let laws = laws(head, &mut words)?;
    GlobalProblem::new(head.layout, m, h, f, w, laws)
        .map(ContactProblem::Global)
        .map_err(|error| (FilePosition::File, Fault::Problem(error)))
}

/// Coefficients of all contacts, to the end of the file.
fn laws(head: &Head, words: &mut TokenReader) -> Result<Vec<ContactThresholds>, LocatedFault> {
    let sliding = words.numbers("a friction coefficient", head.contacts)?;
    let rolling = match head.layout.rolling().is_empty() {
        true => vec![0.0; head.contacts],
        false => words.numbers("a rolling threshold", head.contacts)?,
    };
    end(words)?;
    let laws = sliding.into_iter().zip(rolling);
    Ok(laws
        .map(|(sliding, rolling)| ContactThresholds {
            sliding,
            rolling,
            ..ContactThresholds::default()
        })
        .collect())
}

/// Nothing may follow but a flag that old versions of Siconos wrote.
fn end(words: &mut TokenReader) -> Result<(), LocatedFault> {
    let mut after = words.clone();
    if let Some("0" | "1") = after.next_word() {
        *words = after;
    }
    match words.next_word() {
        None => Ok(()),
        Some(word) => Err((words.place(), Fault::Beyond(words::shortened(word)))),
    }
}
