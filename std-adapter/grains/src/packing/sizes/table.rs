//! Tables of radii and their weights.

use crate::packing::SettingError;
use tribos_base::record::{Rows, TableError};

/// Columns of a table; weights are numbers of spheres.
pub(super) const COLUMNS: [&str; 2] = ["radius", "weight"];
/// Most lines of a table.
const MOST: usize = 1_000_000;

/// Radii and weights in ascending order of radius.
pub(super) fn read(mut rows: Rows<'_>) -> Result<Vec<[f64; 2]>, TableError> {
    let (mut table, mut row) = (Vec::new(), [0.0; 2]);
    while rows.next(&mut row)?.is_some() {
        if let Some((name, value)) = COLUMNS.iter().zip(row).find(|(_, value)| *value <= 0.0) {
            let reason = format!("{name} must be a finite number > 0, not `{value}`");
            return Err(rows.refusal(&reason));
        }
        table.push(row);
        if table.len() > MOST {
            return Err(rows.refusal(&format!("more than {MOST} rows")));
        }
    }
    table.sort_by(|a, b| f64::total_cmp(&a[0], &b[0]));
    Ok(table)
}

/// The refusal with its place.
pub(super) fn refused(error: TableError) -> SettingError {
    match error {
        TableError::Access { file, reason } | TableError::Whole { file, reason } => {
            SettingError::File { file, reason }
        }
        TableError::Line { file, line, reason } => SettingError::Line {
            file,
            line: usize::try_from(line).unwrap_or(usize::MAX),
            reason,
        },
    }
}
