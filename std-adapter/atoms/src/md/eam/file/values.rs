//! Tables of numbers over any number of lines.

use crate::md::text::{Lines, TextError};

/// The next `count` numbers, which begin and end with a line.
pub(super) fn values(
    lines: &mut Lines,
    what: &'static str,
    count: usize,
) -> Result<Vec<f64>, TextError> {
    let mut values = Vec::new();
    while values.len() < count {
        let cure = format!("{} of {count} values are there", values.len());
        let line = lines.need(what, &cure)?;
        for word in line.words() {
            values.push(line.number(what, word)?);
        }
        if values.len() > count {
            let valid = format!("{count} values that end with a line");
            return Err(line.invalid(what, valid, line.text.trim()));
        }
    }
    Ok(values)
}

/// Refuses what follows the last table.
pub(super) fn end(lines: &mut Lines) -> Result<(), TextError> {
    match lines.find(|line| !line.text.trim().is_empty()) {
        Some(line) => Err(TextError::Unsupported {
            line: line.number,
            what: "what follows the last table".into(),
            cure: "only setfl (.eam.alloy) and funcfl (.eam) files are known, not .eam.fs and others",
        }),
        None => Ok(()),
    }
}
