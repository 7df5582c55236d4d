//! CSV files with a fixed set of numeric columns.

use crate::failure::Failure;
use std::path::Path;
use tribos::record::{read_text, read_text_from};

/// Bytes of a table at most: some ten million lines.
const MOST_BYTES: u64 = 1 << 30;

/// Reads the rows of a file that has these columns, in any order, and no others (`-` for standard
/// input); every refusal names the file and the line.
pub fn read<const N: usize>(path: &Path, columns: [&str; N]) -> Result<Vec<[f64; N]>, Failure> {
    let rows = parse(&text(path)?, columns)
        .map_err(|message| Failure::input(format!("{}:{message}", path.display())))?;
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}

/// What stands in a file, or comes from standard input for `-`.
pub fn text(path: &Path) -> Result<Vec<u8>, Failure> {
    let text = if path == Path::new("-") {
        read_text_from(&mut std::io::stdin().lock(), MOST_BYTES)
    } else {
        read_text(path, MOST_BYTES)
    };
    let fail = |error| Failure::input(format!("cannot read {}: {error}", path.display()));
    Ok(text.map_err(fail)?.into_bytes())
}

/// Names of the columns of a file.
pub fn header(text: &[u8]) -> Vec<String> {
    let first = text.split(|&byte| byte == b'\n').next().unwrap_or_default();
    let line = String::from_utf8_lossy(first);
    line.split(',').map(|name| name.trim().to_owned()).collect()
}

/// Rows with their lines; a refusal begins with the line.
pub fn parse<const N: usize>(
    text: &[u8],
    names: [&str; N],
) -> Result<Vec<(u64, [f64; N])>, String> {
    let wanted = names.join(",");
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text);
    let headers = reader
        .headers()
        .map_err(|error| in_words(&error, &wanted))?
        .clone();
    let mut columns = [0; N];
    for (column, name) in columns.iter_mut().zip(names) {
        *column = headers
            .iter()
            .position(|header| header == name)
            .ok_or(format!(
                "1: column `{name}` is missing; the header must be {wanted}"
            ))?;
    }
    if let Some(extra) = headers.iter().find(|header| !names.contains(header)) {
        return Err(format!(
            "1: unknown column `{extra}`; the header must be {wanted}"
        ));
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| in_words(&error, &wanted))?;
        let line = record
            .position()
            .map_or(0, |position| line_of(text, position));
        let mut row = [0.0; N];
        for ((value, column), name) in row.iter_mut().zip(columns).zip(names) {
            let text = record.get(column).unwrap_or("");
            *value = crate::command::number::finite(text)
                .map_err(|cure| format!("{line}: {name} is `{text}`; {cure}"))?;
        }
        rows.push((line, row));
    }
    if rows.is_empty() {
        return Err(format!("2: no rows; give one line of {wanted} for each"));
    }
    Ok(rows)
}

/// Line of a record, past the blank lines that the reader counts to it.
fn line_of(text: &[u8], position: &csv::Position) -> u64 {
    let rest = text.iter().skip(position.byte() as usize);
    let blank = rest.take_while(|byte| byte.is_ascii_whitespace());
    position.line() + blank.filter(|&&byte| byte == b'\n').count() as u64
}

/// A CSV error with its line first.
fn in_words(error: &csv::Error, wanted: &str) -> String {
    let line = error.position().map_or(1, csv::Position::line);
    match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => {
            format!("{line}: {len} columns instead of {expected_len}; give {wanted}")
        }
        csv::ErrorKind::Utf8 { .. } => {
            format!("{line}: not UTF-8 text; save the file as plain CSV")
        }
        _ => format!("{line}: {error}"),
    }
}
