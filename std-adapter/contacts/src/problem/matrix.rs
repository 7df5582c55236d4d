//! Sparse matrices, stored by rows.

/// A sparse matrix: for each row the columns of its entries, in rising order, and their values.
///
/// ```
/// use tribos::problem::SparseMatrix;
/// // Entries of the same place are added.
/// let matrix = SparseMatrix::from_triplets([2, 3], &[(0, 2, 5.0), (1, 0, 1.0), (0, 2, -2.0)])?;
/// assert_eq!(matrix.times(&[1.0, 10.0, 100.0]), [300.0, 1.0]);
/// assert_eq!(matrix.transposed().times(&[1.0, 2.0]), [2.0, 0.0, 3.0]);
/// # Ok::<(), tribos::problem::ProblemError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SparseMatrix {
    columns: usize,
    /// First entry of each row, and the number of entries.
    starts: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

use super::error::ProblemError;

impl SparseMatrix {
    /// A matrix of `shape` (rows, columns) from entries (row, column, value); entries of one place are added in
    /// the order given.
    ///
    /// # Errors
    /// [`ProblemError::OutOfRange`] if an entry is outside, [`ProblemError::NotFinite`] if a value or a sum is not finite.
    pub fn from_triplets(
        shape: [usize; 2],
        triplets: &[(usize, usize, f64)],
    ) -> Result<Self, ProblemError> {
        let [rows, columns] = shape;
        let mut starts = vec![0; rows + 1];
        for &(row, column, value) in triplets {
            if row >= rows || column >= columns {
                return Err(ProblemError::OutOfRange { row, column, shape });
            }
            if !value.is_finite() {
                return Err(ProblemError::NotFinite {
                    what: "an entry of a matrix",
                });
            }
            starts[row + 1] += 1;
        }
        for row in 0..rows {
            starts[row + 1] += starts[row];
        }
        let mut next = starts.clone();
        let mut entries = vec![(0, 0.0); triplets.len()];
        for &(row, column, value) in triplets {
            entries[next[row]] = (column, value);
            next[row] += 1;
        }
        let mut matrix = Self {
            columns,
            starts,
            entries,
        };
        matrix.merge();
        if !matrix.entries.iter().all(|entry| entry.1.is_finite()) {
            return Err(ProblemError::NotFinite {
                what: "a sum of entries of a matrix",
            });
        }
        Ok(matrix)
    }

    /// Sorts each row and adds entries of the same column.
    fn merge(&mut self) {
        let mut kept = 0;
        for row in 0..self.rows() {
            let range = self.starts[row]..self.starts[row + 1];
            self.entries[range.clone()].sort_by_key(|entry| entry.0);
            self.starts[row] = kept;
            for from in range {
                let (column, value) = self.entries[from];
                if kept > self.starts[row] && self.entries[kept - 1].0 == column {
                    self.entries[kept - 1].1 += value;
                } else {
                    self.entries[kept] = (column, value);
                    kept += 1;
                }
            }
        }
        let rows = self.rows();
        self.starts[rows] = kept;
        self.entries.truncate(kept);
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Number of columns.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of stored entries.
    #[must_use]
    pub fn stored(&self) -> usize {
        self.entries.len()
    }

    /// Entries (column, value) of a row, columns rising.
    ///
    /// # Panics
    /// If there is no such row.
    #[must_use]
    pub fn row(&self, row: usize) -> &[(usize, f64)] {
        &self.entries[self.starts[row]..self.starts[row + 1]]
    }

    /// All entries (row, column, value), by rows.
    pub fn triplets(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        (0..self.rows()).flat_map(move |row| {
            self.row(row)
                .iter()
                .map(move |&(column, v)| (row, column, v))
        })
    }

    /// The transposed matrix.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let mut starts = vec![0; self.columns + 1];
        for &(column, _) in &self.entries {
            starts[column + 1] += 1;
        }
        for column in 0..self.columns {
            starts[column + 1] += starts[column];
        }
        let mut next = starts.clone();
        let mut entries = vec![(0, 0.0); self.entries.len()];
        for (row, column, value) in self.triplets() {
            entries[next[column]] = (row, value);
            next[column] += 1;
        }
        Self {
            columns: self.rows(),
            starts,
            entries,
        }
    }

    /// Product with a vector of [`SparseMatrix::columns`] elements.
    ///
    /// # Panics
    /// If the vector is shorter.
    #[must_use]
    pub fn times(&self, vector: &[f64]) -> Vec<f64> {
        (0..self.rows())
            .map(|row| {
                self.row(row)
                    .iter()
                    .map(|&(column, v)| v * vector[column])
                    .sum()
            })
            .collect()
    }
}
