//! Tables of numbers as CSV.

use super::number;

/// CSV text with a header line and one line per row, 17 significant digits each.
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
