//! Matrices of Siconos: dense, in blocks, or as CSparse prints them.

use super::super::error::LocatedFault;
use super::compressed::{self, Triplet};
use super::words::TokenReader;
use crate::problem::SparseMatrix;

/// Ways of storage, by the number that precedes a matrix.
const DENSE: usize = 0;
const BLOCKS: usize = 1;
const COMPRESSED: usize = 2;

/// Whether the next words can begin a matrix: a way of storage and two sizes.
pub(super) fn may_follow(mut words: TokenReader) -> bool {
    words.count("", COMPRESSED).is_ok() && (0..2).all(|_| words.count("", usize::MAX).is_ok())
}

pub(super) fn read(words: &mut TokenReader) -> Result<SparseMatrix, LocatedFault> {
    let storage = words.count(
        "the storage of a matrix (0 dense, 1 blocks, 2 CSparse)",
        COMPRESSED,
    )?;
    // Vectors of the same sizes follow.
    let shape = [
        words.amount("the number of rows")?,
        words.amount("the number of columns")?,
    ];
    let triplets = match storage {
        DENSE => dense(words, shape)?,
        BLOCKS => blocks(words, shape)?,
        _ => compressed::read(words, shape)?,
    };
    SparseMatrix::from_triplets(shape, &triplets).map_err(|error| words.not_a_problem(error))
}

/// All elements, column by column as Siconos holds them (lines of the file break elsewhere).
fn dense(words: &mut TokenReader, shape: [usize; 2]) -> Result<Vec<Triplet>, LocatedFault> {
    words.same("the repeated number of rows", shape[0])?;
    words.same("the repeated number of columns", shape[1])?;
    let mut triplets = Vec::new();
    block(words, [0, 0], shape, &mut triplets)?;
    Ok(triplets)
}

/// Elements of a block column by column, without zeros.
fn block(
    words: &mut TokenReader,
    [row, column]: [usize; 2],
    [rows, columns]: [usize; 2],
    triplets: &mut Vec<Triplet>,
) -> Result<(), LocatedFault> {
    // A block without rows takes no words, but its columns must not take time either.
    if rows == 0 {
        return Ok(());
    }
    for j in 0..columns {
        for i in 0..rows {
            let value = words.number("an element of a matrix")?;
            if value != 0.0 {
                triplets.push((row + i, column + j, value));
            }
        }
    }
    Ok(())
}

/// Blocks by rows of blocks: ends of the rows and columns of blocks, first block of each row, column of each block,
/// then each block's number and elements.
fn blocks(words: &mut TokenReader, shape: [usize; 2]) -> Result<Vec<Triplet>, LocatedFault> {
    let count = words.amount("the number of blocks")?;
    let mut triplets = Vec::new();
    // Siconos writes nothing more.
    if count == 0 {
        return Ok(triplets);
    }
    let rows = words.amount("the number of rows of blocks")?;
    let columns = words.amount("the number of columns of blocks")?;
    let row_ends = ends(words, "the end of a row of blocks", rows, shape[0])?;
    let column_ends = ends(words, "the end of a column of blocks", columns, shape[1])?;
    let starts = words.count("the number of starts of rows of blocks", rows + 1)?;
    words.same("the number of columns of blocks that are stored", count)?;
    let starts = rising(words, "the first block of a row", starts, count)?;
    let places =
        (0..count).map(|_| words.integer("the column of a block", [0, columns as i128 - 1]));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    for (row, pair) in starts.windows(2).enumerate() {
        for (number, place) in places.iter().enumerate().take(pair[1]).skip(pair[0]) {
            words.same("the number of a block", number)?;
            let [top, height] = span(&row_ends, row);
            let [left, width] = span(&column_ends, *place as usize);
            block(words, [top, left], [height, width], &mut triplets)?;
        }
    }
    Ok(triplets)
}

/// Numbers that do not fall, none above `most`.
fn rising(
    words: &mut TokenReader,
    what: &str,
    count: usize,
    most: usize,
) -> Result<Vec<usize>, LocatedFault> {
    let mut last = 0;
    let mut numbers = Vec::with_capacity(count);
    for _ in 0..count {
        last = words.integer(what, [last, most as i128])?;
        numbers.push(last as usize);
    }
    Ok(numbers)
}

/// Ends of rows or columns of blocks, the last one that of the matrix.
fn ends(
    words: &mut TokenReader,
    what: &str,
    count: usize,
    size: usize,
) -> Result<Vec<usize>, LocatedFault> {
    let ends = rising(words, what, count, size)?;
    let last = ends.last().copied().unwrap_or(0);
    if last != size {
        return Err(words.wrong_count(what, last as i128, format!("{size} at last")));
    }
    Ok(ends)
}

/// First index and size of a row or column of blocks.
fn span(ends: &[usize], at: usize) -> [usize; 2] {
    let first = if at == 0 { 0 } else { ends[at - 1] };
    [first, ends[at] - first]
}
