//! Tables of radii and their weights.

use super::SizesError;

/// Radii and weights in ascending order of radius.
pub(super) fn read(file: &str, text: &str) -> Result<Vec<[f64; 2]>, SizesError> {
    let refused = |line: usize, reason: String| SizesError::Line {
        file: file.into(),
        line: line + 1,
        reason,
    };
    let rows = text.lines().enumerate();
    let mut rows = rows.filter(|(_, row)| !row.trim().is_empty() && !row.starts_with('#'));
    let header = rows.next();
    let (first, header) =
        header.ok_or_else(|| refused(0, "the file is empty; give columns radius,weight".into()))?;
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    if names != ["radius", "weight"] {
        let reason = "the columns must be radius,weight; weights are numbers of spheres";
        return Err(refused(first, reason.into()));
    }
    let mut table = Vec::new();
    for (number, row) in rows {
        let cells: Vec<&str> = row.split(',').map(str::trim).collect();
        let &[radius, weight] = cells.as_slice() else {
            let reason = format!("{} values where there are 2 columns", cells.len());
            return Err(refused(number, reason));
        };
        let positive = |name: &str, cell: &str| {
            let value = cell.parse::<f64>().ok();
            value
                .filter(|value| value.is_finite() && *value > 0.0)
                .ok_or_else(|| {
                    let reason = format!("{name} must be a finite number > 0, not `{cell}`");
                    refused(number, reason)
                })
        };
        table.push([positive("radius", radius)?, positive("weight", weight)?]);
    }
    if table.is_empty() {
        return Err(refused(
            first,
            "there is no radius; give a line or more".into(),
        ));
    }
    table.sort_by(|a, b| f64::total_cmp(&a[0], &b[0]));
    Ok(table)
}
