//! Tables of measures.

/// Columns of numbers for a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name of the file without its ending.
    pub name: &'static str,
    /// Names of the columns.
    pub columns: &'static [&'static str],
    /// Rows, each with a number for every column.
    pub rows: Vec<Vec<f64>>,
}
