//! Tables of numbers as CSV.

use super::{AtomicFile, RecordError, number};
use std::path::Path;

/// CSV text with a header line and one line per row, each number in its shortest form that keeps the bits.
///
/// ```
/// use tribos::record::series_csv;
/// // A body that brakes evenly from 1 m/s to half of it.
/// let rows = [[0.0, 1.0], [2.0, 0.5]];
/// let text = series_csv(&["time", "speed"], rows.iter().map(|row| &row[..]));
/// assert_eq!(text.lines().next(), Some("time,speed"));
/// assert_eq!(text.lines().last(), Some("2.0,0.5"));
/// ```
pub fn series_csv<'a>(columns: &[&str], rows: impl IntoIterator<Item = &'a [f64]>) -> String {
    let mut text = columns.join(",");
    text.push('\n');
    for row in rows {
        let cells: Vec<String> = row.iter().map(|&value| number(value)).collect();
        text.push_str(&cells.join(","));
        text.push('\n');
    }
    text
}

/// Writes the file of [`series_csv`] row by row, completely or not at all.
///
/// ```
/// use tribos::record::{series_csv, write_series};
/// # let home = tempfile::tempdir()?;
/// # let file = home.path().join("series.csv");
/// let rows = [[0.0, 1.0], [2.0, 0.5]];
/// let rows = || rows.iter().map(|row| &row[..]);
/// write_series(&file, &["time", "speed"], rows())?;
/// assert_eq!(std::fs::read_to_string(&file)?, series_csv(&["time", "speed"], rows()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_series<'a>(
    path: &Path,
    columns: &[&str],
    rows: impl IntoIterator<Item = &'a [f64]>,
) -> Result<(), RecordError> {
    let mut file = AtomicFile::begin(path)?;
    file.add(series_csv(columns, []).as_bytes())?;
    for row in rows {
        let cells: Vec<String> = row.iter().map(|&value| number(value)).collect();
        file.add((cells.join(",") + "\n").as_bytes())?;
    }
    file.finish()
}
