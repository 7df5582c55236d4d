//! Sparse matrices as CSparse prints them.

use super::super::error::LocatedFault;
use super::words::TokenReader;

/// An entry: row, column, value.
pub(super) type Triplet = (usize, usize, f64);

/// A kind of storage, its title, then entries.
pub(super) fn read(
    words: &mut TokenReader,
    shape: [usize; 2],
) -> Result<Vec<Triplet>, LocatedFault> {
    // 1: triplets, 2: columns, 3: rows; the title says it too.
    words.count("the origin of a sparse matrix (1 to 4)", 4)?;
    words.exactly("CSparse")?;
    words.skip_line();
    let title = words.word("the sizes of a sparse matrix")?;
    match title {
        "triplet:" => {
            let sizes = words.word("the sizes of a sparse matrix")?;
            let count = entries(words, sizes, shape)?;
            triplets(words, count)
        }
        "csr:" => {
            let sizes = words.word("the sizes of a sparse matrix")?;
            let count = entries(words, sizes, shape)?;
            words.exactly("1-norm:")?;
            words.word("a norm")?;
            let rows = lines(words, "row", shape[0], count)?;
            Ok(rows)
        }
        sizes => {
            let count = entries(words, sizes, shape)?;
            words.exactly("1-norm:")?;
            words.word("a norm")?;
            let columns = lines(words, "col", shape[1], count)?;
            Ok(columns.into_iter().map(|(j, i, v)| (i, j, v)).collect())
        }
    }
}

/// Number of entries, after sizes as in `3-by-4,`.
fn entries(
    words: &mut TokenReader,
    sizes: &str,
    [rows, columns]: [usize; 2],
) -> Result<usize, LocatedFault> {
    let wanted = format!("{rows}-by-{columns},");
    if sizes != wanted {
        return Err(words.wrong_word(sizes, &wanted));
    }
    words.exactly("nzmax:")?;
    words.word("the room for entries")?;
    words.exactly("nnz:")?;
    let what = "the number of entries";
    let word = words.word(what)?;
    let most = words.room() as i128;
    let count = words.integer_of(word.trim_end_matches(','), what, [0, most])?;
    Ok(count as usize)
}

/// Lines of `row column : value`.
fn triplets(words: &mut TokenReader, count: usize) -> Result<Vec<Triplet>, LocatedFault> {
    let mut triplets = Vec::with_capacity(count);
    for _ in 0..count {
        let row = words.count("the row of an entry", usize::MAX)?;
        let column = words.count("the column of an entry", usize::MAX)?;
        words.exactly(":")?;
        triplets.push((row, column, words.number("an entry")?));
    }
    Ok(triplets)
}

/// Rows or columns, as in `col 2 : locations 4 to 5` and two lines of `index : value`.
fn lines(
    words: &mut TokenReader,
    name: &str,
    number: usize,
    count: usize,
) -> Result<Vec<Triplet>, LocatedFault> {
    let mut triplets = Vec::with_capacity(count);
    for line in 0..number {
        words.exactly(name)?;
        words.same("the number of a row or column", line)?;
        words.exactly(":")?;
        words.exactly("locations")?;
        let first = triplets.len() as i128;
        words.integer("the first location", [first; 2])?;
        words.exactly("to")?;
        let last = words.integer("the last location", [first - 1, count as i128 - 1])?;
        for _ in first..=last {
            let index = words.count("the index of an entry", usize::MAX)?;
            words.exactly(":")?;
            triplets.push((line, index, words.number("an entry")?));
        }
    }
    if triplets.len() != count {
        return Err(words.wrong_count(
            "the number of entries",
            triplets.len() as i128,
            count.to_string(),
        ));
    }
    Ok(triplets)
}
